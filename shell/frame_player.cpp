// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/frame_player.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <utility>

#include "shell/popover_fields.h"

namespace mesecina {

Played_frames frames_of_sweeps(std::shared_ptr<const Registry> registry, Document& document,
                               std::vector<Sweep> sweeps) {
  QStringList labels;
  for (const Sweep& sweep : sweeps)
    if (const Setting_spec* spec = registry->find_setting(sweep.setting)) labels << QString::fromStdString(spec->label);
  const QString text = QCoreApplication::translate("Frame_player", "Animate %1").arg(labels.join(QStringLiteral(", ")));
  const int count = frames_of(sweeps);
  const auto settings = [registry = std::move(registry), &document, sweeps = std::move(sweeps)](int frame) {
    return swept(*registry, document.settings(), sweeps, frame);
  };
  return {count,
          [&document, settings, text, merge = new_merge_key(QStringLiteral("animate"))](int frame) {
            document.edit_settings(settings(frame), text, merge);
          },
          [&document, settings](int frame) { return settings(frame) == document.settings(); }};
}

Played_frames frames_of_track(Document& document) {
  const Track_pointer track = document.track();
  return {track ? static_cast<int>(document.step_count()) + 1 : 0,
          [&document](int frame) { document.go_to(static_cast<std::size_t>(frame)); },
          [&document, track](int frame) {
            return document.track() == track && document.position() == static_cast<std::size_t>(frame);
          }};
}

Frame_player::Frame_player(Computation& computation, QObject* parent) : QObject(parent), computation_(computation) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Frame_player::check);
  connect(&computation_, &Computation::busy_changed, this, [this](bool is_busy) {
    if (!is_busy) go_on();
  });
}

void Frame_player::play(Played_frames frames, double frames_per_second, std::function<bool()> may_go_on) {
  stop();
  if (frames.count < 1) return;
  frames_ = std::move(frames);
  may_go_on_ = std::move(may_go_on);
  constexpr double milliseconds = 1000;
  interval_ = milliseconds / std::max(frames_per_second, 0.01);
  frame_ = 0;
  is_playing_ = true;
  show_frame();
}

void Frame_player::stop() {
  if (is_playing_) end(false);
}

void Frame_player::end(bool is_complete) {
  is_playing_ = false;
  timer_.stop();
  Q_EMIT changed();
  Q_EMIT ended(is_complete);
}

void Frame_player::go_on() {
  if (is_playing_) timer_.start(0);
}

void Frame_player::show_frame() {
  is_shown_ = false;
  frames_.show(frame_);
  Q_EMIT changed();
  timer_.start(0);
}

void Frame_player::check() {
  if (!is_playing_ || computation_.is_busy()) return;
  if (!frames_.is_there(frame_)) {
    end(false);
    return;
  }
  if (!is_shown_) {
    is_shown_ = true;
    since_shown_.start();
    Q_EMIT shown(frame_);
    if (!is_playing_) return;
  }
  if (frame_ + 1 >= frames_.count) {
    end(true);
    return;
  }
  const double left = interval_ - static_cast<double>(since_shown_.elapsed());
  if (left > 0) {
    timer_.start(static_cast<int>(std::ceil(left)));
  } else if (!may_go_on_ || may_go_on_()) {
    ++frame_;
    show_frame();
  }
}

}  // namespace mesecina

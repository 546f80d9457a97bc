// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window_recording.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "core/turntable_3.h"

namespace mesecina {

namespace {

/// Whether pictures of the two are the same.
bool is_same_picture(const Film_frame& one, const Film_frame& other) {
  const auto is_same_layer = [](const Scene_layer& a, const Scene_layer& b) {
    return a.id == b.id && a.primitives == b.primitives && a.cut == b.cut && a.style == b.style;
  };
  return one.view == other.view && one.view_3 == other.view_3 && one.scene.background == other.scene.background &&
         std::ranges::equal(one.scene.layers, other.scene.layers, is_same_layer);
}

/// film.mp4, film-2.mp4, film-3.mp4: the first that is not there.
QString free_name(const QString& file) {
  const QFileInfo info(file);
  QString candidate = file;
  for (int i = 2; QFileInfo::exists(candidate); ++i)
    candidate =
        QDir(info.path()).filePath(QStringLiteral("%1-%2.%3").arg(info.completeBaseName()).arg(i).arg(info.suffix()));
  return candidate;
}

}  // namespace

Window_recording::Window_recording(std::shared_ptr<const Registry> registry, std::shared_ptr<const Formats> formats,
                                   Document& document, Computation& computation, Window window, QWidget* parent)
    : QObject(parent),
      registry_(std::move(registry)),
      document_(document),
      computation_(computation),
      window_(std::move(window)),
      recorder_(std::move(formats)),
      player_(computation),
      panel_(new Record_panel(registry_->dimension(), parent)),
      indicator_(new QToolButton(parent)) {
  indicator_->setObjectName(QStringLiteral("record-indicator"));
  indicator_->setAutoRaise(true);
  indicator_->setStyleSheet(QStringLiteral("QToolButton { color: #d0342c; font-weight: bold; }"));
  indicator_->setAccessibleName(tr("Recording"));
  indicator_->setToolTip(tr("A film is being recorded; click for its panel"));
  indicator_->hide();
  connect(indicator_, &QToolButton::clicked, this, [this] { window_.show_panel(); });
  change_timer_.setSingleShot(true);
  connect(&change_timer_, &QTimer::timeout, this, [this] {
    if (!computation_.is_busy()) take_change();
  });
  connect(&computation_, &Computation::scene_changed, this, &Window_recording::note_change);
  connect(&computation_, &Computation::request_completed, this, &Window_recording::take_change);
  connect(&computation_, &Computation::busy_changed, this, [this](bool is_busy) {
    if (is_busy) return;
    if (std::exchange(is_waiting_, false)) begin_source();
    note_change();
  });
  connect(&document_, &Document::changed, this,
          [this] { panel_->set_evolution_steps(static_cast<int>(document_.step_count())); });
  connect(&player_, &Frame_player::shown, this, [this] {
    if (is_player_recorded_) take_frame();
  });
  connect(&player_, &Frame_player::ended, this, [this] {
    if (std::exchange(is_player_recorded_, false)) recorder_.finish();
  });
  connect(&recorder_, &Film_recorder::changed, this, [this] {
    if (is_player_recorded_) player_.go_on();
    show_state();
  });
  connect(&recorder_, &Film_recorder::finished, this, [this](const QString& file, const QString& note) {
    window_.tell(false, note.isEmpty() ? tr("Wrote %1").arg(file) : note);
    panel_->show_note(note.isEmpty() ? tr("Wrote %1").arg(QFileInfo(file).fileName()) : note);
    if (!file.contains(QLatin1Char('%'))) panel_->set_file(free_name(file));
  });
  connect(&recorder_, &Film_recorder::failed, this, [this](const QString& reason) {
    is_player_recorded_ = false;
    player_.stop();
    window_.tell(true, reason);
    panel_->show_note(reason);
  });
  connect(panel_, &Record_panel::record_requested, this, &Window_recording::record);
  connect(panel_, &Record_panel::stop_requested, this, &Window_recording::stop);
  connect(panel_, &Record_panel::cancel_requested, this, &Window_recording::cancel);
  connect(panel_, &Record_panel::file_requested, this, &Window_recording::choose_file);
  connect(panel_, &Record_panel::window_size_requested, this, [this] { panel_->set_size(window_.size()); });
  restore();
  connect(panel_, &Record_panel::edited, this, &Window_recording::store);
  connect(panel_, &Record_panel::edited, this, &Window_recording::wish_changed);
}

QWidget* Window_recording::indicator() const { return indicator_; }

void Window_recording::restore() {
  const Preferences known(window_.program);
  constexpr double usual_rate = 30;
  const QSize size = known.value(QStringLiteral("record/size")).toSize();
  if (!size.isEmpty()) panel_->set_size(size);
  panel_->set_frames_per_second(known.value(QStringLiteral("record/frames-per-second"), usual_rate).toDouble());
  panel_->set_transparent(known.value(QStringLiteral("record/transparent"), false).toBool());
}

void Window_recording::store() {
  Preferences known(window_.program);
  const Film_request request = panel_->request();
  known.set_value(QStringLiteral("record/size"), QSize(request.width, request.height));
  known.set_value(QStringLiteral("record/frames-per-second"), request.frames_per_second);
  known.set_value(QStringLiteral("record/transparent"), request.is_transparent);
}

bool Window_recording::ends_by_itself() const {
  return recorder_.is_active() && (source_ != Film_wish::Source::changes || recorder_.is_finishing());
}

void Window_recording::record_wish(const Film_wish& wish) {
  show(wish);
  panel_->set_file(QString::fromStdString(wish.file));
  record();
}

Film_wish Window_recording::wish() const {
  const Film_request request = panel_->request();
  Film_wish wish{panel_->source(),
                 request.file.string(),
                 request.width,
                 request.height,
                 request.frames_per_second,
                 request.is_transparent,
                 {},
                 panel_->turntable_frames()};
  wish.sweeps = animation_;
  return wish;
}

void Window_recording::show(const Film_wish& wish) {
  {
    // Whoever opens a session does not choose its films for all that follow.
    const QSignalBlocker quiet(panel_);
    if (!wish.sweeps.empty()) remember(wish.sweeps);
    panel_->set_source(wish.source);
    panel_->set_turntable_frames(wish.turntable);
    panel_->set_size({wish.width, wish.height});
    panel_->set_frames_per_second(wish.frames_per_second);
    panel_->set_transparent(wish.is_transparent);
    const QString file = QString::fromStdString(wish.file);
    panel_->set_file(file.contains(QLatin1Char('%')) || file.isEmpty() ? file : free_name(file));
  }
  Q_EMIT wish_changed();
}

Sweep Window_recording::sweep(const std::string& setting, double from, double to) const {
  const auto known = sweeps_.find(setting);
  return known == sweeps_.end() ? Sweep{setting, from, to, 100, Sweep::Easing::linear, false} : known->second;
}

void Window_recording::remember(const std::vector<Sweep>& sweeps) {
  animation_ = sweeps;
  QStringList texts;
  for (const Sweep& sweep : sweeps) {
    sweeps_[sweep.setting] = sweep;
    const Setting_spec* spec = registry_->find_setting(sweep.setting);
    texts << tr("%1 from %2 to %3")
                 .arg(spec ? QString::fromStdString(spec->label) : QString())
                 .arg(sweep.from)
                 .arg(sweep.to);
  }
  panel_->set_animation_text(tr("%1, %2 frames.").arg(texts.join(tr(", "))).arg(frames_of(sweeps)));
  Q_EMIT wish_changed();
}

void Window_recording::play(const std::vector<Sweep>& sweeps) {
  if (is_player_recorded_) return;
  remember(sweeps);
  player_.play(frames_of_sweeps(registry_, document_, sweeps), panel_->request().frames_per_second);
}

void Window_recording::prepare(const std::vector<Sweep>& sweeps) {
  remember(sweeps);
  panel_->set_source(Record_panel::Source::animation);
  window_.show_panel();
}

void Window_recording::play_or_stop() {
  if (player_.is_playing()) {
    player_.stop();
  } else if (!animation_.empty()) {
    play(animation_);
  } else {
    window_.tell(false, tr("Nothing is animated yet: choose a number in the settings with its button ▶"));
  }
}

void Window_recording::choose_file() {
  const QString now = QString::fromStdString(panel_->request().file.string());
  const QString file =
      window_.choose_file(now.isEmpty() ? window_.stem() : now, tr("MP4 film (*.mp4);;WebM film (*.webm);;GIF (*.gif);;"
                                                                   "Numbered pictures, NAME-%05d.png (*.png)"));
  if (file.isEmpty()) return;
  // Of pictures there are many.
  const QFileInfo info(file);
  const bool is_picture = info.suffix().toLower() == QLatin1String("png");
  panel_->set_file(is_picture && !film_kind_of(file.toStdString())
                       ? QDir(info.path()).filePath(info.completeBaseName() + QStringLiteral("-%05d.png"))
                       : file);
}

void Window_recording::suggest_file() {
  const QFileInfo given(QString::fromStdString(panel_->request().file.string()));
  if (given.filePath().isEmpty()) {
    choose_file();
  } else if (given.isRelative()) {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::MoviesLocation);
    panel_->set_file(QDir(folder).filePath(given.filePath()));
  }
}

void Window_recording::record() {
  if (recorder_.is_active()) return;
  suggest_file();
  Film_request request = panel_->request();
  if (request.file.empty()) return;
  seen_ = window_.seen();
  request.background = window_.frame(QSize(request.width, request.height), seen_).scene.background;
  if (const std::string reason = reason_against(request); !reason.empty()) {
    window_.tell(true, QString::fromStdString(reason));
    panel_->show_note(QString::fromStdString(reason));
    return;
  }
  source_ = panel_->source();
  last_frame_.reset();
  expected_ = 0;
  player_.stop();
  recorder_.start(request);
  is_waiting_ = computation_.is_busy();
  if (!is_waiting_) begin_source();
}

Played_frames Window_recording::played_frames() {
  if (source_ == Record_panel::Source::evolution) return frames_of_track(document_);
  return frames_of_sweeps(registry_, document_, animation_);
}

bool Window_recording::may_go_on() const {
  constexpr int most_waiting = 4;
  return recorder_.queued() < most_waiting;
}

void Window_recording::begin_source() {
  if (!recorder_.is_active()) return;
  switch (source_) {
    case Record_panel::Source::changes:
      take_change();
      break;
    case Record_panel::Source::animation:
    case Record_panel::Source::evolution: {
      Played_frames frames = played_frames();
      expected_ = frames.count;
      if (expected_ == 0) {
        cancel();
        break;
      }
      is_player_recorded_ = true;
      constexpr double as_fast_as_possible = 1e6;
      player_.play(std::move(frames), as_fast_as_possible, [this] { return may_go_on(); });
      break;
    }
    case Record_panel::Source::turntable: {
      expected_ = panel_->turntable_frames();
      const Film_frame first = frame_now();
      for (int i = 0; i < expected_; ++i) {
        Film_frame frame = first;
        frame.view_3.camera = turned_on_table(first.view_3.camera, static_cast<double>(i) / expected_);
        recorder_.add(std::move(frame));
      }
      recorder_.finish();
      break;
    }
  }
}

void Window_recording::note_change() {
  if (recorder_.is_active() && source_ == Record_panel::Source::changes) change_timer_.start(0);
}

void Window_recording::take_change() {
  if (!recorder_.is_active() || is_waiting_ || source_ != Record_panel::Source::changes) return;
  take_frame();
}

Film_frame Window_recording::frame_now() const {
  const Film_request& request = recorder_.request();
  Film_frame frame = window_.frame(QSize(request.width, request.height), seen_);
  frame.scene.transparent_background = request.is_transparent;
  // What is not shown would only make frames differ.
  std::erase_if(frame.scene.layers, [](const Scene_layer& layer) { return !layer.style.visible; });
  return frame;
}

void Window_recording::take_frame() {
  if (!recorder_.is_active() || recorder_.is_finishing()) return;
  Film_frame frame = frame_now();
  // Steps that look the same take their time all the same; changes that change nothing do not.
  if (source_ == Record_panel::Source::changes) {
    if (last_frame_ && is_same_picture(*last_frame_, frame)) return;
    last_frame_ = frame;
  }
  recorder_.add(std::move(frame));
}

void Window_recording::stop() {
  is_waiting_ = false;
  if (is_player_recorded_) {
    player_.stop();
  } else {
    recorder_.finish();
  }
}

void Window_recording::cancel() {
  is_waiting_ = false;
  if (std::exchange(is_player_recorded_, false)) player_.stop();
  recorder_.cancel();
}

void Window_recording::show_state() {
  const bool is_active = recorder_.is_active();
  panel_->show_state({is_active, recorder_.is_finishing(), recorder_.frames(), recorder_.waiting(), expected_});
  indicator_->setText(tr("● %1").arg(recorder_.frames()));
  indicator_->setAccessibleName(tr("Recording, %1 frames").arg(recorder_.frames()));
  indicator_->setVisible(is_active);
  if (is_active != was_active_) {
    was_active_ = is_active;
    if (!is_active) last_frame_.reset();
    Q_EMIT active_changed(is_active);
  }
}

}  // namespace mesecina

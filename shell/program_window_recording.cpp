// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QImage>
#include <QMenu>
#include <QStatusBar>
#include <QTemporaryDir>
#include <utility>

#include "shell/animation_popover.h"
#include "shell/program_window.h"
#include "shell/recording_commands.h"

namespace mesecina {

void Program_window::make_picture_actions() {
  const QString group = tr("File");
  actions_->add(group,
                {QStringLiteral("export-picture"),
                 tr("Export &picture…"),
                 tr("Write what is in view as PNG, SVG or PDF, in any size"),
                 {QKeySequence(Qt::CTRL | Qt::Key_E)}},
                [this] { export_picture(); });
  actions_->add(group,
                {QStringLiteral("copy-picture"),
                 tr("Copy pict&ure"),
                 tr("Put a picture of what is in view on the clipboard, in the size that was exported last"),
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_C)}},
                [this] { copy_picture(picture_wish()); });
}

QSize Program_window::picture_size() const {
  return (QSizeF(common_canvas_->size()) * common_canvas_->devicePixelRatioF()).toSize();
}

Picture_wish Program_window::picture_wish() const {
  return {picture_wish_.size.isEmpty() ? picture_size() : picture_wish_.size, picture_wish_.is_transparent};
}

void Program_window::export_picture() {
  if (!can_paint()) return;
  if (popover_) popover_->dismiss();
  const auto save = [this](const Picture_wish& wish) {
    picture_wish_ = wish;
    const QString path = common_files_->choose_for_writing(
        tr("Export picture"), common_files_->stem(), tr("PNG picture (*.png);;SVG drawing (*.svg);;PDF page (*.pdf)"));
    if (path.isEmpty()) return;
    Film_frame frame = picture_frame(wish.size, common_canvas_->size());
    frame.scene.transparent_background = wish.is_transparent;
    common_files_->export_picture(path, std::move(frame), wish.size);
  };
  const auto copy = [this](const Picture_wish& wish) {
    picture_wish_ = wish;
    copy_picture(wish);
  };
  open_popover(open_picture_popover({picture_size(), picture_wish_.is_transparent}, tr("PNG, SVG or PDF"),
                                    common_canvas_, save, copy));
}

void Program_window::copy_picture(const Picture_wish& wish) {
  const Picture_writer* writer = formats_->find_picture_writer("png");
  if (!can_paint() || !writer) return;
  Film_frame frame = picture_frame(wish.size, common_canvas_->size());
  frame.scene.transparent_background = wish.is_transparent;
  common_files_->jobs().run(
      tr("Painting a picture"),
      [this, writer, formats = formats_, frame = std::move(frame), wish]() -> std::function<void()> {
        try {
          const QTemporaryDir folder;
          const QString file = folder.filePath(QStringLiteral("picture.png"));
          write_picture(*writer, file.toStdString(), frame, wish.size);
          return [this, picture = QImage(file), wish] {
            QApplication::clipboard()->setImage(picture);
            constexpr int milliseconds = 5000;
            statusBar()->showMessage(
                tr("Copied a picture of %1 × %2 pixels").arg(wish.size.width()).arg(wish.size.height()), milliseconds);
          };
        } catch (const std::exception& error) {
          return [this, reason = QString::fromStdString(error.what())] {
            messages_->add(Message_bar::Kind::error, reason);
          };
        }
      });
}

void Program_window::make_recording() {
  Window_recording::Window window;
  window.program = program_;
  window.frame = [this](const QSize& size, const QSize& seen) { return picture_frame(size, seen); };
  window.seen = [this] { return common_canvas_->size(); };
  window.size = [this] { return picture_size(); };
  window.choose_file = [this](const QString& suggestion, const QString& filters) {
    return common_files_->choose_for_writing(tr("Record into"), suggestion, filters);
  };
  window.stem = [this] { return common_files_->stem(); };
  window.tell = [this](bool is_error, const QString& line) {
    messages_->add(is_error ? Message_bar::Kind::error : Message_bar::Kind::note, line);
  };
  window.show_panel = [this] {
    record_dock_->show();
    record_dock_->raise();
  };
  recording_ = new Window_recording(registry_, formats_, document_, computation_, std::move(window), this);
  record_dock_ = add_dock(QStringLiteral("record-dock"), tr("Record"), &recording_->panel(), Qt::RightDockWidgetArea);
  tabifyDockWidget(settings_dock_, record_dock_);
  settings_dock_->raise();
  record_dock_->hide();
  // Qt would show the last tab, whichever that is.
  connect(record_dock_->toggleViewAction(), &QAction::toggled, this, [this](bool is_shown) {
    if (!is_shown && !settings_dock_->isHidden()) settings_dock_->raise();
  });
  statusBar()->insertPermanentWidget(1, recording_->indicator());
  recording_->indicator()->hide();
  connect(recording_, &Window_recording::wish_changed, this, [this] { touch_scene(); });
  connect(settings_panel_, &Settings_panel::animate_requested, this,
          [this](const QString& setting, double from, double to) { open_animation(setting.toStdString(), from, to); });
  connect(recording_, &Window_recording::active_changed, this, [this](bool is_active) {
    (*actions_)[QStringLiteral("record-film")]->setText(is_active ? tr("Stop &recording") : tr("&Record now"));
    (*actions_)[QStringLiteral("cancel-film")]->setEnabled(is_active);
    if (!is_active && closes_after_film_) close();
  });
  const QString group = tr("Record");
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run) {
    return actions_->add(group, {QLatin1String(id), text, tip, std::move(keys)}, std::move(run));
  };
  add("record", tr("Rec&ord a film…"),
      tr("Film what changes, an animated setting, an evolution or, in space, a turntable: MP4, WebM, GIF or pictures"),
      {QKeySequence(Qt::CTRL | Qt::Key_R)}, [this] {
        record_dock_->show();
        record_dock_->raise();
      });
  add("record-film", tr("&Record now"), tr("Begin a film as the panel says; while there is one, end it and keep it"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R)}, [this] {
        if (!can_paint()) return;
        if (recording_->recorder().is_active()) {
          recording_->stop();
        } else {
          recording_->record();
        }
      });
  QAction* cancel = add("cancel-film", tr("&Cancel the film"), tr("Stop recording, and keep nothing of it"), {},
                        [this] { recording_->cancel(); });
  cancel->setEnabled(false);
  add("play-animation", tr("Play or stop the &animation"), tr("Of the settings that were animated last"),
      {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_P)}, [this] { recording_->play_or_stop(); });
}

void Program_window::open_animation(const std::string& setting, double from, double to) {
  if (popover_) popover_->dismiss();
  Animation_popover_calls calls;
  calls.play = [this](const std::vector<Sweep>& sweeps) { recording_->play(sweeps); };
  calls.record = [this](const std::vector<Sweep>& sweeps) { recording_->prepare(sweeps); };
  calls.remember = [this](const std::vector<Sweep>& sweeps) { recording_->remember(sweeps); };
  open_popover(open_animation_popover(*registry_, recording_->sweep(setting, from, to), recording_->animation(),
                                      recording_->panel().request().frames_per_second, recording_->player(),
                                      common_canvas_, std::move(calls)));
}

bool Program_window::is_filming() const { return film_of_steps_ || recording_->ends_by_itself(); }

void Program_window::make_recording_commands() {
  const auto record = [this](const Record_order& order) {
    if (!can_paint()) throw Command_error(tr("record: there is nothing that paints here"));
    if (is_filming() || recording_->recorder().is_active())
      throw Command_error(tr("record: a film is being recorded already; record-film ends it"));
    if (order.evolutions.empty() && order.wish.source == Film_wish::Source::evolution && document_.step_count() == 0)
      throw Command_error(tr("record: expected steps of an evolution, found none; add --evolve ID=STEPS"));
    // As --record does.
    QDir().mkpath(QFileInfo(QString::fromStdString(order.wish.file)).path());
    if (order.evolutions.empty()) {
      recording_->record_wish(order.wish);
      return;
    }
    film_of_steps_ = order.wish;
    evolution_.run(order.evolutions);
    record_when_steps_are_made();
  };
  commands_->add(record_command(
      *registry_, [this] { return recording_->wish(); }, record));
  connect(&evolution_.evolver(), &Evolver::busy_changed, this, &Program_window::record_when_steps_are_made,
          Qt::QueuedConnection);
}

void Program_window::record_when_steps_are_made() {
  if (!film_of_steps_ || evolution_.is_making_steps()) return;
  const Film_wish wish = *std::exchange(film_of_steps_, std::nullopt);
  if (document_.step_count() > 0) {
    recording_->record_wish(wish);
  } else {
    messages_->add(Message_bar::Kind::error, tr("record: no step was made, so there is nothing to film"));
  }
}

}  // namespace mesecina

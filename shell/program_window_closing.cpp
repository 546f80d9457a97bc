// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCloseEvent>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QMessageBox>
#include <QScopedValueRollback>
#include <QStatusBar>
#include <QTimer>

#include "shell/program_window.h"

namespace mesecina {

namespace {

/// For a disk that does not answer. A million triangles take less than a second.
constexpr qint64 longest_wait = 20'000;
constexpr qint64 noticed_wait = 200;
constexpr std::chrono::milliseconds poll_interval{10};
/// A film that somebody is forced to end is completed if that takes no longer.
constexpr qint64 longest_wait_for_film = 3'000;

/// Runs the event loop without input of the user until `is_done`, or so many milliseconds.
void wait_until(qint64 milliseconds, const std::function<bool(qint64 elapsed)>& is_done) {
  QElapsedTimer time;
  time.start();
  if (is_done(0)) return;
  QEventLoop loop;
  QTimer poll;
  QObject::connect(&poll, &QTimer::timeout, &loop, [&] {
    if (is_done(time.elapsed()) || time.elapsed() > milliseconds) loop.quit();
  });
  poll.start(poll_interval);
  loop.exec(QEventLoop::ExcludeUserInputEvents);
}

}  // namespace

bool Program_window::is_settled() const { return !common_files_->is_saving() && !(autosave_ && autosave_->is_busy()); }

bool Program_window::settle() {
  wait_until(longest_wait, [this](qint64 elapsed) {
    // What was saved has another title, which belongs to the scene.
    if (autosave_) autosave_->flush();
    if (elapsed > noticed_wait)
      statusBar()->showMessage(
          tr("Writing to the disk; the window closes when that is done, or after %1 seconds").arg(longest_wait / 1000));
    return is_settled();
  });
  // What the writer has to say.
  if (autosave_) QCoreApplication::sendPostedEvents(autosave_.get());
  if (is_settled()) return true;
  is_autosave_broken_ = true;
  messages_->add(Message_bar::Kind::warning,
                 tr("The disk has not answered for %1 seconds: the last changes may be lost. Save them elsewhere, or "
                    "close the window once more.")
                     .arg(longest_wait / 1000));
  return false;
}

bool Program_window::may_close() {
  // What is kept comes back at the next start, or from the menu: there is nothing to ask.
  if (is_ending_ || (autosave_ && !is_autosave_broken_)) return true;
  if (!document_.is_modified() || qEnvironmentVariableIsSet("MESECINA_NO_PROMPT")) return true;
  const auto answer = QMessageBox::question(this, tr("Save changes?"), unsaved_text(),
                                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save)
    return common_files_->save() && common_files_->finish_saving(std::chrono::milliseconds(longest_wait)) &&
           !document_.is_modified();
  return answer == QMessageBox::Discard;
}

void Program_window::closeEvent(QCloseEvent* event) {
  event->ignore();
  if (is_closing_) return;
  const QScopedValueRollback guard(is_closing_, true);
  if (!may_lose_film()) return;
  evolution_.pause();
  evolution_.evolver().cancel();
  settle();
  if (!may_close()) return;
  computation_.cancel();
  common_files_->jobs().cancel();
  end_keeping();
  store();
  event->accept();
  Q_EMIT closed();
}

bool Program_window::may_lose_film() {
  if (!recording_ || !recording_->recorder().is_active() || qEnvironmentVariableIsSet("MESECINA_NO_PROMPT"))
    return true;
  if (is_ending_) {
    recording_->stop();
    wait_until(longest_wait_for_film, [this](qint64) { return !recording_->recorder().is_active(); });
    return true;
  }
  const auto answer = QMessageBox::question(
      this, tr("Complete the film?"), tr("A film of %1 frames is not complete.").arg(recording_->recorder().frames()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save && recording_->recorder().is_active()) {
    closes_after_film_ = true;
    recording_->stop();
    return false;
  }
  return answer != QMessageBox::Cancel;
}

void Program_window::end_keeping() {
  if (!autosave_) return;
  if (autosave_->is_busy()) {
    // What was written before is found as after a crash.
    autosave_->abandon();
    autosave_.reset();
    return;
  }
  const bool is_wanted = document_.is_modified() || reopens_scenes();
  autosave_->close(is_wanted && !document_.inputs().is_empty());
  autosave_.reset();
  // Its successor was kept just now.
  std::error_code error;
  if (is_wanted && !reopened_.empty()) std::filesystem::remove_all(reopened_, error);
}

void Program_window::end() {
  if (is_ending_) return;
  is_ending_ = true;
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &Program_window::try_to_end);
  timer->start(poll_interval);
}

void Program_window::try_to_end() {
  if (is_closing_ && !QApplication::activeModalWidget()) return;
  // Whoever waits for an answer gets none, and then it is tried again.
  if (QWidget* dialog = QApplication::activeModalWidget()) {
    dialog->close();
    return;
  }
  if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
  close();
}

}  // namespace mesecina

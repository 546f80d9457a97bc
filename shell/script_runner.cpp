// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/script_runner.h"

#include <QApplication>
#include <QDialog>
#include <QFile>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "shell/commands.h"
#include "shell/program_window.h"

namespace mesecina {

Script_runner::Script_runner(Program_window& window, QString name, const QString& text)
    : QObject(&window), window_(window), name_(std::move(name)), lines_(text.split(QLatin1Char('\n'))) {
  connect(&window_.messages(), &Message_bar::added, this, &Script_runner::hear);
  connect(&timer_, &QTimer::timeout, this, &Script_runner::step);
}

void Script_runner::start() {
  constexpr int milliseconds_between_looks = 5;
  timer_.start(milliseconds_between_looks);
}

void Script_runner::hear(Message_bar::Kind kind, const QString& text) {
  if (kind == Message_bar::Kind::error && error_.isEmpty() && timer_.isActive()) error_ = text;
}

void Script_runner::refuse_dialog() {
  auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
  if (!dialog) return;
  if (error_.isEmpty())
    error_ = tr("expected a command that needs no answer, found one that asks in a dialog: %1")
                 .arg(dialog->windowTitle().isEmpty() ? lines_[line_ - 1].trimmed() : dialog->windowTitle());
  dialog->reject();
}

void Script_runner::step() {
  if (is_running_) {
    refuse_dialog();
    return;
  }
  if (window_.has_file_jobs() || window_.evolution().evolver().is_busy() || window_.is_filming()) return;
  if (!error_.isEmpty()) {
    finish(tr("%1:%2: %3").arg(name_).arg(line_).arg(error_), false);
    return;
  }
  if (line_ == lines_.size()) {
    finish({}, false);
    return;
  }
  try {
    const QStringList words = words_of_line(lines_[line_]);
    const bool is_quitting = words == QStringList{QStringLiteral("quit")};
    if (!words.isEmpty() && window_.commands().find(words.front()).needs_pictures && window_.is_busy()) return;
    ++line_;
    if (is_quitting) {
      finish({}, true);
      return;
    }
    is_running_ = true;
    // Not from the timer, which would not tick in an event loop that the command runs.
    QMetaObject::invokeMethod(
        this, [this, words] { run(words); }, Qt::QueuedConnection);
  } catch (const std::exception& error) {
    ++line_;
    error_ = QString::fromUtf8(error.what());
  }
}

void Script_runner::run(const QStringList& words) {
  try {
    window_.commands().run(words);
  } catch (const std::exception& error) {
    if (error_.isEmpty()) error_ = QString::fromUtf8(error.what());
  }
  is_running_ = false;
}

void Script_runner::finish(const QString& error, bool is_quitting) {
  timer_.stop();
  Q_EMIT finished(error, is_quitting);
}

QString read_script(const QString& name) {
  QFile file(name);
  const bool is_open =
      name == QLatin1String("-") ? file.open(stdin, QIODevice::ReadOnly) : file.open(QIODevice::ReadOnly);
  if (!is_open)
    throw std::runtime_error(
        Script_runner::tr("%1: expected a script, found no file that can be read").arg(name).toStdString());
  return QString::fromUtf8(file.readAll());
}

}  // namespace mesecina

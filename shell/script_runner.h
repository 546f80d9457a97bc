// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include "shell/message_bar.h"

namespace mesecina {

class Program_window;

/// Carries out the lines of a script in a window, one after the other, each when what it needs is there: files are read
/// and written before the next line begins, films that come to an end by themselves are complete, and what needs
/// pictures waits until they are computed.
///
/// Stops at the first line that cannot be carried out: because it is no command, because the window shows an error, or
/// because it asks the user something in a dialog.
class Script_runner : public QObject {
  Q_OBJECT
 public:
  /// `name` is that of the file, for messages.
  Script_runner(Program_window& window, QString name, const QString& text);

  /// The first line runs when the event loop does.
  void start();

 Q_SIGNALS:
  /// Once. `error` is empty, or one line "FILE:LINE: what is wrong". `is_quitting`: a line said so.
  void finished(const QString& error, bool is_quitting);

 private:
  void step();
  void run(const QStringList& words);
  void hear(Message_bar::Kind kind, const QString& text);
  void refuse_dialog();
  void finish(const QString& error, bool is_quitting);

  Program_window& window_;
  QString name_;
  QStringList lines_;
  qsizetype line_ = 0;       ///< number of the line that ran last, counted from 1
  bool is_running_ = false;  ///< a line, which may run an event loop of its own
  QString error_;            ///< of the line that ran last
  QTimer timer_;
};

/// The text of a script; of "-" what comes on the standard input. Throws std::runtime_error when it cannot be read.
QString read_script(const QString& file);

}  // namespace mesecina

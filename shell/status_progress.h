// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;

namespace mesecina {

/// What takes long, how far it is, and a button that stops it; for a status bar. Shows itself only when something has
/// run for a third of a second.
class Status_progress : public QWidget {
  Q_OBJECT
 public:
  explicit Status_progress(QWidget* parent = nullptr);

  /// Said again before it is shown, the third of a second starts anew: a stream of short things, such as a drag, is not
  /// worth showing.
  void begin(const QString& text);
  /// fraction in [0,1]; negative: not known. After a second with the same text it is also told how much longer that
  /// will take.
  void report(const QString& text, double fraction);
  void end();
  bool is_running() const { return is_running_; }

 Q_SIGNALS:
  void cancel_requested();

 private:
  bool is_running_ = false;
  QTimer delay_;
  QString stage_;
  QElapsedTimer stage_time_;
  QLabel* text_;
  QProgressBar* bar_;
};

}  // namespace mesecina

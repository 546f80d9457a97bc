// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>
#include <csignal>

class QSocketNotifier;

namespace mesecina {

/// While it lives, the first SIGTERM, SIGINT or SIGHUP is told in the event loop and ends nothing; a second of the same
/// kind ends the process at once, as usual. SIGHUP stays ignored where it was (nohup). One object at a time.
class Ending_signals : public QObject {
  Q_OBJECT
 public:
  /// Where the process has too many open files, signals end it as usual.
  explicit Ending_signals(QObject* parent = nullptr);
  /// Signals do what they did before.
  ~Ending_signals() override;

 Q_SIGNALS:
  void received();

 private:
  static constexpr std::array kinds{SIGTERM, SIGINT, SIGHUP};

  std::array<int, 2> ends_{-1, -1};  ///< of a pipe: read, write
  std::array<struct sigaction, kinds.size()> before_{};
  QSocketNotifier* notifier_ = nullptr;
};

}  // namespace mesecina

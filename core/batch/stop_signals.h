// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <csignal>
#include <thread>

namespace mesecina {

/// While it lives, SIGINT and SIGTERM do not end the process: the first one is told, and the next one ends the process
/// at once, with exit_interrupted. Holds for the thread that made it and those started from there later. Also where the
/// signals were ignored, as shells do for what they start in the background: whoever sends one there wants the same.
class Stop_signals {
 public:
  /// Throws std::system_error when the process has too many open files.
  Stop_signals();
  ~Stop_signals();
  Stop_signals(const Stop_signals&) = delete;
  Stop_signals& operator=(const Stop_signals&) = delete;

  /// A file descriptor that can be read, and has a byte for ever, when the first signal has come. Not to be read from.
  int descriptor() const { return pipe_[0]; }

 private:
  std::array<int, 2> pipe_{};
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::atomic<bool> is_over_ = false;
  std::thread waiter_;
};

}  // namespace mesecina

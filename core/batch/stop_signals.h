// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <thread>

namespace mesecina {

/// While it lives, SIGINT and SIGTERM do not end the process: the first one calls `on_first`, in a thread of its own,
/// and the next one ends the process at once, with exit_interrupted. Holds for the thread that made it and those
/// started from there later. Also where the signals were ignored, as shells do for what they start in the background:
/// whoever sends one there wants the same.
class Stop_signals {
 public:
  explicit Stop_signals(std::function<void()> on_first);
  ~Stop_signals();
  Stop_signals(const Stop_signals&) = delete;
  Stop_signals& operator=(const Stop_signals&) = delete;

 private:
  sigset_t signals_{};
  sigset_t mask_before_{};
  std::atomic<bool> is_over_ = false;
  std::thread waiter_;
};

}  // namespace mesecina

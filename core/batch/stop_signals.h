// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>

namespace mesecina {

/// While it lives, SIGINT and SIGTERM do nothing to the thread that made it, and those started from there later, but
/// wait to be taken. Also where they were ignored, as shells do for what they start in the background: whoever sends
/// one there wants the same. Without a thread or a handler, so that processes may be forked. Linux only.
class Stop_signals {
 public:
  /// Throws std::system_error when the process has too many open files.
  Stop_signals();
  /// Drops those that were not taken.
  ~Stop_signals();
  Stop_signals(const Stop_signals&) = delete;
  Stop_signals& operator=(const Stop_signals&) = delete;

  /// A file descriptor to poll: it can be read while there is a signal to take.
  int descriptor() const { return descriptor_; }
  /// Whether there was one; it is taken.
  bool take() const;

 private:
  int descriptor_ = -1;
  sigset_t mask_before_{};
};

}  // namespace mesecina

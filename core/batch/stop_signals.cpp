// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/stop_signals.h"

#include <pthread.h>

#include <cstdlib>
#include <utility>

#include "core/batch/command_line.h"

namespace mesecina {

Stop_signals::Stop_signals(std::function<void()> on_first) {
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  // Blocked and waited for, not handled: what is to be done takes locks, which no handler may.
  pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  waiter_ = std::thread([this, call = std::move(on_first)] {
    for (bool is_first = true;; is_first = false) {
      int signal = 0;
      sigwait(&signals_, &signal);
      if (is_over_) return;
      if (!is_first) std::_Exit(exit_interrupted);
      call();
    }
  });
}

Stop_signals::~Stop_signals() {
  is_over_ = true;
  pthread_kill(waiter_.native_handle(), SIGINT);
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

}  // namespace mesecina

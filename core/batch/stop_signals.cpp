// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/stop_signals.h"

#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "core/batch/command_line.h"

namespace mesecina {

Stop_signals::Stop_signals() {
  if (pipe(pipe_.data()) != 0) throw std::system_error(errno, std::generic_category(), "no pipe for signals");
  sigemptyset(&signals_);
  sigaddset(&signals_, SIGINT);
  sigaddset(&signals_, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  waiter_ = std::thread([this] {
    for (bool is_first = true;; is_first = false) {
      int signal = 0;
      sigwait(&signals_, &signal);
      if (is_over_) return;
      // An empty pipe takes a byte.
      if (!is_first || write(pipe_[1], "", 1) != 1) std::_Exit(exit_interrupted);
    }
  });
}

Stop_signals::~Stop_signals() {
  is_over_ = true;
  pthread_kill(waiter_.native_handle(), SIGINT);
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
  close(pipe_[0]);
  close(pipe_[1]);
}

}  // namespace mesecina

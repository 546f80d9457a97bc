// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/stop_signals.h"

#include <pthread.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace mesecina {

Stop_signals::Stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  descriptor_ = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "signals cannot be waited for");
  pthread_sigmask(SIG_BLOCK, &signals, &mask_before_);
}

Stop_signals::~Stop_signals() {
  while (take()) {
  }
  close(descriptor_);
  pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

bool Stop_signals::take() const {
  signalfd_siginfo taken{};
  return read(descriptor_, &taken, sizeof taken) == sizeof taken;
}

}  // namespace mesecina

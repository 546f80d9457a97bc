// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/ending_signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <QSocketNotifier>
#include <atomic>
#include <cerrno>

namespace mesecina {

namespace {

static_assert(std::atomic<int>::is_always_lock_free);

/// Where the handler writes to: nothing else reaches it. Signals may come to any thread.
std::atomic<int>& handler_end() {
  static constinit std::atomic<int> end = -1;
  return end;
}

void tell(int) {
  const int error = errno;
  const char byte = 0;
  // A full pipe has told already.
  [[maybe_unused]] const ssize_t written = write(handler_end(), &byte, sizeof byte);
  errno = error;
}

}  // namespace

Ending_signals::Ending_signals(QObject* parent) : QObject(parent) {
  if (pipe2(ends_.data(), O_NONBLOCK | O_CLOEXEC) != 0) return;
  handler_end() = ends_[1];
  notifier_ = new QSocketNotifier(ends_[0], QSocketNotifier::Read, this);
  connect(notifier_, &QSocketNotifier::activated, this, [this] {
    notifier_->setEnabled(false);
    Q_EMIT received();
  });
  struct sigaction action {};
  action.sa_handler = tell;
  action.sa_flags = SA_RESTART | SA_RESETHAND;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    sigaction(kinds[i], nullptr, &before_[i]);
    // Shells ignore SIGINT for what they start in the background; nohup means it.
    const bool is_meant = kinds[i] == SIGHUP && before_[i].sa_handler == SIG_IGN;
    if (!is_meant) sigaction(kinds[i], &action, nullptr);
  }
}

Ending_signals::~Ending_signals() {
  if (!notifier_) return;
  for (std::size_t i = 0; i < kinds.size(); ++i) sigaction(kinds[i], &before_[i], nullptr);
  delete notifier_;
  handler_end() = -1;
  for (const int end : ends_) close(end);
}

}  // namespace mesecina

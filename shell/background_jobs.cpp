// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/background_jobs.h"

#include <utility>

namespace mesecina {

Background_jobs::Background_jobs(QObject* parent)
    : QObject(parent), thread_([this](const std::stop_token& stop) { serve(stop); }) {}

Background_jobs::~Background_jobs() {
  thread_.request_stop();
  thread_.join();
}

void Background_jobs::run(const QString& text, Work work) {
  ++outstanding_;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back({generation_, text, std::move(work)});
  }
  if (outstanding_ == 1) Q_EMIT started(text);
  wake_.notify_all();
}

void Background_jobs::cancel() {
  ++generation_;
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
  }
  if (outstanding_ == 0) return;
  outstanding_ = 0;
  Q_EMIT idle();
}

void Background_jobs::serve(const std::stop_token& stop) {
  while (true) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [this] { return !waiting_.empty(); }) || stop.stop_requested()) return;
      job = std::move(waiting_.front());
      waiting_.pop_front();
    }
    std::function<void()> then = job.work();
    // Dropped by Qt when this object is gone by then.
    QMetaObject::invokeMethod(
        this,
        [this, generation = job.generation, then = std::move(then)] {
          if (generation != generation_) return;
          --outstanding_;
          then();
          if (outstanding_ == 0) Q_EMIT idle();
        },
        Qt::QueuedConnection);
  }
}

}  // namespace mesecina

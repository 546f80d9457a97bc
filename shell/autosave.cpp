// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/autosave.h"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace mesecina {

/// What the two threads share.
struct Autosave::Work {
  explicit Work(const Scene_store& store) : running(store) {}

  Running_scene running;  ///< of whoever writes
  std::mutex mutex;
  std::condition_variable_any wake;
  std::optional<Session> waiting;
  bool is_writing = false;
  bool is_abandoned = false;  ///< nothing will come any more
  Autosave* owner = nullptr;  ///< null when there is nobody to be told
};

Autosave::Autosave(const Scene_store& store, std::function<Session()> scene, QObject* parent)
    : QObject(parent), scene_(std::move(scene)), work_(std::make_shared<Work>(store)) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Autosave::hand_over);
  work_->owner = this;
  thread_ = std::jthread([work = work_](const std::stop_token& stop) { serve(work, stop); });
}

Autosave::~Autosave() {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
  const std::lock_guard lock(work_->mutex);
  work_->owner = nullptr;
}

const std::filesystem::path& Autosave::folder() const { return work_->running.folder(); }

void Autosave::touch() {
  // The first of many changes counts, so that a long drag is written too.
  if (!timer_.isActive() && thread_.joinable()) timer_.start(delay);
}

void Autosave::flush() {
  if (!timer_.isActive()) return;
  timer_.stop();
  hand_over();
}

void Autosave::hand_over() {
  std::optional<Session> session = scene_();
  const std::lock_guard lock(work_->mutex);
  std::swap(work_->waiting, session);
  work_->wake.notify_all();
}

bool Autosave::is_busy() const {
  const std::lock_guard lock(work_->mutex);
  return timer_.isActive() || work_->waiting || work_->is_writing;
}

void Autosave::close(bool is_kept) {
  if (!thread_.joinable()) return;
  if (is_kept) flush();
  timer_.stop();
  thread_.request_stop();
  thread_.join();
  if (is_kept && work_->waiting) write(*work_, *work_->waiting);
  work_->running.close(is_kept);
}

void Autosave::abandon() {
  timer_.stop();
  {
    const std::lock_guard lock(work_->mutex);
    work_->owner = nullptr;
    work_->is_abandoned = true;
    work_->wake.notify_all();
  }
  if (thread_.joinable()) thread_.detach();
}

void Autosave::serve(const std::shared_ptr<Work>& work, const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::optional<Session> session;
    {
      std::unique_lock lock(work->mutex);
      work->is_writing = false;
      if (!work->wake.wait(lock, stop, [&] { return work->waiting || work->is_abandoned; })) return;
      if (stop.stop_requested() || !work->waiting) return;
      session = std::exchange(work->waiting, std::nullopt);
      work->is_writing = true;
    }
    write(*work, *session);
  }
}

void Autosave::write(Work& work, const Session& session) {
  QString reason;
  try {
    work.running.write(session);
  } catch (const std::exception& error) {
    reason = QString::fromUtf8(error.what());
  }
  const std::lock_guard lock(work.mutex);
  work.is_writing = false;
  if (!work.owner) return;
  QMetaObject::invokeMethod(
      work.owner, [owner = work.owner, reason] { owner->take_result(reason); }, Qt::QueuedConnection);
}

void Autosave::take_result(const QString& reason) {
  if (reason.isEmpty()) Q_EMIT written();
  if (!reason.isEmpty() && reason != last_reason_) Q_EMIT failed(reason);
  last_reason_ = reason;
}

}  // namespace mesecina

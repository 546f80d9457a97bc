// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/autosave.h"

#include <utility>

namespace mesecina {

Autosave::Autosave(const Scene_store& store, std::function<Session()> scene, QObject* parent)
    : QObject(parent), scene_(std::move(scene)), running_(store) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &Autosave::hand_over);
  thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
}

Autosave::~Autosave() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void Autosave::touch() {
  // The first of many changes counts, so that a long drag is written too.
  if (!timer_.isActive() && thread_.joinable()) timer_.start(delay);
}

void Autosave::hand_over() {
  Session session = scene_();
  const std::lock_guard lock(mutex_);
  waiting_ = std::move(session);
  wake_.notify_all();
}

void Autosave::close(bool is_kept) {
  const bool is_changed = timer_.isActive();
  timer_.stop();
  if (is_changed && is_kept) hand_over();
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  if (is_kept && waiting_) write(*std::exchange(waiting_, std::nullopt));
  running_.close(is_kept);
}

void Autosave::serve(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::optional<Session> session;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, stop, [&] { return waiting_.has_value(); })) return;
      if (stop.stop_requested()) return;
      session = std::exchange(waiting_, std::nullopt);
    }
    write(*session);
  }
}

void Autosave::write(const Session& session) {
  QString reason;
  try {
    running_.write(session);
  } catch (const std::exception& error) {
    reason = QString::fromUtf8(error.what());
  }
  const auto tell = [this, reason] {
    if (reason.isEmpty()) Q_EMIT written();
    if (!reason.isEmpty() && reason != last_reason_) Q_EMIT failed(reason);
    last_reason_ = reason;
  };
  QMetaObject::invokeMethod(this, tell, Qt::QueuedConnection);
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace mesecina {

/// Reads and writes files, one after the other, on a thread of its own, so that the window stays live.
class Background_jobs : public QObject {
  Q_OBJECT
 public:
  /// Runs on the other thread and touches nothing of this one; what it returns runs here afterwards. Must not throw.
  using Work = std::function<std::function<void()>()>;

  explicit Background_jobs(QObject* parent = nullptr);
  /// Waits for the job that runs; those that wait are dropped.
  ~Background_jobs() override;

  void run(const QString& text, Work work);
  /// Drops those that wait and ignores what the running one will return.
  void cancel();
  bool is_busy() const { return outstanding_ > 0; }

 Q_SIGNALS:
  void started(const QString& text);
  void idle();

 private:
  struct Job {
    std::uint64_t generation = 0;
    QString text;
    Work work;
  };
  void serve(const std::stop_token& stop);

  int outstanding_ = 0;           // this thread only, like the generation
  std::uint64_t generation_ = 0;  ///< that of jobs which were not cancelled
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<Job> waiting_;
  std::jthread thread_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace mesecina {

/// What the workers of a pool do. Called in their processes, each of which has its own copy of all that there was when
/// it was started.
struct Worker_duties {
  /// Does a task and returns the answer to it. May throw nothing. When `stop` is requested it should return soon.
  std::function<std::string(std::size_t task, std::stop_token stop)> work;
  /// Called, in another thread, when that takes longer than a second; then the process ends. May wait for what must not
  /// be cut off.
  std::function<void()> leave;
};

/// Child processes that do tasks, one at a time each, so that a crash of one does no harm to the others. They share no
/// memory with this process and leave SIGINT to it; they end with the thread that made the pool. Where one has
/// died, another takes its place. A task costs two messages, less than a tenth of a millisecond.
///
/// Processes are copies made by fork(). Threads of this process do not exist in them: none may hold a lock that workers
/// need, and what has threads of its own (contexts of graphics, schedulers of parallel loops) must be made in the
/// workers.
class Worker_pool {
 public:
  /// Of so many workers, each started when there is a first task for it.
  Worker_pool(int count, Worker_duties duties);
  /// Ends all workers at once.
  ~Worker_pool();
  Worker_pool(const Worker_pool&) = delete;
  Worker_pool& operator=(const Worker_pool&) = delete;

  bool has_idle() const;
  bool has_busy() const;
  /// Of an idle worker. Throws std::system_error when a process must be started and cannot.
  void give(std::size_t task);

  struct Done {
    std::size_t task = 0;
    std::optional<std::string> answer;  ///< nothing if the worker died
    int signal = 0;                     ///< that ended it; 0 if it ended by itself
  };
  /// Waits for a task to be done, and returns it; or nothing, when the descriptor (-1: none) can be read before.
  /// Some worker must be busy.
  std::optional<Done> wait(int descriptor);

  /// Asks all workers to stop. They answer, or end, within a second and the time that `leave` takes.
  void stop() const;

 private:
  struct Worker {
    pid_t process = 0;  ///< 0 for one that is not started
    int socket = -1;
    bool is_busy = false;
    std::size_t task = 0;
  };

  void start(Worker& worker);
  [[noreturn]] void serve(int socket) const noexcept;
  static int end(Worker& worker);

  Worker_duties duties_;
  std::vector<Worker> workers_;
};

}  // namespace mesecina

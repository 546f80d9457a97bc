// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/worker_pool.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <thread>
#include <utility>

namespace mesecina {

namespace {

/// Whether all could be sent: false when nobody is at the other end.
bool send_all(int socket, const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = send(socket, next, size, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    next += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool receive_all(int socket, void* data, std::size_t size) {
  char* next = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t count = recv(socket, next, size, 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    next += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

std::optional<std::string> receive_text(int socket) {
  std::size_t size = 0;
  if (!receive_all(socket, &size, sizeof size)) return std::nullopt;
  std::string text(size, '\0');
  if (!receive_all(socket, text.data(), size)) return std::nullopt;
  return text;
}

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

}  // namespace

Worker_pool::Worker_pool(int count, Worker_duties duties)
    : duties_(std::move(duties)), workers_(static_cast<std::size_t>(count)) {}

Worker_pool::~Worker_pool() {
  for (Worker& worker : workers_) {
    if (worker.process == 0) continue;
    kill(worker.process, SIGKILL);
    end(worker);
  }
}

void Worker_pool::start(Worker& worker) {
  std::array<int, 2> sockets{};
  if (socketpair(AF_UNIX, SOCK_STREAM, 0, sockets.data()) != 0) fail("no socket for another process");
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) {
    const int reason = errno;
    close(sockets[0]);
    close(sockets[1]);
    throw std::system_error(reason, std::generic_category(), "no other process can be started");
  }
  if (process == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) std::_Exit(EXIT_FAILURE);
    // Others would not notice the end of this process's parent while somebody holds its ends of their sockets.
    for (const Worker& other : workers_)
      if (other.socket >= 0) close(other.socket);
    close(sockets[0]);
    serve(sockets[1]);
  }
  close(sockets[1]);
  worker.process = process;
  worker.socket = sockets[0];
  worker.is_busy = false;
}

void Worker_pool::serve(int socket) const noexcept {
  sigset_t asked;
  sigemptyset(&asked);
  sigaddset(&asked, SIGTERM);
  sigset_t blocked = asked;
  // A terminal sends it to all processes of the program; what becomes of it is for one to say.
  sigaddset(&blocked, SIGINT);
  pthread_sigmask(SIG_BLOCK, &blocked, nullptr);
  std::stop_source stop;
  std::thread([&] {
    int signal = 0;
    sigwait(&asked, &signal);
    stop.request_stop();
    constexpr std::chrono::seconds patience{1};
    std::this_thread::sleep_for(patience);
    duties_.leave();
    std::_Exit(EXIT_FAILURE);
  }).detach();
  std::size_t task = 0;
  while (receive_all(socket, &task, sizeof task)) {
    const std::string answer = duties_.work(task, stop.get_token());
    const std::size_t size = answer.size();
    if (!send_all(socket, &size, sizeof size) || !send_all(socket, answer.data(), size)) break;
  }
  std::_Exit(EXIT_SUCCESS);
}

/// Of a worker that is dead or dying. Returns the signal, or 0.
int Worker_pool::end(Worker& worker) {
  int status = 0;
  while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
  }
  close(worker.socket);
  worker = {};
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

bool Worker_pool::has_idle() const { return !std::ranges::all_of(workers_, &Worker::is_busy); }

bool Worker_pool::has_busy() const { return std::ranges::any_of(workers_, &Worker::is_busy); }

void Worker_pool::give(std::size_t task) {
  Worker& worker = *std::ranges::find(workers_, false, &Worker::is_busy);
  if (worker.process == 0) start(worker);
  worker.is_busy = true;
  worker.task = task;
  // One that has died meanwhile is found out when its answer is waited for.
  send_all(worker.socket, &task, sizeof task);
}

std::optional<Worker_pool::Done> Worker_pool::wait(int descriptor) {
  std::vector<pollfd> polled{{descriptor, POLLIN, 0}};
  std::vector<Worker*> busy;
  for (Worker& worker : workers_) {
    if (!worker.is_busy) continue;
    polled.push_back({worker.socket, POLLIN, 0});
    busy.push_back(&worker);
  }
  while (poll(polled.data(), polled.size(), -1) < 0)
    if (errno != EINTR) fail("other processes cannot be waited for");
  for (std::size_t i = 0; i < busy.size(); ++i) {
    if (polled[i + 1].revents == 0) continue;
    Worker& worker = *busy[i];
    Done done;
    done.task = worker.task;
    done.answer = receive_text(worker.socket);
    worker.is_busy = false;
    if (!done.answer) done.signal = end(worker);
    return done;
  }
  return std::nullopt;
}

void Worker_pool::stop() const {
  for (const Worker& worker : workers_)
    if (worker.process != 0) kill(worker.process, SIGTERM);
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/encoder_process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

#include "core/outcome.h"

namespace mesecina {

namespace {

constexpr int patience_milliseconds = 50;

class Spawn_setup {
 public:
  Spawn_setup(int input, int complaints) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, complaints, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes_, &none);
  }
  ~Spawn_setup() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Spawn_setup(const Spawn_setup&) = delete;
  Spawn_setup& operator=(const Spawn_setup&) = delete;

  int run(int* process, char* const* words) const {
    return posix_spawnp(process, words[0], &actions_, &attributes_, words, environ);
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

void check_stop(const std::stop_token& stop) {
  if (stop.stop_requested()) throw Cancelled();
}

}  // namespace

Encoder_process::Encoder_process(const std::vector<std::string>& words) : name_(words.at(0)) {
  // Unlike a pipe, a socket answers a reader that is gone with an error instead of a signal.
  int ends[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), name_ + " cannot be fed");
  complaints_ = memfd_create("complaints", MFD_CLOEXEC);
  if (complaints_ < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::system_error(error, std::generic_category(), name_ + " cannot be listened to");
  }
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  arguments.reserve(copies.size() + 1);
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int error = Spawn_setup(ends[1], complaints_).run(&process_, arguments.data());
  close(ends[1]);
  if (error != 0) {
    process_ = -1;
    close(ends[0]);
    close(complaints_);
    if (error == ENOENT || error == EACCES) throw Program_missing("there is no program " + name_);
    throw std::system_error(error, std::generic_category(), name_ + " cannot be started");
  }
  input_ = ends[0];
}

Encoder_process::~Encoder_process() {
  if (input_ >= 0) close(input_);
  if (process_ > 0) {
    kill(process_, SIGKILL);
    while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
    }
  }
  close(complaints_);
}

void Encoder_process::write(std::span<const std::byte> bytes, const std::stop_token& stop) {
  while (!bytes.empty()) {
    check_stop(stop);
    const ssize_t count = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      pollfd ready{input_, POLLOUT, 0};
      poll(&ready, 1, patience_milliseconds);
    } else if (errno != EINTR) {
      fail();
    }
  }
}

void Encoder_process::finish(const std::stop_token& stop) {
  close(input_);
  input_ = -1;
  while (!has_ended()) {
    check_stop(stop);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  if (!WIFEXITED(status_) || WEXITSTATUS(status_) != 0) fail();
}

bool Encoder_process::has_ended() {
  if (process_ < 0) return true;
  const int ended = waitpid(process_, &status_, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
  process_ = -1;
  return true;
}

void Encoder_process::fail() {
  // What it complained of is complete when it has ended, which it does soon; it has closed its input.
  constexpr int rounds = 100;
  for (int i = 0; i < rounds && !has_ended(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  throw std::runtime_error(complaint());
}

std::string Encoder_process::complaint() const {
  constexpr off_t most = 1000;
  const off_t size = lseek(complaints_, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::min(most, std::max<off_t>(0, size))), ' ');
  const ssize_t count = pread(complaints_, text.data(), text.size(), std::max<off_t>(0, size - most));
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, count)));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  const std::string how = process_ >= 0          ? " takes no more pictures"
                          : WIFSIGNALED(status_) ? " was ended by signal " + std::to_string(WTERMSIG(status_))
                                                 : " failed";
  return name_ + how + (text.empty() ? std::string() : ": " + text);
}

}  // namespace mesecina

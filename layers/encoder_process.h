// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

namespace mesecina {

/// There is no such program.
class Program_missing : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A program that is fed through its standard input. Signals for this program, from a keyboard say, do not reach it.
/// One thread uses it at a time.
class Encoder_process {
 public:
  /// Starts words[0], looked for in PATH, with the others as arguments. Throws Program_missing, or std::system_error
  /// where no process can be started.
  explicit Encoder_process(const std::vector<std::string>& words);
  /// Ends it by force, unless it has ended.
  ~Encoder_process();
  Encoder_process(const Encoder_process&) = delete;
  Encoder_process& operator=(const Encoder_process&) = delete;

  /// Waits until it has taken all bytes, which bounds what waits for it. Throws Cancelled when `stop` says so, and
  /// std::runtime_error with what the program complained of when it does not read any more.
  void write(std::span<const std::byte> bytes, const std::stop_token& stop);
  /// Tells it that this was all, and waits until it ends. Throws as write(), also when it ends with a failure.
  void finish(const std::stop_token& stop);

 private:
  [[noreturn]] void fail();
  std::string complaint() const;
  bool has_ended();

  std::string name_;
  int process_ = -1;  ///< its id; -1 when it has ended and was waited for
  int status_ = 0;
  int input_ = -1;
  int complaints_ = -1;  ///< a file without a name that takes its standard error
};

}  // namespace mesecina

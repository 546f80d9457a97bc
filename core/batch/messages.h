// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <iosfwd>
#include <mutex>
#include <string>

#include "core/batch/command_line.h"

namespace mesecina {

/// What a run says: lines of the form "PROGRAM: TEXT", each whole. On a terminal the last line tells how far the run
/// is, and is written over and over. Safe to call from several threads.
class Messages {
 public:
  Messages(std::ostream& stream, std::string program, Log_level most, bool is_terminal)
      : stream_(stream), program_(std::move(program)), most_(most), is_terminal_(is_terminal) {}

  void say(Log_level level, const std::string& text);
  /// On a terminal in place of the last one, unless only errors are wanted; else a line, if Log_level::info is wanted.
  void show_progress(const std::string& text);
  /// Nothing more will be shown in place of what was shown last.
  void end_progress();

 private:
  void clear_line();

  std::ostream& stream_;
  std::string program_;
  Log_level most_;
  bool is_terminal_;
  std::mutex mutex_;
  std::string shown_;  ///< in the last line of the terminal
};

/// How far a run is, and how long the rest may take: as long per byte of input as what was computed so far.
class Time_left {
 public:
  /// All bytes that there are to compute.
  explicit Time_left(std::uintmax_t bytes) : bytes_left_(bytes) {}

  /// An input is done: computed, or found to be complete already.
  void count(std::uintmax_t bytes, bool was_computed) {
    bytes_left_ -= bytes;
    if (was_computed) bytes_computed_ += bytes;
  }
  /// "about 20 s left", "about 5 min left", "about 2 h 5 min left"; empty while nothing is known. `seconds`: since the
  /// start.
  std::string text(double seconds) const;

 private:
  std::uintmax_t bytes_left_;
  std::uintmax_t bytes_computed_ = 0;
};

}  // namespace mesecina

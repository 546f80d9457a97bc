// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mesecina {

/// Thrown by a structure's function to say why there is no such structure for this input
/// ("needs at least 3 points that are not on one line"). The graph turns it into a value; it never reaches a user
/// of the graph as an exception.
class Unavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown out of a computation whose Progress was cancelled; the only exception that leaves the graph.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// The reason of what could not be computed for want of memory.
inline constexpr std::string_view out_of_memory_reason = "not enough memory";

/// An immutable structure, or the reason why there is none.
template <class T>
struct Outcome {
  std::shared_ptr<const T> value;  ///< null iff unavailable
  std::string reason;              ///< not empty iff unavailable
  explicit operator bool() const { return value != nullptr; }
};

}  // namespace mesecina

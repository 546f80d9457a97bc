// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <limits>

namespace mesecina::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// To be told why: `return failure() << ...`.
inline testing::AssertionResult failure() { return testing::AssertionFailure(); }

/// n times what MESECINA_LONG_TESTS says (1 without it): how many seeds to try.
inline std::uint64_t repetitions(std::uint64_t n) {
  const char* factor = std::getenv("MESECINA_LONG_TESTS");
  return factor && *factor ? n * std::strtoull(factor, nullptr, 10) : n;
}

}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace mesecina {

/// In [-1, 1), evenly, by nothing but the number: the same on every machine and in every order of calls.
/// [G. Steele, D. Lea, C. Flood: Fast splittable pseudorandom number generators, 2014]
inline double scattered(std::uint64_t number) {
  std::uint64_t z = (number + 1) * 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  z ^= z >> 31U;
  return static_cast<double>(z >> 11U) * 0x1p-52 - 1;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/frame_pace.h"

namespace mesecina {

namespace {

constexpr double slow = 0.12;
/// A quarter of it is less than `slow`, so that a step finer is not undone at once.
constexpr double quick = 0.025;
constexpr double patience = 2;
constexpr int coarsest = 8;

}  // namespace

void Frame_pace::took(double seconds, int coarseness) {
  full_seconds_ = seconds * coarseness * coarseness;
  // What does not go by pixels makes that too much for coarse pictures; the next fine one will tell.
  coarseness_ = coarseness;
  while (full_seconds_ > slow * coarseness_ * coarseness_ && coarseness_ < coarsest) coarseness_ *= 2;
  if (seconds < quick && coarseness > 1) coarseness_ = coarseness / 2;
}

bool Frame_pace::affords(int samples_per_pixel) const { return full_seconds_ * samples_per_pixel <= patience; }

}  // namespace mesecina

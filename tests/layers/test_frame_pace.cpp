// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/frame_pace.h"

#include <gtest/gtest.h>

namespace mesecina::test {
namespace {

/// A scene whose full picture takes so long, `fixed` of it whatever the number of pixels.
int settled(Frame_pace& pace, double full, double fixed) {
  constexpr int frames = 20;
  for (int i = 0; i < frames; ++i) {
    const int coarseness = pace.coarseness();
    pace.took(fixed + (full - fixed) / (coarseness * coarseness), coarseness);
  }
  return pace.coarseness();
}

TEST(Frame_pace, QuickScenesAreDrawnFinely) {
  Frame_pace pace;
  EXPECT_EQ(pace.coarseness(), 1);
  EXPECT_TRUE(pace.affords(4));
  EXPECT_EQ(settled(pace, 0.1, 0.01), 1);
  EXPECT_TRUE(pace.affords(4));
}

TEST(Frame_pace, SlowScenesAreDrawnAsCoarselyAsNeeded) {
  Frame_pace pace;
  EXPECT_EQ(settled(pace, 0.4, 0), 2);
  EXPECT_EQ(settled(pace, 6, 0), 8);
  EXPECT_FALSE(pace.affords(1));
  pace.took(1, 1);
  EXPECT_EQ(pace.coarseness(), 4) << "one slow picture is enough";
  // What does not go by pixels cannot be helped.
  EXPECT_EQ(settled(pace, 10, 5), 8);
  // A quicker scene becomes fine again.
  EXPECT_EQ(settled(pace, 0.02, 0.01), 1);
}

TEST(Frame_pace, ItSettles) {
  for (double full = 0.01; full < 8; full *= 1.1) {
    Frame_pace pace;
    const int coarseness = settled(pace, full, 0.005);
    pace.took(0.005 + (full - 0.005) / (coarseness * coarseness), coarseness);
    EXPECT_EQ(pace.coarseness(), coarseness) << full;
  }
}

}  // namespace
}  // namespace mesecina::test

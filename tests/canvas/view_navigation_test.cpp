// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/view_navigation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace mesecina {
namespace {

using namespace std::chrono_literals;
const View_history::Time now{};

TEST(View_history, SmallStepsSoonAfterEachOtherAreOneEntry) {
  View_history history;
  View_2 view{{0, 0}, 1};
  for (int i = 0; i < 10; ++i) {
    View_2 next = view;
    next.scale *= 1.1;
    history.step(view, next, now + i * 100ms);
    view = next;
  }
  EXPECT_EQ(history.take(view), (View_2{{0, 0}, 1}));
  EXPECT_EQ(history.take({{0, 0}, 1}), std::nullopt);
}

TEST(View_history, LargeOrLateStepsAreEntries) {
  const View_2 first{{0, 0}, 1};
  const View_2 second{{0, 0}, 1.1};
  const View_2 third{{0, 0}, 11};
  const View_2 fourth{{0, 0}, 12};
  View_history history;
  history.step(first, second, now);
  history.step(second, third, now + 10ms);
  history.step(third, fourth, now + 10s);
  EXPECT_EQ(history.take(fourth), third);
  EXPECT_EQ(history.take(third), second);
  EXPECT_EQ(history.take(second), first);
}

TEST(View_history, AGestureIsOneEntryWhateverItsSteps) {
  const View_2 first{{0, 0}, 1};
  View_history history;
  history.begin_gesture(first);
  history.step(first, {{500, 0}, 1}, now);
  history.step({{500, 0}, 1}, {{5000, 0}, 1}, now + 5s);
  history.end_gesture();
  EXPECT_EQ(history.take({{5000, 0}, 1}), first);
  EXPECT_EQ(history.take(first), std::nullopt);
}

TEST(View_history, AGestureThatWentNowhereIsNoStepBack) {
  const View_2 first{{0, 0}, 1};
  const View_2 second{{0, 0}, 5};
  View_history history;
  history.jump(first, second);
  history.begin_gesture(second);
  history.end_gesture();
  EXPECT_EQ(history.take(second), first);
}

TEST(View_history, KeepsTheNewestHundred) {
  View_history history;
  for (int i = 0; i < 150; ++i) history.jump({{0, 0}, 1.0 + i}, {{0, 0}, 2.0 + i});
  View_2 view{{0, 0}, 151};
  int count = 0;
  while (const auto back = history.take(view)) {
    view = *back;
    ++count;
  }
  EXPECT_EQ(count, 100);
  EXPECT_EQ(view.scale, 51);
}

TEST(View_limits, ZoomKeepsThePointUnderThePixelUntilTheLimit) {
  View_2 view{{1000.123, 2000.456}, 1};
  const Point_2 pixel{13, 571};
  const Point_2 fixed = view.to_plane(pixel, 800, 600);
  for (int i = 0; i < 300; ++i) {
    view = zoomed(view, 1.3, pixel, 800, 600);
    const Point_2 place = view.to_pixel(fixed, 800, 600);
    EXPECT_NEAR(place.x, pixel.x, 1) << view.scale;
    EXPECT_NEAR(place.y, pixel.y, 1) << view.scale;
  }
  EXPECT_GT(view.scale, 1e11);
  EXPECT_LT(view.scale, 1e13);
}

TEST(View_limits, NonsenseIsRefused) {
  EXPECT_EQ(limited({{0, 0}, 0}), std::nullopt);
  EXPECT_EQ(limited({{0, 0}, std::nan("")}), std::nullopt);
  EXPECT_EQ(limited({{HUGE_VAL, 0}, 1}), std::nullopt);
  EXPECT_EQ(limited({{3, 4}, 5}), (View_2{{3, 4}, 5}));
}

TEST(View_limits, PanMovesThePlaneWithTheCursor) {
  const View_2 view = panned({{10, 20}, 4}, 8, -12);
  EXPECT_EQ(view, (View_2{{8, 17}, 4}));
}

}  // namespace
}  // namespace mesecina

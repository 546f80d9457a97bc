// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/animation.h"
#include "core/formats/film.h"
#include "core/turntable_3.h"

namespace mesecina {
namespace {

using testing::HasSubstr;

Registry example() {
  Registry registry;
  registry.begin_module({"example", "Example", "Settings for tests."});
  Setting_spec scale;
  scale.id = "scale-limit";
  scale.default_value = 1.0;
  scale.minimum = 1;
  registry.add_setting(scale);
  Setting_spec count;
  count.id = "count";
  count.default_value = std::int64_t{5};
  registry.add_setting(count);
  Setting_spec is_on;
  is_on.id = "is-on";
  is_on.default_value = false;
  registry.add_setting(is_on);
  return registry;
}

std::string refusal_of_sweep(const std::string& text) {
  try {
    parse_sweep(example(), text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(Sweep, is_exact_at_both_ends) {
  for (const auto easing : {Sweep::Easing::linear, Sweep::Easing::smooth}) {
    const Sweep sweep{"scale-limit", 0.1, 2.7, 300, easing, false};
    EXPECT_EQ(sweep.frames(), 300);
    EXPECT_EQ(sweep.value(0), 0.1);
    EXPECT_EQ(sweep.value(299), 2.7);
    EXPECT_EQ(sweep.value(1000), 2.7);
    for (int frame = 1; frame < 300; ++frame) EXPECT_GT(sweep.value(frame), sweep.value(frame - 1));
  }
}

TEST(Sweep, goes_evenly_or_starts_and_ends_slowly) {
  const Sweep even{"scale-limit", 1, 2, 5, Sweep::Easing::linear, false};
  EXPECT_DOUBLE_EQ(even.value(1), 1.25);
  EXPECT_DOUBLE_EQ(even.value(2), 1.5);
  const Sweep smooth{"scale-limit", 1, 2, 5, Sweep::Easing::smooth, false};
  EXPECT_DOUBLE_EQ(smooth.value(1), 1 + 0.0625 * 2.5);
  EXPECT_DOUBLE_EQ(smooth.value(2), 1.5);
}

TEST(Sweep, comes_back_the_same_way) {
  const Sweep sweep{"scale-limit", 3, 1, 4, Sweep::Easing::smooth, true};
  ASSERT_EQ(sweep.frames(), 7);
  for (int frame = 0; frame < 7; ++frame) EXPECT_EQ(sweep.value(frame), sweep.value(6 - frame));
  EXPECT_EQ(sweep.value(0), 3);
  EXPECT_EQ(sweep.value(3), 1);
  EXPECT_EQ(sweep.value(7), 3);
}

TEST(Sweep, of_one_step_stays) {
  const Sweep sweep{"scale-limit", 3, 1, 1, Sweep::Easing::linear, true};
  EXPECT_EQ(sweep.frames(), 1);
  EXPECT_EQ(sweep.value(0), 3);
}

TEST(Sweep, several_go_together_and_the_shorter_one_stays_at_its_end) {
  const Registry registry = example();
  const std::vector<Sweep> sweeps = {parse_sweep(registry, "scale-limit=1:2:11"), parse_sweep(registry, "count=0:3:4")};
  EXPECT_EQ(frames_of(sweeps), 11);
  const Settings middle = swept(registry, {}, sweeps, 2);
  EXPECT_EQ(registry.value(middle, "scale-limit"), Setting_value(1.2));
  EXPECT_EQ(registry.value(middle, "count"), Setting_value(std::int64_t{2}));
  const Settings late = swept(registry, {}, sweeps, 10);
  EXPECT_EQ(registry.value(late, "scale-limit"), Setting_value(2.0));
  EXPECT_EQ(registry.value(late, "count"), Setting_value(std::int64_t{3}));
  // A default is no change.
  EXPECT_EQ(swept(registry, {}, sweeps, 0).find("scale-limit"), nullptr);
}

TEST(Sweep, is_read_and_written) {
  const Registry registry = example();
  const Sweep sweep = parse_sweep(registry, "scale-limit=1.5:2e1:30:ping-pong:smooth");
  EXPECT_EQ(sweep, (Sweep{"scale-limit", 1.5, 20, 30, Sweep::Easing::smooth, true}));
  EXPECT_EQ(to_text(sweep), "scale-limit=1.5:20:30:smooth:ping-pong");
  EXPECT_EQ(parse_sweep(registry, to_text(sweep)), sweep);
}

TEST(Sweep, refuses_what_is_none) {
  EXPECT_THAT(refusal_of_sweep("scale-limit"), HasSubstr("ID=FROM:TO:STEPS"));
  EXPECT_THAT(refusal_of_sweep("scale-limit=1:2"), HasSubstr("ID=FROM:TO:STEPS"));
  EXPECT_THAT(refusal_of_sweep("scale-limit=1:two:3"), HasSubstr("'two'"));
  EXPECT_THAT(refusal_of_sweep("scale-limit=1:2:0"), HasSubstr("'0'"));
  EXPECT_THAT(refusal_of_sweep("scale-limit=1:2:2.5"), HasSubstr("'2.5'"));
  EXPECT_THAT(refusal_of_sweep("scale-limit=1:2:3:fast"), HasSubstr("'fast'"));
  EXPECT_THAT(refusal_of_sweep("scale-limt=1:2:3"), HasSubstr("did you mean 'scale-limit'"));
  EXPECT_THAT(refusal_of_sweep("is-on=0:1:3"), HasSubstr("is no number"));
  EXPECT_THAT(refusal_of_sweep("scale-limit=0.5:2:3"), HasSubstr("0.5"));
  EXPECT_THAT(refusal_of_sweep("scale-limit=1:inf:3"), HasSubstr("inf"));
}

TEST(Film_name, says_what_it_is) {
  EXPECT_EQ(film_kind_of("a/b.mp4"), Film_kind::mp4);
  EXPECT_EQ(film_kind_of("B.WEBM"), Film_kind::webm);
  EXPECT_EQ(film_kind_of("b.gif"), Film_kind::gif);
  EXPECT_EQ(film_kind_of("frame-%05d.png"), Film_kind::frames);
  EXPECT_EQ(film_kind_of("frame-%d.png"), Film_kind::frames);
  for (const char* name :
       {"frame.png", "frame-%s.png", "%d-%d.png", "%0d.png", "a.avi", "a%d/b.png", "noname", "100%.png"})
    EXPECT_EQ(film_kind_of(name), std::nullopt) << name;
  EXPECT_EQ(frame_name("a/frame-%05d.png", 12), "a/frame-00012.png");
  EXPECT_EQ(frame_name("a/frame-%d.png", 12), "a/frame-12.png");
  EXPECT_EQ(frame_name("a/frame-%02d.png", 1234), "a/frame-1234.png");
}

TEST(Film_name, refuses_what_no_film_can_be) {
  EXPECT_EQ(reason_against({"a.webm", 100, 100, 30, true}), "");
  EXPECT_THAT(reason_against({"a.mp4", 100, 100, 30, true}), HasSubstr("no transparency"));
  EXPECT_THAT(reason_against({"a.avi"}), HasSubstr(".mp4, .webm or .gif"));
  EXPECT_THAT(reason_against({"a.gif", 100, 100, 0}), HasSubstr("frames per second"));
  EXPECT_THAT(reason_against({"a.gif", 20000, 100}), HasSubstr("16384"));
}

TEST(Turntable, goes_round_at_one_height) {
  Camera_3 camera;
  camera.position = {4, 2, 0};
  camera.target = {1, 0, 0};
  const Camera_3 quarter = turned_on_table(camera, 0.25);
  EXPECT_NEAR(quarter.position.x, 1, 1e-12);
  EXPECT_NEAR(quarter.position.y, 2, 1e-12);
  EXPECT_NEAR(quarter.position.z, -3, 1e-12);
  EXPECT_EQ(turned_on_table(camera, 0), camera);
  EXPECT_EQ(turned_on_table(camera, 1), camera);
  const Camera_3 half = turned_on_table(camera, 0.5);
  EXPECT_NEAR(half.position.x, -2, 1e-12);
  EXPECT_NEAR(half.position.y, 2, 1e-12);
}

TEST(Turntable, finds_the_axis_that_goes_upwards) {
  Camera_3 camera;
  camera.position = {3, -8, 4};
  camera.up = {0, 0, 1};
  EXPECT_EQ(up_axis(camera), (Point_3{0, 0, 1}));
  camera.up = {0, 0, -1};
  EXPECT_EQ(up_axis(camera), (Point_3{0, 0, -1}));
  // As a viewer that turns freely leaves it: across the direction of sight.
  camera.position = {0, 3, 8};
  camera.up = {0, 8, -3};
  EXPECT_EQ(up_axis(camera), (Point_3{0, 1, 0}));
  EXPECT_NEAR(turned_on_table(camera, 0.3).position.y, 3, 1e-12);
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/geometries/results.h"
#include "tests/geometries/union_3/axis_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

/// Tunnels, cavities and gaps as small as rounding are beyond what the axis can show.
bool has_tiny_features(std::vector<Ball_3> balls) {
  const Topology whole = topology(*axis_of(balls).dual);
  for (Ball_3& b : balls) b.radius *= 1 + 1e-9;
  return topology(*axis_of(balls).dual) != whole;
}

bool is_sound(const Axis_3& axis) { return has_topology_of_union(axis.complex, *axis.dual); }

testing::AssertionResult has_topology(const Axis_3& axis, const Topology& expected) {
  if (auto result = is_complex(axis); !result) return result;
  const Topology found = topology_by_ranks(axis.complex);
  if (found != expected) return failure() << "medial axis " << to_text(found) << ", dual complex " << to_text(expected);
  if (connectivity(axis.complex) != Connectivity{expected.betti[0], expected.euler})
    return failure() << "counts do not agree with ranks";
  return testing::AssertionSuccess();
}

/// Special positions either do no harm, or are told and can be moved out of.
testing::AssertionResult has_topology_of_the_dual(const std::vector<Ball_3>& balls) {
  const Axis_3 axis = axis_of(balls);
  if (has_tiny_features(balls)) return testing::AssertionSuccess();
  const Topology expected = topology(*axis.dual);
  if (is_sound(axis)) return has_topology(axis, expected);
  testing::AssertionResult result = testing::AssertionSuccess();
  for (const double part : {1e-7, 1e-6, 1e-5}) {
    result = has_topology(axis_of(perturbed(balls, part)), expected);
    if (result) break;
  }
  return result;
}

testing::AssertionResult is_medial_axis(const std::vector<Ball_3>& balls) {
  const Axis_3 axis = axis_of(balls);
  if (!is_sound(axis)) return testing::AssertionSuccess();
  // Where spheres nearly touch, V(U) is known to half the digits only.
  return is_medial(axis, Boundary_oracle_3(balls), 2e-7);
}

testing::AssertionResult is_whole_medial_axis(const std::vector<Ball_3>& balls) {
  const Axis_3 axis = axis_of(balls);
  // In special positions a face that ends on the boundary of the complex may count as leaving it.
  if (!is_sound(axis)) return testing::AssertionSuccess();
  return is_whole(axis, Boundary_oracle_3(balls), 20, balls.size());
}

TEST(Union_medial_axis_3, has_the_topology_of_the_union) {
  expect_of_balls(repetitions(100), has_topology_of_the_dual);
}

TEST(Union_medial_axis_3, is_sound_in_general_position) {
  expect_of_clear_balls(repetitions(60), [](const std::vector<Ball_3>& balls) {
    if (!is_general(power_minima(balls)) || is_sound(axis_of(balls))) return testing::AssertionSuccess();
    return failure() << "rounding changes the topology";
  });
}

TEST(Union_medial_axis_3, tells_where_rounding_decided) {
  // Spheres around corners of a rectangle, which meet in pairs of circles that touch each other.
  const std::vector<Ball_3> balls{{{0, 0, 0}, 3}, {{0, 0, 4}, 3}, {{2, 0, 0}, 3}, {{2, 4, 0}, 3}};
  EXPECT_FALSE(is_sound(axis_of(balls)));
  EXPECT_TRUE(is_sound(axis_of(perturbed(balls, 1e-6))));
}

TEST(Union_medial_axis_3, is_medial) { expect_of_clear_balls(repetitions(30), is_medial_axis); }

TEST(Union_medial_axis_3, lacks_nothing_but_faces_that_leave_the_union) {
  expect_of_clear_balls(repetitions(30), is_whole_medial_axis);
}

/// Three balls around a singular triangle, 3-4-5: half the distance of the contacts, seen from between them.
TEST(Union_medial_axis_3, measures_faces) {
  Progress progress;
  const Axis_3 axis = axis_of({{{4, 0, 0}, 5}, {{0, 4, 0}, 5}, {{-4, 0, 0}, 5}});
  ASSERT_EQ(axis.complex.face_count(), 1U);
  EXPECT_NEAR(lambda_of_faces(axis.complex)[0], 3, 1e-12);
  EXPECT_NEAR(angle_of_faces(axis.complex, progress)[0], 180, 1e-5);
  // The contacts are above (0, 0), 1 beside the triangle.
  const Axis_3 beside =
      axis_of({{{5, 1, 0}, std::sqrt(35.0)}, {{0, 8, 0}, std::sqrt(73.0)}, {{-5, 1, 0}, std::sqrt(35.0)}});
  ASSERT_EQ(beside.complex.face_count(), 1U);
  EXPECT_NEAR(lambda_of_faces(beside.complex)[0], 3, 1e-9);
  EXPECT_NEAR(angle_of_faces(beside.complex, progress)[0], 2 * std::atan(3.0) * 180 / std::numbers::pi, 1e-6);
}

}  // namespace
}  // namespace mesecina::test

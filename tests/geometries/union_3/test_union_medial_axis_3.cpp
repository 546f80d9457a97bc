// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/geometries/union_3/axis_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

testing::AssertionResult failure() { return testing::AssertionFailure(); }

/// Tunnels, cavities and gaps as small as rounding are beyond what the axis can show.
bool has_tiny_features(std::vector<Ball_3> balls) {
  const Topology whole = topology(*axis_of(balls).dual);
  for (Ball_3& b : balls) b.radius *= 1 + 1e-9;
  return topology(*axis_of(balls).dual) != whole;
}

testing::AssertionResult has_topology_of_the_dual(const std::vector<Ball_3>& balls) {
  const Axis_3 axis = axis_of(balls);
  if (has_tiny_features(balls)) return testing::AssertionSuccess();
  if (auto result = is_complex(axis); !result) return result;
  const Topology expected = topology(*axis.dual);
  const Topology found = topology_by_ranks(axis.complex);
  if (found != expected) return failure() << "medial axis " << to_text(found) << ", dual complex " << to_text(expected);
  if (connectivity(axis.complex) != Connectivity{expected.betti[0], expected.euler})
    return failure() << "counts do not agree with ranks";
  return testing::AssertionSuccess();
}

testing::AssertionResult is_medial_axis(const std::vector<Ball_3>& balls) {
  const Axis_3 axis = axis_of(balls);
  // Where spheres nearly touch, V(U) is known to half the digits only; where balls were moved, to less.
  return is_medial(axis, Boundary_oracle_3(balls), is_of_the_balls_themselves(axis) ? 2e-7 : 0.01);
}

testing::AssertionResult is_whole_medial_axis(const std::vector<Ball_3>& balls) {
  const Axis_3 axis = axis_of(balls);
  // In special positions a face that ends on the boundary of the complex may count as leaving it.
  if (!is_of_the_balls_themselves(axis)) return testing::AssertionSuccess();
  return is_whole(axis, Boundary_oracle_3(balls), 20, balls.size());
}

TEST(Union_medial_axis_3, has_the_topology_of_the_union) {
  expect_of_balls(repetitions(100), has_topology_of_the_dual);
}

TEST(Union_medial_axis_3, moves_no_balls_in_general_position) {
  expect_of_clear_balls(repetitions(60), [](const std::vector<Ball_3>& balls) {
    if (!is_general(power_minima(balls)) || is_of_the_balls_themselves(axis_of(balls)))
      return testing::AssertionSuccess();
    return failure() << "rounding changes the topology";
  });
}

TEST(Union_medial_axis_3, is_medial) { expect_of_clear_balls(repetitions(30), is_medial_axis); }

TEST(Union_medial_axis_3, lacks_nothing_but_faces_that_leave_the_union) {
  expect_of_clear_balls(repetitions(30), is_whole_medial_axis);
}

/// Three balls around a singular triangle, 3-4-5: half the distance of the contacts, seen from between them.
TEST(Union_medial_axis_3, measures_faces) {
  const Axis_3 axis = axis_of({{{4, 0, 0}, 5}, {{0, 4, 0}, 5}, {{-4, 0, 0}, 5}});
  ASSERT_EQ(axis.complex.face_count(), 1U);
  EXPECT_NEAR(lambda_of_faces(axis.complex)[0], 3, 1e-12);
  EXPECT_NEAR(angle_of_faces(axis.complex)[0], 180, 1e-5);
  // The contacts are above (0, 0), 1 beside the triangle.
  const Axis_3 beside =
      axis_of({{{5, 1, 0}, std::sqrt(35.0)}, {{0, 8, 0}, std::sqrt(73.0)}, {{-5, 1, 0}, std::sqrt(35.0)}});
  ASSERT_EQ(beside.complex.face_count(), 1U);
  EXPECT_NEAR(lambda_of_faces(beside.complex)[0], 3, 1e-9);
  EXPECT_NEAR(angle_of_faces(beside.complex)[0], 2 * std::atan(3.0) * 180 / std::numbers::pi, 1e-6);
}

}  // namespace
}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometries/medial_filtrations_3/source_balls_3.h"
#include "tests/geometries/union_3/axis_checks_3.h"
#include "tests/geometries/union_3/ball_sets.h"

namespace mesecina::test {
namespace {

/// Whether each contact has three or more source balls, ascending, and lies on their spheres; to rounding.
testing::AssertionResult have_contacts(const Axis_3& axis, const std::vector<Ball_3>& balls, double tolerance) {
  const Source_balls_3 sources = source_balls(axis.complex, axis.vertices);
  if (sources.offsets.size() != 2 * axis.complex.face_count() + 1)
    return testing::AssertionFailure() << "no offset for each contact";
  for (std::size_t f = 0; f < axis.complex.face_count(); ++f) {
    for (std::size_t which = 0; which < 2; ++which) {
      const auto found = sources.of_contact(f, which);
      if (found.size() < 3 || std::ranges::adjacent_find(found, std::greater_equal()) != found.end())
        return testing::AssertionFailure() << found.size() << " balls of face " << f;
      for (const int b : found) {
        const double off = distance(axis.complex.contacts[f][which], balls[b].center) - balls[b].radius;
        if (std::abs(off) > tolerance)
          return testing::AssertionFailure() << "ball " << b << " of face " << f << " is off by " << off;
      }
    }
  }
  return testing::AssertionSuccess();
}

TEST(Source_balls_3, HaveTheContactsOnTheirSpheres) {
  expect_of_clear_balls(repetitions(20),
                        [](const std::vector<Ball_3>& balls) { return have_contacts(axis_of(balls), balls, 1e-6); });
  const std::vector<Ball_3> many = many_balls(1000, 8, 3);
  const Axis_3 axis = axis_of(many);
  EXPECT_GT(axis.complex.face_count(), 1000u);
  EXPECT_TRUE(have_contacts(axis, many, 1e-6));
}

TEST(Source_balls_3, OfATriangleOfBallsAreItsCorners) {
  const Axis_3 axis = axis_of({{{0, 0, 0}, 0.7}, {{1, 0, 0}, 0.7}, {{0.5, 0.8, 0}, 0.7}});
  ASSERT_EQ(axis.complex.face_count(), 1u);
  const Source_balls_3 sources = source_balls(axis.complex, axis.vertices);
  EXPECT_EQ(sources.balls, (std::vector<int>{0, 1, 2, 0, 1, 2}));
}

}  // namespace
}  // namespace mesecina::test

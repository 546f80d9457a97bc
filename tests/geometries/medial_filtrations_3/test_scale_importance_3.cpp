// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometries/scale_importance/scale_importance.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"
#include "tests/growth.h"

namespace mesecina::test {
namespace {

struct Balls {
  std::vector<Point_3> centers;
  std::vector<double> radii;
};

Scale_importance_3 compute(const Balls& balls, const std::vector<double>& slopes = {}, int threads = 1) {
  Progress progress({}, {}, threads);
  return scale_importance(balls.centers, balls.radii, slopes, progress);
}

/// The definition, with quotients raised to the bound of the header where there are slopes.
std::vector<double> by_double_loop(const Balls& balls, const std::vector<double>& slopes = {}) {
  std::vector<double> result(balls.radii.size(), infinity);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < result.size(); ++j) {
      if (!(balls.radii[j] > balls.radii[i])) continue;
      const double d = distance(balls.centers[i], balls.centers[j]);
      double quotient = d / (balls.radii[j] - balls.radii[i]);
      if (!slopes.empty()) quotient = std::max({quotient, 1.0, 1 / (slopes[i] + d / (2 * balls.radii[i]))});
      result[i] = std::min(result[i], quotient);
    }
  }
  return result;
}

void expect_by_definition(const Balls& balls) {
  const std::vector<double> expected = by_double_loop(balls);
  const Scale_importance_3 found = compute(balls);
  ASSERT_EQ(found.values.size(), expected.size());
  ASSERT_EQ(found.witnesses.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == infinity) {
      ASSERT_EQ(found.values[i], infinity) << "ball " << i;
      continue;
    }
    ASSERT_LE(std::abs(found.values[i] - expected[i]), 1e-12 * expected[i]) << "ball " << i;
    const int w = found.witnesses[i];
    ASSERT_GE(w, 0) << "ball " << i;
    ASSERT_GT(balls.radii[w], balls.radii[i]) << "ball " << i;
    const double quotient = distance(balls.centers[i], balls.centers[w]) / (balls.radii[w] - balls.radii[i]);
    ASSERT_LE(std::abs(quotient - expected[i]), 1e-12 * expected[i]) << "ball " << i;
  }
  EXPECT_EQ(compute(balls, {}, 2).values, found.values);
  EXPECT_EQ(compute(balls, {}, 2).witnesses, found.witnesses);
}

Balls random_balls(int count, std::uint64_t seed) {
  Random random(seed);
  Balls balls;
  for (int i = 0; i < count; ++i) {
    const double x = random.unit();
    const double y = random.unit();
    balls.centers.push_back({x, y, random.unit()});
    balls.radii.push_back(random.unit());
  }
  return balls;
}

/// Medial balls along a bent sheet, with fins across it.
Balls sheet_with_fins(int count, std::uint64_t seed) {
  Random random(seed);
  Balls balls;
  for (int i = 0; i < count; ++i) {
    const double u = random.unit();
    const double v = random.unit();
    const double height = random.chance(0.2) ? 0.05 * random.unit() : 0;
    balls.centers.push_back({u, v, 0.1 * std::sin(3 * u + v) + height});
    balls.radii.push_back(0.2 + 0.1 * std::sin(2 * u - 5 * v) * std::cos(u + v) - 0.9 * height);
  }
  return balls;
}

TEST(Scale_importance_3, small_examples) {
  EXPECT_TRUE(compute({}).values.empty());
  EXPECT_EQ(compute({{{1, 2, 3}}, {3}}).values, (std::vector<double>{infinity}));
  EXPECT_EQ(compute({{{0, 0, 0}, {2, 3, 6}}, {1, 2}}).values, (std::vector<double>{7, infinity}));
  EXPECT_EQ(compute({{{0, 0, 0}, {2, 3, 6}}, {2, 2}}).values, (std::vector<double>{infinity, infinity}));
  EXPECT_EQ(compute({{{0, 0, 1}, {0, 0, 1}}, {1, 2}}).values, (std::vector<double>{0, infinity}));
  EXPECT_EQ(compute({{{0, 0, 0}, {0, 0, 1}, {0, 0, 6}}, {1, 1.125, 4}}).values,
            (std::vector<double>{2, 5 / 2.875, infinity}));
}

TEST(Scale_importance_3, of_random_balls) {
  for (const int count : {2, 3, 9, 33, 100, 1000}) {
    SCOPED_TRACE(count);
    for (std::uint64_t seed = 0; seed < 3; ++seed) expect_by_definition(random_balls(count, seed));
  }
  expect_by_definition(random_balls(5000, 3));
}

TEST(Scale_importance_3, of_sheets) {
  for (const int count : {500, 4000}) expect_by_definition(sheet_with_fins(count, 1));
}

TEST(Scale_importance_3, of_degenerate_balls) {
  Balls balls = random_balls(300, 4);
  Random random(5);
  balls.radii.assign(300, 0.25);
  expect_by_definition(balls);
  balls.radii[17] = 1;
  expect_by_definition(balls);
  for (double& radius : balls.radii) radius = random.index(4);
  expect_by_definition(balls);
  for (Point_3& center : balls.centers) center.z = 2;
  expect_by_definition(balls);
  for (Point_3& center : balls.centers) center = {center.x, 0.5 * center.x, -center.x};
  expect_by_definition(balls);
  for (Point_3& center : balls.centers) center = {0.1, 0.2, 0.3};
  expect_by_definition(balls);
  for (double& radius : balls.radii) radius = random.unit();
  expect_by_definition(balls);
  for (int i = 0; i < 300; ++i) {
    balls.centers[i] = {0.1 * (i % 7), 0.1 * (i / 7 % 7), 0.1 * (i / 49)};
    balls.radii[i] = 1 + 1e-16 * i + 1e-9 * (i % 11);
  }
  expect_by_definition(balls);
  for (int i = 0; i < 300; ++i) {
    // All touch a plane from above: the quotient of each two above each other is 1.
    balls.centers[i] = {0.3 * (i % 3), 0, 1.0 + i / 3};
    balls.radii[i] = 1 + i / 3;
  }
  expect_by_definition(balls);
}

TEST(Scale_importance_3, of_extreme_scales) {
  for (const int exponent : {-240, -100, 100, 240}) {
    SCOPED_TRACE(exponent);
    Balls balls = sheet_with_fins(300, 6);
    for (Point_3& center : balls.centers) center = std::ldexp(1, exponent) * center;
    for (double& radius : balls.radii) radius = std::ldexp(radius, exponent);
    expect_by_definition(balls);
  }
}

TEST(Scale_importance_3, is_raised_to_what_slopes_allow) {
  Random random(22);
  const Balls balls = random_balls(400, 21);
  std::vector<double> slopes;
  for (int i = 0; i < 400; ++i) slopes.push_back(random.chance(0.1) ? 1 : 0.1 + 0.9 * random.unit());
  const std::vector<double> expected = by_double_loop(balls, slopes);
  const std::vector<double> found = compute(balls, slopes).values;
  EXPECT_NE(found, compute(balls).values);
  EXPECT_EQ(compute(balls, slopes, 2).values, found);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (expected[i] == infinity) {
      ASSERT_EQ(found[i], infinity) << "ball " << i;
    } else {
      ASSERT_NEAR(found[i], expected[i], 1e-8 * expected[i]) << "ball " << i;
    }
  }
}

TEST(Scale_importance_3, grows_nearly_linearly) {
  const Balls small = sheet_with_fins(10000, 7);
  const Balls large = sheet_with_fins(100000, 8);
  // Every ball against every other would take 100 times as long.
  EXPECT_LT(growth([&] { compute(small); }, [&] { compute(large); }, 15), 25);
}

TEST(Scale_importance_3, can_be_cancelled) {
  std::stop_source source;
  source.request_stop();
  Progress progress(source.get_token());
  const Balls balls = random_balls(10000, 8);
  EXPECT_THROW(scale_importance(balls.centers, balls.radii, {}, progress), Cancelled);
}

}  // namespace
}  // namespace mesecina::test

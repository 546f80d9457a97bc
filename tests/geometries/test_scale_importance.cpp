// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometries/medial_axis_2/medial_axis_2.h"
#include "geometries/scale_importance/scale_importance.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"
#include "tests/growth.h"

namespace mesecina::test {
namespace {

struct Disks {
  std::vector<Point_2> centers;
  std::vector<double> radii;
};

Scale_importance compute(const Disks& disks, int threads = 1) {
  Progress progress({}, {}, threads);
  return scale_importance(disks.centers, disks.radii, {}, progress);
}

std::vector<double> importance(const Disks& disks) { return compute(disks).values; }

std::vector<double> by_double_loop(const Disks& disks) {
  std::vector<double> result(disks.radii.size(), infinity);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < result.size(); ++j) {
      if (disks.radii[j] > disks.radii[i])
        result[i] =
            std::min(result[i], distance(disks.centers[i], disks.centers[j]) / (disks.radii[j] - disks.radii[i]));
    }
  }
  return result;
}

void expect_equal(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (std::isinf(expected[i])) {
      ASSERT_EQ(found[i], infinity) << "disk " << i;
    } else {
      ASSERT_LE(std::abs(found[i] - expected[i]), 1e-12 * expected[i]) << "disk " << i;
    }
  }
}

/// Whether each witness is larger and gives the value; whether there is one where there is a value.
void expect_witnesses(const Disks& disks, const Scale_importance& found) {
  ASSERT_EQ(found.witnesses.size(), found.values.size());
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    const int witness = found.witnesses[i];
    if (std::isinf(found.values[i])) {
      // A quotient may overflow, so that a witness does no harm; the largest disk has none.
      if (disks.radii[i] == *std::ranges::max_element(disks.radii)) {
        ASSERT_EQ(witness, -1) << "disk " << i;
      }
      continue;
    }
    ASSERT_GE(witness, 0) << "disk " << i;
    ASSERT_LT(witness, static_cast<int>(disks.radii.size())) << "disk " << i;
    ASSERT_GT(disks.radii[witness], disks.radii[i]) << "disk " << i;
    const double quotient =
        distance(disks.centers[i], disks.centers[witness]) / (disks.radii[witness] - disks.radii[i]);
    ASSERT_LE(std::abs(quotient - found.values[i]), 1e-12 * quotient) << "disk " << i;
  }
}

void expect_by_definition(const Disks& disks) {
  const std::vector<double> expected = by_double_loop(disks);
  const Scale_importance found = compute(disks);
  expect_equal(found.values, expected);
  expect_witnesses(disks, found);
  EXPECT_EQ(compute(disks, 2).values, found.values);
}

Disks random_disks(int count, std::uint64_t seed) {
  Random random(seed);
  Disks disks{uniform_points(count, seed), {}};
  for (int i = 0; i < count; ++i) disks.radii.push_back(random.unit());
  return disks;
}

struct Medial_balls {
  Disks disks;
  std::vector<double> slopes;
};

Medial_balls medial_balls_with_slopes(const std::vector<Point_2>& samples) {
  Progress progress;
  const Delaunay_2 d = delaunay(samples, progress);
  const Crust_2 crust = one_step_crust(d, progress);
  const Labels_2 labels = flood_labels(d, crust, progress);
  Medial_axis_2 axis = medial_axis(d, voronoi(d, progress), labels, progress);
  std::vector<double> slopes = slope_of_balls(d, axis, progress);
  return {{std::move(axis.centers), std::move(axis.radii)}, std::move(slopes)};
}

Disks medial_balls(const std::vector<Point_2>& samples) { return medial_balls_with_slopes(samples).disks; }

TEST(Scale_importance, small_examples) {
  EXPECT_TRUE(importance({}).empty());
  EXPECT_EQ(importance({{{1, 2}}, {3}}), (std::vector<double>{infinity}));
  EXPECT_EQ(importance({{{0, 0}, {3, 4}}, {1, 2}}), (std::vector<double>{5, infinity}));
  EXPECT_EQ(importance({{{0, 0}, {3, 4}}, {2, 2}}), (std::vector<double>{infinity, infinity}));
  EXPECT_EQ(importance({{{0, 0}, {0, 0}}, {1, 2}}), (std::vector<double>{0, infinity}));
  // A nearer one that is hardly larger loses against a farther, much larger one.
  EXPECT_EQ(importance({{{0, 0}, {1, 0}, {6, 0}}, {1, 1.125, 4}}), (std::vector<double>{2, 5 / 2.875, infinity}));
}

TEST(Scale_importance, of_random_disks) {
  for (const int count : {2, 3, 10, 100, 1000}) {
    SCOPED_TRACE(count);
    for (std::uint64_t seed = 0; seed < 3; ++seed) expect_by_definition(random_disks(count, seed));
  }
}

TEST(Scale_importance, of_degenerate_disks) {
  Disks disks = random_disks(300, 4);
  Random random(5);
  disks.radii.assign(300, 0.25);
  expect_by_definition(disks);
  disks.radii.assign(300, 0);
  expect_by_definition(disks);
  disks.radii[17] = 1;
  expect_by_definition(disks);
  for (double& radius : disks.radii) radius = random.index(4);
  expect_by_definition(disks);
  disks.centers.assign(300, Point_2{0.1, 0.2});
  expect_by_definition(disks);
  for (double& radius : disks.radii) radius = random.unit();
  expect_by_definition(disks);
  for (int i = 0; i < 300; ++i) disks.centers[i] = {0.1 * i, 7};
  expect_by_definition(disks);
  for (int i = 0; i < 300; ++i) disks.radii[i] = 1 + 1e-16 * i + 1e-9 * (i % 7);
  expect_by_definition(disks);
}

TEST(Scale_importance, of_nested_and_tangent_disks) {
  Disks nested;
  Disks tangent;
  for (int i = 0; i < 200; ++i) {
    nested.centers.push_back({0.001 * i, 0});
    nested.radii.push_back(1 + i);
    // All touch the y axis from the right: every pair gives exactly 1.
    tangent.centers.push_back({1.0 + i, 0});
    tangent.radii.push_back(1 + i);
  }
  expect_by_definition(nested);
  expect_by_definition(tangent);
}

TEST(Scale_importance, of_extreme_scales) {
  for (const int exponent : {-240, -100, 100, 240}) {
    SCOPED_TRACE(exponent);
    Disks disks = random_disks(200, 6);
    disks.centers = scaled(disks.centers, exponent);
    for (double& radius : disks.radii) radius = std::ldexp(radius, exponent);
    expect_by_definition(disks);
  }
  Disks mixed = random_disks(300, 7);
  for (int i = 0; i < 300; ++i) {
    mixed.centers[i] = {std::ldexp(mixed.centers[i].x, i - 150), std::ldexp(mixed.centers[i].y, i - 150)};
    mixed.radii[i] = std::ldexp(mixed.radii[i], 150 - i);
  }
  expect_by_definition(mixed);
}

TEST(Scale_importance, of_medial_balls) {
  for (const Smooth_shape& shape : smooth_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_by_definition(medial_balls(shape.samples()));
  }
}

TEST(Scale_importance, of_medial_balls_of_real_shapes) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    expect_by_definition(medial_balls(points_of(file)));
  }
}

/// The disks after some were taken out and some put in, in another order, and where each comes from.
struct Exchange {
  Disks disks;
  std::vector<int> old_index;
};

Exchange exchange(const Disks& old, double lost, int fresh, bool shuffle, std::uint64_t seed) {
  Random random(seed);
  const int count = static_cast<int>(old.radii.size());
  std::vector<int> kept;
  for (int i = 0; i < count; ++i)
    if (!random.chance(lost)) kept.push_back(i);
  for (int i = 0; i < fresh; ++i) kept.insert(kept.begin() + random.index(static_cast<int>(kept.size()) + 1), -1);
  Exchange result;
  std::vector<int> order = random_permutation(static_cast<int>(kept.size()), seed);
  if (!shuffle) std::ranges::sort(order);
  for (const int k : order) {
    const int i = kept[k];
    result.old_index.push_back(i);
    if (i != -1) {
      result.disks.centers.push_back(old.centers[i]);
      result.disks.radii.push_back(old.radii[i]);
    } else {
      const double x = random.uniform(-1, 1);
      result.disks.centers.push_back({x, random.uniform(-1, 1)});
      // Small, among the others, as large as one of them, or larger than all.
      const double radius = count > 0 && random.chance(0.2) ? old.radii[random.index(count)] : 1.2 * random.unit();
      result.disks.radii.push_back(random.chance(0.3) ? 0.01 * radius : radius);
    }
  }
  return result;
}

void expect_update_equals_full_computation(Disks disks, std::uint64_t seed) {
  Progress progress;
  Scale_importance current = compute(disks);
  Random random(seed);
  for (int step = 0; step < 12; ++step) {
    const double lost = step % 4 == 3 ? 0.5 : 0.01 * random.index(4);
    Exchange next = exchange(disks, lost, random.index(4), random.chance(0.5), random.next());
    current = update_scale_importance(current, next.old_index, next.disks.centers, next.disks.radii, {}, progress);
    disks = std::move(next.disks);
    ASSERT_EQ(current.values, compute(disks).values) << "step " << step;
    expect_witnesses(disks, current);
  }
}

TEST(Update_scale_importance, equals_the_full_computation) {
  for (const int count : {0, 1, 2, 5, 30, 400}) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      SCOPED_TRACE(testing::Message() << count << " disks, seed " << seed);
      expect_update_equals_full_computation(random_disks(count, seed), seed);
    }
  }
}

TEST(Update_scale_importance, equals_the_full_computation_on_equal_and_medial_disks) {
  Disks equal = random_disks(100, 3);
  for (double& radius : equal.radii) radius = std::floor(4 * radius) / 4;
  expect_update_equals_full_computation(equal, 5);
  expect_update_equals_full_computation(medial_balls(flower(300, 0.3, 5, 0.8, 4)), 6);
  expect_update_equals_full_computation(medial_balls(cocircular_points()), 7);
}

TEST(Update_scale_importance, when_the_largest_goes_or_comes) {
  Progress progress;
  const Disks all = random_disks(50, 9);
  const int largest = static_cast<int>(std::ranges::max_element(all.radii) - all.radii.begin());
  Disks without = all;
  without.centers.erase(without.centers.begin() + largest);
  without.radii.erase(without.radii.begin() + largest);
  std::vector<int> fewer;
  std::vector<int> more;
  for (int i = 0; i < 50; ++i) {
    if (i != largest) fewer.push_back(i);
    more.push_back(i < largest ? i : i == largest ? -1 : i - 1);
  }
  const Scale_importance after =
      update_scale_importance(compute(all), fewer, without.centers, without.radii, {}, progress);
  EXPECT_EQ(after.values, compute(without).values);
  EXPECT_EQ(update_scale_importance(after, more, all.centers, all.radii, {}, progress).values, compute(all).values);
}

double growth_for(const Disks& small, const Disks& large, double enough) {
  return growth([&] { importance(small); }, [&] { importance(large); }, enough);
}

TEST(Scale_importance, grows_nearly_linearly) {
  const Disks small = medial_balls(flower(20000, 0.3, 5, 0.8, 11));
  const Disks large = medial_balls(flower(200000, 0.3, 5, 0.8, 12));
  ASSERT_GT(small.radii.size(), 19000U);
  ASSERT_LT(small.radii.size(), 20001U);
  ASSERT_GT(large.radii.size(), 190000U);
  EXPECT_LT(growth_for(small, large, 12), 12);
}

Disks equal_up_to_rounding(int count) {
  // The ends of thin rectangles: 0.1 i is rounded, and so are the radii.
  Disks disks;
  for (int i = 0; i < count; ++i) {
    disks.centers.push_back({0.1 * i, 7});
    disks.radii.push_back(std::hypot(0.1 * (i + 1) - 0.1 * i, 1));
  }
  return disks;
}

TEST(Scale_importance, of_radii_that_differ_by_rounding) {
  expect_by_definition(equal_up_to_rounding(1000));
  const Disks large = equal_up_to_rounding(50000);
  ASSERT_NE(*std::ranges::min_element(large.radii), *std::ranges::max_element(large.radii));
  const auto with_equal_radii = [](Disks disks) {
    disks.radii.assign(disks.radii.size(), 1);
    return disks;
  };
  // Every disk against every other would take 100 times as long.
  const Disks small = equal_up_to_rounding(5000);
  EXPECT_LT(growth_for(small, large, 15), 30);
  EXPECT_LT(growth_for(with_equal_radii(small), with_equal_radii(large), 15), 30);
}

/// Every quotient raised to the bound of the header, within a billionth.
std::vector<double> raised_by_double_loop(const Disks& disks, const std::vector<double>& slopes) {
  std::vector<double> result(disks.radii.size(), infinity);
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < result.size(); ++j) {
      if (!(disks.radii[j] > disks.radii[i])) continue;
      const double d = distance(disks.centers[i], disks.centers[j]);
      const double bound = std::max(1.0, 1 / (slopes[i] + d / (2 * disks.radii[i])));
      result[i] = std::min(result[i], std::max(bound, d / (disks.radii[j] - disks.radii[i])));
    }
  }
  return result;
}

TEST(Scale_importance, is_raised_to_what_slopes_allow) {
  Progress progress;
  Random random(22);
  Disks disks = random_disks(300, 21);
  std::vector<double> slopes;
  for (int i = 0; i < 300; ++i) slopes.push_back(random.chance(0.1) ? 1 : 0.1 + 0.9 * random.unit());
  const auto expect_all = [&](const Scale_importance& found) {
    const std::vector<double> expected = raised_by_double_loop(disks, slopes);
    ASSERT_EQ(found.values.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i] == infinity) {
        ASSERT_EQ(found.values[i], infinity) << "disk " << i;
      } else {
        ASSERT_NEAR(found.values[i], expected[i], 1e-8 * expected[i]) << "disk " << i;
      }
    }
  };
  Scale_importance current = scale_importance(disks.centers, disks.radii, slopes, progress);
  EXPECT_NE(current.values, importance(disks));
  expect_all(current);
  for (int step = 0; step < 10; ++step) {
    Exchange next = exchange(disks, 0.01, 3, true, random.next());
    std::vector<double> next_slopes;
    for (const int old : next.old_index) next_slopes.push_back(old < 0 ? random.unit() : slopes[old]);
    current =
        update_scale_importance(current, next.old_index, next.disks.centers, next.disks.radii, next_slopes, progress);
    disks = std::move(next.disks);
    slopes = std::move(next_slopes);
    expect_all(current);
    ASSERT_EQ(current.values, scale_importance(disks.centers, disks.radii, slopes, progress).values) << "step " << step;
  }
}

TEST(Scale_importance, of_samples_on_one_circle) {
  // All disks are the same but for rounding.
  Progress progress;
  const auto [disks, slopes] = medial_balls_with_slopes(ellipse(1, 1, 300000));
  const auto [fewer, slopes_of_fewer] = medial_balls_with_slopes(ellipse(1, 1, 30000));
  ASSERT_GT(disks.radii.size(), 290000U);
  ASSERT_GT(fewer.radii.size(), 29000U);
  const Scale_importance result = scale_importance(disks.centers, disks.radii, slopes, progress);
  EXPECT_LT(growth([&, &few = fewer, &s = slopes_of_fewer] { scale_importance(few.centers, few.radii, s, progress); },
                   [&, &all = disks, &s = slopes] { scale_importance(all.centers, all.radii, s, progress); }, 15),
            30);
  for (std::size_t i = 0; i < slopes.size(); ++i) ASSERT_GE(result.values[i], (1 - 1e-6) / (slopes[i] + 1e-6)) << i;
}

TEST(Scale_importance, can_be_cancelled) {
  std::stop_source source;
  source.request_stop();
  Progress progress(source.get_token());
  const Disks disks = random_disks(10000, 8);
  EXPECT_THROW(scale_importance(disks.centers, disks.radii, {}, progress), Cancelled);
}

}  // namespace
}  // namespace mesecina::test

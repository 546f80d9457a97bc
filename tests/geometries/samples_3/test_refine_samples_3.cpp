// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "geometries/samples_3/refine_samples_3.h"
#include "tests/geometries/samples_3/surface_checks_3.h"
#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/solid_3/solid_oracle_3.h"

namespace mesecina::test {
namespace {

constexpr double slope = 0.3;

Sampled_balls_3 sampled(const Solid_3& solid, double spacing, int threads = 1) {
  Progress progress({}, {}, threads);
  Sampled_balls_3 balls;
  balls.samples = sample_surface(solid.surface, spacing, progress);
  balls.triangulate(solid, progress);
  return balls;
}

struct Refinement {
  bool is_crowded = false;
  double finest = 0;
  double gap = std::numeric_limits<double>::infinity();
  int threads = 1;
};

/// Samples in a part of the solid.
std::vector<int> crowd_of(const Sampled_balls_3& balls) {
  Box box;
  for (const Point_3& p : balls.samples.points) box.add(p);
  std::vector<int> crowd;
  for (std::size_t s = 0; s < balls.samples.points.size(); ++s)
    if (distance(balls.samples.points[s], box.upper) < 0.3 * box.diagonal()) crowd.push_back(static_cast<int>(s));
  return crowd;
}

std::vector<double> wanted_of(const Sampled_balls_3& balls, bool is_crowded, double finest) {
  return wanted_spacing(balls, is_crowded ? crowd_of(balls) : std::vector<int>{}, finest);
}

/// Returns how many samples were added.
std::size_t refine(Sampled_balls_3& balls, const Solid_3& solid, const Refinement& how) {
  Progress progress({}, {}, how.threads);
  const std::vector<double> wanted = wanted_of(balls, how.is_crowded, how.finest);
  const std::size_t count = add_samples(balls, solid.surface, wanted, how.gap, progress);
  balls.triangulate(solid, progress);
  return count;
}

/// Until nothing is added. Returns whether that came soon.
bool settle(Sampled_balls_3& balls, const Solid_3& solid, const Refinement& how) {
  constexpr int enough_rounds = 12;
  for (int round = 0; round < enough_rounds; ++round)
    if (refine(balls, solid, how) == 0) return true;
  return false;
}

std::vector<std::array<int, 2>> delaunay_edges(const Delaunay_3& delaunay) {
  std::vector<std::array<int, 2>> edges;
  for (const auto& cell : delaunay.cells)
    for (const int a : cell)
      for (const int b : cell)
        if (a != b) edges.push_back({a, b});
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// By going over all edges until nothing changes.
std::vector<double> slow_wanted_spacing(const Sampled_balls_3& balls, bool is_crowded, double finest) {
  const std::vector<double>& before = balls.samples.spacing;
  std::vector<double> wish = before;
  for (std::size_t s = 0; s < wish.size(); ++s)
    if (balls.poles()[s] < 0) wish[s] = 0;
  if (is_crowded)
    for (const int s : crowd_of(balls)) wish[s] = 0;
  std::vector<double> own = before;
  for (std::size_t s = 0; s < wish.size(); ++s) {
    const double spacing = std::max({wish[s], before[s] / 2, finest});
    if (spacing < 0.8 * before[s]) own[s] = spacing;
  }
  const auto edges = delaunay_edges(balls.delaunay());
  const auto length = [&](int a, int b) { return distance(balls.samples.points[a], balls.samples.points[b]); };
  std::vector<double> wanted = own;
  for (const auto& [a, b] : edges)
    if (own[a] < before[a] && length(a, b) < 1.5 * before[a]) wanted[b] = std::min(wanted[b], own[a]);
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (const auto& [a, b] : edges) {
      if (wanted[a] >= before[a]) continue;
      const double most = wanted[a] + slope * length(a, b);
      if (most >= wanted[b]) continue;
      wanted[b] = most;
      has_changed = true;
    }
  }
  return wanted;
}

struct Named_solid {
  std::string name;
  Solid_3 solid;
  double spacing;
};
std::vector<Named_solid> solids() {
  return {{"plate", solid_of(box_mesh({0, 0, 0}, {2, 2, 0.1})), 0.2},
          {"blade", solid_of(column_mesh({{0, 0}, {1, -0.1}, {1, 0.1}}, 1)), 0.1},
          {"hollow sphere", solid_of(joined({sphere_mesh({0, 0, 0}, 1), turned(sphere_mesh({0.1, 0, 0}, 0.8))})), 0.3},
          {"torus", solid_of(torus_mesh(1, 0.1)), 0.2},
          {"cube", solid_of(box_mesh({0, 0, 0}, {1, 1, 1})), 0.2}};
}

TEST(Wanted_spacing_3, AsDefined) {
  for (const auto& [name, solid, spacing] : solids()) {
    Sampled_balls_3 balls = sampled(solid, spacing);
    for (int round = 0; round < 3; ++round) {
      for (const bool is_crowded : {false, true}) {
        const double finest = spacing / 5;
        const std::vector<double> wanted = wanted_of(balls, is_crowded, finest);
        EXPECT_EQ(wanted, slow_wanted_spacing(balls, is_crowded, finest)) << name << ' ' << round << ' ' << is_crowded;
      }
      refine(balls, solid, {true, spacing / 5});
    }
  }
}

TEST(Wanted_spacing_3, NeverGrowsAndChangesSlowly) {
  bool is_lowered = false;
  for (const auto& [name, solid, spacing] : solids()) {
    Sampled_balls_3 balls = sampled(solid, spacing);
    for (int round = 0; round < 4; ++round) {
      const double finest = spacing / 10;
      const std::vector<double>& before = balls.samples.spacing;
      const std::vector<double> wanted = wanted_of(balls, true, finest);
      ASSERT_EQ(wanted.size(), before.size());
      for (std::size_t s = 0; s < wanted.size(); ++s) {
        EXPECT_LE(wanted[s], before[s]) << name;
        EXPECT_GE(wanted[s], finest) << name;
        if (balls.poles()[s] < 0) {
          EXPECT_LE(wanted[s], std::max(0.5 * before[s], finest / 0.8)) << name;
        }
      }
      for (const auto& [a, b] : delaunay_edges(balls.delaunay())) {
        if (wanted[a] >= before[a]) continue;
        is_lowered = true;
        EXPECT_LE(wanted[b], wanted[a] + slope * distance(balls.samples.points[a], balls.samples.points[b])) << name;
      }
      refine(balls, solid, {true, finest});
    }
  }
  EXPECT_TRUE(is_lowered);
}

TEST(Wanted_spacing_3, StaysWhereTheSolidIsThick) {
  const Solid_3 solid = solid_of(sphere_mesh({0, 0, 0}, 1, 24));
  const Sampled_balls_3 balls = sampled(solid, 0.1);
  EXPECT_EQ(wanted_spacing(balls, {}, 0.001), balls.samples.spacing);
}

TEST(Wanted_spacing_3, IsHalfWhereItIsCrowded) {
  const Solid_3 solid = solid_of(sphere_mesh({0, 0, 0}, 1, 24));
  Sampled_balls_3 balls = sampled(solid, 0.1);
  const std::vector<int> crowded = crowd_of(balls);
  const std::vector<double> wanted = wanted_spacing(balls, crowded, 0.001);
  for (const int s : crowded) EXPECT_EQ(wanted[s], 0.05);
  EXPECT_EQ(*std::ranges::min_element(wanted), 0.05);
  EXPECT_EQ(*std::ranges::max_element(wanted), 0.1);
  const std::vector<double> little = wanted_spacing(balls, crowded, 0.09);
  EXPECT_EQ(little, balls.samples.spacing) << "a little less is not worth it";
}

/// What is wanted at a point of the surface.
double spacing_at(const Surface_samples_3& samples, const Point_3& p) {
  double spacing = samples.covering_radius;
  for (std::size_t s = 0; s < samples.points.size(); ++s)
    spacing = std::min(spacing, samples.spacing[s] + slope * distance(p, samples.points[s]));
  return spacing;
}

TEST(Add_samples_3, LeaveNoPlaceWithoutOneWithinTheWantedSpacing) {
  for (const auto& [name, solid, spacing] : solids()) {
    Sampled_balls_3 balls = sampled(solid, spacing);
    for (int round = 0; round < 3; ++round) {
      const Surface_samples_3 before = balls.samples;
      const std::vector<double> wanted = wanted_of(balls, true, spacing / 10);
      Progress progress;
      const std::size_t added = add_samples(balls, solid.surface, wanted, 0.3 * spacing, progress);
      const Surface_samples_3& samples = balls.samples;
      ASSERT_EQ(samples.points.size(), before.points.size() + added) << name;
      ASSERT_EQ(samples.normals.size(), samples.points.size());
      ASSERT_EQ(samples.spacing.size(), samples.points.size());
      EXPECT_TRUE(std::ranges::equal(before.points, std::span(samples.points).first(wanted.size())));
      EXPECT_TRUE(std::ranges::equal(wanted, std::span(samples.spacing).first(wanted.size())));
      for (std::size_t s = wanted.size(); s < samples.points.size(); ++s) {
        EXPECT_LT(distance_to(solid.surface, samples.points[s]), 1e-12);
        EXPECT_NEAR(dot(samples.normals[s], samples.normals[s]), 1, 1e-12);
        EXPECT_GE(samples.spacing[s], spacing / 10);
        EXPECT_LE(samples.spacing[s], spacing);
      }
      for (const Point_3& p : random_surface_points(solid.surface, 1500, 9))
        ASSERT_LE(distance_to_nearest(samples.points, p), spacing_at(samples, p)) << name << ' ' << round;
      balls.triangulate(solid, progress);
    }
  }
}

TEST(Add_samples_3, KeepTheirDistance) {
  for (const auto& [name, solid, spacing] : solids()) {
    Sampled_balls_3 balls = sampled(solid, spacing);
    for (int round = 0; round < 3; ++round) refine(balls, solid, {true, spacing / 10});
    const Surface_samples_3& samples = balls.samples;
    for (std::size_t i = 0; i < samples.points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        ASSERT_GE(distance(samples.points[i], samples.points[j]),
                  0.7 * std::min(samples.spacing[i], samples.spacing[j]) * (1 - 1e-9))
            << name << ' ' << i << ' ' << j;
  }
}

TEST(Add_samples_3, BringTheSpheresOfPolesNearTheSurface) {
  // The inner poles of an even sampling leave creases that point inward far from their spheres.
  const Solid_3 solid = solid_of(column_mesh({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}, 1));
  const double spacing = 0.2;
  const double gap = 0.2 * spacing;
  Sampled_balls_3 balls = sampled(solid, spacing);
  const std::vector<Point_3> places = random_surface_points(solid.surface, 3000, 11);
  const auto is_missed = [&](const Point_3& p) {
    if (distance_to_nearest(balls.samples.points, p) < 0.3 * spacing_at(balls.samples, p)) return false;
    double deviation = std::numeric_limits<double>::infinity();
    for (const int c : balls.poles())
      if (c >= 0)
        deviation =
            std::min(deviation, distance(p, balls.delaunay().circumcenters[c]) - balls.delaunay().circumradii[c]);
    return std::abs(deviation) > 1.5 * gap;
  };
  const auto missed_before = std::ranges::count_if(places, is_missed);
  EXPECT_GT(missed_before, 30);
  ASSERT_TRUE(settle(balls, solid, {false, spacing / 8, gap}));
  EXPECT_EQ(std::ranges::count_if(places, is_missed), 0);
}

TEST(Add_samples_3, AddNoneToWhatIsSettled) {
  for (const auto& [name, solid, spacing] : solids()) {
    for (const bool is_crowded : {false, true}) {
      const Refinement how{is_crowded, spacing / 10, 0.3 * spacing};
      Sampled_balls_3 balls = sampled(solid, spacing);
      ASSERT_TRUE(settle(balls, solid, how)) << name;
      const std::size_t count = balls.samples.points.size();
      EXPECT_EQ(std::ranges::count(balls.is_settled, 1), std::ssize(balls.is_settled)) << name;
      EXPECT_EQ(refine(balls, solid, how), 0u) << name;
      // Nor where it is looked at everywhere once more.
      std::ranges::fill(balls.is_settled, 0);
      EXPECT_EQ(refine(balls, solid, how), 0u) << name << ' ' << is_crowded;
      EXPECT_EQ(balls.samples.points.size(), count);
    }
  }
}

TEST(Triangulate_samples_3, KeepsSettledWhatKeepsItsPole) {
  // Without symmetries, where other cells would have the same spheres.
  Triangle_mesh_3 mesh = torus_mesh(1, 0.3, 40, 20);
  Random random(2);
  for (Point_3& p : mesh.vertices) p = p + 0.01 * Point_3{random.unit(), random.unit(), random.unit()};
  const Solid_3 solid = solid_of(mesh);
  Sampled_balls_3 balls = sampled(solid, 0.1);
  EXPECT_EQ(std::ranges::count(balls.is_settled, 0), std::ssize(balls.samples.points));
  std::ranges::fill(balls.is_settled, 1);
  const auto pole_of = [&](std::size_t s) {
    return balls.poles()[s] < 0 ? Point_3{9, 9, 9} : balls.delaunay().circumcenters[balls.poles()[s]];
  };
  std::vector<Point_3> before;
  for (std::size_t s = 0; s < balls.poles().size(); ++s) before.push_back(pole_of(s));
  balls.samples.points.push_back({-1.29, 0.03, 0.02});
  balls.samples.normals.push_back({-1, 0, 0});
  balls.samples.spacing.push_back(0.1);
  Progress progress;
  balls.triangulate(solid, progress);
  ASSERT_EQ(balls.is_settled.size(), before.size() + 1);
  EXPECT_EQ(balls.is_settled.back(), 0);
  std::size_t kept = 0;
  for (std::size_t s = 0; s < before.size(); ++s) {
    kept += balls.is_settled[s];
    if (distance(pole_of(s), before[s]) > 1e-9) {
      EXPECT_EQ(balls.is_settled[s], 0) << s;
    }
    if (balls.samples.points[s].x > 0.2) {
      EXPECT_EQ(balls.is_settled[s], 1) << s;
    }
  }
  EXPECT_GT(kept, before.size() / 2);
  EXPECT_LT(kept, before.size());
}

TEST(Refined_samples_3, AreTheSameForEveryNumberOfThreads) {
  const Solid_3 solid = solid_of(torus_mesh(1, 0.05, 180, 30));
  std::vector<Sampled_balls_3> results;
  for (const int threads : {1, 2}) {
    Sampled_balls_3& balls = results.emplace_back(sampled(solid, 0.08, threads));
    for (int round = 0; round < 3; ++round) refine(balls, solid, {true, 0.01, 0.02, threads});
  }
  for (const Sampled_balls_3& other : results) {
    EXPECT_EQ(other.samples.points, results[0].samples.points);
    EXPECT_EQ(other.samples.normals, results[0].samples.normals);
    EXPECT_EQ(other.samples.spacing, results[0].samples.spacing);
    EXPECT_EQ(other.poles(), results[0].poles());
    EXPECT_EQ(other.is_settled, results[0].is_settled);
  }
}

}  // namespace
}  // namespace mesecina::test

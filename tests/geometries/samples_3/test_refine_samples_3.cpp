// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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
  triangulate_samples(balls, solid, progress);
  return balls;
}

struct Refinement {
  bool also_thin_parts = false;
  double finest = 0;
  double gap = std::numeric_limits<double>::infinity();
  int threads = 1;
};

/// Returns how many samples were added.
std::size_t refine(Sampled_balls_3& balls, const Solid_3& solid, const Refinement& how) {
  Progress progress({}, {}, how.threads);
  const std::vector<double> wanted = wanted_spacing(balls, how.also_thin_parts, how.finest);
  const std::size_t count = add_samples(balls, solid.surface, wanted, how.gap, progress);
  triangulate_samples(balls, solid, progress);
  return count;
}

/// Until nothing is added. Returns whether that came soon.
bool settle(Sampled_balls_3& balls, const Solid_3& solid, const Refinement& how) {
  constexpr int enough_rounds = 12;
  for (int round = 0; round < enough_rounds; ++round)
    if (refine(balls, solid, how) == 0) return true;
  return false;
}

double angle(const Point_3& u, const Point_3& v) {
  return std::atan2(std::sqrt(dot(cross(u, v), cross(u, v))), dot(u, v)) * 180 / std::numbers::pi;
}

/// Pairs of corners of a cell that lie on both sides of a thin part, by angles.
std::vector<std::array<int, 2>> opposite_corners(const Sampled_balls_3& balls, std::size_t cell) {
  std::vector<std::array<int, 2>> pairs;
  const Point_3& center = balls.delaunay.circumcenters[cell];
  for (const int a : balls.delaunay.cells[cell]) {
    for (const int b : balls.delaunay.cells[cell]) {
      if (b <= a) continue;
      const Point_3 to_a = balls.samples.points[a] - center;
      const Point_3 to_b = balls.samples.points[b] - center;
      const Point_3& normal_a = balls.samples.normals[a];
      const Point_3& normal_b = balls.samples.normals[b];
      if (angle(to_a, to_b) > 120 && angle(normal_a, normal_b) > 120 && angle(to_a, normal_a) < 90 &&
          angle(to_b, normal_b) < 90)
        pairs.push_back({a, b});
    }
  }
  return pairs;
}

std::vector<int> slow_thin_cells(const Sampled_balls_3& balls, double factor) {
  std::vector<int> thin;
  for (std::size_t c = 0; c < balls.delaunay.cells.size(); ++c) {
    double spacing = 0;
    for (const int s : balls.delaunay.cells[c]) spacing = std::max(spacing, balls.samples.spacing[s]);
    if (balls.delaunay.circumradii[c] <= factor * spacing && !opposite_corners(balls, c).empty())
      thin.push_back(static_cast<int>(c));
  }
  return thin;
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
std::vector<double> slow_wanted_spacing(const Sampled_balls_3& balls, bool also_at_thin_parts, double finest) {
  const std::vector<double>& before = balls.samples.spacing;
  std::vector<double> wish = before;
  for (std::size_t s = 0; s < wish.size(); ++s)
    if (balls.poles[s] < 0) wish[s] = 0;
  if (also_at_thin_parts)
    for (const int c : slow_thin_cells(balls, 1))
      for (const auto& pair : opposite_corners(balls, c))
        for (const int s : pair) wish[s] = std::min(wish[s], 0.8 * balls.delaunay.circumradii[c]);
  std::vector<double> own = before;
  for (std::size_t s = 0; s < wish.size(); ++s) {
    const double spacing = std::max({wish[s], before[s] / 2, finest});
    if (spacing < 0.8 * before[s]) own[s] = spacing;
  }
  const auto edges = delaunay_edges(balls.delaunay);
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

TEST(Thin_cells_3, AsDefined) {
  std::size_t count = 0;
  for (const auto& [name, solid, spacing] : solids()) {
    Sampled_balls_3 balls = sampled(solid, spacing);
    for (std::size_t s = 0; s < balls.samples.spacing.size(); s += 3) balls.samples.spacing[s] /= 2;
    for (const double factor : {0.3, 1.0, 2.0}) {
      const std::vector<int> thin = thin_cells(balls.samples, balls.delaunay, factor);
      EXPECT_EQ(thin, slow_thin_cells(balls, factor)) << name;
      count += thin.size();
    }
  }
  EXPECT_GT(count, 1000u);
}

TEST(Thin_cells_3, LieInsideOfAPlateAllOverIt) {
  const Solid_3 solid = solid_of(box_mesh({0, 0, 0}, {2, 2, 0.2}));
  const Sampled_balls_3 balls = sampled(solid, 0.15);
  std::vector<Point_3> centers;
  for (const int c : thin_cells(balls.samples, balls.delaunay, 2)) centers.push_back(balls.delaunay.circumcenters[c]);
  for (const Point_3& p : centers) EXPECT_EQ(place_of(solid.surface, p), Place::inside);
  Random random(3);
  for (int i = 0; i < 500; ++i)
    EXPECT_LT(distance_to_nearest(centers, {random.uniform(0.2, 1.8), random.uniform(0.2, 1.8), 0.1}), 0.2);
}

TEST(Thin_cells_3, AreNotThereInThickSolidsAndBetweenSolids) {
  const Solid_3 cube = solid_of(box_mesh({0, 0, 0}, {1, 1, 1}));
  const Solid_3 spheres = solid_of(joined({sphere_mesh({0, 0, 0}, 1, 24), sphere_mesh({2.05, 0, 0}, 1, 24)}));
  for (const Solid_3* solid : {&cube, &spheres}) {
    const Sampled_balls_3 balls = sampled(*solid, 0.1);
    EXPECT_TRUE(thin_cells(balls.samples, balls.delaunay, 2).empty());
  }
}

TEST(Wanted_spacing_3, AsDefined) {
  for (const auto& [name, solid, spacing] : solids()) {
    Sampled_balls_3 balls = sampled(solid, spacing);
    for (int round = 0; round < 3; ++round) {
      for (const bool also_thin : {false, true}) {
        const double finest = spacing / 5;
        const std::vector<double> wanted = wanted_spacing(balls, also_thin, finest);
        EXPECT_EQ(wanted, slow_wanted_spacing(balls, also_thin, finest)) << name << ' ' << round << ' ' << also_thin;
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
      const std::vector<double> wanted = wanted_spacing(balls, true, finest);
      ASSERT_EQ(wanted.size(), before.size());
      for (std::size_t s = 0; s < wanted.size(); ++s) {
        EXPECT_LE(wanted[s], before[s]) << name;
        EXPECT_GE(wanted[s], finest) << name;
        if (balls.poles[s] < 0) {
          EXPECT_LE(wanted[s], std::max(0.5 * before[s], finest / 0.8)) << name;
        }
      }
      for (const auto& [a, b] : delaunay_edges(balls.delaunay)) {
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
  EXPECT_EQ(wanted_spacing(balls, true, 0.001), balls.samples.spacing);
}

TEST(Wanted_spacing_3, HalvesInAPlateUntilItIsThick) {
  const Solid_3 solid = solid_of(box_mesh({0, 0, 0}, {2, 2, 0.1}));
  Sampled_balls_3 balls = sampled(solid, 0.2);
  const std::vector<double> wanted = wanted_spacing(balls, true, 0.001);
  EXPECT_NEAR(*std::ranges::min_element(wanted), 0.1, 1e-12);
  ASSERT_TRUE(settle(balls, solid, {true, 0.001}));
  // Circumscribed balls of the plate have a radius of 0.05 at least; less than 0.8 of that is not wanted for them.
  for (std::size_t s = 0; s < balls.samples.points.size(); ++s) {
    const Point_3& p = balls.samples.points[s];
    if (std::min({p.x, p.y, 2 - p.x, 2 - p.y}) < 0.3) continue;
    EXPECT_GE(balls.samples.spacing[s], 0.8 * 0.05);
    EXPECT_LE(balls.samples.spacing[s], 0.1);
  }
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
      const Sampled_balls_3 before = balls;
      const std::vector<double> wanted = wanted_spacing(balls, true, spacing / 10);
      Progress progress;
      const std::size_t added = add_samples(balls, solid.surface, wanted, 0.3 * spacing, progress);
      const Surface_samples_3& samples = balls.samples;
      ASSERT_EQ(samples.points.size(), before.samples.points.size() + added) << name;
      ASSERT_EQ(samples.normals.size(), samples.points.size());
      ASSERT_EQ(samples.spacing.size(), samples.points.size());
      EXPECT_TRUE(std::ranges::equal(before.samples.points, std::span(samples.points).first(wanted.size())));
      EXPECT_TRUE(std::ranges::equal(wanted, std::span(samples.spacing).first(wanted.size())));
      for (std::size_t s = wanted.size(); s < samples.points.size(); ++s) {
        EXPECT_LT(distance_to(solid.surface, samples.points[s]), 1e-12);
        EXPECT_NEAR(dot(samples.normals[s], samples.normals[s]), 1, 1e-12);
        EXPECT_GE(samples.spacing[s], spacing / 10);
        EXPECT_LE(samples.spacing[s], spacing);
      }
      for (const Point_3& p : random_surface_points(solid.surface, 1500, 9))
        ASSERT_LE(distance_to_nearest(samples.points, p), spacing_at(samples, p)) << name << ' ' << round;
      triangulate_samples(balls, solid, progress);
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
    for (const int c : balls.poles)
      if (c >= 0)
        deviation = std::min(deviation, distance(p, balls.delaunay.circumcenters[c]) - balls.delaunay.circumradii[c]);
    return std::abs(deviation) > 1.5 * gap;
  };
  const auto missed_before = std::ranges::count_if(places, is_missed);
  EXPECT_GT(missed_before, 30);
  ASSERT_TRUE(settle(balls, solid, {false, spacing / 8, gap}));
  EXPECT_EQ(std::ranges::count_if(places, is_missed), 0);
}

TEST(Add_samples_3, AddNoneToWhatIsSettled) {
  for (const auto& [name, solid, spacing] : solids()) {
    for (const bool also_thin : {false, true}) {
      const Refinement how{also_thin, spacing / 10, 0.3 * spacing};
      Sampled_balls_3 balls = sampled(solid, spacing);
      ASSERT_TRUE(settle(balls, solid, how)) << name;
      const std::size_t count = balls.samples.points.size();
      EXPECT_EQ(std::ranges::count(balls.is_settled, 1), std::ssize(balls.is_settled)) << name;
      EXPECT_EQ(refine(balls, solid, how), 0u) << name;
      // Nor where it is looked at everywhere once more.
      std::ranges::fill(balls.is_settled, 0);
      EXPECT_EQ(refine(balls, solid, how), 0u) << name << ' ' << also_thin;
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
    return balls.poles[s] < 0 ? Point_3{9, 9, 9} : balls.delaunay.circumcenters[balls.poles[s]];
  };
  std::vector<Point_3> before;
  for (std::size_t s = 0; s < balls.poles.size(); ++s) before.push_back(pole_of(s));
  balls.samples.points.push_back({-1.29, 0.03, 0.02});
  balls.samples.normals.push_back({-1, 0, 0});
  balls.samples.spacing.push_back(0.1);
  Progress progress;
  triangulate_samples(balls, solid, progress);
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
    EXPECT_EQ(other.poles, results[0].poles);
    EXPECT_EQ(other.is_settled, results[0].is_settled);
  }
}

}  // namespace
}  // namespace mesecina::test

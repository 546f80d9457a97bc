// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "core/formats/format.h"
#include "geometries/samples_3/ball_approximation_3.h"
#include "geometries/union_3/union_3.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"
#include "tests/geometries/solid_3/meshes_3.h"
#include "tests/geometries/union_3/alpha_complex_3.h"
#include "tests/geometries/union_3/ball_sets.h"

/// The dual complex beside GUDHI's weighted alpha complex. Both take the simplices whose power faces meet the closed
/// balls, so what touches in a point is the same too. Where a regular triangulation is not unique (several cells with
/// one orthogonal sphere, power cells without volume), CGAL's triangulations, of space and of any dimension, break ties
/// by the order of positions. So all simplices must be the same, and all balls that are left out, everywhere.
namespace mesecina::test {
namespace {

std::size_t size_of(const Simplex_3& simplex) { return 4 - std::ranges::count(simplex, -1); }
std::string name_of(const Simplex_3& simplex) {
  std::string result = "{";
  for (const int ball : simplex)
    if (ball >= 0) result += (result.size() > 1 ? " " : "") + std::to_string(ball);
  return result + "}";
}

/// Ours: all simplices of the triangulation, and whether they are in the complex.
using Complex = std::map<Simplex_3, bool>;
testing::AssertionResult collect(const Dual_3& dual, Complex& complex) {
  const Regular_3& regular = *dual.regular;
  for (const auto& cell : regular.cells)
    for (unsigned chosen = 1; chosen < 16; ++chosen) {
      std::vector<int> balls;
      for (unsigned i = 0; i < 4; ++i)
        if (chosen >> i & 1u) balls.push_back(cell[i]);
      if (std::ranges::count(balls, -1) == 0) complex.emplace(simplex_of(balls), false);
    }
  std::size_t count = 0;
  const auto add = [&](std::span<const int> balls) {
    const auto it = complex.find(simplex_of(balls));
    if (it != complex.end() && !it->second) ++count;
    complex[simplex_of(balls)] = true;
  };
  std::size_t all = dual.edges.size() + dual.triangles.size();
  for (int i = 0; i < static_cast<int>(dual.vertices.size()); ++i)
    if (dual.vertices[i] != Simplex_kind_3::outside) {
      ++all;
      add(std::array{i});
    }
  for (const Dual_3::Edge& e : dual.edges) add(e.balls);
  for (const Dual_3::Triangle& t : dual.triangles) add(t.balls);
  for (std::size_t i = 0; i < dual.has_cell.size(); ++i)
    if (dual.has_cell[i]) {
      ++all;
      add(regular.cells[i]);
    }
  if (count != all) return failure() << "a simplex is there twice, or not in the triangulation";
  return testing::AssertionSuccess();
}

testing::AssertionResult agrees(const std::vector<Ball_3>& balls, const Alpha_complex& theirs) {
  Progress progress;
  const Dual_3 dual = dual_complex(std::make_shared<const Regular_3>(regular_triangulation(balls, progress)), progress);
  Complex ours;
  if (const auto result = collect(dual, ours); !result) return result;
  for (const auto& [simplex, value] : theirs.values)
    if (!ours.contains(simplex)) return failure() << name_of(simplex) << " is only in their triangulation";
  for (const auto& [simplex, is_in] : ours) {
    const auto it = theirs.values.find(simplex);
    if (it == theirs.values.end()) return failure() << name_of(simplex) << " is only in our triangulation";
    if (is_in != (it->second <= 0))
      return failure() << name_of(simplex) << " is only in " << (is_in ? "ours" : "theirs") << "; it appears at "
                       << it->second;
  }
  const Topology found = topology(dual);
  if (found == theirs.topology) return testing::AssertionSuccess();
  return failure() << "Betti numbers " << testing::PrintToString(found.betti) << ", theirs "
                   << testing::PrintToString(theirs.topology.betti);
}

bool is_spatial(const Alpha_complex& complex) {
  return std::ranges::any_of(complex.values, [](const auto& entry) { return size_of(entry.first) == 4; });
}

/// Beside both, where there are both.
testing::AssertionResult agrees_with_gudhi(const std::vector<Ball_3>& balls) {
  const Alpha_complex theirs = alpha_complex(balls);
  const auto result = agrees(balls, theirs);
  if (!result || !is_spatial(theirs)) return result;
  return agrees(balls, alpha_complex_of_space(balls));
}

TEST(Alpha_complex_3, of_difficult_and_random_sets_is_the_dual_complex) {
  expect_of_balls(repetitions(40), [](const std::vector<Ball_3>& balls) {
    return may_underflow(balls) ? testing::AssertionSuccess() : agrees_with_gudhi(balls);
  });
}

TEST(Alpha_complex_3, knows_the_topology_of_simple_unions) {
  for (const Named_balls& set : difficult_ball_sets()) {
    SCOPED_TRACE(set.name);
    EXPECT_EQ(alpha_complex(set.balls).topology.betti, set.betti);
  }
}

TEST(Alpha_complex_3, of_random_balls_is_the_dual_complex) {
  for (const int count : {1, 2, 3, 4, 5, 10, 50, 200})
    for (const double neighbors : {1.0, 5.0, 30.0})
      for (std::uint64_t seed = 0; seed < repetitions(3); ++seed) {
        SCOPED_TRACE(std::to_string(count) + " balls, " + std::to_string(neighbors) + " neighbors");
        EXPECT_TRUE(agrees_with_gudhi(many_balls(count, neighbors, seed)));
      }
}

TEST(Alpha_complex_3, of_many_random_balls_is_the_dual_complex) {
  for (const double neighbors : {2.0, 20.0}) {
    SCOPED_TRACE(neighbors);
    const std::vector<Ball_3> balls = many_balls(3000, neighbors, 1);
    EXPECT_TRUE(agrees(balls, alpha_complex_of_space(balls)));
  }
}

/// Equal balls that are points, touch, cross around cavities, or fill all: every cell has eight corners on one sphere.
TEST(Alpha_complex_3, of_lattices_is_the_dual_complex) {
  constexpr int side = 5;
  for (const double radius : {0.0, 4.0, 6.0, 7.0}) {
    SCOPED_TRACE(radius);
    std::vector<Ball_3> balls;
    for (int i = 0; i < side * side * side; ++i)
      balls.push_back({{8.0 * (i % side), 8.0 * (i / side % side), 8.0 * (i / side / side)}, radius});
    EXPECT_TRUE(agrees_with_gudhi(balls));
  }
}

/// Many balls in a plane, or on a line.
TEST(Alpha_complex_3, of_flat_sets_is_the_dual_complex) {
  for (const bool is_line : {false, true})
    for (std::uint64_t seed = 0; seed < repetitions(5); ++seed) {
      std::vector<Ball_3> balls = many_balls(80, 3, seed);
      for (Ball_3& b : balls) {
        b.center.z = 2;
        if (is_line) b.center.y = -1;
      }
      EXPECT_TRUE(agrees_with_gudhi(balls)) << (is_line ? "line, seed " : "plane, seed ") << seed;
    }
}

/// Nested and equal balls among many: both leave out the same.
TEST(Alpha_complex_3, leaves_out_the_balls_that_are_hidden) {
  for (std::uint64_t seed = 0; seed < repetitions(5); ++seed) {
    std::vector<Ball_3> balls = many_balls(60, 8, seed);
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      const Ball_3& b = balls[i];
      balls.push_back(random.chance(0.3) ? b
                                         : Ball_3{b.center + (0.2 * b.radius) * Point_3{1, -0.5, 0.3}, 0.3 * b.radius});
    }
    const Alpha_complex theirs = alpha_complex_of_space(balls);
    Progress progress;
    const Regular_3 ours = regular_triangulation(balls, progress);
    std::size_t hidden = 0;
    for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
      EXPECT_EQ(ours.cell_of_ball[i] < 0, !theirs.values.contains(simplex_of(std::array{i}))) << i;
      if (ours.cell_of_ball[i] < 0) ++hidden;
    }
    EXPECT_GE(hidden, 30u);
    EXPECT_TRUE(agrees(balls, theirs));
  }
}

TEST(Alpha_complex_3, of_real_balls_is_the_dual_complex) {
  MESECINA_NEED_DATA();
  const auto atoms = read_file(spatial_formats(), *data_folder() / "3d" / "balls_caffeine.cin").inputs.get(balls_input);
  for (const double factor : {0.5, 1.0, 1.5, 2.0}) {
    SCOPED_TRACE(factor);
    std::vector<Ball_3> balls = *atoms;
    for (Ball_3& b : balls) b.radius *= factor;
    EXPECT_TRUE(agrees_with_gudhi(balls));
  }
}

/// Balls that approximate a mesh, as they are and with the roundings of centers and radii that leave many spheres
/// nearly through one point; and grown, as for a scale axis.
void expect_agreement_on_mesh(const std::string& file) {
  const Solid_3 solid = solid_of(real_mesh(file));
  Box box;
  for (const Point_3& p : solid.surface.vertices) box.add(p);
  for (const double perturbation : {1e-4, 0.0}) {
    SCOPED_TRACE(perturbation);
    Progress progress;
    std::vector<Ball_3> balls = approximate_by_balls(solid, 0.04 * box.diagonal(), perturbation, progress).balls;
    EXPECT_GT(balls.size(), 500u);
    for (const double scale : {1.0, 1.2}) {
      SCOPED_TRACE(scale);
      for (Ball_3& b : balls) b.radius *= scale;
      EXPECT_TRUE(agrees(balls, alpha_complex_of_space(balls)));
    }
  }
}
TEST(Alpha_complex_3, of_a_kitten_is_the_dual_complex) {
  MESECINA_NEED_DATA();
  expect_agreement_on_mesh("kitten.obj");
}
TEST(Alpha_complex_3, of_a_fandisk_is_the_dual_complex) {
  MESECINA_NEED_DATA();
  expect_agreement_on_mesh("fandisk.off");
}

}  // namespace
}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/geometries/union/disk_sets.h"
#include "tests/geometries/union/union_oracle.h"

namespace mesecina::test {
namespace {

Power_oracle power_of(std::vector<Disk_2> disks) { return Power_oracle(exact_disks(given_balls(disks))); }
Union_oracle union_of(const std::string& name) {
  for (const Named_disks& set : difficult_disk_sets())
    if (set.name == name) return union_oracle(given_balls(set.disks));
  throw std::invalid_argument(name);
}

TEST(Power_oracle, signs_with_roots) {
  EXPECT_EQ(sign_with_root(-3, 2, 2), -1);
  EXPECT_EQ(sign_with_root(-3, 2, 3), 1);
  EXPECT_EQ(sign_with_root(3, -2, 3), -1);
  EXPECT_EQ(sign_with_root(-4, 2, 4), 0);
  EXPECT_EQ(sign_with_root(0, -1, 5), -1);
  EXPECT_EQ(sign_with_root(1, -1, 0), 1);
}

TEST(Power_oracle, knows_simple_diagrams) {
  const Power_oracle two = power_of({{{0, 0}, 5}, {{6, 0}, 5}});
  EXPECT_TRUE(two.edge(0, 1).has_length());
  EXPECT_EQ(*two.minimum_on_edge(0, 1), Rational(-16));
  EXPECT_EQ(*two.minimum_on_cell(0), Rational(-25));
  EXPECT_FALSE(two.is_hidden(0));

  const Power_oracle pencil = power_of({{{-3, 0}, 5}, {{0, 0}, 4}, {{3, 0}, 5}});
  EXPECT_FALSE(pencil.is_hidden(0));
  EXPECT_TRUE(pencil.is_hidden(1));
  EXPECT_FALSE(pencil.is_hidden(2));

  const Power_oracle square = power_of({{{0, 0}, 1}, {{2, 0}, 1}, {{2, 2}, 1}, {{0, 2}, 1}, {{0, 2}, 1}});
  EXPECT_TRUE(square.edge(0, 2).is_point());
  EXPECT_EQ(*square.minimum_on_edge(0, 2), Rational(1));
  EXPECT_EQ(*square.minimum_on_vertex(0, 1, 2), Rational(1));
  EXPECT_FALSE(square.is_hidden(3));
  EXPECT_TRUE(square.is_hidden(4));

  // Its own center belongs to the cell of the large disk: the nearest point of its cell is on the edge.
  const Power_oracle attached = power_of({{{0, 0}, 10}, {{8, 0}, 2}});
  EXPECT_EQ(*attached.minimum_on_cell(1), Rational(-4) + Rational(4));
  EXPECT_EQ(*attached.minimum_on_edge(0, 1), Rational(0));
}

TEST(Union_oracle, knows_vertices_arcs_and_topology) {
  struct Case {
    const char* name;
    std::size_t vertices;
    std::size_t arcs;
    int components;
    int holes;
  };
  for (const Case& c : std::vector<Case>{
           {"none", 0, 0, 0, 0},
           {"one", 0, 1, 1, 0},
           {"one point", 0, 1, 1, 0},
           {"two apart", 0, 2, 2, 0},
           {"two touching", 1, 2, 1, 0},
           {"two crossing", 2, 2, 1, 0},
           {"two touching from inside", 1, 1, 1, 0},
           {"two nested", 0, 1, 1, 0},
           {"two concentric", 0, 1, 1, 0},
           {"two equal", 0, 1, 1, 0},
           {"point on a circle", 1, 1, 1, 0},
           {"point in a disk", 0, 1, 1, 0},
           {"pencil through two points", 2, 2, 1, 0},
           {"pencil touching in one point", 1, 2, 1, 0},
           {"three through a point, which they surround", 3, 3, 1, 0},
           {"three through a point, on one side", 3, 3, 1, 0},
           {"four through a point", 4, 4, 1, 0},
           {"three around a hole", 6, 6, 1, 1},
           {"four around a hole, touching", 4, 8, 1, 1},
           {"four around a hole with a disk in it", 4, 9, 2, 1},
           {"chain of touching disks", 3, 6, 1, 0},
           {"ring with a hole", 24, 24, 1, 1},
           {"ring with an island in its hole", 24, 25, 2, 1},
       }) {
    SCOPED_TRACE(c.name);
    const Union_oracle u = union_of(c.name);
    EXPECT_EQ(u.vertices.size(), c.vertices);
    EXPECT_EQ(u.arcs.size(), c.arcs);
    EXPECT_EQ(u.component_count, c.components);
    EXPECT_EQ(u.hole_count, c.holes);
  }
}

TEST(Union_oracle, names_every_circle_through_a_vertex) {
  const Union_oracle pencil = union_of("pencil through two points");
  for (const Oracle_vertex& v : pencil.vertices) {
    EXPECT_EQ(v.sources, (std::vector<int>{0, 1, 2}));
    EXPECT_NEAR(std::abs(static_cast<double>(v.y)), 4, 1e-15);
  }
  const Union_oracle touching = union_of("pencil touching in one point");
  EXPECT_EQ(touching.vertices.at(0).sources, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Union_oracle, takes_doubles_for_what_they_are) {
  const auto disk = [](double x, double r) { return Exact_disk{x, 0, Rational(Rational(r) * Rational(r))}; };
  EXPECT_TRUE(disks_meet(disk(0, 1), disk(3, 2)));
  EXPECT_FALSE(disks_meet(disk(0, 1), disk(std::nextafter(3.0, 4.0), 2)));
  EXPECT_TRUE(disks_meet(disk(0, 0.1), disk(0.3, 0.2)));
  EXPECT_EQ(Rational(0.1) + Rational(0.2) > Rational(0.3), true);
}

TEST(Union_oracle, measures_area_and_distance) {
  EXPECT_NEAR(union_of("two apart").area(), 5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(union_of("two touching from inside").area(), 25 * std::numbers::pi, 1e-12);
  // Two disks of radius 2 at distance 3.
  const double half_angle = std::acos(0.75);
  const Union_oracle crossing = union_of("two crossing");
  EXPECT_NEAR(crossing.area(), 8 * std::numbers::pi - 8 * half_angle + 2 * 3 * std::sqrt(4 - 2.25) / 2, 1e-12);
  EXPECT_NEAR(crossing.boundary_distance({1.5, 0}), std::sqrt(4 - 2.25), 1e-15);
  EXPECT_NEAR(crossing.boundary_distance({-3, 0}), 1, 1e-15);
  EXPECT_NEAR(crossing.vertex_distance({0, 0}), 2, 1e-15);
  EXPECT_NEAR(crossing.arc_distance({0, 0}), 2, 1e-15);
  EXPECT_NEAR(crossing.arc_distance({-1, 0}), 1, 1e-15);
  EXPECT_EQ(crossing.arc_distance({1.5, 0}), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(crossing.is_inside({4.9, 0}));
  EXPECT_FALSE(crossing.is_inside({5.1, 0}));
}

TEST(Union_oracle, agrees_with_counting_points_for_areas) {
  for (const Disk_family& family : disk_families()) {
    if (family.name == "extreme scale" || family.name == "far away") continue;
    SCOPED_TRACE(family.name);
    const Union_oracle u = union_oracle(given_balls(family.make(5)));
    // In columns, each measured exactly as a union of intervals.
    double area = 0;
    constexpr int columns = 4000;
    const double width = 4 * u.scale / columns;
    for (int column = 0; column < columns; ++column) {
      const double x = -2 * u.scale + (column + 0.5) * width;
      std::vector<std::pair<double, double>> intervals;
      for (std::size_t i = 0; i < u.centers.size(); ++i) {
        const double dx = x - u.centers[i].x;
        if (std::abs(dx) >= u.radii[i]) continue;
        const double half = std::sqrt(u.radii[i] * u.radii[i] - dx * dx);
        intervals.emplace_back(u.centers[i].y - half, u.centers[i].y + half);
      }
      std::ranges::sort(intervals);
      double reached = -1e300;
      for (const auto& [low, high] : intervals) {
        if (high <= reached) continue;
        area += width * (high - std::max(low, reached));
        reached = high;
      }
    }
    EXPECT_NEAR(u.area(), area, 1e-3 * (area + u.scale * u.scale));
  }
}

}  // namespace
}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "geometries/delaunay_3/delaunay_3.h"
#include "geometries/spatial_order_3.h"
#include "geometries/union_3/regular_3.h"
#include "geometries/union_3/union_3.h"
#include "geometries/union_3/vertex_delaunay_3.h"
#include "geometries/union_3/vertex_voronoi_3.h"
#include "tests/geometries/union_3/ball_sets.h"

/// Triangulations beside those of plain CGAL, one point after the other: the same cells, and the same arrays on every
/// number of threads.
namespace mesecina::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cells = std::vector<std::array<int, 4>>;
using Cell_set = std::set<std::array<int, 4>>;

const std::vector<int> thread_counts{2, 3, 8};

Progress on_threads(int count) { return Progress({}, {}, count); }

std::array<int, 4> sorted(std::array<int, 4> cell) {
  std::ranges::sort(cell);
  return cell;
}

Cell_set set_of(const Cells& cells) {
  Cell_set result;
  for (const auto& cell : cells) result.insert(sorted(cell));
  return result;
}

/// Of a triangulation with numbers in its vertices, those around the hull with -1.
template <class Triangulation>
Cell_set set_of_all_cells(Triangulation& triangulation) {
  triangulation.infinite_vertex()->info() = -1;
  Cell_set result;
  for (auto cell = triangulation.all_cells_begin(); cell != triangulation.all_cells_end(); ++cell)
    result.insert(
        sorted({cell->vertex(0)->info(), cell->vertex(1)->info(), cell->vertex(2)->info(), cell->vertex(3)->info()}));
  return result;
}

Cell_set plain_delaunay(const std::vector<Point_3>& points) {
  using Structure = CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>,
                                                         CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
  CGAL::Delaunay_triangulation_3<Kernel, Structure> triangulation;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(Kernel::Point_3(points[i].x, points[i].y, points[i].z));
    if (triangulation.number_of_vertices() > before) vertex->info() = static_cast<int>(i);
  }
  return set_of_all_cells(triangulation);
}

Cell_set plain_regular(const std::vector<Ball_3>& balls) {
  using Structure = CGAL::Triangulation_data_structure_3<
      CGAL::Triangulation_vertex_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>,
      CGAL::Regular_triangulation_cell_base_3<Kernel>>;
  CGAL::Regular_triangulation_3<Kernel, Structure> triangulation;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto& [c, r] = balls[i];
    const auto vertex = triangulation.insert(Kernel::Weighted_point_3({c.x, c.y, c.z}, r * r));
    if (vertex != decltype(vertex)()) vertex->info() = static_cast<int>(i);
  }
  return set_of_all_cells(triangulation);
}

/// Across from each corner lies a cell that has the three others.
void expect_neighbors(const Cells& cells, const Cells& neighbors) {
  ASSERT_EQ(cells.size(), neighbors.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    for (int i = 0; i < 4; ++i) {
      const int across = neighbors[c][i];
      if (across < 0) continue;
      ASSERT_TRUE(std::ranges::count(neighbors[across], static_cast<int>(c)) > 0);
      for (int k = 0; k < 4; ++k) {
        if (k == i) continue;
        ASSERT_TRUE(std::ranges::count(cells[across], cells[c][k]) > 0);
      }
    }
  }
}

struct Named_cloud {
  std::string name;
  std::vector<Point_3> points;
};

std::vector<Named_cloud> large_sets() {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> number(-1, 1);
  std::normal_distribution<double> normal;
  const auto in_cube = [&] { return Point_3{number(engine), number(engine), number(engine)}; };
  const auto on_sphere = [&](const Point_3& center, double radius) {
    const Point_3 away{normal(engine), normal(engine), normal(engine)};
    return center + (radius / distance(away, {})) * away;
  };
  constexpr int count = 12000;
  std::vector<Named_cloud> sets{{"cube", {}},     {"sphere", {}}, {"two far spheres", {}},
                                {"lattice", {}},  {"needle", {}}, {"flat lattice and a point", {}},
                                {"all twice", {}}};
  for (int i = 0; i < count; ++i) {
    sets[0].points.push_back(in_cube());
    sets[1].points.push_back(on_sphere({5, 5, 5}, 2));
    sets[2].points.push_back(on_sphere({i % 2 == 0 ? -1e4 : 1e4, 0, 0}, 1));
    sets[3].points.push_back({1.0 * (i % 23), 1.0 * (i / 23 % 23), 1.0 * (i / 529)});
    sets[4].points.push_back({1000 * number(engine), number(engine), number(engine)});
    sets[5].points.push_back({1.0 * (i % 110), 1.0 * (i / 110), i == 5000 ? 1.0 : 0.0});
  }
  sets[6].points = sets[0].points;
  sets[6].points.resize(count / 2);
  const std::vector<Point_3> copy = sets[6].points;
  sets[6].points.insert(sets[6].points.end(), copy.rbegin(), copy.rend());
  return sets;
}

TEST(Parallel_insertion_3, of_points_gives_the_cells_of_cgal_on_all_threads) {
  for (const auto& [name, points] : large_sets()) {
    SCOPED_TRACE(name);
    Progress alone;
    const Delaunay_3 expected = delaunay(points, alone);
    Cell_set plain = plain_delaunay(points);
    std::erase_if(plain, [](const auto& cell) { return cell[0] < 0; });
    EXPECT_TRUE(set_of(expected.cells) == plain);
    expect_neighbors(expected.cells, expected.neighbors);
    for (const int threads : thread_counts) {
      Progress progress = on_threads(threads);
      const Delaunay_3 found = delaunay(points, progress);
      EXPECT_TRUE(found.cells == expected.cells) << threads << " threads";
      EXPECT_TRUE(found.neighbors == expected.neighbors) << threads << " threads";
      EXPECT_TRUE(found.site == expected.site) << threads << " threads";
      EXPECT_TRUE(found.circumcenters == expected.circumcenters) << threads << " threads";
    }
  }
}

/// With balls that others hide, before or after these are there.
std::vector<Ball_3> balls_of_all_sizes(const std::vector<Point_3>& centers, double size) {
  std::mt19937 engine(8);
  std::exponential_distribution<double> radius(1 / size);
  std::vector<Ball_3> balls;
  for (const Point_3& center : centers) balls.push_back({center, radius(engine)});
  return balls;
}

TEST(Parallel_insertion_3, of_balls_gives_the_cells_of_cgal_on_all_threads) {
  for (const auto& [name, points] : large_sets()) {
    if (name == "all twice") continue;  // of equal centers the first of the largest is kept, CGAL keeps another
    for (const double size : {0.0, 0.02, 0.2, 2.0}) {
      SCOPED_TRACE(name + " " + std::to_string(size));
      const std::vector<Ball_3> balls = size == 0 ? balls_of_all_sizes(points, 1e-9) : balls_of_all_sizes(points, size);
      Progress alone;
      const Regular_3 expected = regular_triangulation(balls, alone);
      EXPECT_TRUE(set_of(expected.cells) == plain_regular(balls));
      expect_neighbors(expected.cells, expected.neighbors);
      for (const int threads : thread_counts) {
        Progress progress = on_threads(threads);
        const Regular_3 found = regular_triangulation(balls, progress);
        EXPECT_TRUE(found.cells == expected.cells) << threads << " threads";
        EXPECT_TRUE(found.neighbors == expected.neighbors) << threads << " threads";
        EXPECT_TRUE(found.cell_of_ball == expected.cell_of_ball) << threads << " threads";
      }
    }
  }
}

Vertex_voronoi_3 voronoi_of(const std::vector<Ball_3>& balls, int threads) {
  Progress progress = on_threads(threads);
  const auto regular = std::make_shared<const Regular_3>(regular_triangulation(balls, progress));
  const auto dual = std::make_shared<const Dual_3>(dual_complex(regular, progress));
  return vertex_voronoi(union_vertices(dual, progress), progress);
}

void expect_vertex_delaunay(const std::vector<Ball_3>& balls, std::size_t least_points) {
  const Vertex_voronoi_3 expected = voronoi_of(balls, 1);
  ASSERT_GT(expected.points.size(), least_points);
  EXPECT_TRUE(set_of(expected.cells) == plain_delaunay(expected.points));
  expect_neighbors(expected.cells, expected.neighbors);
  for (const int threads : thread_counts) {
    const Vertex_voronoi_3 found = voronoi_of(balls, threads);
    EXPECT_TRUE(found.points == expected.points) << threads << " threads";
    EXPECT_TRUE(found.cells == expected.cells) << threads << " threads";
    EXPECT_TRUE(found.neighbors == expected.neighbors) << threads << " threads";
    EXPECT_TRUE(found.is_inner == expected.is_inner) << threads << " threads";
  }
}

TEST(Parallel_insertion_3, of_vertices_of_a_union_gives_the_cells_of_cgal_on_all_threads) {
  expect_vertex_delaunay(many_balls(6000, 6, 1), 9000);
  for (const Smooth_solid& solid : smooth_solids()) {
    SCOPED_TRACE(solid.name);
    // Nearly all balls of a sphere are the ball that it bounds.
    const std::size_t least_points = solid.name == "sphere" ? 200 : 9000;
    expect_vertex_delaunay(inner_voronoi_balls(solid, 6000, 1e-4, 3), least_points);
  }
}

TEST(Parallel_insertion_3, of_vertices_of_balls_on_a_lattice) {
  // Each sphere has many vertices, in special position but for rounding.
  std::vector<Ball_3> balls;
  constexpr int side = 14;
  for (int i = 0; i < side * side * side; ++i) {
    const int x = i % side;
    const int y = i / side % side;
    const int z = i / (side * side);
    if ((x + y + z) % 2 == 0) balls.push_back({{2.0 * x, 2.0 * y, 2.0 * z}, 1.7});
  }
  expect_vertex_delaunay(balls, 9000);
}

TEST(Parallel_insertion_3, balls_that_have_no_points_near_their_spheres_do_no_harm) {
  // The balls only say where doubles may decide.
  std::vector<Point_3> points = large_sets()[0].points;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  Progress progress;
  sort_along_hilbert_curve(points, order, progress);
  std::vector<Point_3> along;
  for (const std::size_t i : order) along.push_back(points[i]);
  const std::vector<Ball_3> balls{{{0, 0, 0}, 1e-3}, {{0, 0, 0}, 0.5}, {{9, 9, 9}, 16}};
  std::vector<int> offsets{0};
  std::vector<int> numbers;
  for (std::size_t i = 0; i < along.size(); ++i) {
    numbers.insert(numbers.end(), {0, 1, 2});
    offsets.push_back(static_cast<int>(numbers.size()));
  }
  Cells cells;
  Cells neighbors;
  vertex_delaunay({along, offsets, numbers, balls}, cells, neighbors, progress);
  EXPECT_TRUE(set_of(cells) == plain_delaunay(along));
}

TEST(Parallel_insertion_3, fewer_than_four_points_and_planes_have_no_cells) {
  const std::vector<int> offsets(200, 0);
  for (const int count : {0, 1, 2, 3, 100}) {
    std::vector<Point_3> points;
    for (int i = 0; i < count; ++i) points.push_back({1.0 * i, 1.0 * (i * i), 0});
    Cells cells;
    Cells neighbors;
    Progress progress = on_threads(2);
    vertex_delaunay({points, std::span(offsets).first(points.size() + 1), {}, {}}, cells, neighbors, progress);
    EXPECT_TRUE(cells.empty());
    EXPECT_TRUE(neighbors.empty());
  }
}

TEST(Parallel_insertion_3, stops_on_all_threads_when_asked_to) {
  const std::vector<Point_3> points = large_sets()[0].points;
  std::stop_source stop;
  int reports = 0;
  Progress progress(
      stop.get_token(),
      [&](std::string_view, double fraction) {
        ++reports;
        if (fraction > 0.5) stop.request_stop();
      },
      2);
  EXPECT_THROW(delaunay(points, progress), Cancelled);
  EXPECT_GT(reports, 3);
}

TEST(Insertion_order, has_each_number_once_in_rounds_along_the_curve) {
  for (const std::size_t count : {0, 1, 5, 64, 65, 1000, 100000}) {
    const std::vector<int> order = insertion_order_along_curve(count);
    std::vector<int> all = order;
    std::ranges::sort(all);
    std::vector<int> expected(count);
    std::iota(expected.begin(), expected.end(), 0);
    EXPECT_EQ(all, expected);
    EXPECT_EQ(insertion_order_along_curve(count), order);
  }
  const std::vector<int> order = insertion_order_along_curve(100000);
  std::size_t last_round = 0;
  int rounds = 1;
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (order[i] > order[i - 1]) continue;
    ++rounds;
    last_round = i;
  }
  EXPECT_EQ(rounds, 5);
  EXPECT_NEAR(static_cast<double>(last_round), 12500, 500);
}

}  // namespace
}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/generators_3.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "app3d/example_3.h"
#include "core/portable_random.h"

namespace mesecina {

namespace {

constexpr double turn = 2 * std::numbers::pi;
/// Of the tube of a torus, where the torus has the outer radius 1.
constexpr double tube = 0.3;

/// From the cube around the origin with sides of 2 to where it is ordered.
Point_3 placed(const Generator_order_3& order, const Point_3& p) { return order.center + order.size * p; }

Inputs points_of(const Generator_order_3& order, std::vector<Point_3> points) {
  for (Point_3& p : points) p = placed(order, p);
  return Inputs().with(cloud_input, std::move(points));
}

Inputs mesh_of(const Generator_order_3& order, Triangle_mesh_3 mesh) {
  for (Point_3& p : mesh.vertices) p = placed(order, p);
  return Inputs().with(mesh_input, std::move(mesh));
}

Point_3 in_cube(Portable_random& random) {
  const double x = random.within(-1, 1);
  const double y = random.within(-1, 1);
  return {x, y, random.within(-1, 1)};
}

Point_3 on_torus(double along, double around) {
  const double away = 1 - tube + tube * std::cos(around);
  return {away * std::cos(along), away * std::sin(along), tube * std::sin(around)};
}

Inputs points_in_cube(const Generator_order_3& order) {
  Portable_random random(order.seed);
  std::vector<Point_3> points;
  points.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) points.push_back(in_cube(random));
  return points_of(order, std::move(points));
}

Inputs points_on_sphere(const Generator_order_3& order) {
  Portable_random random(order.seed);
  std::vector<Point_3> points;
  points.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) {
    const double height = random.within(-1, 1);
    const double angle = random.within(0, turn);
    const double away = std::sqrt(1 - height * height);
    points.push_back({away * std::cos(angle), away * std::sin(angle), height});
  }
  return points_of(order, std::move(points));
}

Inputs points_on_torus(const Generator_order_3& order) {
  Portable_random random(order.seed);
  std::vector<Point_3> points;
  while (points.size() < order.count) {
    const double along = random.within(0, turn);
    const double around = random.within(0, turn);
    // As likely as there is surface: there is more outside.
    if (random.unit() > 1 - tube + tube * std::cos(around)) continue;
    points.push_back(on_torus(along, around));
  }
  return points_of(order, std::move(points));
}

/// Cells along one side of a lattice of at least so many places, at least one.
std::size_t side_of_lattice(std::size_t count) {
  std::size_t side = 1;
  while (side * side * side < count) ++side;
  return side;
}

/// Exactly on a lattice, layer by layer; the second is the distance of neighbours.
std::pair<std::vector<Point_3>, double> lattice(const Generator_order_3& order) {
  const std::size_t side = side_of_lattice(order.count);
  // Few significant bits: multiples of it have no rounding.
  const double step = std::exp2(std::floor(std::log2(2 * order.size / std::max<double>(1, double(side) - 1))));
  const double fine = step / 64;
  const auto first = [&](double middle) { return std::round((middle - step * (double(side) - 1) / 2) / fine) * fine; };
  const Point_3 corner{first(order.center.x), first(order.center.y), first(order.center.z)};
  std::vector<Point_3> points;
  points.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i)
    points.push_back(corner + step * Point_3{double(i % side), double(i / side % side), double(i / side / side)});
  return {std::move(points), step};
}

Inputs grid(const Generator_order_3& order) { return Inputs().with(cloud_input, lattice(order).first); }

Inputs balls_of(const std::vector<Point_3>& centers, double radius) {
  std::vector<Ball_3> balls;
  balls.reserve(centers.size());
  for (const Point_3& center : centers) balls.push_back({center, radius});
  return Inputs().with(balls_input, std::move(balls));
}

Inputs random_balls(const Generator_order_3& order) {
  Portable_random random(order.seed);
  std::vector<Ball_3> balls;
  balls.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) {
    const Point_3 center = placed(order, in_cube(random));
    balls.push_back({center, random.within(order.least_radius, order.greatest_radius)});
  }
  return Inputs().with(balls_input, std::move(balls));
}

/// Of the distance of neighbours; more than a half, so that they overlap.
constexpr double relative_radius = 0.6;

Inputs grid_of_balls(const Generator_order_3& order) {
  const auto [centers, step] = lattice(order);
  return balls_of(centers, relative_radius * step);
}

Inputs ring_of_balls(const Generator_order_3& order) {
  std::vector<Point_3> centers;
  centers.reserve(order.count);
  for (std::size_t i = 0; i < order.count; ++i) {
    const double angle = turn * double(i) / double(order.count);
    centers.push_back(placed(order, {std::cos(angle), std::sin(angle), 0}));
  }
  const double step = centers.size() < 2 ? order.size : distance(centers[0], centers[1]);
  return balls_of(centers, relative_radius * step);
}

/// A closed strip of squares around and across, whose places are given by numbers of steps.
template <class Place>
Triangle_mesh_3 torus_of_squares(int around, int across, Place place) {
  Triangle_mesh_3 mesh;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) mesh.vertices.push_back(place(i, j));
  const auto vertex = [&](int i, int j) { return (i % around) * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return mesh;
}

Inputs torus(const Generator_order_3& order) {
  const int around = std::max(3, static_cast<int>(order.count));
  const int across = std::max(3, around * 2 / 5);
  return mesh_of(order, torus_of_squares(around, across,
                                         [&](int i, int j) { return on_torus(turn * i / around, turn * j / across); }));
}

/// Rings of latitude between two poles.
Inputs sphere(const Generator_order_3& order) {
  const int around = std::max(3, static_cast<int>(order.count));
  const int rings = std::max(1, around / 2 - 1);
  Triangle_mesh_3 mesh;
  mesh.vertices.push_back({0, 0, -1});
  for (int i = 1; i <= rings; ++i) {
    const double height = -std::cos(turn / 2 * i / (rings + 1));
    const double away = std::sin(turn / 2 * i / (rings + 1));
    for (int j = 0; j < around; ++j)
      mesh.vertices.push_back({away * std::cos(turn * j / around), away * std::sin(turn * j / around), height});
  }
  mesh.vertices.push_back({0, 0, 1});
  const int last = static_cast<int>(mesh.vertices.size()) - 1;
  const auto vertex = [&](int ring, int j) { return 1 + ring * around + j % around; };
  for (int j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, vertex(0, j + 1), vertex(0, j)});
    for (int i = 0; i + 1 < rings; ++i) {
      mesh.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
      mesh.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
    }
    mesh.triangles.push_back({last, vertex(rings - 1, j), vertex(rings - 1, j + 1)});
  }
  return mesh_of(order, std::move(mesh));
}

Inputs cube(const Generator_order_3& order) {
  Triangle_mesh_3 mesh;
  for (int i = 0; i < 8; ++i) mesh.vertices.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  constexpr std::array<std::array<int, 4>, 6> sides{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& [a, b, c, d] : sides) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return mesh_of(order, std::move(mesh));
}

Inputs ring(const Generator_order_3& order) {
  Triangle_mesh_3 mesh = twisted_ring(static_cast<int>(order.count));
  Box box;
  for (const Point_3& p : mesh.vertices) box.add(p);
  const double reach = std::max(box.upper.x, box.upper.y);
  for (Point_3& p : mesh.vertices) p = (1 / reach) * p;
  return mesh_of(order, std::move(mesh));
}

}  // namespace

const std::vector<Generator_3>& generators_3() {
  constexpr std::size_t few = 12;
  constexpr std::size_t fine = 48;
  static const std::vector<Generator_3> generators = {
      {"random-points", QT_TRANSLATE_NOOP("generators", "Random points"),
       QT_TRANSLATE_NOOP("generators", "Points spread evenly at random in a cube"), Product_3::points, 500, true, false,
       points_in_cube},
      {"sphere-points", QT_TRANSLATE_NOOP("generators", "Points on a sphere"),
       QT_TRANSLATE_NOOP("generators", "Points spread evenly at random on a sphere"), Product_3::points, 500, true,
       false, points_on_sphere},
      {"torus-points", QT_TRANSLATE_NOOP("generators", "Points on a torus"),
       QT_TRANSLATE_NOOP("generators", "Points spread evenly at random on a torus"), Product_3::points, 1000, true,
       false, points_on_torus},
      {"grid", QT_TRANSLATE_NOOP("generators", "Lattice"),
       QT_TRANSLATE_NOOP("generators", "Points exactly on a lattice of cubes: a degenerate set"), Product_3::points,
       125, false, false, grid},
      {"random-balls", QT_TRANSLATE_NOOP("generators", "Random balls"),
       QT_TRANSLATE_NOOP("generators", "Balls at random places of a cube with random radii"), Product_3::balls, fine,
       true, true, random_balls},
      {"ring-of-balls", QT_TRANSLATE_NOOP("generators", "Ring of balls"),
       QT_TRANSLATE_NOOP("generators", "Equal balls that overlap around a hole"), Product_3::balls, few, false, false,
       ring_of_balls},
      {"grid-of-balls", QT_TRANSLATE_NOOP("generators", "Lattice of balls"),
       QT_TRANSLATE_NOOP("generators", "Equal balls exactly on a lattice of cubes: a degenerate set"), Product_3::balls,
       27, false, false, grid_of_balls},
      {"sphere", QT_TRANSLATE_NOOP("generators", "Sphere"), QT_TRANSLATE_NOOP("generators", "A mesh of a sphere"),
       Product_3::mesh, fine, false, false, sphere},
      {"cube", QT_TRANSLATE_NOOP("generators", "Cube"), QT_TRANSLATE_NOOP("generators", "A mesh of a cube"),
       Product_3::mesh, 0, false, false, cube},
      {"torus", QT_TRANSLATE_NOOP("generators", "Torus"), QT_TRANSLATE_NOOP("generators", "A mesh of a torus"),
       Product_3::mesh, fine, false, false, torus},
      {"twisted-ring", QT_TRANSLATE_NOOP("generators", "Twisted ring"),
       QT_TRANSLATE_NOOP("generators", "The mesh that is there at the start"), Product_3::mesh, 96, false, false, ring},
  };
  return generators;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometries/sphere_kernel_3.h"

namespace mesecina {
namespace {

using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Exact::Point_3;

/// Compares with CGAL's kernel. Returns whether double-doubles alone decide, and checks that they do so rightly.
bool expect_same(const std::array<Point, 5>& p) {
  const auto expected = Exact().side_of_oriented_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]);
  EXPECT_EQ(Sphere_kernel_3().side_of_oriented_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]), expected);
  Sphere_query_3 query{};
  for (int i = 0; i < 5; ++i) query[i] = {p[i].x(), p[i].y(), p[i].z()};
  const auto side = side_of_sphere_by_double_doubles(query);
  if (side == CGAL::ON_ORIENTED_BOUNDARY) return false;
  EXPECT_EQ(side, expected);
  return true;
}

class Random_spheres {
 public:
  explicit Random_spheres(int seed) : engine_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
  Point on_sphere(const Point& center, double radius) {
    std::normal_distribution<double> normal;
    const double x = normal(engine_);
    const double y = normal(engine_);
    const double z = normal(engine_);
    const double factor = radius / std::sqrt(x * x + y * y + z * z);
    return {center.x() + factor * x, center.y() + factor * y, center.z() + factor * z};
  }

 private:
  std::mt19937 engine_;
};

TEST(Sphere_kernel_3, random_points_of_all_sizes) {
  Random_spheres random(1);
  for (const double size : {1e-60, 1e-52, 1e-30, 1e-5, 1.0, 1e8, 1e30, 1e49, 1e55}) {
    for (int i = 0; i < 300; ++i) {
      std::array<Point, 5> p;
      for (Point& q : p) q = Point(random.number(-size, size), random.number(-size, size), random.number(-size, size));
      expect_same(p);
    }
  }
}

TEST(Sphere_kernel_3, points_of_one_sphere_but_for_rounding) {
  Random_spheres random(2);
  int decided = 0;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) {
    const double far = std::pow(10.0, random.number(-3, 3));
    const Point center(random.number(-far, far), random.number(-far, far), random.number(-far, far));
    const double radius = std::pow(10.0, random.number(-3, 3));
    std::array<Point, 5> p;
    for (Point& q : p) q = random.on_sphere(center, radius);
    decided += expect_same(p) ? 1 : 0;
  }
  // What they are for: doubles decide hardly any of these.
  EXPECT_GT(decided, count * 95 / 100);
}

TEST(Sphere_kernel_3, points_near_each_other_on_one_sphere) {
  Random_spheres random(3);
  for (int i = 0; i < 2000; ++i) {
    const Point center(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1));
    const Point middle = random.on_sphere(center, 0.5);
    std::array<Point, 5> p;
    const double reach = std::pow(10.0, random.number(-8, -1));
    for (Point& q : p) {
      const Point near(middle.x() + random.number(-reach, reach), middle.y() + random.number(-reach, reach),
                       middle.z() + random.number(-reach, reach));
      const auto away = near - center;
      q = center + (0.5 / std::sqrt(away.squared_length())) * away;
    }
    expect_same(p);
  }
}

TEST(Sphere_kernel_3, points_that_are_on_one_sphere_exactly) {
  // Corners of a cube, in all orders of five; also far from the origin.
  for (const double shift : {0.0, 0.5, 1048576.0}) {
    std::array<Point, 8> cube;
    for (int i = 0; i < 8; ++i) cube[i] = Point(shift + (i & 1), shift + (i >> 1 & 1), shift + (i >> 2 & 1));
    for (int code = 0; code < 8 * 8 * 8 * 8 * 8; ++code) {
      std::array<Point, 5> p;
      for (int i = 0; i < 5; ++i) p[i] = cube[code >> (3 * i) & 7];
      EXPECT_EQ(Sphere_kernel_3().side_of_oriented_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]),
                CGAL::ON_ORIENTED_BOUNDARY);
    }
  }
}

TEST(Sphere_kernel_3, points_in_a_plane_and_equal_ones) {
  Random_spheres random(4);
  for (int i = 0; i < 1000; ++i) {
    const double height = random.number(-1, 1);
    std::array<Point, 5> p;
    for (Point& q : p) q = Point(random.number(-1, 1), random.number(-1, 1), height);
    expect_same(p);
    p[1] = p[3];
    expect_same(p);
    p[4] = Point(0, 0, std::nextafter(height, 2.0));
    expect_same(p);
  }
}

/// What powers to a sphere say, which has to be right; ON_ORIENTED_BOUNDARY where they say nothing.
CGAL::Oriented_side expect_powers_right(const std::array<Point, 5>& p, const Point& center, double radius) {
  std::array<double, 5> powers{};
  for (int i = 0; i < 5; ++i)
    powers[i] = power_by_double_doubles({p[i].x(), p[i].y(), p[i].z()}, {center.x(), center.y(), center.z()}, radius);
  const auto side = Sphere_side_3(p[0], p[1], p[2], p[3], p[4]).by_powers(powers, 0x1p-97 * radius * radius);
  if (side != CGAL::ON_ORIENTED_BOUNDARY) {
    EXPECT_EQ(side, Exact().side_of_oriented_sphere_3_object()(p[0], p[1], p[2], p[3], p[4]));
  }
  return side;
}

TEST(Sphere_side_3, powers_decide_of_points_on_one_sphere_but_for_rounding) {
  Random_spheres random(5);
  int by_coordinates = 0;
  int by_powers = 0;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) {
    const double far = std::pow(10.0, random.number(-3, 3));
    const Point center(random.number(-far, far), random.number(-far, far), random.number(-far, far));
    const double radius = std::pow(10.0, random.number(-3, 3));
    std::array<Point, 5> p;
    for (Point& q : p) q = random.on_sphere(center, radius);
    if (expect_powers_right(p, center, radius) != CGAL::ON_ORIENTED_BOUNDARY) ++by_powers;
    if (Sphere_side_3(p[0], p[1], p[2], p[3], p[4]).by_coordinates() != CGAL::ON_ORIENTED_BOUNDARY) ++by_coordinates;
  }
  EXPECT_GT(by_powers, count * 98 / 100);
  EXPECT_LT(by_coordinates, count * 10 / 100);
}

TEST(Sphere_side_3, powers_are_right_also_where_points_are_near_each_other) {
  Random_spheres random(6);
  for (int i = 0; i < 4000; ++i) {
    const Point center(random.number(-1, 1), random.number(-1, 1), random.number(-1, 1));
    const Point middle = random.on_sphere(center, 0.5);
    const double reach = std::pow(10.0, random.number(-12, -1));
    std::array<Point, 5> p;
    for (Point& q : p)
      q = Point(middle.x() + random.number(-reach, reach), middle.y() + random.number(-reach, reach),
                middle.z() + random.number(-reach, reach));
    expect_powers_right(p, center, 0.5);
    // The sphere may be any.
    expect_powers_right(p, random.on_sphere(center, 0.1), 0.4);
  }
}

TEST(Sphere_side_3, powers_of_points_far_from_the_sphere_say_nothing) {
  Random_spheres random(7);
  for (int i = 0; i < 100; ++i) {
    std::array<Point, 5> p;
    for (Point& q : p) q = random.on_sphere({0, 0, 0}, 1);
    p[i % 5] = Point(3, 2, 1);
    EXPECT_EQ(expect_powers_right(p, {0, 0, 0}, 1), CGAL::ON_ORIENTED_BOUNDARY);
  }
}

TEST(Sphere_side_3, powers_of_corners_of_a_cube_do_not_tell) {
  std::array<Point, 5> p;
  for (int code = 0; code < 8 * 8 * 8 * 8 * 8; ++code) {
    for (int i = 0; i < 5; ++i) {
      const int corner = code >> (3 * i) & 7;
      p[i] = Point(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    }
    EXPECT_EQ(expect_powers_right(p, {0.5, 0.5, 0.5}, std::sqrt(0.75)), CGAL::ON_ORIENTED_BOUNDARY);
  }
}

}  // namespace
}  // namespace mesecina

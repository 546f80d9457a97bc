// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "geometries/circumcenter_3.h"

namespace mesecina {
namespace {

TEST(Circumcenter_3, IsRightForTetrahedraOfAnyFlatness) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int k = 0; k < 200; ++k) {
    std::array<Point_3, 4> p{};
    for (Point_3& q : p) q = {coordinate(random), coordinate(random), coordinate(random)};
    if (k % 2 == 1) p[3] = p[0] + 0.4 * (p[1] - p[0]) + 0.3 * (p[2] - p[0]);
    const Point_3 c = circumcenter(p);
    const double r = distance(c, p[0]);
    if (!(r < 1e6)) continue;
    for (const Point_3& q : p) EXPECT_NEAR(distance(c, q), r, 1e-9 * std::max(1.0, r)) << k;
  }
}

TEST(Circumcenter_3, IsRightWhereTwoPointsNearlyMeet) {
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int k = 0; k < 300; ++k) {
    std::array<Point_3, 4> p{};
    for (Point_3& q : p) q = {coordinate(random), coordinate(random), coordinate(random)};
    const int near = k % 3;
    const Point_3 step{coordinate(random), coordinate(random), coordinate(random)};
    p[3] = p[near] + 1e-9 * step;
    std::ranges::shuffle(p, random);
    std::array<Exact::Point_3, 4> e;
    for (int i = 0; i < 4; ++i) e[i] = {p[i].x, p[i].y, p[i].z};
    const Exact::Point_3 center = CGAL::circumcenter(e[0], e[1], e[2], e[3]);
    const Point_3 expected{CGAL::to_double(CGAL::exact(center.x())), CGAL::to_double(CGAL::exact(center.y())),
                           CGAL::to_double(CGAL::exact(center.z()))};
    const Point_3 c = circumcenter(p);
    EXPECT_LT(distance(c, expected), 1e-8 * distance(expected, p[0])) << k;
  }
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/outcome.h"
#include "tests/geometries/power_crust_3/delaunay_oracle_3.h"

namespace mesecina::test {
namespace {

std::vector<Cloud> small_clouds() {
  std::vector<Cloud> clouds{lattice(2), lattice(3), sphere_cloud({1, 2, 3}, 0.7, 14, 5),
                            joined(random_cloud(9, 3), random_cloud(9, 3))};
  for (std::uint64_t seed = 1; seed <= 6; ++seed) clouds.push_back(random_cloud(4 + 3 * static_cast<int>(seed), seed));
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    clouds.push_back(integer_cloud(18, 2 + static_cast<int>(seed) % 3, seed));
  // Regular octahedron with its center: spheres through four points, planes with five.
  clouds.push_back({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, 0, 0}});
  return clouds;
}

std::string reason_of(const Cloud& cloud) {
  Progress progress;
  try {
    delaunay(cloud, progress);
  } catch (const Unavailable& unavailable) {
    return unavailable.what();
  }
  return {};
}

double volume_of_cell(const Delaunay_3& triangulation, const std::array<int, 4>& cell) {
  const auto to = [&](int i) { return triangulation.points[cell[i]] - triangulation.points[cell[0]]; };
  return dot(cross(to(1), to(2)), to(3)) / 6;
}

TEST(Delaunay_3, VoronoiVerticesAreAllEmptySpheres) {
  for (const Cloud& cloud : small_clouds()) {
    Progress progress;
    EXPECT_EQ(spheres_of(delaunay(cloud, progress)), empty_spheres(cloud)) << cloud.size() << " points";
  }
}

TEST(Delaunay_3, CellsAreOrientedAndNeighborsMutual) {
  for (const Cloud& cloud : small_clouds()) {
    Progress progress;
    const Delaunay_3 triangulation = delaunay(cloud, progress);
    ASSERT_EQ(triangulation.cells.size(), triangulation.neighbors.size());
    for (int c = 0; c < static_cast<int>(triangulation.cells.size()); ++c) {
      EXPECT_GT(volume_of_cell(triangulation, triangulation.cells[c]), 0);
      for (int i = 0; i < 4; ++i) {
        const int corner = triangulation.cells[c][i];
        EXPECT_EQ(triangulation.site[corner], corner);
        EXPECT_NEAR(distance(triangulation.circumcenters[c], cloud[corner]), triangulation.circumradii[c],
                    1e-9 * triangulation.circumradii[c]);
        const int next = triangulation.neighbors[c][i];
        if (next < 0) continue;
        std::array<int, 4> common = triangulation.cells[c];
        common[i] = -1;
        int place = -1;
        for (int k = 0; k < 4; ++k)
          if (std::ranges::count(common, triangulation.cells[next][k]) == 0) place = k;
        ASSERT_GE(place, 0);
        EXPECT_EQ(triangulation.neighbors[next][place], c);
      }
    }
  }
}

TEST(Delaunay_3, FillsTheConvexHull) {
  Progress progress;
  const Delaunay_3 triangulation = delaunay(lattice(4), progress);
  double sum = 0;
  for (const auto& cell : triangulation.cells) sum += volume_of_cell(triangulation, cell);
  EXPECT_NEAR(sum, 27, 1e-9);
}

TEST(Delaunay_3, TheFirstOfEqualPointsIsTheSite) {
  Progress progress;
  Cloud cloud = random_cloud(40, 9);
  cloud = joined(cloud, cloud);
  cloud[7] = cloud[3];
  const Delaunay_3 triangulation = delaunay(cloud, progress);
  EXPECT_EQ(triangulation.site_count, 40u);
  for (int i = 0; i < 80; ++i) {
    const int first = static_cast<int>(std::ranges::find(cloud, cloud[i]) - cloud.begin());
    EXPECT_EQ(triangulation.site[i], first);
  }
}

TEST(Delaunay_3, SaysWhyThereIsNone) {
  EXPECT_EQ(reason_of({}), "needs at least 4 distinct points that are not in one plane; there are 0");
  EXPECT_EQ(reason_of({{1, 2, 3}, {1, 2, 3}}),
            "needs at least 4 distinct points that are not in one plane; there is 1");
  EXPECT_EQ(reason_of({{1, 2, 3}, {1, 2, 4}, {1, 3, 3}}),
            "needs at least 4 distinct points that are not in one plane; there are 3");
  EXPECT_EQ(reason_of({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {9, 9, 9}}), "all points lie on one line");
  Cloud plane = random_cloud(30, 2);
  for (Point_3& p : plane) p.z = p.x + p.y;
  for (Point_3& p : plane)
    p = {std::round(64 * p.x), std::round(64 * p.y), std::round(64 * p.x) + std::round(64 * p.y)};
  EXPECT_EQ(reason_of(plane), "all points lie in one plane");
  EXPECT_EQ(reason_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1e-12}}), "");
}

TEST(Delaunay_3, OneThreadAndTwoGiveTheSame) {
  const Cloud cloud = ellipsoid_cloud(5000, 4);
  Progress one;
  Progress two({}, {}, 2);
  const Delaunay_3 a = delaunay(cloud, one);
  const Delaunay_3 b = delaunay(cloud, two);
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.neighbors, b.neighbors);
  EXPECT_EQ(a.circumcenters, b.circumcenters);
  EXPECT_EQ(a.circumradii, b.circumradii);
  EXPECT_EQ(cells_by_sphere(a, one), cells_by_sphere(b, two));
}

TEST(Delaunay_3, StopsWhenCancelled) {
  std::stop_source stop;
  stop.request_stop();
  Progress progress(stop.get_token());
  EXPECT_THROW(delaunay(random_cloud(100, 1), progress), Cancelled);
}

TEST(Voronoi_faces_3, AreThoseOfEdgesInside) {
  for (const Cloud& cloud : small_clouds()) {
    Progress progress;
    const Delaunay_3 triangulation = delaunay(cloud, progress);
    const Voronoi_faces_3 faces = bounded_voronoi_faces(triangulation, progress);
    const std::vector<int> sphere = cells_by_sphere(triangulation, progress);
    std::map<int, std::set<int>> contacts;
    for (std::size_t c = 0; c < triangulation.cells.size(); ++c)
      contacts[sphere[c]].insert(triangulation.cells[c].begin(), triangulation.cells[c].end());
    std::set<std::array<int, 2>> found;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto [a, b] = faces.sites[f];
      EXPECT_TRUE(found.insert({std::min(a, b), std::max(a, b)}).second);
      const std::set<int> corners(faces.face(f).begin(), faces.face(f).end());
      EXPECT_EQ(corners.size(), faces.face(f).size());
      std::set<int> common;
      for (const auto& [cell, points] : contacts)
        if (points.contains(a) && points.contains(b)) common.insert(cell);
      EXPECT_EQ(corners, common);
    }
    for (int a = 0; a < static_cast<int>(cloud.size()); ++a) {
      for (int b = a + 1; b < static_cast<int>(cloud.size()); ++b) {
        if (triangulation.site[a] != a || triangulation.site[b] != b) continue;
        const auto common = std::ranges::count_if(
            contacts, [&](const auto& entry) { return entry.second.contains(a) && entry.second.contains(b); });
        const bool is_face = common >= 3 && !is_on_hull(cloud, a, b);
        EXPECT_EQ(found.contains({a, b}), is_face) << a << ' ' << b << ' ' << common;
      }
    }
  }
}

TEST(Voronoi_faces_3, TurnCounterclockwiseAroundTheirSites) {
  Progress progress;
  const Cloud cloud = random_cloud(200, 8);
  const Delaunay_3 triangulation = delaunay(cloud, progress);
  const Voronoi_faces_3 faces = bounded_voronoi_faces(triangulation, progress);
  ASSERT_GT(faces.size(), 300u);
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto corner = [&](std::size_t i) {
      return triangulation.circumcenters[faces.face(f)[i % faces.face(f).size()]];
    };
    Point_3 area;
    for (std::size_t i = 0; i < faces.face(f).size(); ++i) area = area + cross(corner(i), corner(i + 1));
    EXPECT_GT(dot(area, cloud[faces.sites[f][1]] - cloud[faces.sites[f][0]]), 0);
  }
}

}  // namespace
}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/graph.h"
#include "geometries/delaunay_parts_3/delaunay_parts_3.h"
#include "geometries/modules_3.h"
#include "tests/geometries/power_crust_3/delaunay_oracle_3.h"

namespace mesecina::test {
namespace {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

Exact::Point_3 exact(const Point_3& p) { return {p.x, p.y, p.z}; }

/// What the smallest ball around two or three points holds of the others.
enum class Content { nothing, on_its_sphere, inside };

template <class Side>
Content content(const Cloud& cloud, const std::vector<int>& corners, const Side& side_of) {
  Content result = Content::nothing;
  for (int i = 0; i < static_cast<int>(cloud.size()); ++i) {
    if (std::ranges::count(corners, i) != 0) continue;
    const auto side = side_of(exact(cloud[i]));
    if (side == CGAL::ON_BOUNDED_SIDE) return Content::inside;
    if (side == CGAL::ON_BOUNDARY) result = Content::on_its_sphere;
  }
  return result;
}

Content content_of(const Cloud& cloud, const std::array<int, 2>& edge) {
  return content(cloud, {edge[0], edge[1]}, [&](const Exact::Point_3& p) {
    return CGAL::side_of_bounded_sphere(exact(cloud[edge[0]]), exact(cloud[edge[1]]), p);
  });
}

/// The center in exact numbers, instead of a predicate.
Content content_of(const Cloud& cloud, const std::array<int, 3>& triangle) {
  const auto a = exact(cloud[triangle[0]]);
  const auto center = CGAL::circumcenter(a, exact(cloud[triangle[1]]), exact(cloud[triangle[2]]));
  const auto square = CGAL::squared_distance(center, a);
  return content(cloud, {triangle[0], triangle[1], triangle[2]}, [&](const Exact::Point_3& p) {
    const auto other = CGAL::squared_distance(center, p);
    return other < square ? CGAL::ON_BOUNDED_SIDE : other > square ? CGAL::ON_UNBOUNDED_SIDE : CGAL::ON_BOUNDARY;
  });
}

template <std::size_t Count>
std::set<std::array<int, Count>> faces_of(const Delaunay_3& triangulation) {
  std::set<std::array<int, Count>> faces;
  for (auto corners : triangulation.cells) {
    std::ranges::sort(corners);
    for (unsigned bits = 0; bits < 16; ++bits) {
      std::array<int, Count> face{};
      std::size_t found = 0;
      for (unsigned i = 0; i < 4; ++i)
        if ((bits >> i & 1U) != 0 && found++ < Count) face[found - 1] = corners[i];
      if (found == Count) faces.insert(face);
    }
  }
  return faces;
}

/// All of them and no others; those with nothing on their sphere must be in every Delaunay triangulation.
template <std::size_t Count>
void expect_by_definition(const Cloud& cloud, const Delaunay_3& triangulation,
                          const std::set<std::array<int, Count>>& found) {
  for (const auto& face : faces_of<Count>(triangulation))
    EXPECT_EQ(found.contains(face), content_of(cloud, face) != Content::inside);
  for (const auto& face : found) EXPECT_TRUE(faces_of<Count>(triangulation).contains(face));
}

void expect_gabriel(const Cloud& cloud) {
  Progress progress;
  const Delaunay_3 triangulation = delaunay(cloud, progress);
  const Gabriel_complex_3 complex = gabriel_complex(triangulation, progress);
  EXPECT_TRUE(std::ranges::is_sorted(complex.edges));
  std::set<std::array<int, 3>> triangles;
  for (auto triangle : complex.triangles) {
    std::ranges::sort(triangle);
    EXPECT_TRUE(triangles.insert(triangle).second);
  }
  const std::set<std::array<int, 2>> edges(complex.edges.begin(), complex.edges.end());
  EXPECT_EQ(edges.size(), complex.edges.size());
  expect_by_definition(cloud, triangulation, edges);
  expect_by_definition(cloud, triangulation, triangles);
  const int count = static_cast<int>(cloud.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      if (content_of(cloud, std::array{a, b}) == Content::nothing) {
        EXPECT_TRUE(edges.contains({a, b}));
      }
      for (int c = b + 1; c < count; ++c) {
        if (CGAL::collinear(exact(cloud[a]), exact(cloud[b]), exact(cloud[c]))) continue;
        if (content_of(cloud, std::array{a, b, c}) == Content::nothing) {
          EXPECT_TRUE(triangles.contains({a, b, c}));
        }
      }
    }
  }
}

Cloud without_equal_points(Cloud cloud) {
  Cloud result;
  for (const Point_3& p : cloud)
    if (std::ranges::count(result, p) == 0) result.push_back(p);
  return result;
}

TEST(Gabriel_3, IsThatOfTheDefinitionForRandomPoints) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) expect_gabriel(random_cloud(22, seed));
}

TEST(Gabriel_3, IsThatOfTheDefinitionForPointsOnOneSphereAndOnALattice) {
  expect_gabriel(lattice(2));
  expect_gabriel(lattice(3));
  expect_gabriel(sphere_cloud({0, 0, 0}, 1, 20, 3));
  expect_gabriel({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  for (std::uint64_t seed = 1; seed <= 6; ++seed) expect_gabriel(without_equal_points(integer_cloud(20, 3, seed)));
}

TEST(Gabriel_3, ASampleOnTheSphereIsNotInside) {
  // A cube: all corners lie on the sphere around a diagonal through the middle, and on each of its triangles' sphere.
  // Only triangles of three diagonals of its sides have a corner inside.
  Progress progress;
  const Cloud corners = lattice(2);
  const Delaunay_3 cube = delaunay(corners, progress);
  const Gabriel_complex_3 complex = gabriel_complex(cube, progress);
  EXPECT_EQ(complex.edges.size(), faces_of<2>(cube).size());
  const auto is_equilateral = [&](const std::array<int, 3>& t) {
    return squared_distance(corners[t[0]], corners[t[1]]) == 2 && squared_distance(corners[t[1]], corners[t[2]]) == 2 &&
           squared_distance(corners[t[2]], corners[t[0]]) == 2;
  };
  const auto triangles = faces_of<3>(cube);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(complex.triangles.size() + std::ranges::count_if(triangles, is_equilateral)),
            static_cast<std::ptrdiff_t>(triangles.size()));
}

TEST(Gabriel_3, TheLayerHasTheRadiiOfTheBalls) {
  const Cloud cloud = joined({{3, 0, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 5}}, {{3, 0, 0}});
  Graph graph(make_registry_3());
  graph.set_inputs(Inputs().with(cloud_input, cloud));
  Progress progress;
  const auto layer = graph.layer("gabriel-complex", progress);
  ASSERT_TRUE(layer) << layer.reason;
  EXPECT_EQ(layer.value->vertices.size(), 4u);
  const Values* radius = layer.value->find_values("radius");
  ASSERT_NE(radius, nullptr);
  bool has_right_triangle = false;
  for (std::size_t t = 0; t < layer.value->triangles.size(); ++t) {
    auto corners = layer.value->triangles[t];
    std::ranges::sort(corners);
    if (corners != std::array{0, 1, 2}) continue;
    has_right_triangle = true;
    EXPECT_NEAR(radius->data[layer.value->segments.size() + t], 2.5, 1e-15);
  }
  EXPECT_TRUE(has_right_triangle);
  for (std::size_t s = 0; s < layer.value->segments.size(); ++s) {
    const auto& [a, b] = layer.value->segments[s];
    EXPECT_NEAR(radius->data[s], distance(layer.value->vertices[a], layer.value->vertices[b]) / 2, 1e-15);
  }
}

}  // namespace
}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "geometries/scale_axis_3/scale_axis_3.h"

namespace mesecina {
namespace {

/// Builds complexes of triangles and edges by their vertices; positions do not matter to the topology.
class Builder {
 public:
  int vertex(const Point_3& p = {}) {
    complex_.centers.push_back(p);
    complex_.radii.push_back(1);
    complex_.balls.push_back(-1);
    return static_cast<int>(complex_.centers.size()) - 1;
  }
  void face(const std::vector<int>& corners, double angle) {
    complex_.face_vertices.insert(complex_.face_vertices.end(), corners.begin(), corners.end());
    complex_.face_offsets.push_back(static_cast<int>(complex_.face_vertices.size()));
    complex_.contacts.push_back({});
    angles.push_back(angle);
    for (std::size_t i = 0; i < corners.size(); ++i) edge(corners[i], corners[(i + 1) % corners.size()]);
  }
  void edge(int a, int b) { complex_.edges.push_back({std::min(a, b), std::max(a, b)}); }
  Medial_complex_3 complex() {
    std::ranges::sort(complex_.edges);
    complex_.edges.erase(std::unique(complex_.edges.begin(), complex_.edges.end()), complex_.edges.end());
    return complex_;
  }
  std::vector<double> angles;

 private:
  Medial_complex_3 complex_ = [] {
    Medial_complex_3 empty;
    empty.face_offsets = {0};
    return empty;
  }();
};

/// A plate of two squares, and fins on the line between them with these angles.
Builder plate_with_fins(const std::vector<double>& fins, double plate_angle = 180) {
  Builder builder;
  const int a = builder.vertex({0, 0, 0});
  const int b = builder.vertex({0, 1, 0});
  const int c = builder.vertex({-1, 0, 0});
  const int d = builder.vertex({-1, 1, 0});
  const int e = builder.vertex({1, 0, 0});
  const int f = builder.vertex({1, 1, 0});
  builder.face({a, b, d, c}, plate_angle);
  builder.face({a, e, f, b}, plate_angle);
  for (const double angle : fins) {
    const int g = builder.vertex({0, 0, 1});
    const int h = builder.vertex({0, 1, 1});
    builder.face({a, b, h, g}, angle);
  }
  return builder;
}

std::int64_t euler(const Medial_complex_3& complex) {
  return static_cast<std::int64_t>(complex.centers.size()) - static_cast<std::int64_t>(complex.edges.size()) +
         static_cast<std::int64_t>(complex.face_count());
}

/// Whose sheets are those of what is left.
Pruned_complex_3 pruned(Builder& builder, double min_angle) {
  Progress progress;
  Pruned_complex_3 result = without_small_sheets(builder.complex(), builder.angles, min_angle, progress);
  const Sheets_3 expected = sheets(result.complex);
  EXPECT_EQ(result.sheets.count, expected.count);
  EXPECT_EQ(result.sheets.sheet_of_face, expected.sheet_of_face);
  return result;
}

TEST(Sheets_3, EndWhereThreeFacesMeet) {
  EXPECT_EQ(sheets(plate_with_fins({}).complex()).count, 1);
  const Sheets_3 parts = sheets(plate_with_fins({20}).complex());
  EXPECT_EQ(parts.count, 3);
  EXPECT_EQ(parts.sheet_of_face, (std::vector<int>{0, 1, 2}));
}

TEST(Sheets_3, SmallOnesGoAndWhatTheyPartedIsOneAgain) {
  Builder builder = plate_with_fins({20, 10});
  const Medial_complex_3 result = pruned(builder, 30).complex;
  EXPECT_EQ(result.face_count(), 2u);
  EXPECT_EQ(result.centers.size(), 6u);
  EXPECT_EQ(result.edges.size(), 7u);
  EXPECT_EQ(sheets(result).count, 1);
}

TEST(Sheets_3, LargeOnesStay) {
  Builder builder = plate_with_fins({20, 40});
  const Medial_complex_3 result = pruned(builder, 30).complex;
  EXPECT_EQ(result.face_count(), 3u);
  // The plate and the fin of 40 degrees.
  EXPECT_EQ(pruned(builder, 30).faces, (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(pruned(builder, 0).complex.face_count(), 4u);
}

TEST(Sheets_3, AComplexOfOnlySmallSheetsKeepsItsTopology) {
  Builder builder = plate_with_fins({20}, 25);
  const Medial_complex_3 result = pruned(builder, 30).complex;
  EXPECT_EQ(euler(result), 1);
  EXPECT_FALSE(result.centers.empty());
}

TEST(Sheets_3, ASheetThatClosesATunnelOrACavityStays) {
  // A ring of three squares: removing one would open it.
  Builder ring;
  std::vector<int> v;
  for (int i = 0; i < 6; ++i) v.push_back(ring.vertex());
  for (int i = 0; i < 3; ++i) ring.face({v[i], v[(i + 1) % 3], v[3 + (i + 1) % 3], v[3 + i]}, 10);
  EXPECT_EQ(euler(ring.complex()), 0);
  EXPECT_EQ(euler(pruned(ring, 30).complex), 0);
  // A tetrahedron's surface.
  Builder hull;
  v.clear();
  for (int i = 0; i < 4; ++i) v.push_back(hull.vertex());
  for (int i = 0; i < 4; ++i) hull.face({v[i], v[(i + 1) % 4], v[(i + 2) % 4]}, 10);
  EXPECT_EQ(pruned(hull, 30).complex.face_count(), 4u);
  // A fin that also carries an edge at its far side cannot go without what hangs on it.
  Builder carrier = plate_with_fins({20});
  carrier.edge(7, carrier.vertex());
  EXPECT_EQ(pruned(carrier, 30).complex.face_count(), 3u);
  // With both of its far corners held by a handle, it holds a tunnel.
  Builder handle = plate_with_fins({20});
  const int far = handle.vertex();
  handle.edge(6, far);
  handle.edge(7, far);
  const auto kept = pruned(handle, 30).complex;
  EXPECT_EQ(euler(kept), euler(handle.complex()));
  EXPECT_EQ(kept.face_count(), 3u);
}

TEST(Smooth_rims_3, MoveRimVerticesAndKeepBallsInside) {
  Medial_complex_3 complex = plate_with_fins({}).complex();
  complex.radii = {1, 1, 0.8, 0.9, 0.7, 0.8};
  const Medial_complex_3 before = complex;
  const Medial_complex_3 result = with_smooth_rims(complex, 3);
  EXPECT_EQ(result.edges, before.edges);
  bool has_moved = false;
  for (std::size_t i = 0; i < result.centers.size(); ++i) {
    has_moved = has_moved || !(result.centers[i] == before.centers[i]);
    const bool is_inside = std::ranges::any_of(std::vector{0, 1, 2, 3, 4, 5}, [&](int j) {
      return distance(result.centers[i], before.centers[j]) + result.radii[i] <= before.radii[j] + 1e-12;
    });
    EXPECT_TRUE(is_inside) << i;
  }
  EXPECT_TRUE(has_moved);
  EXPECT_EQ(with_smooth_rims(complex, 0).centers, before.centers);
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/surface_locator_3.h"

#include <algorithm>

namespace mesecina {

Surface_locator_3::Surface_locator_3(const Triangle_mesh_3& surface, Progress& progress) {
  const auto corners_of = [&](const std::array<int, 3>& t) {
    return Corners_3{surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]};
  };
  std::vector<Box> boxes;
  boxes.reserve(surface.triangles.size());
  for (const std::array<int, 3>& t : surface.triangles) boxes.push_back(box_of(corners_of(t)));
  tree_ = Box_tree_3(boxes, progress);
  corners_.reserve(surface.triangles.size());
  for (const int t : tree_.order()) corners_.push_back(corners_of(surface.triangles[t]));
}

bool Surface_locator_3::contains(const Point_3& p) const {
  const Double_place place(p);
  int winding = 0;
  bool is_on = false;
  tree_.visit([&](const Box& box) { return may_be_above(box, place.box()); },
              [&](int i) {
                const Crossing_3 crossing = crossing_above(corners_[i], place);
                winding += crossing.direction;
                is_on = crossing.is_on;
                return !is_on;
              });
  return is_on || winding > 0;
}

Surface_locator_3::Nearest Surface_locator_3::nearest(const Point_3& p, int guess) const {
  Nearest result;
  if (corners_.empty()) return result;
  result = {mesecina::squared_distance(corners_[guess], p), guess};
  tree_.approach([&](const Box& box) { return mesecina::squared_distance(box, p); }, result.squared_distance,
                 [&](int i) {
                   const double square = mesecina::squared_distance(corners_[i], p);
                   if (square < result.squared_distance) result = {square, i};
                 });
  return result;
}

// [C. Ericson: Real-Time Collision Detection, 2005, section 5.1.5]
double squared_distance(const Corners_3& triangle, const Point_3& p) {
  const auto& [a, b, c] = triangle;
  const Point_3 ab = b - a;
  const Point_3 ac = c - a;
  const Point_3 ap = p - a;
  const double d1 = dot(ab, ap);
  const double d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return dot(ap, ap);
  const Point_3 bp = p - b;
  const double d3 = dot(ab, bp);
  const double d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return dot(bp, bp);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return squared_distance(p, a + (d1 / (d1 - d3)) * ab);
  const Point_3 cp = p - c;
  const double d5 = dot(ab, cp);
  const double d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return dot(cp, cp);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return squared_distance(p, a + (d2 / (d2 - d6)) * ac);
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    return squared_distance(p, b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b));
  // By the normal, which thin triangles spoil less than barycentric coordinates.
  const Point_3 normal = cross(ab, ac);
  const double square = dot(normal, normal);
  constexpr double too_thin = 1e-16;
  if (square > too_thin * dot(ab, ab) * dot(ac, ac)) {
    const double height = dot(normal, ap);
    return height * height / square;
  }
  const auto to_segment = [&](const Point_3& from, const Point_3& to) {
    const Point_3 along = to - from;
    return squared_distance(p, from + std::clamp(dot(along, p - from) / dot(along, along), 0.0, 1.0) * along);
  };
  return std::min({to_segment(a, b), to_segment(b, c), to_segment(c, a)});
}

}  // namespace mesecina

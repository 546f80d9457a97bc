// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/convex_hull_2/convex_hull_2.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <numeric>

#include "core/graph.h"
#include "geometries/primitives_2.h"
#include "geometries/samples_2/module.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

bool turns_left(const Point_2& p, const Point_2& q, const Point_2& r) {
  return CGAL::left_turn(Kernel::Point_2(p.x, p.y), Kernel::Point_2(q.x, q.y), Kernel::Point_2(r.x, r.y));
}

/// Appends the corners of the hull's lower side, met in this order, without the last one.
template <class Iterator>
void append_side(std::span<const Point_2> points, Iterator begin, Iterator end, std::vector<int>& corners) {
  const std::size_t first = corners.size();
  for (; begin != end; ++begin) {
    while (corners.size() >= first + 2 &&
           !turns_left(points[corners[corners.size() - 2]], points[corners.back()], points[*begin]))
      corners.pop_back();
    corners.push_back(*begin);
  }
  corners.pop_back();
}

Primitive_set hull_layer(Context& context) {
  const auto samples = context.get(samples_2_key);
  const auto hull = context.get(convex_hull_2_key);
  const std::size_t count = hull->corners.size();
  if (count < 3) throw Unavailable("needs at least 3 points that are not on one line");
  Primitive_set set;
  set.is_complex = true;
  Values lengths{"length", "units of the input", {}};
  for (std::size_t i = 0; i < count; ++i) {
    const Point_2& corner = samples->points[hull->corners[i]];
    set.vertices.push_back(lifted(corner));
    set.segments.push_back({static_cast<int>(i), static_cast<int>((i + 1) % count)});
    lengths.data.push_back(distance(corner, samples->points[hull->corners[(i + 1) % count]]));
  }
  set.values.push_back(std::move(lengths));
  return set;
}

}  // namespace

Convex_hull_2 convex_hull(std::span<const Point_2> points, Progress& progress) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto position = [&](int i) { return std::pair(points[i].x, points[i].y); };
  std::ranges::stable_sort(order, {}, position);
  const auto is_equal = [&](int i, int j) { return points[i] == points[j]; };
  order.erase(std::unique(order.begin(), order.end(), is_equal), order.end());
  progress.check();
  Convex_hull_2 hull;
  if (order.size() < 2) {
    hull.corners = order;
    return hull;
  }
  append_side(points, order.begin(), order.end(), hull.corners);
  append_side(points, order.rbegin(), order.rend(), hull.corners);
  return hull;
}

void register_convex_hull_2(Registry& registry) {
  registry.begin_module({"convex-hull-2", "Convex hull", "The smallest convex set around the shape."});
  registry.add_structure<Convex_hull_2>(convex_hull_2_key, [](Context& context) {
    return convex_hull(context.get(samples_2_key)->points, context.progress());
  });
  Layer_spec layer;
  layer.id = "convex-hull";
  layer.label = "Convex hull";
  layer.stage = "Diagram";
  layer.help =
      "The boundary of the smallest convex set that holds all samples. [A. Andrew: Another efficient algorithm for "
      "convex hulls in two dimensions, 1979]";
  layer.style = look({150, 60, 120}, 2);
  layer.build = hull_layer;
  registry.add_layer(std::move(layer));
}

}  // namespace mesecina

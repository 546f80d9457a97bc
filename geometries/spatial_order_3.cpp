// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/spatial_order_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>
#include <utility>

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, CGAL::Pointer_property_map<Kernel::Point_3>::const_type>;

std::vector<Kernel::Point_3> places_of(std::span<const Point_3> points) {
  std::vector<Kernel::Point_3> places;
  places.reserve(points.size());
  for (const Point_3& p : points) places.emplace_back(p.x, p.y, p.z);
  return places;
}

}  // namespace

std::vector<std::size_t> insertion_order(std::span<const Point_3> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  if (points.empty()) return order;
  const std::vector<Kernel::Point_3> places = places_of(points);
  CGAL::spatial_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(places)));
  return order;
}

void sort_along_hilbert_curve(std::span<const Point_3> points, std::vector<std::size_t>& indices) {
  if (points.empty()) return;
  const std::vector<Kernel::Point_3> places = places_of(points);
  CGAL::hilbert_sort(indices.begin(), indices.end(), Traits(CGAL::make_property_map(places)));
}

}  // namespace mesecina

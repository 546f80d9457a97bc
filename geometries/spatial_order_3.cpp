// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/spatial_order_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>

#include "geometries/parallel.h"

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

/// Well mixed bits of a number. [G. Steele, D. Lea, C. Flood: Fast splittable pseudorandom number generators, 2014]
std::uint64_t mixed(std::uint64_t number) {
  number = (number + 1) * 0x9e3779b97f4a7c15;
  number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9;
  number = (number ^ (number >> 27)) * 0x94d049bb133111eb;
  return number ^ (number >> 31);
}

}  // namespace

std::vector<int> insertion_order_along_curve(std::size_t count) {
  // Of each round an eighth was there before.
  constexpr int bits_per_round = 3;
  constexpr std::size_t few = 64;
  int most_rounds = 0;
  for (std::size_t left = count; left > few; left >>= bits_per_round) ++most_rounds;
  std::vector<std::uint8_t> rounds(count);
  std::vector<std::size_t> next(static_cast<std::size_t>(most_rounds) + 2, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const int before_end = std::min(most_rounds, std::countl_zero(mixed(i)) / bits_per_round);
    rounds[i] = static_cast<std::uint8_t>(most_rounds - before_end);
    ++next[rounds[i] + 1];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) order[next[rounds[i]]++] = static_cast<int>(i);
  return order;
}

void sort_along_hilbert_curve(std::span<const Point_3> points, std::vector<std::size_t>& indices,
                              const Progress& progress) {
  if (points.empty()) return;
  const std::vector<Kernel::Point_3> places = places_of(points);
  const Traits traits(CGAL::make_property_map(places));
  if (progress.threads() <= 1) {
    CGAL::hilbert_sort(indices.begin(), indices.end(), traits);
  } else {
    parallel_region(progress, [&] { CGAL::hilbert_sort<CGAL::Parallel_tag>(indices.begin(), indices.end(), traits); });
  }
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/scale_importance/scale_importance.h"

#include <numeric>

#include "geometries/scale_importance/scale_hierarchy.h"

namespace mesecina {

using scale_search::Query;
using scale_search::Sphere;

class Scale_importance::Hierarchy : public scale_search::Hierarchy<2> {
 public:
  using scale_search::Hierarchy<2>::Hierarchy;
};

namespace {

constexpr double infinity = scale_search::infinity;

/// The exchanged disks may be this many before a new hierarchy pays.
constexpr std::size_t most_outside_hierarchy = 256;

Sphere<2> sphere(const Point_2& center, double radius) { return {{center.x, center.y}, radius}; }
Sphere<3> sphere(const Point_3& center, double radius) { return {{center.x, center.y, center.z}, radius}; }

template <class Point>
auto spheres(std::span<const Point> centers, std::span<const double> radii) {
  std::vector<decltype(sphere(Point(), 0))> result;
  result.reserve(centers.size());
  for (std::size_t i = 0; i < centers.size(); ++i) result.push_back(sphere(centers[i], radii[i]));
  return result;
}

}  // namespace

Scale_importance scale_importance(std::span<const Point_2> centers, std::span<const double> radii,
                                  std::span<const double> slopes, Progress& progress) {
  Scale_importance result;
  result.values.assign(centers.size(), infinity);
  result.witnesses.assign(centers.size(), -1);
  result.disk_of_entry.resize(centers.size());
  std::iota(result.disk_of_entry.begin(), result.disk_of_entry.end(), 0);
  if (centers.empty()) return result;
  const auto disks = spheres(centers, radii);
  const auto hierarchy = std::make_shared<const Scale_importance::Hierarchy>(disks, progress);
  hierarchy->find_all(slopes, result.values, result.witnesses, progress);
  result.hierarchy = hierarchy;
  return result;
}

Scale_importance_3 scale_importance(std::span<const Point_3> centers, std::span<const double> radii,
                                    std::span<const double> slopes, Progress& progress) {
  Scale_importance_3 result;
  result.values.assign(centers.size(), infinity);
  result.witnesses.assign(centers.size(), -1);
  if (centers.empty()) return result;
  const auto balls = spheres(centers, radii);
  scale_search::Hierarchy<3>(balls, progress).find_all(slopes, result.values, result.witnesses, progress);
  return result;
}

Scale_importance update_scale_importance(const Scale_importance& old, std::span<const int> old_index,
                                         std::span<const Point_2> centers, std::span<const double> radii,
                                         std::span<const double> slopes, Progress& progress) {
  const std::size_t count = centers.size();
  std::vector<int> new_index(old.values.size(), -1);
  std::vector<int> added;
  for (std::size_t i = 0; i < count; ++i) {
    if (old_index[i] >= 0) {
      new_index[old_index[i]] = static_cast<int>(i);
    } else {
      added.push_back(static_cast<int>(i));
    }
  }
  Scale_importance result;
  result.hierarchy = old.hierarchy;
  result.disk_of_entry.reserve(old.disk_of_entry.size());
  std::vector<bool> is_inside(count, false);
  for (const int disk : old.disk_of_entry) {
    const int now = disk < 0 ? -1 : new_index[disk];
    result.disk_of_entry.push_back(now);
    if (now >= 0) is_inside[now] = true;
  }
  std::vector<int> outside;
  for (std::size_t i = 0; i < count; ++i)
    if (!is_inside[i]) outside.push_back(static_cast<int>(i));
  if (!old.hierarchy || outside.size() > most_outside_hierarchy)
    return scale_importance(centers, radii, slopes, progress);

  result.values.assign(count, infinity);
  result.witnesses.assign(count, -1);
  const auto& order = result.hierarchy->order();
  const auto disk = [&](std::size_t i) { return sphere(centers[i], radii[i]); };
  parallel_for(count, progress, [&](std::size_t i) {
    const Query<2> query(disk(i), slopes.empty() ? infinity : slopes[i]);
    const int before = old_index[i];
    const int witness = before < 0 ? -1 : old.witnesses[before];
    const bool is_lost = before < 0 || (witness >= 0 && new_index[witness] < 0);
    if (is_lost) {
      int candidate = -1;
      result.values[i] = result.hierarchy->importance(query, result.disk_of_entry, candidate);
      if (result.values[i] < infinity) result.witnesses[i] = result.disk_of_entry[order[candidate]];
    } else {
      result.values[i] = old.values[before];
      if (witness >= 0) result.witnesses[i] = new_index[witness];
    }
    for (const int other : is_lost ? outside : added) {
      if (!may_be_less(query.sphere(), disk(other), result.values[i] * result.values[i])) continue;
      const double value = query.quotient_below(disk(other), result.values[i]);
      if (!(value < result.values[i])) continue;
      result.values[i] = value;
      result.witnesses[i] = other;
    }
  });
  return result;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_filtrations_2/ball_scale_2.h"

#include <algorithm>

namespace mesecina {

namespace {

/// Per ball the lesser of its importance among the disks and that along edges.
std::vector<double> values_of(const Scale_importance& importance, const Delaunay_2& triangulation,
                              const Medial_axis_2& axis, Progress& progress) {
  std::vector<double> values = scale_along_edges(triangulation, axis, progress);
  for (std::size_t b = 0; b < values.size(); ++b) values[b] = std::min(values[b], importance.values[b]);
  return values;
}

}  // namespace

Ball_scale_2 ball_scale(const Delaunay_2& triangulation, const Medial_axis_2& axis, Progress& progress) {
  std::vector<double> slopes = slope_of_balls(triangulation, axis, progress);
  Scale_importance importance = scale_importance(axis.centers, axis.radii, slopes, progress);
  std::vector<double> values = values_of(importance, triangulation, axis, progress);
  return {std::move(values), axis.centers, axis.radii, axis.triangles, std::move(slopes), std::move(importance)};
}

Ball_scale_2 update_ball_scale(const Ball_scale_2& previous, const Delaunay_2& triangulation, const Medial_axis_2& axis,
                               Progress& progress) {
  std::vector<double> slopes = slope_of_balls(triangulation, axis, progress);
  // A ball is the same if it belongs to the same triangle and has the same place, size and slope.
  std::vector<int> ball_of_triangle;
  for (std::size_t b = 0; b < previous.triangles.size(); ++b) {
    const auto t = static_cast<std::size_t>(previous.triangles[b]);
    if (t >= ball_of_triangle.size()) ball_of_triangle.resize(t + 1, -1);
    ball_of_triangle[t] = static_cast<int>(b);
  }
  std::vector<int> old_index(axis.centers.size(), -1);
  for (std::size_t b = 0; b < old_index.size(); ++b) {
    const auto t = static_cast<std::size_t>(axis.triangles[b]);
    const int old = t < ball_of_triangle.size() ? ball_of_triangle[t] : -1;
    if (old >= 0 && previous.centers[old] == axis.centers[b] && previous.radii[old] == axis.radii[b] &&
        previous.slopes[old] == slopes[b])
      old_index[b] = old;
  }
  Scale_importance importance =
      update_scale_importance(previous.importance, old_index, axis.centers, axis.radii, slopes, progress);
  std::vector<double> values = values_of(importance, triangulation, axis, progress);
  return {std::move(values), axis.centers, axis.radii, axis.triangles, std::move(slopes), std::move(importance)};
}

}  // namespace mesecina

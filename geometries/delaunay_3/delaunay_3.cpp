// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_3/delaunay_3.h"

#include <utility>

#include "geometries/delaunay_3/growing_delaunay_3.h"

namespace mesecina {

Delaunay_3 delaunay(const std::vector<Point_3>& points, Progress& progress) {
  Growing_delaunay_3 triangulation;
  triangulation.add(points, progress);
  return std::move(triangulation).take();
}

}  // namespace mesecina

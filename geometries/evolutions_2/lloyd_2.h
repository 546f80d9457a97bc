// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// Per point the centroid of the part of the domain in its Voronoi cell, the point itself where that has no area. Equal
/// points have one cell. The domain's rings must not cross; inside is what an odd number of them surround.
/// Expected O(n log n + m log n) for n points and m vertices of the domain.
/// [S. Lloyd: Least squares quantization in PCM, 1982]
std::vector<Point_2> cell_centroids(std::span<const Point_2> points, const Outline_2& domain, Progress& progress);

/// The same in a box, which must have an area.
std::vector<Point_2> cell_centroids(std::span<const Point_2> points, const Box& domain, Progress& progress);

}  // namespace mesecina

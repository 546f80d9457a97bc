// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/samples_2/samples_2.h"

#include <cmath>

namespace mesecina {

double diagonal(const Outline_2& outline) {
  Box box;
  for (const Ring_2& ring : outline.rings)
    for (const Point_2& p : ring) box.add(p);
  return box.diagonal();
}

std::vector<Point_2> sample_outline(const Outline_2& outline, double step) {
  constexpr double most_points = 5e7;
  const auto pieces = [step](const Point_2& p, const Point_2& q) {
    return std::max(1.0, std::ceil(distance(p, q) / step));
  };
  double count = 0;
  for (const Ring_2& ring : outline.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) count += pieces(ring[i], ring[(i + 1) % ring.size()]);
  if (!(count <= most_points))
    throw Unavailable("sampling the outline would give " + std::to_string(count) +
                      " points, more than 50 million: choose a larger {sampling-step}");

  std::vector<Point_2> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (const Ring_2& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point_2& p = ring[i];
      const Point_2& q = ring[(i + 1) % ring.size()];
      const double n = pieces(p, q);
      samples.push_back(p);
      for (double k = 1; k < n; ++k) samples.push_back({p.x + (q.x - p.x) * (k / n), p.y + (q.y - p.y) * (k / n)});
    }
  }
  return samples;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_filtrations_3/source_balls_3.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace mesecina {

Source_balls_3 source_balls(const Medial_complex_3& axis, const Union_vertices_3& vertices) {
  // Contacts are copies of vertices of the union, and vertices at equal places are one contact.
  const auto place = [](const Point_3& p) { return std::tuple(p.x, p.y, p.z); };
  const auto place_of_vertex = [&](int v) { return place(vertices.points[v]); };
  std::vector<int> order(vertices.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int v) { return std::tuple_cat(place_of_vertex(v), std::tuple(v)); });

  Source_balls_3 result;
  result.offsets.reserve(2 * axis.face_count() + 1);
  result.offsets.push_back(0);
  std::vector<int> found;
  for (std::size_t f = 0; f < axis.face_count(); ++f) {
    for (const Point_3& contact : axis.contacts[f]) {
      found.clear();
      for (auto it = std::ranges::lower_bound(order, place(contact), {}, place_of_vertex);
           it != order.end() && vertices.points[*it] == contact; ++it) {
        const auto balls = vertices.balls_of(*it);
        found.insert(found.end(), balls.begin(), balls.end());
      }
      // The spheres of a singular triangle meet there, within rounding of a vertex that has other balls too.
      if (found.empty())
        for (const int corner : axis.face(f)) found.push_back(axis.balls[corner]);
      std::ranges::sort(found);
      found.erase(std::unique(found.begin(), found.end()), found.end());
      result.balls.insert(result.balls.end(), found.begin(), found.end());
      result.offsets.push_back(static_cast<int>(result.balls.size()));
    }
  }
  return result;
}

}  // namespace mesecina

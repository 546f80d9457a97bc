// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/vertex_voronoi_3.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include "core/disjoint_sets.h"
#include "geometries/circumcenter_3.h"
#include "geometries/parallel.h"
#include "geometries/spatial_order_3.h"
#include "geometries/union_3/vertex_delaunay_3.h"

namespace mesecina {

namespace {

/// Points at equal places become one with the balls of all of them.
void take_points(const Union_vertices_3& vertices, Vertex_voronoi_3& result, Progress& progress) {
  struct Place {
    double x, y, z;
    int vertex;
    auto operator<=>(const Place&) const = default;
  };
  std::vector<Place> places;
  places.reserve(vertices.points.size());
  for (const Point_3& p : vertices.points) places.push_back({p.x, p.y, p.z, static_cast<int>(places.size())});
  parallel_region(progress, [&] { tbb::parallel_sort(places.begin(), places.end(), std::less<>()); });
  std::vector<int> order;
  order.reserve(places.size());
  for (const Place& place : places) order.push_back(place.vertex);
  places = {};
  std::vector<int> first(order.size());
  std::vector<std::vector<int>> others;
  std::vector<int> slot(order.size(), -1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && vertices.points[order[i]] == vertices.points[order[i - 1]];
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
    if (!is_same) continue;
    const int representative = first[order[i]];
    if (slot[representative] < 0) {
      slot[representative] = static_cast<int>(others.size());
      others.emplace_back();
    }
    others[slot[representative]].push_back(order[i]);
  }
  std::vector<std::size_t> kept;
  for (std::size_t v = 0; v < first.size(); ++v)
    if (first[v] == static_cast<int>(v)) kept.push_back(v);
  sort_along_hilbert_curve(vertices.points, kept, progress);
  result.points.reserve(kept.size());
  result.ball_offsets.reserve(kept.size() + 1);
  result.balls.reserve(vertices.balls.size());
  result.ball_offsets.push_back(0);
  for (const std::size_t v : kept) {
    result.points.push_back(vertices.points[v]);
    const auto own = vertices.balls_of(static_cast<int>(v));
    const std::size_t begin = result.balls.size();
    result.balls.insert(result.balls.end(), own.begin(), own.end());
    if (slot[v] >= 0) {
      for (const int other : others[slot[v]]) {
        const auto more = vertices.balls_of(other);
        result.balls.insert(result.balls.end(), more.begin(), more.end());
      }
      const auto start = result.balls.begin() + static_cast<std::ptrdiff_t>(begin);
      std::sort(start, result.balls.end());
      result.balls.erase(std::unique(start, result.balls.end()), result.balls.end());
    }
    result.ball_offsets.push_back(static_cast<int>(result.balls.size()));
  }
}

void find_balls_of_cells(Vertex_voronoi_3& result, std::size_t ball_count, Progress& progress) {
  const std::size_t count = result.cells.size();
  result.ball_of_cell.assign(count, -1);
  std::vector<std::uint8_t> has_several(count, 0);
  parallel_for(count, progress, [&](std::size_t c) {
    if (std::ranges::min(result.cells[c]) < 0) return;
    int found = 0;
    result.for_common_balls(result.cells[c], [&](int ball) {
      if (found++ == 0) result.ball_of_cell[c] = ball;
    });
    has_several[c] = found > 1;
  });
  std::vector<std::uint8_t> has_cell(ball_count, 0);
  for (std::size_t c = 0; c < count; ++c)
    if (result.ball_of_cell[c] >= 0 && has_several[c] == 0) has_cell[result.ball_of_cell[c]] = 1;
  parallel_for(count, progress, [&](std::size_t c) {
    if (has_several[c] == 0) return;
    bool is_found = false;
    result.for_common_balls(result.cells[c], [&](int ball) {
      if (has_cell[ball] != 0 && !std::exchange(is_found, true)) result.ball_of_cell[c] = ball;
    });
  });
}

/// How far from flat a tetrahedron is, in (0, 1]: the center of its sphere has about this part of all digits.
double roundness(const std::array<Point_3, 4>& p) {
  const Point_3 u = p[1] - p[0];
  const Point_3 v = p[2] - p[0];
  const Point_3 w = p[3] - p[0];
  const double lengths = dot(u, u) * dot(v, v) * dot(w, w);
  return lengths > 0 ? std::abs(dot(u, cross(v, w))) / std::sqrt(lengths) : 0;
}

/// Voronoi edges cross the boundary of the dual complex at centers of balls only, those on whose spheres the three
/// points of the edge lie. So cells are on one side together across facets whose points have no ball in common, and
/// where a Voronoi vertex lies is asked once per class, at the one whose place is known best. Voronoi vertices at
/// centers of balls need no asking.
void label_cells(const Dual_3& dual, Vertex_voronoi_3& result, Progress& progress) {
  const Regular_3& regular = *dual.regular;
  const std::size_t count = result.cells.size();
  const auto corners_of = [&](std::size_t c) {
    std::array<Point_3, 4> corners{};
    for (int i = 0; i < 4; ++i) corners[i] = result.points[result.cells[c][i]];
    return corners;
  };
  const auto is_infinite = [&](std::size_t c) { return std::ranges::min(result.cells[c]) < 0; };

  std::vector<std::uint8_t> is_open(count, 0);  // as bits, per facet
  std::vector<float> quality(count, 0);
  parallel_for(count, progress, [&](std::size_t c) {
    if (is_infinite(c) || result.ball_of_cell[c] >= 0) return;
    quality[c] = static_cast<float>(roundness(corners_of(c)));
    for (int i = 0; i < 4; ++i) {
      const int across = result.neighbors[c][i];
      // The other cell says it.
      if (across < static_cast<int>(c) && !is_infinite(across) && result.ball_of_cell[across] < 0) continue;
      std::array<int, 3> facet{};
      for (int k = 0; k < 3; ++k) facet[k] = result.cells[c][(i + 1 + k) % 4];
      bool have_ball = false;
      result.for_common_balls(facet, [&](int) { have_ball = true; });
      if (!have_ball) is_open[c] |= static_cast<std::uint8_t>(1 << i);
    }
  });
  // At roots: a cell of the class to ask about. Infinite ones are outside.
  constexpr int outside = -1;
  std::vector<int> class_of_cell(count);
  std::vector<int> representatives(count);
  const auto find_classes = [&] {
    Disjoint_sets classes(count);
    for (std::size_t c = 0; c < count; ++c) {
      if (is_open[c] == 0) continue;
      for (int i = 0; i < 4; ++i)
        if ((is_open[c] >> i & 1) != 0) classes.join(static_cast<int>(c), result.neighbors[c][i]);
    }
    std::iota(representatives.begin(), representatives.end(), 0);
    for (std::size_t c = 0; c < count; ++c) {
      const int root = classes.find(static_cast<int>(c));
      class_of_cell[c] = root;
      int& best = representatives[root];
      if (best == outside) continue;
      if (is_infinite(c)) {
        best = outside;
      } else if (quality[c] > quality[best]) {
        best = static_cast<int>(c);
      }
    }
  };
  const auto make_room = [&] {
    result.is_inner.assign(count, 0);
    result.centers.assign(count, {});
  };
  at_once(progress, find_classes, make_room);
  std::vector<int> asked;
  for (std::size_t c = 0; c < count; ++c)
    if (class_of_cell[c] == static_cast<int>(c) && representatives[c] != outside && result.ball_of_cell[c] < 0)
      asked.push_back(static_cast<int>(c));
  parallel_for(asked.size(), progress, [&](std::size_t i) {
    const int cell = representatives[asked[i]];
    const int start = regular.cell_of_ball[result.balls_of(result.cells[cell][0]).front()];
    const int found = locate(regular, circumcenter(corners_of(cell)), start);
    if (found >= 0 && dual.has_cell[found] != 0) result.is_inner[asked[i]] = 1;
  });
  for (std::size_t c = 0; c < count; ++c) result.is_inner[c] = result.is_inner[class_of_cell[c]];
  parallel_for(count, progress, [&](std::size_t c) {
    if (result.ball_of_cell[c] >= 0) {
      result.is_inner[c] = 1;
    } else if (result.is_inner[c] != 0) {
      result.centers[c] = circumcenter(corners_of(c));
    }
  });
}

}  // namespace

Vertex_voronoi_3 vertex_voronoi(const Union_vertices_3& vertices, Progress& progress) {
  progress.begin_stage("Voronoi diagram of the vertices of the union");
  Vertex_voronoi_3 result;
  take_points(vertices, result, progress);
  const std::vector<Ball_3>& balls = vertices.dual->regular->balls;
  vertex_delaunay({result.points, result.ball_offsets, result.balls, balls}, result.cells, result.neighbors, progress);
  progress.check();
  find_balls_of_cells(result, balls.size(), progress);
  label_cells(*vertices.dual, result, progress);
  return result;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/power_crust_3/power_crust_3.h"

#include <algorithm>
#include <utility>

#include "core/disjoint_sets.h"
#include "geometries/edge_ring_3.h"
#include "geometries/parallel.h"
#include "geometries/union_3/power_center_3.h"

namespace mesecina {

namespace {

/// The first sample that lies on the spheres of all these poles; -1 for none.
int shared_sample(const Poles_3& poles, std::array<int, 4> four) {
  std::ranges::sort(four, {}, [&](int pole) { return poles.contacts_of(pole).size(); });
  for (const int point : poles.contacts_of(four[0])) {
    if (point >= static_cast<int>(poles.sample_count)) break;
    const auto has_it = [&](int pole) { return std::ranges::binary_search(poles.contacts_of(pole), point); };
    if (has_it(four[1]) && has_it(four[2]) && has_it(four[3])) return point;
  }
  return -1;
}

class Crust_builder {
 public:
  Crust_builder(const Polar_balls_3& polar, Progress& progress)
      : polar_(polar), poles_(*polar.poles), regular_(*polar.regular), progress_(progress) {}

  Power_crust_3 build() {
    progress_.begin_stage("power crust");
    find_rings();
    find_positions();
    number_vertices();
    add_faces();
    return std::move(result_);
  }

 private:
  bool is_inner(int pole) const { return pole >= 0 && polar_.is_inner[pole] != 0; }
  std::size_t ring_count() const { return ring_poles_.size(); }
  std::span<const int> ring(std::size_t i) const {
    return std::span(ring_cells_).subspan(ring_offsets_[i], ring_offsets_[i + 1] - ring_offsets_[i]);
  }

  /// The cells around each edge between an inner and an outer pole. Around none of these is an infinite cell, for only
  /// infinite poles are on the hull.
  void find_rings() {
    ring_offsets_.push_back(0);
    const auto add_ring = [&](int cell, int inner_place, int outer_place) {
      const std::size_t begin = ring_cells_.size();
      const bool is_whole =
          walk_around_edge(regular_.cells, regular_.neighbors, cell, inner_place, outer_place, [&](int current) {
            if (current < cell || regular_.is_infinite(current)) return false;
            ring_cells_.push_back(current);
            return true;
          });
      if (!is_whole) {
        ring_cells_.resize(begin);
        return;
      }
      ring_offsets_.push_back(static_cast<int>(ring_cells_.size()));
      ring_poles_.push_back({regular_.cells[cell][inner_place], regular_.cells[cell][outer_place]});
    };
    for (int c = 0; c < static_cast<int>(regular_.cells.size()); ++c) {
      constexpr int often = 4096;
      if (c % often == 0) progress_.check();
      if (regular_.is_infinite(c)) continue;
      const auto& corners = regular_.cells[c];
      for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4 && is_inner(corners[i]); ++j)
          if (!is_inner(corners[j])) add_ring(c, i, j);
    }
  }

  void find_positions() {
    Box box;
    for (std::size_t s = 0; s < poles_.sample_count; ++s) box.add(poles_.points[s]);
    constexpr double allowed_error = 1e-9;
    const double error = allowed_error * box.diagonal();
    const std::size_t count = regular_.cells.size();
    std::vector<std::uint8_t> is_used(count, 0);
    for (const int cell : ring_cells_) is_used[cell] = 1;
    samples_.assign(count, -1);
    centers_.resize(count);
    parallel_for(count, progress_, [&](std::size_t c) {
      if (is_used[c] == 0) return;
      samples_[c] = shared_sample(poles_, regular_.cells[c]);
      if (samples_[c] >= 0) {
        centers_[c] = poles_.points[samples_[c]];
        return;
      }
      centers_[c] = power_center(regular_, static_cast<int>(c), error);
    });
  }

  /// What edges of the surface join, at one sample, becomes one vertex: if that is a disk, faces have it in one piece,
  /// and no two edges get the same ends. Otherwise the surface would be pinched there.
  void number_vertices() {
    join_places();
    tear_pinched_places();
    while (tear_doubled_edges()) progress_.check();
    vertex_of_cell_.assign(regular_.cells.size(), -1);
    for (const int cell : ring_cells_) {
      const int first = place_of_cell_[cell];
      if (vertex_of_cell_[first] < 0) {
        vertex_of_cell_[first] = static_cast<int>(result_.vertices.size());
        result_.vertices.push_back(centers_[first]);
        result_.samples.push_back(samples_[first]);
      }
      vertex_of_cell_[cell] = vertex_of_cell_[first];
    }
  }

  void join_places() {
    const std::size_t count = regular_.cells.size();
    Disjoint_sets places(count);
    for_each_step([&](int cell, int next) {
      if (samples_[cell] >= 0 && samples_[cell] == samples_[next]) places.join(cell, next);
    });
    place_of_cell_.resize(count);
    for (std::size_t c = 0; c < count; ++c) place_of_cell_[c] = places.find(static_cast<int>(c));
  }

  /// Each cell of a torn place becomes a place of its own. False when nothing changes.
  bool tear(const std::vector<std::uint8_t>& is_torn) {
    bool is_any = false;
    for (std::size_t c = 0; c < place_of_cell_.size(); ++c) {
      if (is_torn[place_of_cell_[c]] == 0 || place_of_cell_[c] == static_cast<int>(c)) continue;
      place_of_cell_[c] = static_cast<int>(c);
      is_any = true;
    }
    return is_any;
  }

  void tear_pinched_places() {
    const std::size_t count = regular_.cells.size();
    std::vector<int> twice_euler(count, 0);
    std::vector<std::uint8_t> is_seen(count, 0);
    for (const int cell : ring_cells_) {
      if (is_seen[cell] == 0) twice_euler[place_of_cell_[cell]] += 2;
      is_seen[cell] = 1;
    }
    for_each_step([&](int cell, int next) {
      if (place_of_cell_[cell] == place_of_cell_[next]) --twice_euler[place_of_cell_[cell]];
    });
    std::vector<std::uint8_t> is_torn(count, 0);
    std::vector<int> entered;
    for (std::size_t r = 0; r < ring_count(); ++r) {
      entered.clear();
      int previous = place_of_cell_[ring(r).back()];
      for (const int cell : ring(r)) {
        const int place = place_of_cell_[cell];
        if (place != previous) {
          if (std::ranges::find(entered, place) != entered.end()) is_torn[place] = 1;
          entered.push_back(place);
        }
        previous = place;
      }
      if (entered.empty()) twice_euler[previous] += 2;
    }
    for (const int cell : ring_cells_)
      if (twice_euler[place_of_cell_[cell]] != 2) is_torn[place_of_cell_[cell]] = 1;
    tear(is_torn);
  }

  /// An edge between two places: these, and its two cells, each ascending.
  using Edge = std::array<int, 4>;

  Edge edge_between(int cell, int next) const {
    const auto [u, v] = std::minmax(place_of_cell_[cell], place_of_cell_[next]);
    return {u, v, std::min(cell, next), std::max(cell, next)};
  }

  /// False when there were none to tear. Edges with a face of two edges between them are one.
  bool tear_doubled_edges() {
    std::vector<Edge> edges;
    for_each_step([&](int cell, int next) {
      if (place_of_cell_[cell] != place_of_cell_[next] && (samples_[cell] >= 0 || samples_[next] >= 0))
        edges.push_back(edge_between(cell, next));
    });
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    Disjoint_sets same(edges.size());
    const auto number = [&](const Edge& edge) {
      return static_cast<int>(std::ranges::lower_bound(edges, edge) - edges.begin());
    };
    std::vector<Edge> sides;
    for (std::size_t r = 0; r < ring_count(); ++r) {
      sides.clear();
      int previous = ring(r).back();
      for (const int cell : ring(r)) {
        if (place_of_cell_[cell] != place_of_cell_[previous]) sides.push_back(edge_between(previous, cell));
        previous = cell;
      }
      if (sides.size() == 2) same.join(number(sides[0]), number(sides[1]));
    }
    std::vector<std::uint8_t> is_torn(regular_.cells.size(), 0);
    for (int e = 1; e < static_cast<int>(edges.size()); ++e) {
      if (edges[e][0] != edges[e - 1][0] || edges[e][1] != edges[e - 1][1] || same.find(e) == same.find(e - 1))
        continue;
      is_torn[edges[e][0]] = is_torn[edges[e][1]] = 1;
    }
    return tear(is_torn);
  }

  /// Calls function(cell, next) for the sides of all rings; each edge of the surface is twice among them.
  template <class Function>
  void for_each_step(const Function& function) const {
    for (std::size_t r = 0; r < ring_count(); ++r) {
      int previous = ring(r).back();
      for (const int cell : ring(r)) function(std::exchange(previous, cell), cell);
    }
  }

  void add_faces() {
    result_.face_offsets.push_back(0);
    std::vector<int> corners;
    for (std::size_t r = 0; r < ring_count(); ++r) {
      corners.clear();
      for (const int cell : ring(r))
        if (corners.empty() || corners.back() != vertex_of_cell_[cell]) corners.push_back(vertex_of_cell_[cell]);
      while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
      constexpr std::size_t least = 3;
      if (corners.size() < least) continue;
      result_.face_vertices.insert(result_.face_vertices.end(), corners.begin(), corners.end());
      result_.face_offsets.push_back(static_cast<int>(result_.face_vertices.size()));
      result_.poles.push_back(ring_poles_[r]);
    }
  }

  const Polar_balls_3& polar_;
  const Poles_3& poles_;
  const Regular_3& regular_;
  Progress& progress_;
  std::vector<std::array<int, 2>> ring_poles_;  ///< per ring the inner and the outer one
  std::vector<int> ring_offsets_;
  std::vector<int> ring_cells_;
  std::vector<int> samples_;        ///< per cell of a ring the sample that it is; -1 for none
  std::vector<Point_3> centers_;    ///< per cell of a ring its power center
  std::vector<int> place_of_cell_;  ///< by the first cell of the place
  std::vector<int> vertex_of_cell_;
  Power_crust_3 result_;
};

}  // namespace

Power_crust_3 power_crust(const Polar_balls_3& polar, Progress& progress) {
  return Crust_builder(polar, progress).build();
}

}  // namespace mesecina

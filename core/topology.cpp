// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/disjoint_sets.h"
#include "core/primitives.h"

namespace mesecina {
namespace {

/// Groups of integers, one after the other.
struct Groups {
  std::vector<int> offsets{0};
  std::vector<int> members;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const int> operator[](std::size_t i) const {
    return std::span(members).subspan(offsets[i], offsets[i + 1] - offsets[i]);
  }
  void close() { offsets.push_back(static_cast<int>(members.size())); }
};

/// The triangles, then the polygons of a set, as cycles of vertices.
Groups faces_of(const Primitive_set& set) {
  Groups faces;
  faces.members.reserve(3 * set.triangles.size() + set.polygon_vertices.size());
  faces.offsets.reserve(set.triangles.size() + set.polygon_count() + 1);
  for (const auto& triangle : set.triangles) {
    faces.members.insert(faces.members.end(), triangle.begin(), triangle.end());
    faces.close();
  }
  for (std::size_t i = 0; i < set.polygon_count(); ++i) {
    const auto polygon = set.polygon(i);
    faces.members.insert(faces.members.end(), polygon.begin(), polygon.end());
    faces.close();
  }
  return faces;
}

/// The different edges of faces and segments.
struct Edges {
  std::vector<std::array<int, 2>> ends;
  Groups faces;  ///< of each edge, increasing; a face that visits it an even number of times is not there
};

constexpr int no_face = -1;

/// Sorted by their vertices in two passes, of which the first is a counting sort.
Edges edges_of(const Groups& faces, const Primitive_set& set) {
  struct Side {
    int other = 0;  ///< the larger vertex; the smaller one is that of the bucket
    int face = 0;
    auto operator<=>(const Side&) const = default;
  };
  const auto each_side = [&](const auto& use) {
    for (std::size_t face = 0; face < faces.size(); ++face) {
      const auto cycle = faces[face];
      for (std::size_t i = 0; i < cycle.size(); ++i) {
        const auto [low, high] = std::minmax(cycle[i], cycle[i + 1 == cycle.size() ? 0 : i + 1]);
        use(low, Side{high, static_cast<int>(face)});
      }
    }
    for (const auto& [from, to] : set.segments) use(std::min(from, to), Side{std::max(from, to), no_face});
  };
  std::vector<std::size_t> ends(set.vertices.size() + 1, 0);
  each_side([&](int low, const Side&) { ++ends[low]; });
  std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), std::size_t{0});
  std::vector<Side> sides(ends.back());
  each_side([&](int low, const Side& side) { sides[ends[low]++] = side; });

  Edges edges;
  std::size_t begin = 0;
  for (std::size_t low = 0; low < set.vertices.size(); begin = ends[low++]) {
    const auto bucket = std::span(sides).subspan(begin, ends[low] - begin);
    std::ranges::sort(bucket);
    for (std::size_t i = 0; i < bucket.size();) {
      const int high = bucket[i].other;
      edges.ends.push_back({static_cast<int>(low), high});
      for (std::size_t j = i; i < bucket.size() && bucket[i].other == high; i = j) {
        while (j < bucket.size() && bucket[j] == bucket[i]) ++j;
        if ((j - i) % 2 == 1 && bucket[i].face != no_face) edges.faces.members.push_back(bucket[i].face);
      }
      edges.faces.close();
    }
  }
  return edges;
}

/// A sum of unknowns over the field of two elements: their numbers, increasing.
using Sum = std::vector<int>;

/// Adds `other`, whose unknowns cancel those that are there already; `scratch` only saves allocations.
void add(Sum& sum, std::span<const int> other, Sum& scratch) {
  if (other.empty()) return;
  scratch.clear();
  std::ranges::set_symmetric_difference(sum, other, std::back_inserter(scratch));
  sum.swap(scratch);
}

/// Counts independent equations as they come.
class Equations {
 public:
  explicit Equations(int unknown_count) : by_last_unknown_(unknown_count) {}

  /// sum = 0; uses `sum` up.
  void add_equation(Sum& sum) {
    while (!sum.empty()) {
      Sum& known = by_last_unknown_[sum.back()];
      if (known.empty()) {
        known.swap(sum);
        ++rank_;
        return;
      }
      add(sum, known, scratch_);
    }
  }
  std::int64_t rank() const { return rank_; }

 private:
  std::vector<Sum> by_last_unknown_;
  Sum scratch_;
  std::int64_t rank_ = 0;
};

/// The dimension of the space of cycles: of the sets of faces of which every edge bounds an even number.
///
/// Faces are taken away one by one. A face that is the last one at an edge goes at once: whether a cycle holds it
/// follows from the faces that were taken from this edge before. When there is no such face, the next one in the order
/// of a breadth-first walk becomes an unknown, so there are few unknowns that a face can depend on. An edge that never
/// decided over a face gives an equation between unknowns.
class Cycle_counter {
 public:
  Cycle_counter(const Groups& faces, const Edges& edges)
      : edges_(edges.faces), sums_(faces.size()), is_gone_(faces.size(), false), has_decided_(edges_.size(), false) {
    edges_of_faces_ = transposed(edges_, faces.size());
    left_.reserve(edges_.size());
    for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
      left_.push_back(static_cast<int>(edges_[edge].size()));
      if (left_.back() == 1) free_edges_.push_back(static_cast<int>(edge));
    }
  }

  /// Once.
  std::int64_t count() {
    collapse();
    while (const std::optional<int> face = next_face()) {
      sums_[*face] = {pool_.size(), 1};
      pool_.push_back(unknown_count_++);
      take_away(*face);
      collapse();
    }
    Equations equations(unknown_count_);
    for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
      if (has_decided_[edge]) continue;
      sum_at(static_cast<int>(edge));
      equations.add_equation(total_);
    }
    return unknown_count_ - equations.rank();
  }

 private:
  struct Place {
    std::size_t begin = 0;
    std::size_t length = 0;
  };

  static Groups transposed(const Groups& groups, std::size_t member_count) {
    Groups result;
    result.offsets.assign(member_count + 1, 0);
    for (const int member : groups.members) ++result.offsets[member + 1];
    std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
    result.members.resize(groups.members.size());
    std::vector<int> next(result.offsets.begin(), result.offsets.end() - 1);
    for (std::size_t group = 0; group < groups.size(); ++group)
      for (const int member : groups[group]) result.members[next[member]++] = static_cast<int>(group);
    return result;
  }

  std::span<const int> sum_of(int face) const {
    return std::span(pool_).subspan(sums_[face].begin, sums_[face].length);
  }

  /// Puts the sum over the faces that are gone from an edge in total_. Merging is faster for few of them, sorting is
  /// not quadratic for many.
  void sum_at(int edge) {
    constexpr std::size_t many = 16;
    const auto faces = edges_[edge];
    total_.clear();
    if (faces.size() < many) {
      for (const int face : faces)
        if (is_gone_[face]) add(total_, sum_of(face), scratch_);
      return;
    }
    scratch_.clear();
    for (const int face : faces)
      if (is_gone_[face]) scratch_.insert(scratch_.end(), sum_of(face).begin(), sum_of(face).end());
    std::ranges::sort(scratch_);
    for (std::size_t i = 0; i < scratch_.size();) {
      const bool is_pair = i + 1 < scratch_.size() && scratch_[i] == scratch_[i + 1];
      if (!is_pair) total_.push_back(scratch_[i]);
      i += is_pair ? 2 : 1;
    }
  }

  void take_away(int face) {
    is_gone_[face] = true;
    for (const int edge : edges_of_faces_[face]) {
      --left_[edge];
      if (left_[edge] == 1) free_edges_.push_back(edge);
      if (left_[edge] > 1 && sums_[face].length != 0) walk_.push_back(edge);
    }
  }

  void collapse() {
    for (; next_free_edge_ < free_edges_.size(); ++next_free_edge_) {
      const int edge = free_edges_[next_free_edge_];
      if (left_[edge] != 1) continue;
      has_decided_[edge] = true;
      const int last = *std::ranges::find_if(edges_[edge], [&](int face) { return !is_gone_[face]; });
      decide(last, edge);
      take_away(last);
    }
  }

  /// Gives `last` the sum of the other faces of the edge; shares it if it is that of one of them.
  void decide(int last, int edge) {
    int with_sum = 0;
    for (const int face : edges_[edge]) {
      if (face == last || sums_[face].length == 0) continue;
      sums_[last] = sums_[face];
      ++with_sum;
    }
    if (with_sum < 2) return;
    sum_at(edge);
    sums_[last] = {pool_.size(), total_.size()};
    pool_.insert(pool_.end(), total_.begin(), total_.end());
  }

  /// The one that becomes an unknown: at the first edge of the walk that has any, else any.
  std::optional<int> next_face() {
    const auto is_left = [&](int face) { return !is_gone_[face]; };
    for (; next_edge_ < walk_.size(); ++next_edge_, next_in_edge_ = 0) {
      if (left_[walk_[next_edge_]] == 0) continue;
      const auto faces = edges_[walk_[next_edge_]];
      const auto found = std::find_if(faces.begin() + next_in_edge_, faces.end(), is_left);
      next_in_edge_ = found - faces.begin();
      if (found != faces.end()) return *found;
    }
    while (next_face_ < is_gone_.size() && is_gone_[next_face_]) ++next_face_;
    return next_face_ < is_gone_.size() ? std::optional(static_cast<int>(next_face_)) : std::nullopt;
  }

  const Groups& edges_;  ///< the faces of each
  Groups edges_of_faces_;
  std::vector<Place> sums_;  ///< in pool_, of each face: 1 in a cycle, 0 not; all that is known is what is gone
  std::vector<int> pool_;
  std::vector<bool> is_gone_;
  std::vector<bool> has_decided_;  ///< per edge
  std::vector<int> left_;          ///< per edge, the number of its faces that are not gone
  std::vector<int> free_edges_;
  std::size_t next_free_edge_ = 0;
  std::vector<int> walk_;  ///< edges of faces that are gone
  std::size_t next_edge_ = 0;
  std::ptrdiff_t next_in_edge_ = 0;
  std::size_t next_face_ = 0;
  int unknown_count_ = 0;
  Sum total_;
  Sum scratch_;
};

std::int64_t count_components(const std::vector<bool>& used, std::span<const std::array<int, 2>> edges) {
  Disjoint_sets parts(used.size());
  std::int64_t count = std::ranges::count(used, true);
  for (const auto& [from, to] : edges)
    if (parts.join(from, to)) --count;
  return count;
}

}  // namespace

std::optional<Topology> topology(const Primitive_set& set) {
  if (set.known_topology) return set.known_topology;
  const bool is_in_space = set.dimension == 3;
  if (!set.is_complex || !set.rays.empty() || !set.balls.empty() || (set.polygon_count() != 0 && !is_in_space))
    return std::nullopt;

  const Groups faces = faces_of(set);
  Edges edges;
  if (faces.size() == 0)
    edges.ends = set.segments;
  else
    edges = edges_of(faces, set);
  Topology result;
  if (is_in_space && faces.size() != 0) result.betti[2] = Cycle_counter(faces, edges).count();

  for (const Arc& arc : set.arcs) edges.ends.push_back({arc.from, arc.to});
  std::vector<bool> used(set.vertices.size(), false);
  for (const int vertex : set.points) used[vertex] = true;
  for (const auto& [from, to] : edges.ends) used[from] = used[to] = true;
  result.betti[0] = count_components(used, edges.ends);
  result.euler = std::ranges::count(used, true) - static_cast<std::int64_t>(edges.ends.size()) +
                 static_cast<std::int64_t>(faces.size());
  result.betti[1] = result.betti[0] + result.betti[2] - result.euler;
  return result;
}

}  // namespace mesecina

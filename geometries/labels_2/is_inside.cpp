// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

#include "geometries/labels_2/labels_2.h"
#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A segment that is not horizontal, from its lower to its upper end.
struct Edge {
  Point_2 lower;
  Point_2 upper;
};

/// The edges sorted into horizontal strips of equal height; an edge is in every strip that it meets.
class Strips {
 public:
  explicit Strips(const Outline_2& outline) {
    for (const Ring_2& ring : outline.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point_2& p = ring[i];
        const Point_2& q = ring[(i + 1) % ring.size()];
        if (p.y != q.y) edges_.push_back(p.y < q.y ? Edge{p, q} : Edge{q, p});
      }
    }
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const Edge& edge : edges_) {
      lowest = std::min(lowest, edge.lower.y);
      highest = std::max(highest, edge.upper.y);
    }
    lowest_ = lowest;
    highest_ = highest;
    const std::size_t count = std::max<std::size_t>(1, edges_.size());
    strips_per_unit_ = static_cast<double>(count) / (highest - lowest);
    first_.assign(count + 1, 0);
    if (edges_.empty()) return;
    for (const Edge& edge : edges_)
      for (std::size_t s = strip(edge.lower.y); s <= strip(edge.upper.y); ++s) ++first_[s + 1];
    for (std::size_t s = 0; s < count; ++s) first_[s + 1] += first_[s];
    members_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (std::size_t s = strip(edges_[e].lower.y); s <= strip(edges_[e].upper.y); ++s)
        members_[next[s]++] = static_cast<int>(e);
  }

  /// Parity of the edges that the ray from `query` to the right crosses; an edge owns its lower end only.
  bool contains(const Point_2& query) const {
    if (!(query.y >= lowest_ && query.y < highest_)) return false;
    const std::size_t s = strip(query.y);
    bool inside = false;
    for (std::size_t m = first_[s]; m < first_[s + 1]; ++m) {
      const Edge& edge = edges_[members_[m]];
      if (query.y < edge.lower.y || query.y >= edge.upper.y) continue;
      if (query.x > std::max(edge.lower.x, edge.upper.x)) continue;
      if (query.x < std::min(edge.lower.x, edge.upper.x) ||
          CGAL::orientation(Kernel::Point_2(edge.lower.x, edge.lower.y), Kernel::Point_2(edge.upper.x, edge.upper.y),
                            Kernel::Point_2(query.x, query.y)) == CGAL::LEFT_TURN)
        inside = !inside;
    }
    return inside;
  }

 private:
  std::size_t strip(double y) const {
    const double s = (y - lowest_) * strips_per_unit_;
    const std::size_t last = first_.size() - 2;
    return s >= static_cast<double>(last) ? last : static_cast<std::size_t>(std::max(0.0, s));
  }

  std::vector<Edge> edges_;
  double lowest_ = 0;
  double highest_ = 0;
  double strips_per_unit_ = 0;
  std::vector<std::size_t> first_;  ///< per strip, where its members begin
  std::vector<int> members_;
};

}  // namespace

std::vector<std::uint8_t> is_inside(const Outline_2& outline, std::span<const Point_2> queries, Progress& progress) {
  const Strips strips(outline);
  std::vector<std::uint8_t> inside(queries.size());
  parallel_for(queries.size(), progress, [&](std::size_t i) { inside[i] = strips.contains(queries[i]) ? 1 : 0; });
  return inside;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>

#include "geometries/labels_2/labels_2.h"
#include "geometries/parallel.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Edge {
  Point_2 p;
  Point_2 q;
};

/// The sides of an outline in the cells of a grid, and for each cell whether a reference point in it is inside. A query
/// is answered by walking from it to the reference point of its cell, first horizontally, then vertically, and counting
/// the edges on the way.
///
/// Every point stands for one moved by (d, e) with infinitely small 0 < e << d, so that no walk meets a vertex and no
/// point lies on an edge.
class Grid {
 public:
  /// `queries`: how many are to be expected; more of them are worth a finer grid.
  Grid(const Outline_2& outline, std::size_t queries, const Progress& progress) {
    Box box;
    for (const Ring_2& ring : outline.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point_2& p = ring[i];
        const Point_2& q = ring[(i + 1) % ring.size()];
        box.add(p);
        if (p != q) edges_.push_back({p, q});
      }
    }
    if (edges_.empty()) return;
    lower_ = {box.lower.x, box.lower.y};
    upper_ = {box.upper.x, box.upper.y};
    choose_size(edges_.size() + queries);
    fill(progress);
    find_references(progress);
  }

  bool contains(const Point_2& query) const {
    if (edges_.empty() || !(query.x >= lower_.x && query.x <= upper_.x && query.y >= lower_.y && query.y <= upper_.y))
      return false;
    const std::size_t column = columns_.cell(query.x);
    const std::size_t row = rows_.cell(query.y);
    const std::size_t cell = row * columns_.count + column;
    const Point_2 reference{columns_.middle(column), rows_.middle(row)};
    const Point_2 turn{reference.x, query.y};
    bool inside = is_reference_inside_[cell];
    for (std::size_t m = first_[cell]; m < first_[cell + 1]; ++m) {
      const Edge& edge = edges_[members_[m]];
      if (spans(edge.p.y, edge.q.y, query.y) && is_left(edge, query) != is_left(edge, turn)) inside = !inside;
      if (spans(edge.p.x, edge.q.x, turn.x) && is_left(edge, turn) != is_left(edge, reference)) inside = !inside;
    }
    return inside;
  }

 private:
  /// One direction of the grid. `cell` is monotone, so that all that lies between two points of a cell is in it.
  struct Axis {
    double low = 0;
    double size = 0;  ///< of the whole
    std::size_t count = 1;

    std::size_t cell(double x) const {
      if (count == 1) return 0;
      const double c = (x - low) / size * static_cast<double>(count);
      return c > 0 ? std::min(count - 1, static_cast<std::size_t>(c)) : 0;
    }
    double middle(std::size_t i) const {
      return low + size * ((static_cast<double>(i) + 0.5) / static_cast<double>(count));
    }
  };

  static bool spans(double a, double b, double x) { return (a <= x) != (b <= x); }

  /// Of the line from p to q; exact.
  static bool is_left(const Edge& edge, const Point_2& point) {
    const CGAL::Orientation turn = CGAL::orientation(
        Kernel::Point_2(edge.p.x, edge.p.y), Kernel::Point_2(edge.q.x, edge.q.y), Kernel::Point_2(point.x, point.y));
    if (turn != CGAL::COLLINEAR) return turn == CGAL::LEFT_TURN;
    return edge.p.y != edge.q.y ? edge.q.y < edge.p.y : edge.p.x < edge.q.x;
  }

  /// As many cells as pay, but so few that the members of all cells together stay linear in `work`: long edges crowded
  /// in one direction (a comb) want cells that are long in this direction.
  void choose_size(std::size_t work) {
    const double budget = 16 * static_cast<double>(work);
    const double most_cells = std::max(1.0, static_cast<double>(work) / 2);
    columns_.low = lower_.x;
    rows_.low = lower_.y;
    columns_.size = upper_.x - lower_.x;
    rows_.size = upper_.y - lower_.y;
    double across = 0;
    double along = 0;
    for (const Edge& edge : edges_) {
      across += std::abs(edge.q.x - edge.p.x) / columns_.size;
      along += std::abs(edge.q.y - edge.p.y) / rows_.size;
    }
    const auto affordable = [&](const Axis& axis, double crossings) {
      const bool can_be_cut = axis.size > 0 && std::isfinite(axis.size) && std::isfinite(crossings);
      return can_be_cut ? std::clamp(budget / crossings, 1.0, most_cells) : 1.0;
    };
    double columns = affordable(columns_, across);
    double rows = affordable(rows_, along);
    if (const double excess = columns * rows / most_cells; excess > 1) {
      const double factor = std::sqrt(excess);
      columns = std::max(1.0, columns / factor);
      rows = std::max(1.0, rows / factor);
    }
    columns_.count = static_cast<std::size_t>(std::min(columns, most_cells / rows));
    rows_.count = static_cast<std::size_t>(rows);
    for (Axis* axis : {&columns_, &rows_}) {
      axis->count = std::max<std::size_t>(1, axis->count);
      // Too fine for the numbers there are.
      for (std::size_t i = 0; i < axis->count; ++i)
        if (axis->cell(axis->middle(i)) != i) axis->count = 1;
    }
  }

  /// Calls visit(cell) for every cell that the edge may meet.
  template <class Visit>
  void each_cell(const Edge& edge, const Visit& visit) const {
    const auto [left, right] = std::minmax({columns_.cell(edge.p.x), columns_.cell(edge.q.x)});
    const std::size_t bottom = std::min(rows_.cell(edge.p.y), rows_.cell(edge.q.y));
    const std::size_t top = std::max(rows_.cell(edge.p.y), rows_.cell(edge.q.y));
    // Far more than the rounding errors of what follows.
    constexpr double slack = 1e-9;
    const double x0 = (edge.p.x - columns_.low) / columns_.size;
    const double dx = (edge.q.x - columns_.low) / columns_.size - x0;
    for (std::size_t column = left; column <= right; ++column) {
      std::size_t low = bottom;
      std::size_t high = top;
      if (left < right && bottom < top) {
        const auto count = static_cast<double>(columns_.count);
        const double at_left = (static_cast<double>(column) / count - slack - x0) / dx;
        const double at_right = ((static_cast<double>(column) + 1) / count + slack - x0) / dx;
        const auto row_at = [&](double t, double shift) {
          const double y = edge.p.y + (edge.q.y - edge.p.y) * std::clamp(t, 0.0, 1.0);
          return std::clamp(rows_.cell(y + shift * rows_.size), bottom, top);
        };
        low = std::min(row_at(at_left, -slack), row_at(at_right, -slack));
        high = std::max(row_at(at_left, slack), row_at(at_right, slack));
      }
      for (std::size_t row = low; row <= high; ++row) visit(row * columns_.count + column);
    }
  }

  void fill(const Progress& progress) {
    first_.assign(columns_.count * rows_.count + 1, 0);
    for (const Edge& edge : edges_) {
      progress.check();
      each_cell(edge, [&](std::size_t cell) { ++first_[cell + 1]; });
    }
    for (std::size_t cell = 1; cell < first_.size(); ++cell) first_[cell] += first_[cell - 1];
    members_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      progress.check();
      each_cell(edges_[e], [&](std::size_t cell) { members_[next[cell]++] = static_cast<int>(e); });
    }
  }

  /// Counts the edges to the left of each reference point: every edge changes, in each row whose middle it passes, the
  /// side of all reference points to its right.
  void find_references(const Progress& progress) {
    is_reference_inside_.assign(columns_.count * rows_.count, 0);
    for (const Edge& edge : edges_) {
      progress.check();
      const std::size_t bottom = std::min(rows_.cell(edge.p.y), rows_.cell(edge.q.y));
      const std::size_t top = std::max(rows_.cell(edge.p.y), rows_.cell(edge.q.y));
      const bool goes_up = edge.p.y < edge.q.y;
      for (std::size_t row = bottom; row <= top; ++row) {
        const double y = rows_.middle(row);
        if (!spans(edge.p.y, edge.q.y, y)) continue;
        std::size_t low = 0;
        std::size_t high = columns_.count;
        while (low < high) {
          const std::size_t middle = (low + high) / 2;
          if (is_left(edge, {columns_.middle(middle), y}) == goes_up) {
            low = middle + 1;
          } else {
            high = middle;
          }
        }
        if (low < columns_.count) is_reference_inside_[row * columns_.count + low] ^= 1;
      }
    }
    for (std::size_t row = 0; row < rows_.count; ++row)
      for (std::size_t cell = row * columns_.count + 1; cell < (row + 1) * columns_.count; ++cell)
        is_reference_inside_[cell] ^= is_reference_inside_[cell - 1];
  }

  std::vector<Edge> edges_;
  Point_2 lower_;
  Point_2 upper_;
  Axis columns_;
  Axis rows_;
  std::vector<std::size_t> first_;  ///< per cell, where its members begin
  std::vector<int> members_;
  std::vector<std::uint8_t> is_reference_inside_;
};

}  // namespace

std::vector<std::uint8_t> is_inside(const Outline_2& outline, std::span<const Point_2> queries, Progress& progress) {
  const Grid grid(outline, queries.size(), progress);
  std::vector<std::uint8_t> inside(queries.size());
  parallel_for(queries.size(), progress, [&](std::size_t i) { inside[i] = grid.contains(queries[i]) ? 1 : 0; });
  return inside;
}

}  // namespace mesecina

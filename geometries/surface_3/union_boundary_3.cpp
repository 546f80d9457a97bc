// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/union_boundary_3.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include "core/disjoint_sets.h"
#include "geometries/parallel.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

double length(const Point_3& p) { return std::sqrt(dot(p, p)); }

Point_3 some_perpendicular(const Point_3& p) {
  const Point_3 axis = std::abs(p.x) < std::abs(p.y) ? Point_3{1, 0, 0} : Point_3{0, 1, 0};
  const Point_3 q = cross(p, axis);
  return (1 / length(q)) * q;
}

/// An edge of a cell seen from one of its two triangles there, the one without `entry`; the other one is without
/// `exit`.
struct Wedge {
  int cell = 0;
  int first = 0;  ///< places
  int second = 0;
  int entry = 0;
  int exit = 0;
};

/// The places (first, second, exit, entry) are an even permutation: from the one triangle through the cell to the other
/// one it goes counterclockwise about the axis from first to second.
bool is_counterclockwise(const Wedge& wedge) {
  const std::array<int, 4> order{wedge.first, wedge.second, wedge.exit, wedge.entry};
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) inversions += static_cast<int>(order[i] > order[j]);
  return inversions % 2 == 0;
}

class Boundary_builder {
 public:
  Boundary_builder(std::shared_ptr<const Dual_3> dual, Progress& progress)
      : dual_(*dual), regular_(*dual->regular), progress_(progress) {
    result_.dual = std::move(dual);
  }

  Union_boundary_3 build() {
    progress_.begin_stage("boundary of the union");
    find_vertices();
    join_corners();
    find_arcs();
    find_circles();
    shape_arcs();
    find_loops();
    return std::move(result_);
  }

 private:
  /// A ball at a cell that is not in the complex.
  static int corner(int cell, int place) { return 4 * cell + place; }

  void find_vertices() {
    is_wall_.assign(regular_.cells.size(), {});
    vertex_.assign(regular_.cells.size(), {-1, -1, -1, -1});
    struct Name {
      int triangle;
      bool is_above;
    };
    std::vector<Name> names;
    for (std::size_t t = 0; t < dual_.triangles.size(); ++t) {
      const Dual_3::Triangle& triangle = dual_.triangles[t];
      for (int side = 0; side < 2; ++side) {
        const int cell = triangle.cells[side];
        for (int i = 0; i < 4; ++i) {
          if (regular_.neighbors[cell][i] != triangle.cells[1 - side] ||
              std::ranges::count(triangle.balls, regular_.cells[cell][i]) != 0)
            continue;
          is_wall_[cell][i] = true;
          if (dual_.has_cell[cell]) continue;
          vertex_[cell][i] = static_cast<int>(names.size());
          names.push_back({static_cast<int>(t), side == 1});
          vertex_places_.push_back(corner(cell, i));
        }
      }
    }
    result_.vertices.resize(names.size());
    parallel_for(names.size(), progress_, [&](std::size_t v) {
      const auto& balls = dual_.triangles[names[v].triangle].balls;
      result_.vertices[v] = meeting_point(regular_.balls[balls[0]], regular_.balls[balls[1]], regular_.balls[balls[2]],
                                          names[v].is_above);
    });
  }

  /// Corners of one ball that hang together around it, across what is not in the complex, are on one patch.
  void join_corners() {
    patches_ = Disjoint_sets(4 * regular_.cells.size());
    for (int cell = 0; cell < static_cast<int>(regular_.cells.size()); ++cell) {
      if (dual_.has_cell[cell]) continue;
      for (int across = 0; across < 4; ++across) {
        const int next = regular_.neighbors[cell][across];
        if (is_wall_[cell][across] || next < cell) continue;
        for (int i = 0; i < 4; ++i)
          if (i != across && regular_.cells[cell][i] >= 0)
            patches_.join(corner(cell, i), corner(next, place_of(next, cell, i)));
      }
    }
  }
  /// In `next` the place of the ball that is at place i of `cell`.
  int place_of(int next, int cell, int i) const {
    const auto& corners = regular_.cells[next];
    return static_cast<int>(std::ranges::find(corners, regular_.cells[cell][i]) - corners.begin());
  }

  /// The wedge in the next cell around the edge.
  Wedge next(const Wedge& wedge) const {
    Wedge result;
    result.cell = regular_.neighbors[wedge.cell][wedge.exit];
    result.first = place_of(result.cell, wedge.cell, wedge.first);
    result.second = place_of(result.cell, wedge.cell, wedge.second);
    for (int i = 0; i < 4; ++i) {
      if (i != result.first && i != result.second && regular_.neighbors[result.cell][i] == wedge.cell) result.entry = i;
    }
    result.exit = 6 - result.first - result.second - result.entry;
    return result;
  }

  void find_arcs() {
    for (std::size_t v = 0; v < vertex_places_.size(); ++v) {
      const int cell = vertex_places_[v] / 4;
      const int entry = vertex_places_[v] % 4;
      for (int exit = 0; exit < 4; ++exit) {
        if (exit == entry) continue;
        Wedge wedge{cell, -1, -1, entry, exit};
        for (int i = 0; i < 4; ++i) {
          if (i != entry && i != exit) (wedge.first < 0 ? wedge.first : wedge.second) = i;
        }
        const auto& balls = regular_.cells[cell];
        if (balls[wedge.first] > balls[wedge.second]) std::swap(wedge.first, wedge.second);
        if (!is_counterclockwise(wedge)) continue;
        Union_boundary_3::Arc arc;
        arc.balls = {balls[wedge.first], balls[wedge.second]};
        arc.from = static_cast<int>(v);
        arc_starts_.push_back(wedge);
        while (!is_wall_[wedge.cell][wedge.exit]) wedge = next(wedge);
        arc.to = vertex_[wedge.cell][wedge.exit];
        result_.arcs.push_back(arc);
      }
    }
  }

  void find_circles() {
    std::vector<std::array<int, 2>> circles;
    for (const Dual_3::Edge& edge : dual_.edges)
      if (edge.kind == Simplex_kind_3::singular) circles.push_back(edge.balls);
    if (circles.empty()) return;
    std::ranges::sort(circles);
    std::vector<std::uint8_t> is_done(circles.size(), 0);
    for (int cell = 0; cell < static_cast<int>(regular_.cells.size()); ++cell) {
      const auto& balls = regular_.cells[cell];
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
          if (balls[i] < 0 || balls[i] >= balls[j]) continue;
          const std::array<int, 2> pair{balls[i], balls[j]};
          const auto it = std::ranges::lower_bound(circles, pair);
          if (it == circles.end() || *it != pair || is_done[it - circles.begin()] != 0) continue;
          is_done[it - circles.begin()] = 1;
          Union_boundary_3::Arc arc;
          arc.balls = pair;
          result_.arcs.push_back(arc);
          arc_starts_.push_back({cell, i, j, 0, 0});
        }
      }
    }
  }

  void shape_arcs() {
    parallel_for(result_.arcs.size(), progress_, [&](std::size_t a) {
      Union_boundary_3::Arc& arc = result_.arcs[a];
      const Ball_3& first = regular_.balls[arc.balls[0]];
      const Ball_3& second = regular_.balls[arc.balls[1]];
      const Point_3 between = second.center - first.center;
      const double apart = length(between);
      const Point_3 axis = (1 / apart) * between;
      const double height = (apart + (first.radius - second.radius) * ((first.radius + second.radius) / apart)) / 2;
      arc.center = first.center + height * axis;
      arc.radius = std::sqrt(std::max(0.0, (first.radius - height) * (first.radius + height)));
      arc.start = some_perpendicular(axis);
      arc.angle = full_turn;
      if (arc.from >= 0) {
        const auto flat = [&](int vertex) {
          const Point_3 p = result_.vertices[vertex] - arc.center;
          return p - dot(p, axis) * axis;
        };
        const Point_3 start = flat(arc.from);
        if (const double size = length(start); size > 0) arc.start = (1 / size) * start;
        const Point_3 end = flat(arc.to);
        arc.angle = std::atan2(dot(end, cross(axis, arc.start)), dot(end, arc.start));
        if (arc.angle < 0) arc.angle += full_turn;
        if (is_nearly_closed(arc) && (arc.angle < 1) == is_long(arc, arc_starts_[a]))
          arc.angle = arc.angle < 1 ? full_turn : 0;
      }
      arc.side = cross(axis, arc.start);
    });
  }

  /// Rounding could make a point of the arc or nearly the whole circle.
  bool is_nearly_closed(const Union_boundary_3::Arc& arc) const {
    constexpr double narrow = 1e-6;
    const double size = regular_.balls[arc.balls[0]].radius + regular_.balls[arc.balls[1]].radius;
    return arc.angle < narrow || arc.angle > full_turn - narrow ||
           distance(result_.vertices[arc.from], result_.vertices[arc.to]) < narrow * narrow * size;
  }
  /// Of an arc whose ends are about the same point, whether it is the rest of the circle: then no other arc is there,
  /// and no ball around it has the point of the circle that is farthest from the ends.
  bool is_long(const Union_boundary_3::Arc& arc, const Wedge& start) const {
    const Point_3 farthest = arc.center - arc.radius * arc.start;
    int ends = 0;
    bool is_covered = false;
    Wedge wedge = start;
    do {
      ends += static_cast<int>(vertex_[wedge.cell][wedge.entry] >= 0) +
              static_cast<int>(vertex_[wedge.cell][wedge.exit] >= 0);
      if (const int ball = regular_.cells[wedge.cell][wedge.entry]; ball >= 0) {
        const Ball_3& b = regular_.balls[ball];
        is_covered = is_covered || distance(b.center, farthest) < b.radius;
      }
      wedge = next(wedge);
    } while (wedge.cell != start.cell);
    return ends == 2 && !is_covered;
  }

  void find_loops() {
    struct Use {
      int patch;
      int from;
      int to;
      Union_boundary_3::Side side;
    };
    std::vector<Use> uses;
    uses.reserve(2 * result_.arcs.size());
    for (std::size_t a = 0; a < result_.arcs.size(); ++a) {
      const auto& arc = result_.arcs[a];
      const Wedge& start = arc_starts_[a];
      const int index = static_cast<int>(a);
      uses.push_back({patches_.find(corner(start.cell, start.first)), arc.to, arc.from, {index, false}});
      uses.push_back({patches_.find(corner(start.cell, start.second)), arc.from, arc.to, {index, true}});
    }
    const auto key = [](const Use& use) { return std::tuple(use.patch, use.from, use.side.arc); };
    std::ranges::sort(uses, {}, key);
    std::vector<std::uint8_t> is_done(uses.size(), 0);
    result_.loop_offsets.push_back(0);
    result_.patch_offsets.push_back(0);
    for (std::size_t begin = 0; begin < uses.size();) {
      std::size_t end = begin;
      while (end < uses.size() && uses[end].patch == uses[begin].patch) ++end;
      for (std::size_t first = begin; first < end; ++first) {
        if (is_done[first] != 0) continue;
        std::size_t use = first;
        while (is_done[use] == 0) {
          is_done[use] = 1;
          result_.sides.push_back(uses[use].side);
          if (uses[use].from < 0) break;
          const auto next = std::lower_bound(uses.begin() + static_cast<std::ptrdiff_t>(begin),
                                             uses.begin() + static_cast<std::ptrdiff_t>(end), uses[use].to,
                                             [](const Use& other, int vertex) { return other.from < vertex; });
          use = static_cast<std::size_t>(next - uses.begin());
        }
        result_.loop_offsets.push_back(static_cast<int>(result_.sides.size()));
      }
      result_.patch_balls.push_back(regular_.cells[uses[begin].patch / 4][uses[begin].patch % 4]);
      result_.patch_offsets.push_back(static_cast<int>(result_.loop_offsets.size()) - 1);
      begin = end;
    }
    for (std::size_t b = 0; b < dual_.vertices.size(); ++b) {
      if (dual_.vertices[b] != Simplex_kind_3::singular) continue;
      result_.patch_balls.push_back(static_cast<int>(b));
      result_.patch_offsets.push_back(static_cast<int>(result_.loop_offsets.size()) - 1);
    }
  }

  const Dual_3& dual_;
  const Regular_3& regular_;
  Progress& progress_;
  Union_boundary_3 result_;
  std::vector<std::array<bool, 4>> is_wall_;  ///< per cell and place: the triangle across is in the complex
  std::vector<std::array<int, 4>> vertex_;    ///< and the vertex on this side of it, or -1
  std::vector<int> vertex_places_;            ///< per vertex the corner across from its triangle
  Disjoint_sets patches_{0};                  ///< of corners
  std::vector<Wedge> arc_starts_;
};

}  // namespace

Point_3 Union_boundary_3::Arc::point(int k, int n) const {
  const double turn = angle * k / n;
  return center + (radius * std::cos(turn)) * start + (radius * std::sin(turn)) * side;
}

Union_boundary_3 union_boundary(std::shared_ptr<const Dual_3> dual, Progress& progress) {
  return Boundary_builder(std::move(dual), progress).build();
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/regular_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "core/outcome.h"
#include "geometries/cell_arrays_3.h"
#include "geometries/parallel_insertion_3.h"
#include "geometries/spatial_order_3.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base =
    CGAL::Triangulation_vertex_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Data_structure = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base, CGAL::Parallel_tag>;
using Triangulation = CGAL::Regular_triangulation_3<Kernel, Data_structure, Territory_locks_3>;
using Weighted_point = Kernel::Weighted_point_3;

constexpr int no_ball = -1;

/// Of each center the first of the largest balls.
std::vector<int> first_of_each_center(const std::vector<Ball_3>& balls, const Progress& progress) {
  std::vector<int> order(balls.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    const Ball_3& b = balls[i];
    return std::tuple(b.center.x, b.center.y, b.center.z, -b.radius, i);
  };
  parallel_region(
      progress, [&] { tbb::parallel_sort(order.begin(), order.end(), [&](int i, int j) { return key(i) < key(j); }); });
  std::vector<int> kept;
  for (const int i : order)
    if (kept.empty() || !(balls[kept.back()].center == balls[i].center)) kept.push_back(i);
  std::ranges::sort(kept);
  return kept;
}

std::vector<int> along_curve(const std::vector<Ball_3>& balls, const std::vector<int>& numbers,
                             const Progress& progress) {
  std::vector<Point_3> centers;
  centers.reserve(numbers.size());
  for (const int i : numbers) centers.push_back(balls[i].center);
  std::vector<std::size_t> order(numbers.size());
  std::iota(order.begin(), order.end(), 0);
  sort_along_hilbert_curve(centers, order, progress);
  std::vector<int> sorted;
  sorted.reserve(order.size());
  for (const std::size_t i : order) sorted.push_back(numbers[i]);
  return sorted;
}

/// For Parallel_insertion_3.
class Ball_triangulation : public Triangulation {
 public:
  Ball_triangulation() { infinite_vertex()->info() = no_ball; }

  /// numbers: of the balls to be inserted, of different centers, along a curve. new_numbers: of those before, per old
  /// number. Both are used until the next call.
  void expect(std::span<const Ball_3> balls, std::span<const int> numbers, std::span<const int> new_numbers) {
    balls_ = balls;
    numbers_ = numbers;
    vertices_.assign(numbers.size(), {});
    place_of_ball_.assign(balls.size(), -1);
    for (std::size_t i = 0; i < numbers.size(); ++i) place_of_ball_[numbers[i]] = static_cast<int>(i);
    for (const Vertex_handle vertex : finite_vertex_handles()) {
      vertex->info() = new_numbers[vertex->info()];
      vertices_[place_of_ball_[vertex->info()]] = vertex;
    }
  }

  std::span<const int> place_of_ball() const { return place_of_ball_; }

  Weighted_point place(int i) const {
    const auto& [c, r] = balls_[numbers_[i]];
    return {Kernel::Point_3(c.x, c.y, c.z), r * r};
  }
  Vertex_handle vertex(int i) const { return vertices_[i]; }
  Vertex_handle insert(int i, Locate_type type, Cell_handle cell, int at, int other, bool* could_lock_zone) {
    const Weighted_point p = place(i);
    if (dimension() < 3) {
      // It may be hidden later without word.
      const Vertex_handle vertex = Triangulation::insert(p, type, cell, at, other);
      if (vertex != Vertex_handle()) vertex->info() = numbers_[i];
      return vertex;
    }
    Hidden hidden(*this);
    const Conflict_tester_3 conflict(p, this);
    const Vertex_handle vertex = insert_in_conflict(p, type, cell, at, other, conflict, hidden, could_lock_zone);
    if (vertex == Vertex_handle()) return vertex;
    vertex->info() = numbers_[i];
    vertices_[i] = vertex;
    return vertex;
  }

 private:
  /// Forgets balls that are hidden, which CGAL would keep in the cells where they are.
  class Hidden {
   public:
    explicit Hidden(Ball_triangulation& triangulation) : triangulation_(triangulation) {}
    template <class Cells>
    void process_cells_in_conflict(Cells begin, Cells end) {
      for (; begin != end; ++begin) {
        for (int i = 0; i < 4; ++i) {
          const Vertex_handle vertex = (*begin)->vertex(i);
          if (vertex->cell() == Cell_handle()) continue;
          vertices_.push_back(vertex);
          vertex->set_cell(Cell_handle());
        }
      }
    }
    void reinsert_vertices(Vertex_handle) {
      for (const Vertex_handle vertex : vertices_) {
        if (vertex->cell() != Cell_handle()) continue;
        triangulation_.vertices_[triangulation_.place_of_ball_[vertex->info()]] = {};
        triangulation_.tds().delete_vertex(vertex);
      }
    }
    Vertex_handle replace_vertex(Cell_handle cell, int i, const Weighted_point& p) const {
      cell->vertex(i)->set_point(p);
      return cell->vertex(i);
    }
    void hide_point(Cell_handle, const Weighted_point&) const {}

   private:
    Ball_triangulation& triangulation_;
    boost::container::small_vector<Vertex_handle, 64> vertices_;
  };

  std::span<const Ball_3> balls_;
  std::span<const int> numbers_;
  std::vector<Vertex_handle> vertices_;
  std::vector<int> place_of_ball_;
};

/// Far away and with weights so negative that they take no part between the balls, but give the triangulation cells.
void add_surroundings(Triangulation& triangulation, const std::vector<Ball_3>& balls) {
  Box box;
  double radius = 0;
  for (const Ball_3& ball : balls) {
    box.add(ball.center);
    radius = std::max(radius, ball.radius);
  }
  constexpr double far = 64;
  const Point_3 c = midpoint(box.lower, box.upper);
  // Far from the origin, what is near has the same coordinates.
  constexpr double least_part = 0x1p-30;
  double size = std::max(far * std::max(box.diagonal(), radius),
                         least_part * std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}));
  if (size == 0) size = 1;
  const double weight = -far * size * size;
  for (const Point_3& d : {Point_3{1, 1, 1}, Point_3{1, -1, -1}, Point_3{-1, 1, -1}, Point_3{-1, -1, 1}}) {
    const Point_3 p = c + size * d;
    const auto vertex = triangulation.insert(Weighted_point({p.x, p.y, p.z}, weight));
    vertex->info() = no_ball;
  }
}

/// Per old ball its number among the new ones, if all are there in the same order.
std::optional<std::vector<int>> numbers_among(const std::vector<Ball_3>& old_balls, const std::vector<Ball_3>& balls) {
  std::vector<int> numbers;
  numbers.reserve(old_balls.size());
  for (std::size_t i = 0; i < balls.size() && numbers.size() < old_balls.size(); ++i)
    if (balls[i] == old_balls[numbers.size()]) numbers.push_back(static_cast<int>(i));
  if (numbers.size() < old_balls.size()) return std::nullopt;
  return numbers;
}

}  // namespace

class Growing_regular_3::Implementation {
 public:
  Regular_3 triangulate(std::vector<Ball_3> balls, Progress& progress) {
    if (balls.empty()) throw Unavailable("there are no balls");
    progress.begin_stage("regular triangulation");
    const std::vector<int> kept = along_curve(balls, first_of_each_center(balls, progress), progress);
    std::vector<Point_3> centers;
    centers.reserve(kept.size());
    for (const int i : kept) centers.push_back(balls[i].center);

    auto before = std::exchange(before_, {});
    std::vector<std::uint8_t> is_in(balls.size(), 0);
    const std::optional<std::vector<int>> numbers = numbers_of(before, balls, kept, is_in);
    if (!numbers) triangulation_ = std::make_unique<Ball_triangulation>();
    triangulation_->expect(balls, kept, numbers ? std::span(*numbers) : std::span<const int>());
    std::vector<int> order;
    if (numbers) {
      for (std::size_t place = 0; place < kept.size(); ++place)
        if (is_in[kept[place]] == 0) order.push_back(static_cast<int>(place));
    } else {
      order = insertion_order_along_curve(kept.size());
    }
    Parallel_insertion_3(*triangulation_, centers, progress).insert(order);
    progress.check();
    const bool is_flat = triangulation_->dimension() < 3;
    if (is_flat) add_surroundings(*triangulation_, balls);

    Regular_3 result;
    result.cell_of_ball.assign(balls.size(), -1);
    write_cells(*triangulation_, triangulation_->place_of_ball(), result.cells, result.neighbors, progress);
    if (!is_flat) before_ = {balls, kept};
    result.balls = std::move(balls);
    for (std::size_t c = 0; c < result.cells.size(); ++c)
      for (const int ball : result.cells[c])
        if (ball >= 0) result.cell_of_ball[ball] = static_cast<int>(c);
    return result;
  }

 private:
  struct Set {
    std::vector<Ball_3> balls;
    std::vector<int> kept;  ///< of different centers
  };

  /// The new numbers of the balls of before, if these are in the triangulation and can stay there; marks them.
  static std::optional<std::vector<int>> numbers_of(const Set& before, const std::vector<Ball_3>& balls,
                                                    const std::vector<int>& kept, std::vector<std::uint8_t>& is_in) {
    // From the start all threads take part.
    constexpr std::size_t most_times = 2;
    if (before.balls.empty() || balls.size() > most_times * before.balls.size()) return std::nullopt;
    auto numbers = numbers_among(before.balls, balls);
    if (!numbers) return std::nullopt;
    for (const int old : before.kept) is_in[(*numbers)[old]] = 1;
    const auto still_kept = std::ranges::count_if(kept, [&](int ball) { return is_in[ball] != 0; });
    if (still_kept < std::ssize(before.kept)) return std::nullopt;
    return numbers;
  }

  std::unique_ptr<Ball_triangulation> triangulation_;
  Set before_;
};

Growing_regular_3::Growing_regular_3() : implementation_(std::make_unique<Implementation>()) {}
Growing_regular_3::Growing_regular_3(Growing_regular_3&&) noexcept = default;
Growing_regular_3& Growing_regular_3::operator=(Growing_regular_3&&) noexcept = default;
Growing_regular_3::~Growing_regular_3() = default;

Regular_3 Growing_regular_3::triangulate(std::vector<Ball_3> balls, Progress& progress) {
  return implementation_->triangulate(std::move(balls), progress);
}

Regular_3 regular_triangulation(std::vector<Ball_3> balls, Progress& progress) {
  return Growing_regular_3().triangulate(std::move(balls), progress);
}

int locate(const Regular_3& regular, const Point_3& point, int start) {
  const Kernel::Point_3 p(point.x, point.y, point.z);
  const auto position = [&](int ball) {
    const Point_3& c = regular.balls[ball].center;
    return Kernel::Point_3(c.x, c.y, c.z);
  };
  int cell = start;
  if (regular.is_infinite(cell)) {
    // Across from its infinite place lies a finite cell, unless all balls lie in a plane.
    const auto& corners = regular.cells[cell];
    for (int i = 0; i < 4; ++i)
      if (corners[i] < 0) cell = regular.neighbors[start][i];
    if (regular.is_infinite(cell)) return -1;
  }
  int previous = -1;
  // A visibility walk in a regular triangulation comes to an end.
  for (;;) {
    const auto& corners = regular.cells[cell];
    std::array<Kernel::Point_3, 4> points{position(corners[0]), position(corners[1]), position(corners[2]),
                                          position(corners[3])};
    int next = -1;
    for (int i = 0; i < 4 && next < 0; ++i) {
      if (regular.neighbors[cell][i] == previous) continue;
      const Kernel::Point_3 corner = std::exchange(points[i], p);
      if (CGAL::orientation(points[0], points[1], points[2], points[3]) == CGAL::NEGATIVE)
        next = regular.neighbors[cell][i];
      points[i] = corner;
    }
    if (next < 0) return cell;
    if (regular.is_infinite(next)) return -1;
    previous = std::exchange(cell, next);
  }
}

}  // namespace mesecina

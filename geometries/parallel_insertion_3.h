// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/scalable_allocator.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "core/point.h"
#include "geometries/parallel.h"
#include "geometries/territories_3.h"

namespace mesecina {

/// Declared before a triangulation with CGAL::Parallel_tag, and so destroyed after it, it gives the memory of that
/// back: the allocator of such triangulations would keep it for others of their kind.
struct Memory_return {
  Memory_return() = default;
  Memory_return(const Memory_return&) = delete;
  Memory_return& operator=(const Memory_return&) = delete;
  ~Memory_return() { scalable_allocation_command(TBBMALLOC_CLEAN_ALL_BUFFERS, nullptr); }
};

/// Inserts numbered points into a triangulation of CGAL, on as many threads as `progress` allows. First one thread
/// inserts a few; then each thread those in its own territory, as long as nothing has to change in that of another;
/// then one thread what is left. Which cells come out depends neither on the order nor on the threads, as CGAL decides
/// all special positions by symbolic perturbation; how they are stored does.
///
/// Numbered is a triangulation of CGAL in space with CGAL::Parallel_tag and Territory_locks_3 that also has
///   Point place(int i)                      of point number i
///   Vertex_handle insert(int i, Locate_type, Cell_handle, int, int, bool* could_lock_zone)
///     as that of CGAL, for the point number i; null where it is hidden
///   Vertex_handle vertex(int i)             of an inserted point that is still a vertex; null for others
template <class Numbered>
class Parallel_insertion_3 {
 public:
  /// points: numbered along a curve, so that those with near numbers are mostly near each other.
  Parallel_insertion_3(Numbered& triangulation, std::span<const Point_3> points, Progress& progress)
      : triangulation_(triangulation), points_(points), progress_(progress), caller_(std::this_thread::get_id()) {}

  /// O(n log n) for points along surfaces in an order as of insertion_order_along_curve.
  void insert(std::span<const int> order) {
    total_ = order.size();
    const bool is_shared = progress_.threads() > 1 && order.size() >= least_shared;
    const std::size_t alone = is_shared ? std::max(least_alone, order.size() / 32) : order.size();
    std::size_t done = 0;
    // As long as all points lie in a plane, a point may change all cells.
    for (; done < order.size() && (done < alone || triangulation_.dimension() < 3); ++done) insert_alone(order[done]);
    if (done == order.size()) return;
    // No one may have the infinite vertex: all territories have it.
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    triangulation_.infinite_vertex()->set_point(Place(Place_3(nowhere, nowhere, nowhere)));
    // What is left of the first ones comes before the others: it makes the cells between the territories smaller, and
    // so fewer of the others change cells of two.
    std::vector<int> left;
    for (const std::size_t end : {order.size() / 8, order.size()}) {
      for (; done < end; ++done) left.push_back(order[done]);
      const int rounds = end < order.size() ? 1 : 2;
      for (int round = 0; round < rounds && left.size() >= least_shared_again; ++round)
        if (!insert_shared(left)) break;
      insert_alone(left);
    }
  }

 private:
  using Place = typename Numbered::Point;
  using Place_3 = typename Numbered::Geom_traits::Point_3;
  using Vertex = typename Numbered::Vertex_handle;
  using Cell = typename Numbered::Cell_handle;
  using Locate_type = typename Numbered::Locate_type;

  static constexpr std::size_t least_shared = 4096;
  static constexpr std::size_t least_alone = 1024;
  static constexpr std::size_t least_shared_again = 1024;

  void count_one() {
    constexpr std::size_t often = 512;
    if (const std::size_t count = ++count_; count % often == 0 && std::this_thread::get_id() != caller_)
      progress_.check();
    else if (count % often == 0)
      progress_.report(std::min(1.0, static_cast<double>(count) / static_cast<double>(total_)));
  }

  void insert_alone(int i) {
    count_one();
    Locate_type type{};
    int at = 0;
    int other = 0;
    const Cell cell =
        triangulation_.locate(triangulation_.place(i), type, at, other, last_ == Vertex() ? Cell() : last_->cell());
    const Vertex vertex = triangulation_.insert(i, type, cell, at, other, nullptr);
    if (vertex != Vertex()) last_ = vertex;
  }

  void insert_alone(std::vector<int>& numbers) {
    last_ = {};  // it may be hidden by now
    for (const int i : numbers) {
      if (const Vertex near = vertex_near(i); near != Vertex()) last_ = near;
      insert_alone(i);
    }
    numbers.clear();
  }

  /// The vertex with the nearest number; null where none is near.
  Vertex vertex_near(int i) const {
    return vertex_near(i, [](int) { return true; });
  }
  /// The same of those that fit.
  template <class Fits>
  Vertex vertex_near(int i, const Fits& fits) const {
    constexpr int most = 64;
    const auto count = static_cast<int>(points_.size());
    for (int distance = 1; distance < most; ++distance)
      for (const int number : {i - distance, i + distance})
        if (number >= 0 && number < count && fits(number))
          if (const Vertex vertex = triangulation_.vertex(number); vertex != Vertex()) return vertex;
    return {};
  }

  /// Of the cells of a vertex, whose neighbour the point is to become.
  Territories_3::Reach reach_of(int i) {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    const Vertex vertex = vertex_near(i);
    const Point_3& p = points_[i];
    Territories_3::Reach reach{{p.x, p.y, p.z}, {p.x, p.y, p.z}};
    const auto take_everywhere = [&] {
      reach.lower.fill(-everywhere);
      reach.upper.fill(everywhere);
    };
    if (vertex == Vertex()) {
      take_everywhere();
      return reach;
    }
    neighbors_.clear();
    triangulation_.adjacent_vertices(vertex, std::back_inserter(neighbors_));
    for (const Vertex neighbor : neighbors_) {
      if (triangulation_.is_infinite(neighbor)) {
        take_everywhere();
        return reach;
      }
      const auto& place = neighbor->point();
      const std::array<double, 3> coordinates{place.x(), place.y(), place.z()};
      for (int k = 0; k < 3; ++k) {
        reach.lower[k] = std::min(reach.lower[k], coordinates[k]);
        reach.upper[k] = std::max(reach.upper[k], coordinates[k]);
      }
    }
    return reach;
  }

  Territories_3 find_territories(std::span<const int> numbers) {
    constexpr std::size_t most_looked_at = 1024;
    const std::size_t step = std::max<std::size_t>(1, numbers.size() / most_looked_at);
    std::vector<Territories_3::Reach> reaches;
    for (std::size_t i = 0; i < numbers.size(); i += step) reaches.push_back(reach_of(numbers[i]));
    return Territories_3::around(reaches, progress_.threads());
  }

  /// Leaves the numbers of the points that could not be inserted. False where none was tried.
  bool insert_shared(std::vector<int>& numbers) {
    Territory_locks_3 locks(find_territories(numbers));
    const Territories_3& territories = locks.territories();
    const auto boxes = static_cast<std::size_t>(territories.box_count());
    if (boxes < 2) return false;
    const auto box_of = [&](int i) { return territories.box_of(points_[i].x, points_[i].y, points_[i].z); };
    std::vector<std::vector<int>> parts(boxes);
    for (const int i : numbers) parts[box_of(i)].push_back(i);
    std::vector<std::vector<int>> left(boxes);
    triangulation_.set_lock_data_structure(&locks);
    parallel_blocks(boxes, progress_, [&](std::size_t box) {
      locks.take(static_cast<int>(box));
      Vertex hint;
      for (const int i : parts[box]) {
        const auto is_own = [&](int number) { return box_of(number) == static_cast<int>(box); };
        if (insert_locked(i, is_own, hint)) {
          count_one();
        } else {
          left[box].push_back(i);
        }
      }
      locks.leave(static_cast<int>(box));
    });
    triangulation_.set_lock_data_structure(nullptr);
    numbers.clear();
    for (const auto& part : left) numbers.insert(numbers.end(), part.begin(), part.end());
    return true;
  }

  /// False where it would change what other threads may change.
  template <class Is_own>
  bool insert_locked(int i, const Is_own& is_own, Vertex& hint) {
    bool is_locked = false;
    Locate_type type{};
    int at = 0;
    int other = 0;
    Cell cell;
    const auto locate_from = [&](Vertex vertex) {
      is_locked = true;
      cell = triangulation_.locate(triangulation_.place(i), type, at, other, vertex->cell(), &is_locked);
    };
    if (hint != Vertex()) locate_from(hint);
    if (!is_locked) {
      // The way from there may lead through what is no one's.
      const Vertex near = vertex_near(i, is_own);
      if (near == Vertex() || near == hint) return false;
      locate_from(near);
    }
    if (!is_locked) return false;
    const Vertex vertex = triangulation_.insert(i, type, cell, at, other, &is_locked);
    if (is_locked && vertex != Vertex()) hint = vertex;
    return is_locked;
  }

  Numbered& triangulation_;
  std::span<const Point_3> points_;
  Progress& progress_;
  std::thread::id caller_;
  std::atomic<std::size_t> count_ = 0;
  std::size_t total_ = 0;
  Vertex last_;
  std::vector<Vertex> neighbors_;
};

}  // namespace mesecina

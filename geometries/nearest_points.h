// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/point.h"

namespace mesecina {

/// Which of some points are nearest to a place. The answers are exact for the squared distances as they are rounded,
/// and of points equally far the one with the lesser number comes first, so they do not depend on how points are kept.
/// Point is Point_2 or Point_3.
template <class Point>
class Nearest_points {
 public:
  struct Neighbor {
    double squared_distance = std::numeric_limits<double>::infinity();
    int point = -1;  ///< -1: there is none
    auto operator<=>(const Neighbor&) const = default;
  };

  /// O(n log n).
  explicit Nearest_points(std::vector<Point> points) : points_(std::move(points)), order_(points_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    sort(0, order_.size(), 0);
  }

  /// The two nearest, the nearer first. O(log n) where points are not crowded at the distance of the second.
  std::array<Neighbor, 2> nearest_two(const Point& place) const {
    std::array<Neighbor, 2> best;
    search(place, 0, order_.size(), 0, best);
    return best;
  }

 private:
  static constexpr int dimension = sizeof(Point) / sizeof(double);

  static double coordinate(const Point_2& p, int axis) { return axis == 0 ? p.x : p.y; }
  static double coordinate(const Point_3& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

  void sort(std::size_t begin, std::size_t end, int axis) {
    if (end - begin < 2) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [this, axis](int p, int q) {
      return coordinate(points_[p], axis) < coordinate(points_[q], axis);
    });
    sort(begin, middle, (axis + 1) % dimension);
    sort(middle + 1, end, (axis + 1) % dimension);
  }

  void search(const Point& place, std::size_t begin, std::size_t end, int axis, std::array<Neighbor, 2>& best) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const int point = order_[middle];
    const Neighbor found{squared_distance(place, points_[point]), point};
    if (found < best[0]) {
      best[1] = std::exchange(best[0], found);
    } else if (found < best[1]) {
      best[1] = found;
    }
    const double offset = coordinate(place, axis) - coordinate(points_[point], axis);
    const int next = (axis + 1) % dimension;
    const bool is_below = offset < 0;
    if (is_below) {
      search(place, begin, middle, next, best);
    } else {
      search(place, middle + 1, end, next, best);
    }
    if (offset * offset > best[1].squared_distance) return;
    if (is_below) {
      search(place, middle + 1, end, next, best);
    } else {
      search(place, begin, middle, next, best);
    }
  }

  std::vector<Point> points_;
  std::vector<int> order_;  ///< a balanced tree: the middle of a range divides the rest by one coordinate
};

}  // namespace mesecina

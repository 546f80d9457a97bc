// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "geometries/parallel.h"

/// What scale_importance searches in, in the plane and in space: shared by its sources, of no use to others.
namespace mesecina::scale_search {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double unit_roundoff = 1.1102230246251565e-16;

template <std::size_t dimension>
using Vector = std::array<double, dimension>;

template <std::size_t dimension>
double dot(const Vector<dimension>& u, const Vector<dimension>& v) {
  double sum = u[0] * v[0];
  for (std::size_t i = 1; i < dimension; ++i) sum += u[i] * v[i];
  return sum;
}

template <std::size_t dimension>
Vector<dimension> difference(const Vector<dimension>& p, const Vector<dimension>& q) {
  Vector<dimension> result;
  for (std::size_t i = 0; i < dimension; ++i) result[i] = p[i] - q[i];
  return result;
}

template <std::size_t dimension>
double sum_of_sizes(const Vector<dimension>& v) {
  double sum = 0;
  for (const double x : v) sum += std::abs(x);
  return sum;
}

/// A disk in the plane, a ball in space.
template <std::size_t dimension>
struct Sphere {
  Vector<dimension> center;
  double radius;
};

template <std::size_t dimension>
double squared_distance(const Sphere<dimension>& a, const Sphere<dimension>& b) {
  const Vector<dimension> d = difference(b.center, a.center);
  return dot(d, d);
}

template <std::size_t dimension>
double quotient(const Sphere<dimension>& sphere, const Sphere<dimension>& larger) {
  const double growth = larger.radius - sphere.radius;
  return growth > 0 ? std::sqrt(squared_distance(sphere, larger)) / growth : infinity;
}

/// Whether the square of their quotient may be less than that value or equal to it, without root and division: true may
/// be wrong by rounding.
template <std::size_t dimension>
bool may_be_less(const Sphere<dimension>& sphere, const Sphere<dimension>& larger, double squared_value) {
  const double growth = larger.radius - sphere.radius;
  return growth > 0 &&
         !(squared_distance(sphere, larger) > squared_value * (growth * growth) * (1 + 16 * unit_roundoff));
}

/// A sphere whose importance is wanted.
template <std::size_t dimension>
class Query {
 public:
  /// slope: see scale_importance; infinity where nothing is known.
  Query(const Sphere<dimension>& sphere, double slope)
      : sphere_(sphere), slope_(slope), least_(slope < infinity ? 1 : 0), inverse_diameter_(0.5 / sphere.radius) {}

  const Sphere<dimension>& sphere() const { return sphere_; }
  /// Lower bound of all quotients.
  double least() const { return least_; }
  /// Lower bound of the quotients with spheres up to `distance` away. Not increasing with the distance, as rounded too,
  /// and the same for all that cannot be told from the sphere itself: so one of them settles it for the others.
  double least_within(double distance) const {
    return std::max(least_, 1 / (slope_ + std::max(distance * inverse_diameter_, resolution)));
  }
  /// Whether least_within(distance) >= value.
  bool is_least_within(double distance, double value) const {
    // A product tells in most cases.
    if (least_ == 0 || value * (slope_ + std::max(distance * inverse_diameter_, resolution)) > 1 + 8 * unit_roundoff)
      return false;
    return least_within(distance) >= value;
  }
  /// The quotient if it is less than `value`, else anything not less than it.
  double quotient_below(const Sphere<dimension>& larger, double value) const {
    const double result = quotient(sphere_, larger);
    if (!(result < value) || least_ == 0) return result;
    return std::max(result, least_within(std::sqrt(squared_distance(sphere_, larger))));
  }

 private:
  /// Relative to the diameter. Larger than what rounding does to centers in most sets of samples, so that bounds are
  /// the same there, and so small that nothing is lost: it makes bounds lower by such a part.
  static constexpr double resolution = 0x1p-32;

  Sphere<dimension> sphere_;
  double slope_;
  double least_;
  double inverse_diameter_;
};

/// Unit vectors, at right angles to rounding: the eigenvectors of a symmetric matrix, the largest eigenvalue first.
template <std::size_t dimension>
std::array<Vector<dimension>, dimension> principal_axes(std::array<Vector<dimension>, dimension> matrix) {
  std::array<Vector<dimension>, dimension> axes{};
  for (std::size_t i = 0; i < dimension; ++i) axes[i][i] = 1;
  // Rotations that make one entry after the other vanish. [C. Jacobi, 1846] In the plane one does it.
  constexpr int rounds = dimension == 2 ? 1 : 6;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t p = 0; p + 1 < dimension; ++p) {
      for (std::size_t q = p + 1; q < dimension; ++q) {
        if (matrix[p][q] == 0) continue;
        const double cotangent = (matrix[q][q] - matrix[p][p]) / (2 * matrix[p][q]);
        const double t = std::copysign(1 / (std::abs(cotangent) + std::hypot(cotangent, 1)), cotangent);
        const double c = 1 / std::sqrt(1 + t * t);
        const double s = c * t;
        for (std::size_t k = 0; k < dimension; ++k) {
          const double kp = matrix[k][p];
          const double kq = matrix[k][q];
          matrix[k][p] = c * kp - s * kq;
          matrix[k][q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < dimension; ++k) {
          const double pk = matrix[p][k];
          const double qk = matrix[q][k];
          matrix[p][k] = c * pk - s * qk;
          matrix[q][k] = s * pk + c * qk;
          const double ap = axes[p][k];
          const double aq = axes[q][k];
          axes[p][k] = c * ap - s * aq;
          axes[q][k] = s * ap + c * aq;
        }
      }
    }
  }
  std::array<std::size_t, dimension> order;
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](std::size_t i, std::size_t j) { return matrix[i][i] > matrix[j][j]; });
  std::array<Vector<dimension>, dimension> sorted;
  for (std::size_t i = 0; i < dimension; ++i) sorted[i] = axes[order[i]];
  return sorted;
}

/// Coordinates along an axis, and how fast radii grow along it.
struct Interval {
  double low;
  double high;
  double slope;
};

/// The least (|u|^2 + rest) / (growth + slopes u)^2 over u in the box of the intervals where the denominator is
/// positive; infinity where it nowhere is. Its root is quasiconvex there.
template <std::size_t count>
double least_squared_quotient(const std::array<Interval, count>& intervals, double growth, double rest) {
  if constexpr (count == 0) {
    return growth > 0 ? rest / (growth * growth) : infinity;
  } else {
    // Without limits the least value is at u = slopes rest / growth, or infinitely far in the direction of the slopes.
    // If that is beyond some sides of the box, the least value in the box is on one of those.
    double least = infinity;
    bool is_inside = true;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& [low, high, slope] = intervals[i];
      double u = slope > 0 ? high : low;
      if (growth > 0) {
        u = std::clamp(slope * rest / growth, low, high);
        if (u > low && u < high) continue;
      } else if (slope == 0) {
        continue;
      }
      is_inside = false;
      std::array<Interval, count - 1> others;
      for (std::size_t j = 0; j + 1 < count; ++j) others[j] = intervals[j < i ? j : j + 1];
      least = std::min(least, least_squared_quotient(others, growth + slope * u, rest + u * u));
    }
    if (!is_inside) return least;
    if (!(growth > 0)) return infinity;
    double square = rest;
    double growth_there = growth;
    for (const auto& [low, high, slope] : intervals) {
      const double u = slope * rest / growth;
      square += u * u;
      growth_there += slope * u;
    }
    return square / (growth_there * growth_there);
  }
}

/// Bounding volume of spheres whose centers lie near a line in the plane or near a plane in space and whose radii
/// change nearly linearly along it, as those of neighbours on a medial axis do: centers within an oriented box, radius
/// at most peak + slopes t at coordinates t along all of its axes but the last.
///
/// Plain boxes with a largest radius are off by the size of the box; near a minimum, where the quotient changes with
/// the square of the distance, a search would have to open some sqrt(n) of them. This volume is off by the square of
/// its size.
template <std::size_t dimension>
struct Node {
  Vector<dimension> middle{};  ///< of the box
  std::array<Vector<dimension>, dimension> axes{};
  Vector<dimension> half_sides{};
  Vector<dimension - 1> slopes{};
  double peak = -infinity;
  double largest_radius = -infinity;

  static Node around(std::span<const Sphere<dimension>> spheres);

  /// Upper bound of the distances from the center of `sphere` to those of the node.
  double largest_distance(const Sphere<dimension>& sphere) const {
    return (sum_of_sizes(difference(sphere.center, middle)) + sum_of_sizes(half_sides)) * (1 + 16 * unit_roundoff);
  }

  /// Square of a lower bound of the quotient of `sphere` with any of the node; infinity when none is larger, and maybe
  /// when it is more than `limit`. Rounding is accounted for, so that it can never cut off the minimum.
  double squared_bound(const Sphere<dimension>& sphere, double limit) const {
    // As rounded, no growth in the node is more than this; without slack, because radii may differ by rounding alone.
    const double largest_growth = largest_radius - sphere.radius;
    if (!(largest_growth > 0)) return infinity;
    const Vector<dimension> offset = difference(sphere.center, middle);
    const double position_error = 16 * unit_roundoff * sum_of_sizes(offset);
    std::array<Interval, dimension - 1> intervals;
    double growth = peak - sphere.radius;
    double growth_error = std::abs(peak) + sphere.radius;
    double nearest_square = 0;
    for (std::size_t i = 0; i + 1 < dimension; ++i) {
      const double along = dot(offset, axes[i]);
      intervals[i] = {-half_sides[i] - along - position_error, half_sides[i] - along + position_error, slopes[i]};
      growth += slopes[i] * along;
      growth_error += std::abs(slopes[i]) * (std::abs(along) + half_sides[i]);
      const double nearest = std::clamp(0.0, intervals[i].low, intervals[i].high);
      nearest_square += nearest * nearest;
    }
    const double across = std::max(0.0, std::abs(dot(offset, axes.back())) - half_sides.back() - position_error);
    const double rest = across * across;
    constexpr double less = 1 - 128 * unit_roundoff;
    // At the nearest point of the box the least distance, with the largest growth of all.
    const double squared_growth = largest_growth * largest_growth;
    const double by_largest = squared_growth > 0 ? (nearest_square + rest) / squared_growth * less : 0;
    if (by_largest > limit) return infinity;
    const double by_slopes = least_squared_quotient(intervals, growth + 16 * unit_roundoff * growth_error, rest);
    return std::max(by_slopes * less, by_largest);
  }
};

template <std::size_t dimension>
Node<dimension> Node<dimension>::around(std::span<const Sphere<dimension>> spheres) {
  Node node;
  const double count = static_cast<double>(spheres.size());
  double radius = 0;
  for (const auto& sphere : spheres) {
    for (std::size_t i = 0; i < dimension; ++i) node.middle[i] += sphere.center[i] / count;
    radius += sphere.radius / count;
  }
  std::array<Vector<dimension>, dimension> covariance{};
  for (const auto& sphere : spheres) {
    const Vector<dimension> offset = difference(sphere.center, node.middle);
    for (std::size_t i = 0; i < dimension; ++i)
      for (std::size_t j = 0; j < dimension; ++j) covariance[i][j] += offset[i] * offset[j];
  }
  node.axes = principal_axes(covariance);

  // Along principal axes each slope is a regression of its own.
  Vector<dimension> squares{};
  Vector<dimension> products{};
  Vector<dimension> low;
  Vector<dimension> high;
  low.fill(infinity);
  high.fill(-infinity);
  for (const auto& sphere : spheres) {
    const Vector<dimension> offset = difference(sphere.center, node.middle);
    for (std::size_t i = 0; i < dimension; ++i) {
      const double t = dot(offset, node.axes[i]);
      low[i] = std::min(low[i], t);
      high[i] = std::max(high[i], t);
      squares[i] += t * t;
      products[i] += t * (sphere.radius - radius);
    }
  }
  for (std::size_t i = 0; i < dimension; ++i) {
    const double shift = (low[i] + high[i]) / 2;
    for (std::size_t j = 0; j < dimension; ++j) node.middle[j] += shift * node.axes[i][j];
  }
  for (std::size_t i = 0; i + 1 < dimension; ++i) {
    node.slopes[i] = squares[i] > 0 ? products[i] / squares[i] : 0;
    // Across what is nearly a line a regression would be one of rounding. No radius of a medial ball grows faster
    // than 1.
    constexpr double steepest = 2;
    if (i > 0 && !(std::abs(node.slopes[i]) <= steepest)) node.slopes[i] = 0;
  }
  double reach = 0;
  for (const auto& sphere : spheres) {
    const Vector<dimension> offset = difference(sphere.center, node.middle);
    double excess = sphere.radius;
    for (std::size_t i = 0; i < dimension; ++i) {
      const double t = dot(offset, node.axes[i]);
      node.half_sides[i] = std::max(node.half_sides[i], std::abs(t));
      if (i + 1 < dimension) excess -= node.slopes[i] * t;
    }
    node.peak = std::max(node.peak, excess);
    node.largest_radius = std::max(node.largest_radius, sphere.radius);
    reach = std::max(reach, sum_of_sizes(offset));
  }
  for (double& half : node.half_sides) half += 16 * unit_roundoff * reach;
  node.peak += 16 * unit_roundoff * (node.largest_radius + sum_of_sizes(node.slopes) * reach);
  return node;
}

inline constexpr std::size_t leaf_size = 8;
inline constexpr std::size_t fan_out = 4;

template <std::size_t dimension>
struct Entry {
  Sphere<dimension> sphere;
  int index;
};

/// Orders the entries so that the aligned blocks of leaf_size * 2^k of them are the cells of a kd-tree, each cut across
/// the longest side of the box of its centers. (A space-filling curve with fixed alternation of the axes would cut a
/// medial axis along a coordinate axis by its rounding noise, and spread every block over half of it.)
template <std::size_t dimension>
void sort_into_cells(std::span<Entry<dimension>> entries, const Progress& progress) {
  if (entries.size() <= leaf_size) return;
  progress.check();
  Vector<dimension> low = entries.front().sphere.center;
  Vector<dimension> high = low;
  for (const auto& entry : entries) {
    for (std::size_t i = 0; i < dimension; ++i) {
      low[i] = std::min(low[i], entry.sphere.center[i]);
      high[i] = std::max(high[i], entry.sphere.center[i]);
    }
  }
  const Vector<dimension> sides = difference(high, low);
  const auto longest = static_cast<std::size_t>(std::ranges::max_element(sides) - sides.begin());
  const std::size_t half = std::bit_ceil((entries.size() + leaf_size - 1) / leaf_size) / 2 * leaf_size;
  const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(half);
  std::ranges::nth_element(entries, middle, {},
                           [longest](const Entry<dimension>& entry) { return entry.sphere.center[longest]; });
  const auto lower = [&] { sort_into_cells(entries.first(half), progress); };
  const auto upper = [&] { sort_into_cells(entries.subspan(half), progress); };
  constexpr std::size_t worth_a_task = 1 << 15;
  if (entries.size() > worth_a_task && progress.threads() > 1) {
    tbb::parallel_invoke(lower, upper);
  } else {
    lower();
    upper();
  }
}

/// Spheres in the order of a kd-tree under a tree of nodes; level 0 holds the leaves.
template <std::size_t dimension>
class Hierarchy {
 public:
  /// At least one sphere. O(n log n).
  Hierarchy(std::span<const Sphere<dimension>> spheres, Progress& progress) {
    std::vector<Entry<dimension>> entries;
    entries.reserve(spheres.size());
    for (const auto& sphere : spheres) entries.push_back({sphere, static_cast<int>(entries.size())});
    parallel_region(progress, [&] { sort_into_cells(std::span(entries), progress); });
    order_.reserve(entries.size());
    spheres_.reserve(entries.size());
    for (const auto& entry : entries) {
      order_.push_back(entry.index);
      spheres_.push_back(entry.sphere);
    }
    for (std::size_t size = leaf_size;; size *= fan_out) {
      std::vector<Node<dimension>>& level = levels_.emplace_back((spheres_.size() + size - 1) / size);
      const std::span<const Sphere<dimension>> all(spheres_);
      const std::size_t nodes_per_block = std::max<std::size_t>(1, 8192 / size);
      parallel_blocks((level.size() + nodes_per_block - 1) / nodes_per_block, progress, [&](std::size_t block) {
        const std::size_t end = std::min(level.size(), (block + 1) * nodes_per_block);
        for (std::size_t i = block * nodes_per_block; i < end; ++i)
          level[i] = Node<dimension>::around(all.subspan(i * size, std::min(size, all.size() - i * size)));
      });
      if (level.size() <= 1) break;
    }
  }

  /// Per position in the order, the entry (index at construction) there.
  const std::vector<int>& order() const { return order_; }

  /// The importance of a sphere among the entries that are still there, or anything not above its `least` if it is not.
  /// `sphere_of_entry`: negative for entries that are gone. `candidate`, when not -1, is the position of a likely
  /// witness; it is set to the one found, and left alone if there is none.
  double importance(const Query<dimension>& query, std::span<const int> sphere_of_entry, int& candidate) const {
    const Sphere<dimension>& sphere = query.sphere();
    const auto is_there = [&](std::size_t position) { return sphere_of_entry[order_[position]] >= 0; };
    double best =
        candidate >= 0 && is_there(candidate) ? query.quotient_below(spheres_[candidate], infinity) : infinity;
    double squared_best = best * best;

    struct Visit {
      double squared_bound;
      std::uint32_t level;
      std::uint32_t node;
    };
    std::array<Visit, 128> stack;
    std::size_t depth = 0;
    stack[depth++] = {levels_.back()[0].squared_bound(sphere, squared_best),
                      static_cast<std::uint32_t>(levels_.size() - 1), 0};
    while (depth > 0) {
      if (best <= query.least()) break;
      const Visit visit = stack[--depth];
      if (!(visit.squared_bound <= squared_best) || visit.squared_bound == infinity) continue;
      if (query.is_least_within(levels_[visit.level][visit.node].largest_distance(sphere), best)) continue;
      if (visit.level == 0) {
        const std::size_t end = std::min(spheres_.size(), (std::size_t{visit.node} + 1) * leaf_size);
        for (std::size_t i = std::size_t{visit.node} * leaf_size; i < end; ++i) {
          if (!may_be_less(sphere, spheres_[i], squared_best)) continue;
          const double value = query.quotient_below(spheres_[i], best);
          if (value < best && is_there(i)) {
            best = value;
            squared_best = best * best;
            candidate = static_cast<int>(i);
          }
        }
        continue;
      }
      const auto& below = levels_[visit.level - 1];
      const std::size_t begin = std::size_t{visit.node} * fan_out;
      const std::size_t end = std::min(below.size(), begin + fan_out);
      const std::size_t first = depth;
      for (std::size_t i = begin; i < end; ++i) {
        const double bound = below[i].squared_bound(sphere, squared_best);
        if (bound <= squared_best && bound < infinity)
          stack[depth++] = {bound, visit.level - 1, static_cast<std::uint32_t>(i)};
      }
      // The most promising child is taken first, from the top of the stack.
      std::sort(stack.begin() + first, stack.begin() + depth,
                [](const Visit& a, const Visit& b) { return a.squared_bound > b.squared_bound; });
    }
    return best;
  }

  /// The importance of all spheres, which are those of the construction. Ends with their values and the entries that
  /// attain them in `values` and `witnesses`, which hold infinity and -1. `slopes`: see scale_importance.
  void find_all(std::span<const double> slopes, std::span<double> values, std::span<int> witnesses,
                Progress& progress) const {
    constexpr std::size_t block = 512;
    parallel_blocks((order_.size() + block - 1) / block, progress, [&](std::size_t b) {
      // Neighbours in the order often share their witness, which makes a good start.
      int candidate = -1;
      const std::size_t end = std::min(order_.size(), (b + 1) * block);
      for (std::size_t position = b * block; position < end; ++position) {
        const int i = order_[position];
        const Query<dimension> query(spheres_[position], slopes.empty() ? infinity : slopes[i]);
        // None is gone.
        values[i] = importance(query, order_, candidate);
        if (values[i] < infinity) witnesses[i] = order_[candidate];
      }
    });
  }

 private:
  std::vector<int> order_;  ///< per position the index of the sphere
  std::vector<Sphere<dimension>> spheres_;
  std::vector<std::vector<Node<dimension>>> levels_;
};

}  // namespace mesecina::scale_search

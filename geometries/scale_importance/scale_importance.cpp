// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/scale_importance/scale_importance.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t leaf_size = 8;
constexpr std::size_t fan_out = 4;

constexpr double unit_roundoff = 1.1102230246251565e-16;

struct Disk {
  double x;
  double y;
  double radius;
};

double quotient(const Disk& disk, const Disk& larger) {
  const double growth = larger.radius - disk.radius;
  if (!(growth > 0)) return infinity;
  const double dx = larger.x - disk.x;
  const double dy = larger.y - disk.y;
  return std::sqrt(dx * dx + dy * dy) / growth;
}

/// A disk whose importance is wanted.
class Query {
 public:
  /// slope: see scale_importance; infinity where nothing is known.
  Query(const Disk& disk, double slope)
      : disk_(disk), slope_(slope), least_(slope < infinity ? 1 : 0), inverse_diameter_(0.5 / disk.radius) {}

  const Disk& disk() const { return disk_; }
  /// Lower bound of all quotients.
  double least() const { return least_; }
  /// Lower bound of the quotients with disks up to `distance` away. Not increasing with the distance, as rounded too,
  /// and the same for all that cannot be told from the disk itself: so one of them settles it for the others.
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
  double quotient_below(const Disk& larger, double value) const {
    const double result = quotient(disk_, larger);
    if (!(result < value) || least_ == 0) return result;
    return std::max(result,
                    least_within(std::sqrt(squared_distance(Point_2{disk_.x, disk_.y}, Point_2{larger.x, larger.y}))));
  }

 private:
  /// Relative to the diameter. Larger than what rounding does to centers in most sets of samples, so that bounds are
  /// the same there, and so small that nothing is lost: it makes bounds lower by such a part.
  static constexpr double resolution = 0x1p-32;

  Disk disk_;
  double slope_;
  double least_;
  double inverse_diameter_;
};

/// Bounding volume of disks whose centers lie near a line and whose radii change nearly linearly along it, as those of
/// neighbours on a medial axis do: centers within an oriented rectangle, radius at most peak + slope t at coordinate t
/// along it.
///
/// Plain boxes with a largest radius are off by the size of the box; near a minimum, where the quotient changes with
/// the square of the distance, a search would have to open some sqrt(n) of them. This volume is off by the square of
/// its size.
struct Node {
  double x = 0;  ///< middle of the rectangle
  double y = 0;
  double axis_x = 1;  ///< unit vector
  double axis_y = 0;
  double half_length = 0;
  double half_width = 0;
  double peak = -infinity;
  double slope = 0;
  double largest_radius = -infinity;

  static Node around(std::span<const Disk> disks);

  /// Upper bound of the distances from the center of `disk` to those of the node.
  double largest_distance(const Disk& disk) const {
    return (std::abs(disk.x - x) + std::abs(disk.y - y) + half_length + half_width) * (1 + 8 * unit_roundoff);
  }

  /// Square of a lower bound of the quotient of `disk` with any disk of the node; infinity when none is larger.
  /// Rounding is accounted for, so that it can never cut off the minimum.
  double squared_bound(const Disk& disk) const {
    // As rounded, no growth in the node is more than this; without slack, because radii may differ by rounding alone.
    const double largest_growth = largest_radius - disk.radius;
    if (!(largest_growth > 0)) return infinity;
    const double dx = disk.x - x;
    const double dy = disk.y - y;
    const double along = dx * axis_x + dy * axis_y;
    const double across = dy * axis_x - dx * axis_y;
    const double position_error = 8 * unit_roundoff * (std::abs(dx) + std::abs(dy));
    const double q = std::max(0.0, std::abs(across) - half_width - position_error);
    // With u = t - along the quotient is sqrt(u^2 + q^2) / (growth + slope u): quasiconvex where growth is positive,
    // with its least value at u = slope q^2 / growth.
    const double low = -half_length - along - position_error;
    const double high = half_length - along + position_error;
    const double growth =
        peak - disk.radius + slope * along +
        8 * unit_roundoff * (std::abs(peak) + disk.radius + std::abs(slope) * (std::abs(along) + half_length));
    double u = slope > 0 ? high : low;
    if (growth > 0) u = std::clamp(slope * q * q / growth, low, high);
    const double growth_there = growth + slope * u;
    if (!(growth_there > 0)) return infinity;
    // At the nearest point of the rectangle the least distance, with the largest growth of all.
    const double nearest = std::clamp(0.0, low, high);
    const double by_slope = (u * u + q * q) / (growth_there * growth_there);
    const double squared_growth = largest_growth * largest_growth;
    const double by_largest = squared_growth > 0 ? (nearest * nearest + q * q) / squared_growth : 0;
    return std::max(by_slope, by_largest) * (1 - 64 * unit_roundoff);
  }
};

Node Node::around(std::span<const Disk> disks) {
  Node node;
  const double count = static_cast<double>(disks.size());
  double radius = 0;
  for (const Disk& disk : disks) {
    node.x += disk.x / count;
    node.y += disk.y / count;
    radius += disk.radius / count;
  }
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (const Disk& disk : disks) {
    const double dx = disk.x - node.x;
    const double dy = disk.y - node.y;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  // Direction of the larger eigenvalue of the covariance.
  const double half_difference = (xx - yy) / 2;
  const double root = std::sqrt(half_difference * half_difference + xy * xy);
  double ax = half_difference >= 0 ? half_difference + root : xy;
  double ay = half_difference >= 0 ? xy : root - half_difference;
  const double length = std::sqrt(ax * ax + ay * ay);
  if (length > 0) {
    ax /= length;
    ay /= length;
  } else {
    ax = 1;
    ay = 0;
  }
  node.axis_x = ax;
  node.axis_y = ay;

  double tt = 0;
  double tr = 0;
  double low_t = infinity;
  double high_t = -infinity;
  double low_w = infinity;
  double high_w = -infinity;
  for (const Disk& disk : disks) {
    const double dx = disk.x - node.x;
    const double dy = disk.y - node.y;
    const double t = dx * ax + dy * ay;
    const double w = dy * ax - dx * ay;
    low_t = std::min(low_t, t);
    high_t = std::max(high_t, t);
    low_w = std::min(low_w, w);
    high_w = std::max(high_w, w);
    tt += t * t;
    tr += t * (disk.radius - radius);
  }
  const double middle_t = (low_t + high_t) / 2;
  const double middle_w = (low_w + high_w) / 2;
  node.x += middle_t * ax - middle_w * ay;
  node.y += middle_t * ay + middle_w * ax;
  node.slope = tt > 0 ? tr / tt : 0;
  double reach = 0;
  for (const Disk& disk : disks) {
    const double dx = disk.x - node.x;
    const double dy = disk.y - node.y;
    const double t = dx * ax + dy * ay;
    node.half_length = std::max(node.half_length, std::abs(t));
    node.half_width = std::max(node.half_width, std::abs(dy * ax - dx * ay));
    node.peak = std::max(node.peak, disk.radius - node.slope * t);
    node.largest_radius = std::max(node.largest_radius, disk.radius);
    reach = std::max(reach, std::abs(dx) + std::abs(dy));
  }
  node.half_length += 8 * unit_roundoff * reach;
  node.half_width += 8 * unit_roundoff * reach;
  node.peak += 8 * unit_roundoff * (node.largest_radius + std::abs(node.slope) * reach);
  return node;
}

}  // namespace

namespace {

struct Entry {
  Disk disk;
  int index;
};

/// Orders the entries so that the aligned blocks of leaf_size * 2^k of them are the cells of a kd-tree, each cut across
/// the longer side of the box of its centers. (A space-filling curve with fixed alternation of the axes would cut a
/// medial axis along a coordinate axis by its rounding noise, and spread every block over half of it.)
void sort_into_cells(std::span<Entry> entries, const Progress& progress) {
  if (entries.size() <= leaf_size) return;
  progress.check();
  Box box;
  for (const Entry& entry : entries) box.add(Point_2{entry.disk.x, entry.disk.y});
  const std::size_t half = std::bit_ceil((entries.size() + leaf_size - 1) / leaf_size) / 2 * leaf_size;
  const auto middle = entries.begin() + static_cast<std::ptrdiff_t>(half);
  if (box.upper.x - box.lower.x >= box.upper.y - box.lower.y) {
    std::ranges::nth_element(entries, middle, {}, [](const Entry& entry) { return entry.disk.x; });
  } else {
    std::ranges::nth_element(entries, middle, {}, [](const Entry& entry) { return entry.disk.y; });
  }
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

}  // namespace

/// Disks in the order of a kd-tree under a tree of nodes; level 0 holds the leaves.
class Scale_importance::Hierarchy {
 public:
  Hierarchy(std::span<const Point_2> centers, std::span<const double> radii, Progress& progress) {
    std::vector<Entry> entries;
    entries.reserve(centers.size());
    for (std::size_t i = 0; i < centers.size(); ++i)
      entries.push_back({{centers[i].x, centers[i].y, radii[i]}, static_cast<int>(i)});
    parallel_region(progress, [&] { sort_into_cells(entries, progress); });
    order_.reserve(entries.size());
    disks_.reserve(entries.size());
    for (const Entry& entry : entries) {
      order_.push_back(entry.index);
      disks_.push_back(entry.disk);
    }
    for (std::size_t size = leaf_size;; size *= fan_out) {
      std::vector<Node>& level = levels_.emplace_back((disks_.size() + size - 1) / size);
      const std::span<const Disk> all(disks_);
      const std::size_t nodes_per_block = std::max<std::size_t>(1, 8192 / size);
      parallel_blocks((level.size() + nodes_per_block - 1) / nodes_per_block, progress, [&](std::size_t block) {
        const std::size_t end = std::min(level.size(), (block + 1) * nodes_per_block);
        for (std::size_t i = block * nodes_per_block; i < end; ++i)
          level[i] = Node::around(all.subspan(i * size, std::min(size, all.size() - i * size)));
      });
      if (level.size() <= 1) break;
    }
  }

  /// Per position in the order, the entry (index at construction) there.
  const std::vector<int>& order() const { return order_; }

  /// The importance of a disk among the entries that are still there, or anything not above its `least` if it is not.
  /// `candidate`, when not -1, is the position of a likely witness; it is set to the one found, and left alone if there
  /// is none.
  double importance(const Query& query, std::span<const int> disk_of_entry, int& candidate) const {
    const Disk& disk = query.disk();
    const auto is_there = [&](std::size_t position) { return disk_of_entry[order_[position]] >= 0; };
    double best = candidate >= 0 && is_there(candidate) ? query.quotient_below(disks_[candidate], infinity) : infinity;
    double squared_best = best * best;

    struct Visit {
      double squared_bound;
      std::uint32_t level;
      std::uint32_t node;
    };
    std::array<Visit, 128> stack;
    std::size_t depth = 0;
    stack[depth++] = {levels_.back()[0].squared_bound(disk), static_cast<std::uint32_t>(levels_.size() - 1), 0};
    while (depth > 0) {
      if (best <= query.least()) break;
      const Visit visit = stack[--depth];
      if (!(visit.squared_bound <= squared_best) || visit.squared_bound == infinity) continue;
      if (query.is_least_within(levels_[visit.level][visit.node].largest_distance(disk), best)) continue;
      if (visit.level == 0) {
        const std::size_t end = std::min(disks_.size(), (std::size_t{visit.node} + 1) * leaf_size);
        for (std::size_t i = std::size_t{visit.node} * leaf_size; i < end; ++i) {
          const double value = query.quotient_below(disks_[i], best);
          if (value < best && is_there(i)) {
            best = value;
            squared_best = best * best;
            candidate = static_cast<int>(i);
          }
        }
        continue;
      }
      const std::vector<Node>& below = levels_[visit.level - 1];
      const std::size_t begin = std::size_t{visit.node} * fan_out;
      const std::size_t end = std::min(below.size(), begin + fan_out);
      const std::size_t first = depth;
      for (std::size_t i = begin; i < end; ++i) {
        const double bound = below[i].squared_bound(disk);
        if (bound <= squared_best && bound < infinity)
          stack[depth++] = {bound, visit.level - 1, static_cast<std::uint32_t>(i)};
      }
      // The most promising child is taken first, from the top of the stack.
      std::sort(stack.begin() + first, stack.begin() + depth,
                [](const Visit& a, const Visit& b) { return a.squared_bound > b.squared_bound; });
    }
    return best;
  }

 private:
  std::vector<int> order_;  ///< per position the index of the disk
  std::vector<Disk> disks_;
  std::vector<std::vector<Node>> levels_;
};

namespace {

/// The exchanged disks may be this many before a new hierarchy pays.
constexpr std::size_t most_outside_hierarchy = 256;

/// Without root and division; true may be wrong by rounding.
bool may_be_less(const Disk& disk, const Disk& larger, double value) {
  const double growth = larger.radius - disk.radius;
  if (!(growth > 0)) return false;
  const double dx = larger.x - disk.x;
  const double dy = larger.y - disk.y;
  return !(dx * dx + dy * dy > value * value * (growth * growth) * (1 + 16 * unit_roundoff));
}

}  // namespace

Scale_importance scale_importance(std::span<const Point_2> centers, std::span<const double> radii,
                                  std::span<const double> slopes, Progress& progress) {
  Scale_importance result;
  result.values.assign(centers.size(), infinity);
  result.witnesses.assign(centers.size(), -1);
  result.disk_of_entry.resize(centers.size());
  std::iota(result.disk_of_entry.begin(), result.disk_of_entry.end(), 0);
  if (centers.empty()) return result;
  const auto hierarchy = std::make_shared<const Scale_importance::Hierarchy>(centers, radii, progress);
  const auto& order = hierarchy->order();
  constexpr std::size_t block = 512;
  parallel_blocks((order.size() + block - 1) / block, progress, [&](std::size_t b) {
    // Neighbours in the order often share their witness, which makes a good start.
    int candidate = -1;
    const std::size_t end = std::min(order.size(), (b + 1) * block);
    for (std::size_t position = b * block; position < end; ++position) {
      const int i = order[position];
      const Query query({centers[i].x, centers[i].y, radii[i]}, slopes.empty() ? infinity : slopes[i]);
      result.values[i] = hierarchy->importance(query, result.disk_of_entry, candidate);
      if (result.values[i] < infinity) result.witnesses[i] = order[candidate];
    }
  });
  result.hierarchy = hierarchy;
  return result;
}

Scale_importance update_scale_importance(const Scale_importance& old, std::span<const int> old_index,
                                         std::span<const Point_2> centers, std::span<const double> radii,
                                         std::span<const double> slopes, Progress& progress) {
  const std::size_t count = centers.size();
  std::vector<int> new_index(old.values.size(), -1);
  std::vector<int> added;
  for (std::size_t i = 0; i < count; ++i) {
    if (old_index[i] >= 0) {
      new_index[old_index[i]] = static_cast<int>(i);
    } else {
      added.push_back(static_cast<int>(i));
    }
  }
  Scale_importance result;
  result.hierarchy = old.hierarchy;
  result.disk_of_entry.reserve(old.disk_of_entry.size());
  std::vector<bool> is_inside(count, false);
  for (const int disk : old.disk_of_entry) {
    const int now = disk < 0 ? -1 : new_index[disk];
    result.disk_of_entry.push_back(now);
    if (now >= 0) is_inside[now] = true;
  }
  std::vector<int> outside;
  for (std::size_t i = 0; i < count; ++i)
    if (!is_inside[i]) outside.push_back(static_cast<int>(i));
  if (!old.hierarchy || outside.size() > most_outside_hierarchy)
    return scale_importance(centers, radii, slopes, progress);

  result.values.assign(count, infinity);
  result.witnesses.assign(count, -1);
  const auto& order = result.hierarchy->order();
  const auto disk = [&](std::size_t i) { return Disk{centers[i].x, centers[i].y, radii[i]}; };
  parallel_for(count, progress, [&](std::size_t i) {
    const Query query(disk(i), slopes.empty() ? infinity : slopes[i]);
    const int before = old_index[i];
    const int witness = before < 0 ? -1 : old.witnesses[before];
    const bool is_lost = before < 0 || (witness >= 0 && new_index[witness] < 0);
    if (is_lost) {
      int candidate = -1;
      result.values[i] = result.hierarchy->importance(query, result.disk_of_entry, candidate);
      if (result.values[i] < infinity) result.witnesses[i] = result.disk_of_entry[order[candidate]];
    } else {
      result.values[i] = old.values[before];
      if (witness >= 0) result.witnesses[i] = new_index[witness];
    }
    for (const int other : is_lost ? outside : added) {
      if (!may_be_less(query.disk(), disk(other), result.values[i])) continue;
      const double value = query.quotient_below(disk(other), result.values[i]);
      if (!(value < result.values[i])) continue;
      result.values[i] = value;
      result.witnesses[i] = other;
    }
  });
  return result;
}

}  // namespace mesecina

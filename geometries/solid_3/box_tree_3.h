// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/point.h"
#include "core/progress.h"

namespace mesecina {

/// Closed boxes meet.
inline bool do_meet(const Box& a, const Box& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y && b.lower.y <= a.upper.y &&
         a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

/// 0 inside.
inline double squared_distance(const Box& box, const Point_3& p) {
  const double x = std::max({box.lower.x - p.x, p.x - box.upper.x, 0.0});
  const double y = std::max({box.lower.y - p.y, p.y - box.upper.y, 0.0});
  const double z = std::max({box.lower.z - p.z, p.z - box.upper.z, 0.0});
  return x * x + y * y + z * z;
}

/// A balanced hierarchy of boxes, about which users ask what meets something or is near to something. Items are known
/// by their position in the order of the tree, so that what belongs to them can be kept in that order.
class Box_tree_3 {
 public:
  Box_tree_3() = default;
  /// O(n log n), on as many threads as `progress` allows. The same tree whatever their number.
  Box_tree_3(std::span<const Box> boxes, Progress& progress);

  /// Which box is at a position of the tree.
  const std::vector<int>& order() const { return order_; }
  bool is_empty() const { return nodes_.empty(); }
  /// Of everything.
  const Box& box() const { return nodes_.front().box; }

  /// Per node the largest of the values of its items, which are given by position. For bounds that are asked about
  /// (box, node).
  std::vector<double> largest_below(std::span<const double> values) const;

  /// Calls visit(position) for all items in the leaves below which `meets(box)` was true all the way: at least those
  /// whose own box meets. Stops when visit returns false. In the order of positions.
  template <class Meets, class Visit>
  void visit(const Meets& meets, const Visit& visit) const {
    visit_from(0, meets, visit);
  }
  /// The same from position `first` on.
  template <class Meets, class Visit>
  void visit_from(int first, const Meets& meets, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<int, depth_limit> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
      const int k = stack[--size];
      const Node& node = nodes_[k];
      const int end = node.first + node.count;
      if (end <= first || !ask(meets, k)) continue;
      if (node.count <= leaf_size) {
        for (int i = std::max(first, node.first); i < end; ++i)
          if (!visit(i)) return;
      } else {
        stack[size++] = right_child(k);
        stack[size++] = k + 1;
      }
    }
  }

  /// Calls visit(position), nearer leaves first, while `bound(box)` of the leaf is not above `limit`, which visit may
  /// lower.
  template <class Bound, class Visit>
  void approach(const Bound& bound, const double& limit, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<std::pair<int, double>, depth_limit> stack;
    std::size_t size = 0;
    stack[size++] = {0, ask(bound, 0)};
    while (size > 0) {
      const auto [k, least] = stack[--size];
      if (least > limit) continue;
      const Node& node = nodes_[k];
      if (node.count <= leaf_size) {
        for (int i = node.first; i < node.first + node.count; ++i) visit(i);
        continue;
      }
      std::pair<int, double> near{k + 1, ask(bound, k + 1)};
      std::pair<int, double> far{right_child(k), ask(bound, right_child(k))};
      if (far.second < near.second) std::swap(near, far);
      stack[size++] = far;
      stack[size++] = near;
    }
  }

 private:
  static constexpr int leaf_size = 4;
  static constexpr std::size_t depth_limit = 64;
  /// Of positions [first, first + count). All leaves but the last are full, so that a node's children are known from
  /// its count: the left one follows it, and all below it.
  struct Node {
    Box box;
    int first = 0;
    int count = 0;
  };
  struct Item {
    std::array<float, 3> middle{};  ///< only decides how good the tree is
    int index = 0;
  };

  /// About a box, or about a box and its node.
  template <class Question>
  auto ask(const Question& question, int k) const {
    if constexpr (std::is_invocable_v<const Question&, const Box&, int>) {
      return question(nodes_[k].box, k);
    } else {
      return question(nodes_[k].box);
    }
  }
  static int leaves(int count) { return (count + leaf_size - 1) / leaf_size; }
  static int left_count(int count) { return leaf_size * ((leaves(count) + 1) / 2); }
  int right_child(int k) const { return k + 2 * leaves(left_count(nodes_[k].count)); }
  void build(int k, int first, int count, std::span<const Box> boxes, std::vector<Item>& items, Progress& progress);

  std::vector<Node> nodes_;
  std::vector<int> order_;
};

}  // namespace mesecina

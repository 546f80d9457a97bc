// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/box_tree_3.h"

#include <tbb/parallel_invoke.h>

#include <limits>

#include "geometries/parallel.h"

namespace mesecina {

Box_tree_3::Box_tree_3(std::span<const Box> boxes, Progress& progress) {
  if (boxes.empty()) return;
  Box all;
  for (const Box& box : boxes) all.add(box);
  const Point_3 origin = midpoint(all.lower, all.upper);
  std::vector<Item> items(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Point_3 middle = midpoint(boxes[i].lower, boxes[i].upper) - origin;
    items[i] = {{static_cast<float>(middle.x), static_cast<float>(middle.y), static_cast<float>(middle.z)},
                static_cast<int>(i)};
  }
  const int count = static_cast<int>(boxes.size());
  nodes_.resize(2 * static_cast<std::size_t>(leaves(count)) - 1);
  parallel_region(progress, [&] { build(0, 0, count, boxes, items, progress); });
  order_.reserve(items.size());
  for (const Item& item : items) order_.push_back(item.index);
}

std::vector<double> Box_tree_3::largest_below(std::span<const double> values) const {
  std::vector<double> result(nodes_.size());
  for (int k = static_cast<int>(nodes_.size()) - 1; k >= 0; --k) {
    const Node& node = nodes_[k];
    result[k] = node.count <= leaf_size
                    ? std::ranges::max(values.subspan(static_cast<std::size_t>(node.first), node.count))
                    : std::max(result[k + 1], result[right_child(k)]);
  }
  return result;
}

void Box_tree_3::build(int k, int first, int count, std::span<const Box> boxes, std::vector<Item>& items,
                       Progress& progress) {
  Node& node = nodes_[k];
  node.first = first;
  node.count = count;
  const auto begin = items.begin() + first;
  const auto end = begin + count;
  if (count <= leaf_size) {
    for (auto item = begin; item != end; ++item) node.box.add(boxes[item->index]);
    return;
  }
  constexpr float infinity = std::numeric_limits<float>::infinity();
  std::array<float, 3> low{infinity, infinity, infinity};
  std::array<float, 3> high{-infinity, -infinity, -infinity};
  for (auto item = begin; item != end; ++item) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], item->middle[axis]);
      high[axis] = std::max(high[axis], item->middle[axis]);
    }
  }
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
  const int on_left = left_count(count);
  std::nth_element(begin, begin + on_left, end, [longest](const Item& a, const Item& b) {
    return a.middle[longest] != b.middle[longest] ? a.middle[longest] < b.middle[longest] : a.index < b.index;
  });
  const auto build_left = [&] { build(k + 1, first, on_left, boxes, items, progress); };
  const auto build_right = [&] { build(right_child(k), first + on_left, count - on_left, boxes, items, progress); };
  constexpr int worth_a_task = 8192;
  if (count >= worth_a_task) progress.check();
  if (count >= worth_a_task && progress.threads() > 1) {
    tbb::parallel_invoke(build_left, build_right);
  } else {
    build_left();
    build_right();
  }
  node.box.add(nodes_[k + 1].box);
  node.box.add(nodes_[right_child(k)].box);
}

}  // namespace mesecina

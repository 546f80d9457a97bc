// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/box_tree.h"

#include <cmath>
#include <limits>
#include <utility>

namespace mesecina {
namespace {

Pixel_box empty_box() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, infinity, -infinity, -infinity};
}

void extend(Pixel_box& box, const Pixel_box& other) {
  box.left = std::min(box.left, other.left);
  box.top = std::min(box.top, other.top);
  box.right = std::max(box.right, other.right);
  box.bottom = std::max(box.bottom, other.bottom);
}

/// The lower 16 bits at the even places.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | (bits << 8)) & 0x00ff00ffU;
  bits = (bits | (bits << 4)) & 0x0f0f0f0fU;
  bits = (bits | (bits << 2)) & 0x33333333U;
  return (bits | (bits << 1)) & 0x55555555U;
}

}  // namespace

Box_tree::Box_tree(const std::vector<Pixel_box>& boxes) {
  const auto is_finite = [](const Pixel_box& box) {
    return std::isfinite(box.left) && std::isfinite(box.top) && std::isfinite(box.right) && std::isfinite(box.bottom);
  };
  Pixel_box all = empty_box();
  for (const Pixel_box& box : boxes)
    if (is_finite(box)) extend(all, box);
  const auto cell = [](double low, double high, double from, double to) {
    const double t = to > from ? ((low / 2 + high / 2) - from) / (to - from) : 0;
    return spread(static_cast<std::uint32_t>(std::clamp(t, 0.0, 1.0) * 65535));
  };
  std::vector<std::pair<std::uint32_t, std::uint32_t>> keys;
  keys.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Pixel_box& box = boxes[i];
    if (!is_finite(box)) continue;
    const std::uint32_t column = cell(box.left, box.right, all.left, all.right);
    const std::uint32_t row = cell(box.top, box.bottom, all.top, all.bottom);
    keys.emplace_back(column | row << 1, static_cast<std::uint32_t>(i));
  }
  if (keys.empty()) return;
  std::sort(keys.begin(), keys.end());
  std::vector<Pixel_box> level;
  level.reserve(keys.size());
  order_.reserve(keys.size());
  for (const auto& [key, i] : keys) {
    order_.push_back(i);
    level.push_back(boxes[i]);
  }
  levels_.push_back(std::move(level));
  while (levels_.back().size() > fan_out) {
    const std::vector<Pixel_box>& below = levels_.back();
    std::vector<Pixel_box> above((below.size() + fan_out - 1) / fan_out, empty_box());
    for (std::size_t i = 0; i < below.size(); ++i) extend(above[i / fan_out], below[i]);
    levels_.push_back(std::move(above));
  }
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/id_picture.h"

#include <cmath>
#include <utility>

namespace mesecina {

Id_picture::Id_picture(const Frame_3& frame, const Projection_3& projection, std::vector<std::uint32_t> ids,
                       std::vector<float> depths)
    : width_(frame.width),
      height_(frame.height),
      projection_(projection),
      ids_(std::move(ids)),
      depths_(std::move(depths)) {}

std::optional<Id_picture::Hit> Id_picture::at(int column, int row) const {
  if (column < 0 || column >= width_ || row < 0 || row >= height_) return std::nullopt;
  const std::size_t pixel =
      static_cast<std::size_t>(height_ - 1 - row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  const std::uint32_t layer = ids_[2 * pixel];
  if (layer == 0) return std::nullopt;
  Hit hit;
  hit.layer = layer - 1;
  constexpr std::uint32_t no_element = ~0U;
  if (ids_[2 * pixel + 1] != no_element) hit.element = ids_[2 * pixel + 1];
  hit.place = projection_->place_at(column, row, depths_[pixel]);
  return hit;
}

std::optional<Id_picture::Hit> Id_picture::find(int column, int row, int tolerance) const {
  std::optional<Hit> best;
  for (int y = -tolerance; y <= tolerance; ++y) {
    for (int x = -tolerance; x <= tolerance; ++x) {
      const double distance = std::hypot(x, y);
      if (distance > tolerance) continue;
      std::optional<Hit> hit = at(column + x, row + y);
      if (!hit) continue;
      hit->distance = distance;
      const bool is_better = !best || (hit->element && !best->element) ||
                             (hit->element.has_value() == best->element.has_value() && distance < best->distance);
      if (is_better) best = hit;
    }
  }
  return best;
}

}  // namespace mesecina

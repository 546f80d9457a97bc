// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "layers/projection_3.h"

namespace mesecina {

/// What is seen in the pixels of a picture.
class Id_picture {
 public:
  struct Hit {
    std::size_t layer = 0;               ///< index in Scene::layers
    std::optional<std::size_t> element;  ///< none where the cutting plane is inside a solid
    Point_3 place;
    double distance = 0;  ///< pixels from where it was looked for
  };

  /// An empty picture.
  Id_picture() = default;
  /// Rows from below: in `ids` layer + 1 and element of each pixel, or two zeros; in `depths` as place_at() takes them.
  Id_picture(const Frame_3& frame, const Projection_3& projection, std::vector<std::uint32_t> ids,
             std::vector<float> depths);

  int width() const { return width_; }
  int height() const { return height_; }
  /// What is seen nearest to the middle of this pixel (rows from above) within `tolerance` pixels, elements before
  /// areas of the cutting plane; nullopt for nothing and beyond the picture. O(tolerance^2).
  std::optional<Hit> find(int column, int row, int tolerance = 0) const;

 private:
  std::optional<Hit> at(int column, int row) const;

  int width_ = 0;
  int height_ = 0;
  std::optional<Projection_3> projection_;
  std::vector<std::uint32_t> ids_;
  std::vector<float> depths_;
};

}  // namespace mesecina

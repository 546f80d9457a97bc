// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/silhouette.h"

#include <cmath>
#include <cstdint>

namespace mesecina {
namespace {

/// Luminance 255 * 255 is white. The level is no whole number, so no sample lies on it and no ring touches itself.
constexpr int white = 255 * 255;
constexpr double level = white / 2.0;
static_assert(white % 2 == 1);
constexpr double smallest_area = 1e-3;

/// Samples at pixel centres, column and row from 0, with a frame of white around.
class Luminance {
 public:
  explicit Luminance(const Image& image)
      : width_(image.width + 2), height_(image.height + 2), samples_(std::size_t(width_) * height_, white) {
    const std::uint8_t* pixel = image.rgba.data();
    for (int row = 1; row + 1 < height_; ++row) {
      for (int column = 1; column + 1 < width_; ++column, pixel += 4) {
        // ITU-R BT.601 weights.
        const int gray = 299 * pixel[0] + 587 * pixel[1] + 114 * pixel[2];
        const int on_white = (gray * pixel[3] + 255 * 1000 * (255 - pixel[3]) + 500) / 1000;
        samples_[index(column, row)] = static_cast<std::uint16_t>(on_white);
      }
    }
  }
  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t index(int column, int row) const { return std::size_t(row) * width_ + column; }
  int at(int column, int row) const { return samples_[index(column, row)]; }
  bool is_dark(int column, int row) const { return at(column, row) < level; }
  std::size_t size() const { return samples_.size(); }

 private:
  int width_;
  int height_;
  std::vector<std::uint16_t> samples_;
};

struct Sample {
  int column = 0;
  int row = 0;
};

/// Follows one contour, dark on its left. It stands between two neighbouring samples, `left` (dark) and `right`
/// (light), and looks across the square of samples in front of them.
class Walker {
 public:
  Walker(const Luminance& luminance, Sample left, Sample right) : luminance_(luminance), left_(left), right_(right) {}

  const Sample& left() const { return left_; }
  const Sample& right() const { return right_; }

  /// Where the contour crosses the line between the two samples, in columns and rows.
  Point_2 crossing() const {
    const double dark = luminance_.at(left_.column, left_.row);
    const double light = luminance_.at(right_.column, right_.row);
    const double t = (level - dark) / (light - dark);
    return {left_.column + t * (right_.column - left_.column), left_.row + t * (right_.row - left_.row)};
  }

  void advance() {
    // With rows growing downwards, ahead is the step to the right sample turned a quarter to the left.
    const int step_column = right_.row - left_.row;
    const int step_row = left_.column - right_.column;
    const Sample front_left{left_.column + step_column, left_.row + step_row};
    const Sample front_right{right_.column + step_column, right_.row + step_row};
    const bool left_is_dark = luminance_.is_dark(front_left.column, front_left.row);
    const bool right_is_dark = luminance_.is_dark(front_right.column, front_right.row);
    const bool joins_diagonal = right_is_dark && (left_is_dark || is_dark_in_the_middle(front_left, front_right));
    if (joins_diagonal) {
      left_ = front_right;
    } else if (left_is_dark) {
      left_ = front_left;
      right_ = front_right;
    } else {
      right_ = front_left;
    }
  }

 private:
  /// At the saddle of the bilinear interpolation; only for squares whose diagonals differ.
  bool is_dark_in_the_middle(const Sample& front_left, const Sample& front_right) const {
    const auto value = [&](const Sample& s) { return luminance_.at(s.column, s.row) - level; };
    const double dark_product = value(left_) * value(front_right);
    const double light_product = value(right_) * value(front_left);
    const double sum = value(left_) + value(front_right) - value(right_) - value(front_left);
    return (dark_product - light_product) / sum < 0;
  }

  const Luminance& luminance_;
  Sample left_;
  Sample right_;
};

double signed_area(const Ring_2& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_2& p = ring[i];
    const Point_2& q = ring[(i + 1) % ring.size()];
    twice += (p.x - ring[0].x) * (q.y - ring[0].y) - (q.x - ring[0].x) * (p.y - ring[0].y);
  }
  return twice / 2;
}

}  // namespace

Outline_2 silhouette(const Image& image) {
  Outline_2 outline;
  if (image.width <= 0 || image.height <= 0) return outline;
  const Luminance luminance(image);
  // Every ring goes down somewhere between a light sample and a dark one to its right.
  std::vector<bool> visited(luminance.size());
  for (int row = 1; row + 1 < luminance.height(); ++row) {
    for (int column = 0; column + 1 < luminance.width(); ++column) {
      const bool goes_down = !luminance.is_dark(column, row) && luminance.is_dark(column + 1, row);
      if (!goes_down || visited[luminance.index(column, row)]) continue;
      Ring_2 ring;
      Walker walker(luminance, {column + 1, row}, {column, row});
      do {
        const auto& [right_column, right_row] = walker.right();
        const bool down = walker.left().row == right_row && walker.left().column == right_column + 1;
        if (down) visited[luminance.index(right_column, right_row)] = true;
        const Point_2 p = walker.crossing();
        ring.push_back({image.lower_left.x + (p.x - 0.5) * image.pixel_size,
                        image.lower_left.y + (image.height - (p.y - 0.5)) * image.pixel_size});
        walker.advance();
      } while (walker.left().column != column + 1 || walker.left().row != row || walker.right().column != column ||
               walker.right().row != row);
      if (std::abs(signed_area(ring)) >= smallest_area * image.pixel_size * image.pixel_size)
        outline.rings.push_back(std::move(ring));
    }
  }
  return outline;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "core/view_3.h"

namespace mesecina {

/// A rectangle of pixels of a picture, from its lower left corner.
struct Tile {
  int left = 0;
  int bottom = 0;
  int width = 0;
  int height = 0;
};

/// What a scene in space is drawn on.
struct Frame_3 {
  int width = 0;  ///< of the whole picture, in device pixels
  int height = 0;
  double pixel_ratio = 1;  ///< device pixels per logical pixel
  int samples = 1;         ///< along each side of a pixel: 2 makes smooth edges and costs four times as much
  int coarseness = 1;      ///< pixels along each side painted as one, once; of no effect on smooth edges, tiles and ids
  double outlines = 0.6;   ///< dark lines where one thing ends before another: 0 none, 1 black
  int most_translucent_layers = 8;  ///< surfaces behind one another, from the nearest
  std::optional<Tile> tile = {};    ///< only this part of the picture; absent: all of it

  Tile whole_tile() const { return tile.value_or(Tile{0, 0, width, height}); }
};

/// From the scene to the pixels of a frame, in doubles. Eye coordinates: the camera at 0, x to the right, y up, z
/// towards the viewer. Matrices are of 16 numbers, column by column.
class Projection_3 {
 public:
  using Matrix = std::array<float, 16>;

  /// Between the planes near and far lies the box.
  Projection_3(const Camera_3& camera, const Box& box, const Frame_3& frame);

  bool is_perspective() const { return is_perspective_; }
  double near() const { return near_; }
  double far() const { return far_; }
  /// Of a sample, in units of the scene: at distance 1, or everywhere without perspective.
  double pixel_size() const { return pixel_size_; }

  Point_3 to_eye(const Point_3& place) const;
  Point_3 direction_to_eye(const Point_3& direction) const;
  /// To eye coordinates, of places relative to `origin`.
  Matrix eye_matrix(const Point_3& origin) const;
  /// From eye coordinates to those of OpenGL on the tile.
  Matrix clip_matrix() const;

  /// The place that is seen in the middle of a pixel of the whole picture (rows from above) at this depth (0 on the
  /// plane near, 1 on the plane far).
  Point_3 place_at(int column, int row, double depth) const;

 private:
  Camera_3 camera_;
  Camera_3::Axes axes_;
  Frame_3 frame_;
  bool is_perspective_ = true;
  double near_ = 1;
  double far_ = 2;
  double half_width_ = 1;  ///< of the whole picture: at distance 1, or everywhere without perspective
  double half_height_ = 1;
  double pixel_size_ = 1;
};

}  // namespace mesecina

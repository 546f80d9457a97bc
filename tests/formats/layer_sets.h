// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <sstream>
#include <string>

#include "core/formats/format.h"

namespace mesecina {

/// One element of each kind in the plane: point 0, segment 1, ray 2, arc 3 (a quarter, clockwise), triangle 4, polygon
/// 5, ball 6; the value "lambda" of element i is i / 2, infinite for the ray.
inline Primitive_set one_of_each() {
  Primitive_set set;
  set.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.25, 0}};
  set.points = {3};
  set.segments = {{0, 1}};
  set.rays = {{1, {0.6, 0.8, 0}}};
  set.arcs = {{{0, 0}, 1, 2, 1, false}};
  set.triangles = {{0, 1, 2}};
  set.polygon_offsets = {0, 3};
  set.polygon_vertices = {1, 2, 3};
  set.balls = {{0, 2.5}};
  set.values = {{"lambda", "", {0, 0.5, std::numeric_limits<double>::infinity(), 1.5, 2, 2.5, 3}}};
  return set;
}

/// By the writer of the planar formats, or if they have none of this name, of the formats of space.
inline std::string written(std::string_view format, const Layer_document& document) {
  std::ostringstream stream;
  const Formats planar = planar_formats();
  const Formats spatial = spatial_formats();
  const Layer_writer* writer = planar.find_layer_writer(format);
  (writer ? writer : spatial.find_layer_writer(format))->write(stream, document);
  return stream.str();
}

inline std::string written(std::string_view format, const Primitive_set& set) {
  Layer_document document;
  document.layer = "some-layer";
  document.primitives = &set;
  return written(format, document);
}

}  // namespace mesecina

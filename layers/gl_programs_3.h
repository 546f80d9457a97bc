// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "layers/gl_objects.h"

namespace mesecina {

/// Texture units of what the shaders of space read.
namespace units_3 {
inline constexpr int color_map = 0;
inline constexpr int places = 1;
inline constexpr int pieces = 2;
inline constexpr int normals = 3;
inline constexpr int numbers = 4;
inline constexpr int threshold_numbers = 5;
inline constexpr int cut_numbers = 6;
inline constexpr int solid_depth = 7;
inline constexpr int nearer_depth = 8;
}  // namespace units_3

/// One program for each kind of element, all painting the same.
struct Gl_programs_3 {
  enum class Paint {
    colors,
    peeled_colors,  ///< only of what lies before the solid things and behind the nearer picture
    ids
  };
  /// Without planes nothing is cut. Throws std::runtime_error with the compiler's message.
  Gl_programs_3(Paint paint, bool has_planes);

  Paint paint;
  Gl_program points;
  Gl_program segments;
  Gl_program faces;
  Gl_program balls;
  Gl_program areas;
};

}  // namespace mesecina

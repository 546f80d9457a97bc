// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs.h"

namespace mesecina {

/// The dark parts of an image laid on white paper: contours at half luminance by marching squares, interpolated between
/// pixel centres (Lorensen and Cline 1987; ambiguous squares by the asymptotic decider, Nielson and Hamann 1991).
/// Beyond the border the paper is white, so every ring is closed; dark is on the left of its direction
/// (counterclockwise around a dark part, clockwise around a hole). Coordinates are those of the image in the plane,
/// with pixel centres half a pixel inside. Rings come in the order of their topmost, then leftmost pixel; those of less
/// than 1e-3 pixels are left out. No rings when nothing is darker than half. O(pixels); 2 bytes of memory per pixel.
Outline_2 silhouette(const Image& image);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

#include "core/style.h"

namespace mesecina {

/// Returns the bytes of the image as a PNG file.
using Png_encoder = std::function<std::string(const Image&)>;

/// Writes the scene as SVG 1.1: one Inkscape layer per visible layer, named after it, with numbers that read back to
/// the same double, true circles and arcs, and the colour bars as a last layer. Circles of more than 1e5 pixels, which
/// programs draw wrongly, become Bézier curves where they cross the page. What is off the page is left out.
/// The bytes depend only on the arguments. Images are left out when there is no encoder.
void write_svg(std::ostream& out, const Scene& scene, const View_2& view, int width, int height,
               const Png_encoder& encode_png);

}  // namespace mesecina

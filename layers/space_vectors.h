// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// Writes a scene in space as SVG 1.1: the shapes of space_shapes(), from the farthest to the nearest. Each run of
/// shapes of one layer is a group with the label of the layer and its id in data-layer; one layer may need several
/// runs, as others lie before and behind it. Colour bars are a last layer. The bytes depend only on the arguments.
/// Throws as space_shapes() does.
void write_space_svg(std::ostream& out, const Scene& scene, const View_3& view, int width, int height);

/// The same as a PDF file of one page, 96 pixels to the inch, without groups. Needs a QGuiApplication. Throws as
/// space_shapes() does.
std::string space_pdf_bytes(const Scene& scene, const View_3& view, int width, int height);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPainter>

#include "core/style.h"

namespace mesecina {

/// Paints background and visible layers of the scene, antialiased, in the painter's logical pixels; the page is
/// [0, width] x [0, height] and clips. Correct for coordinates and radii up to 1e12 pixels. Needs no window; the same
/// code serves the screen without OpenGL, PNG and PDF. The painter's state is restored.
void paint_scene(QPainter& painter, const Scene& scene, const View_2& view, double width, double height);

/// Paints the legends of the layers coloured by value into the lower right corner. Needs a QGuiApplication for its
/// text.
void paint_color_bars(QPainter& painter, const Scene& scene, double width, double height);

}  // namespace mesecina

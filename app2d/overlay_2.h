// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app2d/hover_2.h"
#include "core/style.h"

namespace mesecina {

/// What is drawn above the scene: the hovered element and its dual, selected points with a rim, and the line that is
/// being drawn. `marker_size` is that of ordinary points, in logical pixels.
std::vector<Scene_layer> make_overlay(const std::vector<Point_2>& selected, const std::vector<Point_2>& line,
                                      const Hovered_2* hovered, Color background, double marker_size);

}  // namespace mesecina

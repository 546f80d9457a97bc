// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "core/point.h"
#include "core/style.h"

namespace mesecina {

/// What SVG files of the plane and of space have in common.

/// "#rrggbb".
std::string svg_hex(Color color);
/// As XML takes it; control characters are left out.
std::string svg_escaped(std::string_view text);
/// A blank, and name="value"; texts must be escaped already.
void append_attribute(std::string& text, std::string_view name, double value);
void append_attribute(std::string& text, std::string_view name, std::string_view value);
/// The command of a path and a point, with numbers that read back to the same double.
void append_point(std::string& path, char command, const Point_2& p);
/// A name that XML allows and that no other layer has.
std::string unique_svg_id(std::string_view layer, std::set<std::string>& taken);
/// Up to the first layer, with the ground.
std::string svg_head(const Scene& scene, int width, int height);
/// As a layer of their own, where there are any.
void append_color_bars(std::string& text, const Scene& scene, int width, int height);

}  // namespace mesecina

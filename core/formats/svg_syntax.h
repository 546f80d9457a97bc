// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/svg_geometry.h"
#include "core/formats/text_file.h"

namespace mesecina {

/// An attribute of an SVG element and where it is, for error messages.
struct Svg_attribute {
  const Text_file& file;
  std::size_t line = 0;  ///< of the element
  std::string_view element;
  std::string_view name;
  std::string_view value;

  /// Throws File_error: expected ... in <element name="...">, found `rest`.
  [[noreturn]] void fail(const std::string& expected, std::string_view rest) const;
};

/// These throw File_error when the value breaks SVG's grammar.

/// A path's data ("d"). Subpaths of a single point are left out.
std::vector<Subpath> parse_path(const Svg_attribute& data);
/// The corners of a polygon or polyline.
std::vector<Point_2> parse_corners(const Svg_attribute& points);
Affine_2 parse_transform(const Svg_attribute& transform);
/// In user units (96 to the inch); nothing when the unit depends on the page or the font (%, em, ...).
std::optional<double> parse_length(const Svg_attribute& length);

}  // namespace mesecina

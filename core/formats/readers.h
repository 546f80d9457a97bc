// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/formats/format.h"

namespace mesecina {

/// One point or disk per line: two columns x y are points, three columns x y radius are disks. Columns are separated by
/// blanks, tabs, commas or semicolons; "#" and "//" start comments; the first line may name the columns.
/// A `.xyz` file usually holds points in space, so there a third column that is 0 on every line is a height: the file
/// holds points of the plane. If any is not 0 the column is a radius and all must be positive.
File_contents read_table(const std::filesystem::path& path);

/// "POFF n 0 0" and n lines x y, or "WPOFF n 0 0" and n lines x y radius; "#" starts a comment.
File_contents read_poff(const std::filesystem::path& path);

/// Well-known text: POLYGON and MULTIPOLYGON are outlines, and so are LINESTRING and MULTILINESTRING if they are
/// closed; POINT and MULTIPOINT are points. Several geometries may follow one another. Z and M are dropped.
File_contents read_wkt(const std::filesystem::path& path);

/// The filled shapes of a drawing as an outline: path, rect, circle, ellipse, polygon and polyline under their
/// transforms. What is never drawn (defs, symbol, clipPath, mask, pattern, marker, display:none) is skipped. Curves
/// become polylines no farther from them than 1/2000 of the diagonal of the drawing's bounding box; arcs of ellipses
/// are first replaced by cubic curves, which are within 5e-6 of the larger radius. SVG's y points down, ours up, so y
/// changes its sign; lengths are in user units (viewBox is not applied). The shapes are combined by the even-odd
/// rule, whatever their fill-rule.
File_contents read_svg(const std::filesystem::path& path);

/// Polygon and MultiPolygon are outlines, Point and MultiPoint are points, on their own or in Features, collections of
/// Features and collections of geometries. Heights are dropped.
File_contents read_geojson(const std::filesystem::path& path);

}  // namespace mesecina

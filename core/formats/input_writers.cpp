// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>
#include <ostream>
#include <string>
#include <string_view>

#include "core/formats/number.h"
#include "core/formats/outline_crossings.h"
#include "core/formats/ring_nesting.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

template <class T>
const T& get_or_empty(const Inputs& inputs, Input_key<T> key, const T& empty) {
  const auto value = inputs.get(key);
  return value ? *value : empty;
}

void write(std::ostream& stream, const std::string& text) {
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
}

std::string point_lines(const std::vector<Point_2>& points) {
  std::string text;
  for (const Point_2& point : points) {
    append_number(text, point.x);
    text += ' ';
    append_number(text, point.y);
    text += '\n';
  }
  return text;
}

std::string disk_lines(const std::vector<Disk_2>& disks, char separator) {
  std::string text;
  for (const Disk_2& disk : disks) {
    append_number(text, disk.center.x);
    text += separator;
    append_number(text, disk.center.y);
    text += separator;
    append_number(text, disk.radius);
    text += '\n';
  }
  return text;
}

/// Polygons as lists of ring numbers; if `cross`, one per ring.
struct Polygons {
  bool cross = false;
  std::vector<Polygon_rings> rings;
};

Polygons polygons_of(const Outline_2& outline) {
  if (find_crossings(outline).count == 0) return {false, nest_rings(outline)};
  Polygons polygons{true, {}};
  for (std::size_t ring = 0; ring < outline.rings.size(); ++ring) polygons.rings.push_back({ring});
  return polygons;
}

/// How a format writes nested lists of points.
struct Punctuation {
  char open;
  char close;
  std::string_view point_open;
  std::string_view between_coordinates;
  std::string_view point_close;
};
constexpr Punctuation wkt{'(', ')', "", " ", ""};
constexpr Punctuation geojson{'[', ']', "[", ",", "]"};

void append_point(std::string& text, const Point_2& point, const Punctuation& marks) {
  text += marks.point_open;
  append_number(text, point.x);
  text += marks.between_coordinates;
  append_number(text, point.y);
  text += marks.point_close;
}

void append_polygon(std::string& text, const Outline_2& outline, const Polygon_rings& rings, const Punctuation& marks) {
  text += marks.open;
  for (const std::size_t ring : rings) {
    if (ring != rings.front()) text += ',';
    text += marks.open;
    for (const Point_2& vertex : outline.rings[ring]) {
      append_point(text, vertex, marks);
      text += ',';
    }
    append_point(text, outline.rings[ring].front(), marks);
    text += marks.close;
  }
  text += marks.close;
}

void append_polygons(std::string& text, const Outline_2& outline, const std::vector<Polygon_rings>& polygons,
                     const Punctuation& marks) {
  text += marks.open;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (i != 0) text += ',';
    append_polygon(text, outline, polygons[i], marks);
  }
  text += marks.close;
}

}  // namespace

void write_xy_points(std::ostream& stream, const Inputs& inputs) {
  const std::vector<Point_2> empty;
  const std::vector<Point_2>& points = get_or_empty(inputs, points_input, empty);
  write(stream, points.empty() ? "x y\n" : point_lines(points));
}

void write_poff_points(std::ostream& stream, const Inputs& inputs) {
  const std::vector<Point_2> empty;
  const std::vector<Point_2>& points = get_or_empty(inputs, points_input, empty);
  write(stream, "POFF " + std::to_string(points.size()) + " 0 0\n" + point_lines(points));
}

void write_wpoff_disks(std::ostream& stream, const Inputs& inputs) {
  const std::vector<Disk_2> empty;
  const std::vector<Disk_2>& disks = get_or_empty(inputs, disks_input, empty);
  write(stream, "WPOFF " + std::to_string(disks.size()) + " 0 0\n" + disk_lines(disks, ' '));
}

void write_csv_disks(std::ostream& stream, const Inputs& inputs) {
  const std::vector<Disk_2> empty;
  write(stream, "x,y,r\n" + disk_lines(get_or_empty(inputs, disks_input, empty), ','));
}

void write_wkt_outline(std::ostream& stream, const Inputs& inputs) {
  const Outline_2 empty;
  const Outline_2& outline = get_or_empty(inputs, outline_input, empty);
  const Polygons polygons = polygons_of(outline);
  std::string text;
  if (polygons.rings.empty()) {
    text = "POLYGON EMPTY\n";
  } else if (polygons.cross || polygons.rings.size() == 1) {
    for (const Polygon_rings& rings : polygons.rings) {
      text += "POLYGON ";
      append_polygon(text, outline, rings, wkt);
      text += '\n';
    }
  } else {
    text = "MULTIPOLYGON ";
    append_polygons(text, outline, polygons.rings, wkt);
    text += '\n';
  }
  write(stream, text);
}

void write_geojson_outline(std::ostream& stream, const Inputs& inputs) {
  const Outline_2 empty;
  const Outline_2& outline = get_or_empty(inputs, outline_input, empty);
  const Polygons polygons = polygons_of(outline);
  std::string text;
  if (polygons.cross) {
    text = R"({"type":"GeometryCollection","geometries":[)";
    for (std::size_t i = 0; i < polygons.rings.size(); ++i) {
      text += i == 0 ? "\n" : ",\n";
      text += R"({"type":"Polygon","coordinates":)";
      append_polygon(text, outline, polygons.rings[i], geojson);
      text += '}';
    }
    text += "]}\n";
  } else {
    text = R"({"type":"MultiPolygon","coordinates":)";
    append_polygons(text, outline, polygons.rings, geojson);
    text += "}\n";
  }
  write(stream, text);
}

}  // namespace mesecina

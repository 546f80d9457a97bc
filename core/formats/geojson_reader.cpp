// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <utility>

#include "core/formats/readers.h"
#include "core/formats/ring_collector.h"
#include "core/formats/text_file.h"

namespace mesecina {
namespace {

using nlohmann::json;

class Geojson_reader {
 public:
  explicit Geojson_reader(const Text_file& file) : file_(file) {}

  File_contents read() {
    read_object(parse(), "", 0);
    if (!has_points_ && !has_rings_) {
      throw File_error(file_.path, 0,
                       "expected a Polygon, MultiPolygon, Point or MultiPoint, found none; add a geometry");
    }
    File_contents contents;
    if (has_points_) contents.inputs = contents.inputs.with(points_input, std::move(points_));
    if (has_rings_) contents.inputs = contents.inputs.with(outline_input, rings_.finish());
    contents.warnings = warnings_.take();
    return contents;
  }

 private:
  json parse() const {
    try {
      return json::parse(file_.text);
    } catch (const json::parse_error& error) {
      const std::size_t offset = error.byte == 0 ? 0 : error.byte - 1;
      const std::string_view text = file_.text;
      const std::string found =
          offset < text.size() ? quote(text.substr(offset, text.substr(offset).find('\n'))) : "the end of the file";
      throw File_error(file_.path, file_.line_at(offset),
                       "expected JSON, found " + found + " at byte " + std::to_string(offset) +
                           "; the file is damaged or cut off, write it again");
    } catch (const json::exception& error) {
      throw File_error(file_.path, 0, std::string("expected JSON, found ") + error.what() + "; correct the number");
    }
  }

  /// `where` says which part of the file is meant: "features[3].geometry.coordinates[0][7]".
  [[noreturn]] void fail(const std::string& where, const std::string& expected, const json& found,
                         const std::string& advice) const {
    throw File_error(file_.path, 0,
                     (where.empty() ? "" : "at " + where + ": ") + "expected " + expected + ", found " +
                         describe(found) + "; " + advice);
  }

  static std::string describe(const json& value) {
    if (value.is_array()) return "an array of " + std::to_string(value.size());
    if (value.is_object()) return "an object";
    return quote(value.dump(-1, ' ', true, json::error_handler_t::replace));
  }

  static std::string member(const std::string& where, const char* name) {
    return where.empty() ? name : where + "." + name;
  }
  static std::string element(const std::string& where, std::size_t index) {
    return where + "[" + std::to_string(index) + "]";
  }

  const json& get(const json& object, const char* name, const std::string& where) const {
    const auto it = object.find(name);
    if (it == object.end()) fail(where, std::string("a member \"") + name + "\"", object, "add it");
    return *it;
  }

  const json& get_array(const json& object, const char* name, const std::string& where) const {
    const json& value = get(object, name, where);
    check_array(value, member(where, name));
    return value;
  }

  void check_array(const json& value, const std::string& where) const {
    if (!value.is_array()) fail(where, "an array", value, "compare with the GeoJSON standard, RFC 7946");
  }

  void read_object(const json& object, const std::string& where, int depth) {
    constexpr int deepest = 100;
    if (depth > deepest) fail(where, "at most 100 nested collections", object, "take the geometries out of them");
    if (!object.is_object()) fail(where, "a GeoJSON object", object, "compare with the GeoJSON standard, RFC 7946");
    const json& type_value = get(object, "type", where);
    const std::string type = type_value.is_string() ? type_value.get<std::string>() : "";
    if (type == "FeatureCollection") {
      read_objects(object, "features", where, depth);
    } else if (type == "GeometryCollection") {
      read_objects(object, "geometries", where, depth);
    } else if (type == "Feature") {
      const json& geometry = get(object, "geometry", where);
      if (!geometry.is_null()) read_object(geometry, member(where, "geometry"), depth + 1);
    } else if (type == "Polygon") {
      has_rings_ = true;
      read_polygon(get_array(object, "coordinates", where), member(where, "coordinates"));
    } else if (type == "MultiPolygon") {
      has_rings_ = true;
      const json& polygons = get_array(object, "coordinates", where);
      for (std::size_t i = 0; i < polygons.size(); ++i)
        read_polygon(polygons[i], element(member(where, "coordinates"), i));
    } else if (type == "Point") {
      has_points_ = true;
      points_.push_back(read_position(get_array(object, "coordinates", where), member(where, "coordinates")));
    } else if (type == "MultiPoint") {
      has_points_ = true;
      const json& positions = get_array(object, "coordinates", where);
      for (std::size_t i = 0; i < positions.size(); ++i)
        points_.push_back(read_position(positions[i], element(member(where, "coordinates"), i)));
    } else {
      fail(member(where, "type"), "Polygon, MultiPolygon, Point, MultiPoint or a collection of them", type_value,
           "convert the geometry to one of these");
    }
  }

  void read_objects(const json& object, const char* name, const std::string& where, int depth) {
    const json& members = get_array(object, name, where);
    for (std::size_t i = 0; i < members.size(); ++i)
      read_object(members[i], element(member(where, name), i), depth + 1);
  }

  void read_polygon(const json& rings, const std::string& where) {
    check_array(rings, where);
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const std::string ring_name = element(where, r);
      check_array(rings[r], ring_name);
      Ring_2 ring;
      ring.reserve(rings[r].size());
      for (std::size_t i = 0; i < rings[r].size(); ++i)
        ring.push_back(is_plain_position(rings[r][i])
                           ? Point_2{rings[r][i][0].get<double>(), rings[r][i][1].get<double>()}
                           : read_position(rings[r][i], element(ring_name, i)));
      rings_.add(std::move(ring), Ring_collector::End::repeats_first, ring_name);
    }
  }

  static bool is_plain_position(const json& position) {
    return position.is_array() && position.size() == 2 && position[0].is_number() && position[1].is_number();
  }

  Point_2 read_position(const json& position, const std::string& where) {
    if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
      fail(where, "a position [x, y]", position, "correct or delete it");
    if (position.size() > 2 && !has_heights_) {
      warnings_.add("at " + where + ": heights are left out");
      has_heights_ = true;
    }
    return {position[0].get<double>(), position[1].get<double>()};
  }

  const Text_file& file_;
  Warning_list warnings_;
  Ring_collector rings_{warnings_};
  std::vector<Point_2> points_;
  bool has_points_ = false;
  bool has_rings_ = false;
  bool has_heights_ = false;
};

}  // namespace

File_contents read_geojson(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  return Geojson_reader(file).read();
}

}  // namespace mesecina

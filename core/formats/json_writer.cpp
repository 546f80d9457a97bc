// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>
#include <variant>

#include "core/formats/buffered_text.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

/// Writes an object whose members are on lines of their own, and so are the elements of its arrays.
class Json_text {
 public:
  explicit Json_text(std::ostream& stream) : text_(stream) {}

  Json_text& number(double value) {
    if (std::isfinite(value))
      text_ << value;
    else
      text_ << "\"" << value << "\"";
    return *this;
  }
  Json_text& number(std::int64_t value) {
    text_ << value;
    return *this;
  }
  Json_text& plain(std::string_view text) {
    text_ << text;
    return *this;
  }
  Json_text& quoted(std::string_view text) {
    using nlohmann::json;
    text_ << json(text).dump(-1, ' ', false, json::error_handler_t::replace);
    return *this;
  }
  /// "key": after a comma if it is not the first of the object.
  Json_text& key(std::string_view name) {
    if (!std::exchange(is_first_key_, false)) text_ << ",\n";
    return quoted(name).plain(": ");
  }
  /// write(i) writes the i-th of `count` elements.
  template <class Write>
  Json_text& array(std::size_t count, const Write& write) {
    text_ << "[";
    for (std::size_t i = 0; i < count; ++i) {
      if (i != 0) text_ << ",\n";
      write(i);
    }
    text_ << "]";
    return *this;
  }
  /// An array that is left out when it has no elements.
  template <class Write>
  void member_array(std::string_view name, std::size_t count, const Write& write) {
    if (count != 0) key(name).array(count, write);
  }
  Json_text& vector(const Point_3& p, int dimension) {
    plain("[").number(p.x).plain(",").number(p.y);
    if (dimension == 3) plain(",").number(p.z);
    return plain("]");
  }
  template <class Vertices>
  Json_text& vertices(const Vertices& vertices) {
    std::string_view separator = "[";
    for (const int vertex : vertices) {
      text_ << separator << vertex;
      separator = ",";
    }
    if (vertices.empty()) text_ << separator;
    text_ << "]";
    return *this;
  }
  void open_object() {
    text_ << "{\n";
    is_first_key_ = true;
  }
  void close_object() {
    text_ << "\n}";
    is_first_key_ = false;
  }

 private:
  Buffered_text text_;
  bool is_first_key_ = true;
};

void write_setting(Json_text& json, const Setting_value& value) {
  if (const bool* truth = std::get_if<bool>(&value))
    json.plain(*truth ? "true" : "false");
  else if (const std::int64_t* integer = std::get_if<std::int64_t>(&value))
    json.number(*integer);
  else if (const double* number = std::get_if<double>(&value))
    json.number(*number);
  else
    json.quoted(std::get<std::string>(value));
}

void write_settings(Json_text& json, const std::map<std::string, Setting_value>& settings) {
  json.key("settings");
  if (settings.empty()) {
    json.plain("{}");
    return;
  }
  json.open_object();
  for (const auto& [id, value] : settings) {
    json.key(id);
    write_setting(json, value);
  }
  json.close_object();
}

void write_primitives(Json_text& json, const Primitive_set& set) {
  json.key("vertices").array(set.vertices.size(), [&](std::size_t i) { json.vector(set.vertices[i], set.dimension); });
  json.member_array("radii", set.radii.size(), [&](std::size_t i) { json.number(set.radii[i]); });
  json.member_array("points", set.points.size(), [&](std::size_t i) { json.number(std::int64_t{set.points[i]}); });
  json.member_array("segments", set.segments.size(), [&](std::size_t i) { json.vertices(set.segments[i]); });
  json.member_array("rays", set.rays.size(), [&](std::size_t i) {
    const Ray& ray = set.rays[i];
    json.plain("{\"from\":").number(std::int64_t{ray.from}).plain(",\"direction\":");
    json.vector(ray.direction, set.dimension).plain("}");
  });
  json.member_array("arcs", set.arcs.size(), [&](std::size_t i) {
    const Arc& arc = set.arcs[i];
    json.plain("{\"center\":").vector({arc.center.x, arc.center.y, 0}, 2).plain(",\"radius\":").number(arc.radius);
    json.plain(",\"from\":").number(std::int64_t{arc.from}).plain(",\"to\":").number(std::int64_t{arc.to});
    json.plain(arc.counterclockwise ? ",\"ccw\":true}" : ",\"ccw\":false}");
  });
  json.member_array("triangles", set.triangles.size(), [&](std::size_t i) { json.vertices(set.triangles[i]); });
  json.member_array("polygons", set.polygon_count(), [&](std::size_t i) { json.vertices(set.polygon(i)); });
  json.member_array("balls", set.balls.size(), [&](std::size_t i) {
    const Ball& ball = set.balls[i];
    json.plain("{\"center\":").number(std::int64_t{ball.center}).plain(",\"radius\":").number(ball.radius).plain("}");
  });
  json.member_array("ids", set.ids.size(), [&](std::size_t i) { json.number(set.ids[i]); });
  if (set.values.empty()) return;
  json.key("values").open_object();
  for (const Values& values : set.values)
    json.key(values.name).array(values.data.size(), [&](std::size_t i) { json.number(values.data[i]); });
  json.close_object();
}

}  // namespace

void write_json_layer(std::ostream& stream, const Layer_document& document) {
  Json_text json(stream);
  json.open_object();
  json.key("format").quoted("mesecina-layer");
  json.key("version").number(std::int64_t{1});
  json.key("layer").quoted(document.layer);
  json.key("dimension").number(std::int64_t{document.primitives ? document.primitives->dimension : document.dimension});
  json.key("input").quoted(document.input);
  write_settings(json, document.settings);
  write_primitives(json, document.primitives ? *document.primitives : Primitive_set());
  if (!document.reason.empty()) json.key("reason").quoted(document.reason);
  json.close_object();
  json.plain("\n");
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "core/formats/buffered_text.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

std::string quoted_if_needed(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string result = "\"";
  for (const char c : field) result.append(c == '"' ? 2 : 1, c);
  return result + '"';
}

struct Row {
  std::string_view kind;
  std::array<std::optional<Point_3>, 3> points;
  std::optional<double> radius;
  std::string ring;
};

class Table {
 public:
  Table(std::ostream& stream, const Primitive_set& set)
      : text_(stream),
        set_(set),
        point_count_(set.arcs.empty() && set.triangles.empty() ? 2 : 3),
        has_ring_(set.polygon_count() != 0) {}

  void write_header() {
    text_ << "element,kind,id";
    for (int i = 0; i < point_count_; ++i) {
      for (const char* axis : {"x", "y", "z"})
        if (axis[0] != 'z' || set_.dimension == 3) text_ << "," << axis << i;
    }
    text_ << ",radius";
    if (has_ring_) text_ << ",ring";
    for (const Values& values : set_.values) text_ << "," << quoted_if_needed(values.name);
    text_ << "\n";
  }

  void write(const Row& row) {
    text_ << element_ << "," << row.kind << "," << set_.id(element_);
    for (int i = 0; i < point_count_; ++i) write_point(row.points[static_cast<std::size_t>(i)]);
    text_ << ",";
    if (row.radius) text_ << *row.radius;
    if (has_ring_) text_ << "," << row.ring;
    for (const Values& values : set_.values) text_ << "," << values.data[element_];
    text_ << "\n";
    ++element_;
  }

 private:
  void write_point(const std::optional<Point_3>& point) {
    const bool has_z = set_.dimension == 3;
    if (!point) {
      text_ << (has_z ? ",,," : ",,");
      return;
    }
    text_ << "," << point->x << "," << point->y;
    if (has_z) text_ << "," << point->z;
  }

  Buffered_text text_;
  const Primitive_set& set_;
  int point_count_;
  bool has_ring_;
  std::size_t element_ = 0;
};

std::string ring_text(const Primitive_set& set, std::size_t polygon) {
  std::string text;
  for (const int vertex : set.polygon(polygon)) {
    if (!text.empty()) text += ';';
    append_number(text, set.vertices[vertex].x);
    text += ' ';
    append_number(text, set.vertices[vertex].y);
    if (set.dimension == 3) {
      text += ' ';
      append_number(text, set.vertices[vertex].z);
    }
  }
  return text;
}

}  // namespace

void write_csv_layer(std::ostream& stream, const Layer_document& document) {
  Primitive_set none;
  none.dimension = document.dimension;
  const Primitive_set& set = document.primitives ? *document.primitives : none;
  const auto at = [&](int vertex) { return set.vertices[vertex]; };
  Table table(stream, set);
  table.write_header();
  for (const int vertex : set.points) table.write({"point", {at(vertex)}, {}, {}});
  for (const auto& [from, to] : set.segments) table.write({"segment", {at(from), at(to)}, {}, {}});
  for (const Ray& ray : set.rays) table.write({"ray", {at(ray.from), ray.direction}, {}, {}});
  for (const Arc& arc : set.arcs) {
    const auto [from, to] = arc.counterclockwise ? std::pair(arc.from, arc.to) : std::pair(arc.to, arc.from);
    table.write({"arc", {at(from), at(to), Point_3{arc.center.x, arc.center.y, 0}}, arc.radius, {}});
  }
  for (const auto& [p, q, r] : set.triangles) table.write({"triangle", {at(p), at(q), at(r)}, {}, {}});
  for (std::size_t i = 0; i < set.polygon_count(); ++i) table.write({"polygon", {}, {}, ring_text(set, i)});
  for (const Ball& ball : set.balls) {
    table.write({set.dimension == 3 ? "ball" : "disk", {at(ball.center)}, ball.radius, {}});
  }
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/arc_polyline.h"
#include "core/formats/buffered_text.h"
#include "core/formats/loose_elements.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

void write_vertex(Buffered_text& text, const Point_3& p) { text << "v " << p.x << " " << p.y << " " << p.z << "\n"; }

void write_head(Buffered_text& text, const Layer_document& document) {
  text << "# layer " << on_one_line(document.layer) << "\n";
  if (!document.input.empty()) text << "# input " << on_one_line(document.input) << "\n";
  if (!document.reason.empty()) text << "# empty: " << on_one_line(document.reason) << "\n";
}

void write_arcs(Buffered_text& text, const Primitive_set& set) {
  if (set.arcs.empty()) return;
  text << "# " << set.arcs.size() << " arcs as polylines with at most 1 degree per segment\n";
  std::size_t vertex_count = set.vertices.size();
  for (const Arc& arc : set.arcs) {
    const std::vector<Point_3> inside = points_inside_arc(set, arc);
    for (const Point_3& point : inside) write_vertex(text, point);
    text << "l " << arc.from + 1;
    for (std::size_t i = 0; i < inside.size(); ++i) text << " " << ++vertex_count;
    text << " " << arc.to + 1 << "\n";
  }
}

void write_polygons_of_space(Buffered_text& text, const Primitive_set& set) {
  for (std::size_t i = 0; i < set.polygon_count(); ++i) {
    text << "f";
    for (const int vertex : set.polygon(i)) text << " " << vertex + 1;
    text << "\n";
  }
}

void write_polygons_of_plane(Buffered_text& text, const Primitive_set& set) {
  if (set.polygon_count() == 0) return;
  text << "# " << set.polygon_count() << " polygons, filled together by the even-odd rule, as closed lines\n";
  for (std::size_t i = 0; i < set.polygon_count(); ++i) {
    if (set.polygon(i).empty()) continue;
    text << "l";
    for (const int vertex : set.polygon(i)) text << " " << vertex + 1;
    text << " " << set.polygon(i).front() + 1 << "\n";
  }
}

}  // namespace

void write_obj_layer(std::ostream& stream, const Layer_document& document) {
  Buffered_text text(stream);
  write_head(text, document);
  if (!document.primitives) return;
  const Primitive_set& set = *document.primitives;
  for (const Point_3& vertex : set.vertices) write_vertex(text, vertex);
  const Loose_elements loose = loose_elements(set);
  for (const int vertex : loose.points) text << "p " << vertex + 1 << "\n";
  for (const auto& [from, to] : loose.segments) text << "l " << from + 1 << " " << to + 1 << "\n";
  if (!set.rays.empty()) text << "# " << set.rays.size() << " rays are left out\n";
  write_arcs(text, set);
  for (const auto& [p, q, r] : set.triangles) text << "f " << p + 1 << " " << q + 1 << " " << r + 1 << "\n";
  if (set.dimension == 3)
    write_polygons_of_space(text, set);
  else
    write_polygons_of_plane(text, set);
  const char* kind = set.dimension == 3 ? "ball" : "disk";
  for (const Ball& ball : set.balls)
    text << "# " << kind << " of radius " << ball.radius << "\np " << ball.center + 1 << "\n";
}

void write_obj_mesh(std::ostream& stream, const Inputs& inputs) {
  Buffered_text text(stream);
  const auto mesh = inputs.get(mesh_input);
  if (!mesh || mesh->vertices.empty()) {
    text << "# no vertices\n";
    return;
  }
  for (const Point_3& vertex : mesh->vertices) write_vertex(text, vertex);
  for (const auto& [p, q, r] : mesh->triangles) text << "f " << p + 1 << " " << q + 1 << " " << r + 1 << "\n";
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/arc_polyline.h"
#include "core/formats/buffered_text.h"
#include "core/formats/layer_balls.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

/// What a PLY file can hold, with the numbers of the elements whose values belong to each part.
struct Ply_mesh {
  std::vector<Point_3> vertices;
  std::vector<double> radii;                 ///< per vertex, or empty
  std::vector<std::size_t> vertex_elements;  ///< per vertex, or empty: vertices have no values
  std::vector<std::array<int, 2>> edges;
  std::vector<std::size_t> edge_elements;
  std::vector<std::span<const int>> faces;
  std::vector<std::size_t> face_elements;

  bool has_values_of_points() const { return !vertex_elements.empty(); }
  void add_edge(int from, int to, std::size_t element) {
    edges.push_back({from, to});
    edge_elements.push_back(element);
  }
};

bool has_only_points_and_balls(const Primitive_set& set) {
  return set.element_count() == set.points.size() + set.balls.size();
}

Ply_mesh cloud(const Primitive_set& set) {
  Ply_mesh mesh;
  for (const int vertex : set.points) {
    mesh.vertices.push_back(set.vertices[vertex]);
    if (!set.radii.empty()) mesh.radii.push_back(set.radii[vertex]);
  }
  if (!set.balls.empty()) mesh.radii.resize(set.points.size(), 0);
  for (const Ball& ball : set.balls) {
    mesh.vertices.push_back(set.vertices[ball.center]);
    mesh.radii.push_back(ball.radius);
  }
  for (std::size_t element = 0; element < mesh.vertices.size(); ++element) mesh.vertex_elements.push_back(element);
  return mesh;
}

void add_arc(Ply_mesh& mesh, const Primitive_set& set, const Arc& arc, std::size_t element) {
  int from = arc.from;
  for (const Point_3& point : points_inside_arc(set, arc)) {
    mesh.add_edge(from, static_cast<int>(mesh.vertices.size()), element);
    from = static_cast<int>(mesh.vertices.size());
    mesh.vertices.push_back(point);
  }
  mesh.add_edge(from, arc.to, element);
}

/// Per vertex the point that it is; empty unless each vertex is one, and of one point only.
std::vector<std::size_t> points_of_vertices(const Primitive_set& set) {
  std::vector<std::size_t> points(set.vertices.size(), set.points.size());
  if (set.points.size() != points.size()) return {};
  for (std::size_t i = 0; i < set.points.size(); ++i) points[set.points[i]] = i;
  if (std::ranges::find(points, set.points.size()) != points.end()) return {};
  return points;
}

Ply_mesh complex(const Primitive_set& set) {
  Ply_mesh mesh;
  mesh.vertices = set.vertices;
  if (set.arcs.empty()) mesh.vertex_elements = points_of_vertices(set);
  std::size_t element = set.points.size();
  for (const auto& [from, to] : set.segments) mesh.add_edge(from, to, element++);
  element += set.rays.size();
  for (const Arc& arc : set.arcs) add_arc(mesh, set, arc, element++);
  for (const std::array<int, 3>& triangle : set.triangles) {
    mesh.faces.emplace_back(triangle);
    mesh.face_elements.push_back(element++);
  }
  for (std::size_t i = 0; i < set.polygon_count(); ++i, ++element) {
    const auto polygon = set.polygon(i);
    if (set.dimension == 3) {
      mesh.faces.push_back(polygon);
      mesh.face_elements.push_back(element);
      continue;
    }
    for (std::size_t j = 0; j < polygon.size(); ++j)
      mesh.add_edge(polygon[j], polygon[(j + 1) % polygon.size()], element);
  }
  mesh.radii = vertex_radii(set);
  if (!mesh.radii.empty()) mesh.radii.resize(mesh.vertices.size(), 0);
  return mesh;
}

/// Property names for the values: without characters that PLY does not allow, different from one another and from the
/// names of coordinates.
std::vector<std::string> property_names(const std::vector<Values>& values) {
  std::set<std::string> taken = {"x", "y", "z", "radius", "vertex_indices", "vertex1", "vertex2"};
  std::vector<std::string> names;
  for (const Values& each : values) {
    std::string name;
    for (const char c : each.name) {
      const bool allowed =
          (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
      name += allowed ? c : '_';
    }
    while (name.empty() || !taken.insert(name).second) name = "value_" + name;
    names.push_back(std::move(name));
  }
  return names;
}

class Ply_writer {
 public:
  Ply_writer(std::ostream& stream, const Ply_mesh& mesh, const std::vector<Values>& values)
      : text_(stream), mesh_(mesh), values_(values), names_(property_names(values)) {
    constexpr std::size_t most_in_a_byte = 255;
    has_long_faces_ = std::ranges::any_of(mesh.faces, [](const auto& face) { return face.size() > most_in_a_byte; });
  }

  void write(const std::vector<std::string>& comments) {
    text_ << "ply\nformat binary_little_endian 1.0\n";
    for (const std::string& comment : comments) text_ << "comment " << on_one_line(comment) << "\n";
    declare("vertex", mesh_.vertices.size(), "property double x\nproperty double y\nproperty double z\n");
    if (!mesh_.radii.empty()) text_ << "property double radius\n";
    if (!mesh_.vertex_elements.empty()) declare_values();
    if (!mesh_.faces.empty()) {
      declare("face", mesh_.faces.size(),
              has_long_faces_ ? "property list int int vertex_indices\n" : "property list uchar int vertex_indices\n");
      declare_values();
    }
    if (!mesh_.edges.empty()) {
      declare("edge", mesh_.edges.size(), "property int vertex1\nproperty int vertex2\n");
      declare_values();
    }
    text_ << "end_header\n";
    write_vertices();
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
      const std::size_t count = mesh_.faces[i].size();
      if (has_long_faces_)
        write_bytes(static_cast<std::uint32_t>(count));
      else
        write_bytes(static_cast<std::uint8_t>(count));
      for (const int vertex : mesh_.faces[i]) write_bytes(static_cast<std::uint32_t>(vertex));
      write_values(mesh_.face_elements[i]);
    }
    for (std::size_t i = 0; i < mesh_.edges.size(); ++i) {
      for (const int vertex : mesh_.edges[i]) write_bytes(static_cast<std::uint32_t>(vertex));
      write_values(mesh_.edge_elements[i]);
    }
  }

 private:
  void declare(std::string_view kind, std::size_t count, std::string_view properties) {
    text_ << "element " << kind << " " << count << "\n" << properties;
  }
  void declare_values() {
    for (const std::string& name : names_) text_ << "property double " << name << "\n";
  }

  void write_vertices() {
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
      write_double(mesh_.vertices[i].x);
      write_double(mesh_.vertices[i].y);
      write_double(mesh_.vertices[i].z);
      if (!mesh_.radii.empty()) write_double(mesh_.radii[i]);
      if (!mesh_.vertex_elements.empty()) write_values(mesh_.vertex_elements[i]);
    }
  }
  void write_values(std::size_t element) {
    for (const Values& values : values_) write_double(values.data[element]);
  }
  void write_double(double number) { write_bytes(std::bit_cast<std::uint64_t>(number)); }
  /// Little-endian on every machine.
  template <class Unsigned>
  void write_bytes(Unsigned number) {
    std::array<char, sizeof(Unsigned)> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(number >> (8 * i));
    text_ << std::string_view(bytes.data(), bytes.size());
  }

  Buffered_text text_;
  const Ply_mesh& mesh_;
  const std::vector<Values>& values_;
  std::vector<std::string> names_;
  bool has_long_faces_ = false;
};

std::vector<std::string> comments_on(const Layer_document& document, const Primitive_set& set, const Ply_mesh& mesh) {
  std::vector<std::string> comments = {"layer " + document.layer};
  if (!document.input.empty()) comments.push_back("input " + document.input);
  if (!document.reason.empty()) comments.push_back("empty: " + document.reason);
  if (!set.rays.empty()) comments.push_back(std::to_string(set.rays.size()) + " rays are left out");
  if (!set.arcs.empty()) {
    comments.push_back(std::to_string(set.arcs.size()) + " arcs as polylines with at most 1 degree per segment");
  }
  if (set.dimension == 2 && set.polygon_count() != 0) {
    comments.push_back(std::to_string(set.polygon_count()) +
                       " polygons, filled together by the even-odd rule, as closed lines");
  }
  const std::size_t left_out = set.balls.size() + (mesh.has_values_of_points() ? 0 : set.points.size());
  if (!set.values.empty() && left_out != 0 && !has_only_points_and_balls(set))
    comments.push_back("values of " + std::to_string(left_out) + " points and balls are left out");
  return comments;
}

}  // namespace

void write_ply_layer(std::ostream& stream, const Layer_document& document) {
  const Primitive_set none;
  const Primitive_set& set = document.primitives ? *document.primitives : none;
  const Ply_mesh mesh = has_only_points_and_balls(set) ? cloud(set) : complex(set);
  Ply_writer(stream, mesh, set.values).write(comments_on(document, set, mesh));
}

void write_ply_mesh(std::ostream& stream, const Inputs& inputs) {
  Primitive_set set;
  set.dimension = 3;
  if (const auto mesh = inputs.get(mesh_input)) {
    set.vertices = mesh->vertices;
    set.triangles = mesh->triangles;
  }
  Ply_writer(stream, complex(set), {}).write({});
}

}  // namespace mesecina

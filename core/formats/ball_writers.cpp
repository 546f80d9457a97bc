// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "core/formats/buffered_text.h"
#include "core/formats/layer_balls.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

/// At the end of the file, where also programs that know no comments do not look any more.
void write_comments(Buffered_text& text, const Layer_document& document, std::size_t left_out) {
  text << "# layer " << on_one_line(document.layer) << "\n";
  if (!document.input.empty()) text << "# input " << on_one_line(document.input) << "\n";
  if (!document.reason.empty()) text << "# empty: " << on_one_line(document.reason) << "\n";
  const Primitive_set* set = document.primitives;
  if (set && set->radii.empty() && set->balls.empty())
    text << "# empty: the layer has no balls, and this format holds only balls and what is between their centers\n";
  else if (left_out != 0)
    text << "# " << left_out << " elements are left out\n";
}

void write_balls(Buffered_text& text, std::span<const Ball_3> balls, std::string_view start = "",
                 std::string_view separator = " ") {
  for (const auto& [center, radius] : balls) {
    text << start << center.x << separator << center.y << separator << center.z << separator << radius << "\n";
  }
}

/// The balls of the layer between two parts of a header.
void write_ball_layer(std::ostream& stream, const Layer_document& document, std::string_view keyword,
                      std::string_view after_count) {
  Buffered_text text(stream);
  const std::vector<Ball_3> balls = document.primitives ? layer_balls(*document.primitives) : std::vector<Ball_3>();
  text << keyword << " " << balls.size() << after_count << "\n";
  write_balls(text, balls);
  std::size_t left_out = 0;
  if (const Primitive_set* set = document.primitives) {
    left_out = set->element_count() - set->balls.size();
    if (!set->radii.empty()) left_out -= set->points.size();
  }
  write_comments(text, document, left_out);
}

/// What an MA file holds.
struct Medial_mesh {
  std::vector<Ball_3> balls;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::array<int, 3>> faces;
};

Medial_mesh medial_mesh(const Primitive_set& set) {
  Medial_mesh mesh;
  const bool has_cells = !set.segments.empty() || !set.triangles.empty() || set.polygon_count() != 0;
  const std::vector<double> radii = vertex_radii(set);
  if (!has_cells || radii.empty()) {
    mesh.balls = layer_balls(set);
    return mesh;
  }
  for (std::size_t i = 0; i < radii.size(); ++i) mesh.balls.push_back({set.vertices[i], radii[i]});
  mesh.faces = set.triangles;
  for (std::size_t i = 0; i < set.polygon_count(); ++i) {
    const auto polygon = set.polygon(i);
    for (std::size_t j = 2; j < polygon.size(); ++j) mesh.faces.push_back({polygon[0], polygon[j - 1], polygon[j]});
  }
  const auto add_edge = [&](int v, int w) { mesh.edges.push_back({std::min(v, w), std::max(v, w)}); };
  mesh.edges.reserve(set.segments.size() + 3 * mesh.faces.size());
  for (const auto& segment : set.segments) add_edge(segment[0], segment[1]);
  for (const auto& face : mesh.faces)
    for (std::size_t i = 0; i < 3; ++i) add_edge(face[i], face[(i + 1) % 3]);
  std::ranges::sort(mesh.edges);
  mesh.edges.erase(std::unique(mesh.edges.begin(), mesh.edges.end()), mesh.edges.end());
  return mesh;
}

template <class T>
std::span<const T> all_of(const std::shared_ptr<const std::vector<T>>& values) {
  return values ? std::span<const T>(*values) : std::span<const T>();
}

}  // namespace

void write_ma_layer(std::ostream& stream, const Layer_document& document) {
  Buffered_text text(stream);
  const Medial_mesh mesh = document.primitives ? medial_mesh(*document.primitives) : Medial_mesh();
  text << mesh.balls.size() << " " << mesh.edges.size() << " " << mesh.faces.size() << "\n";
  write_balls(text, mesh.balls, "v ");
  for (const auto& [v, w] : mesh.edges) text << "e " << v << " " << w << "\n";
  for (const auto& [u, v, w] : mesh.faces) text << "f " << u << " " << v << " " << w << "\n";
  const Primitive_set* set = document.primitives;
  write_comments(text, document, set ? set->rays.size() + set->arcs.size() : 0);
}

void write_woff_layer(std::ostream& stream, const Layer_document& document) {
  write_ball_layer(stream, document, "WOFF", " 0 0");
}

void write_moff_layer(std::ostream& stream, const Layer_document& document) {
  write_ball_layer(stream, document, "MOFF", " 0 1");
}

void write_woff_balls(std::ostream& stream, const Inputs& inputs) {
  Buffered_text text(stream);
  const auto balls = inputs.get(balls_input);
  text << "WOFF " << all_of(balls).size() << " 0 0\n";
  write_balls(text, all_of(balls));
}

void write_moff_balls(std::ostream& stream, const Inputs& inputs) {
  Buffered_text text(stream);
  const auto balls = inputs.get(balls_input);
  text << "MOFF " << all_of(balls).size() << " 0 1\n";
  write_balls(text, all_of(balls));
}

void write_ma_balls(std::ostream& stream, const Inputs& inputs) {
  Buffered_text text(stream);
  const auto balls = inputs.get(balls_input);
  text << all_of(balls).size() << " 0 0\n";
  write_balls(text, all_of(balls), "v ");
}

void write_csv_balls(std::ostream& stream, const Inputs& inputs) {
  Buffered_text text(stream);
  const auto balls = inputs.get(balls_input);
  text << "x,y,z,r\n";
  write_balls(text, all_of(balls), "", ",");
}

void write_xyz_cloud(std::ostream& stream, const Inputs& inputs) {
  Buffered_text text(stream);
  const auto cloud = inputs.get(cloud_input);
  if (all_of(cloud).empty()) text << "x y z\n";
  for (const Point_3& p : all_of(cloud)) text << p.x << " " << p.y << " " << p.z << "\n";
}

}  // namespace mesecina

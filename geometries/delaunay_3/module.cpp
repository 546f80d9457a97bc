// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_3/module.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/parallel.h"
#include "geometries/primitives_2.h"
#include "geometries/primitives_3.h"
#include "geometries/samples_3/module.h"

namespace mesecina {

namespace {

constexpr Key<Voronoi_faces_3> voronoi_faces_3_key{"voronoi-faces-3"};

Delaunay_3 compute_delaunay(Context& context) {
  Delaunay_3 triangulation = delaunay(sample_points(context), context.progress());
  warn_of_duplicates(context, triangulation.points.size() - triangulation.site_count, triangulation.points.size());
  return triangulation;
}

/// Radius of the smallest ball that touches the corners across from a place and holds no site, rounded.
double empty_radius(const Delaunay_3& triangulation, int cell, int place) {
  const auto& corners = triangulation.cells[cell];
  const auto point = [&](int corner) { return triangulation.points[corner]; };
  const Point_3 origin = point(corners[(place + 1) % 4]);
  const Point_3 a = point(corners[(place + 2) % 4]) - origin;
  const Point_3 b = point(corners[(place + 3) % 4]) - origin;
  const Point_3 normal = cross(a, b);
  const Point_3 to_center = (1 / (2 * dot(normal, normal))) * cross(dot(a, a) * b - dot(b, b) * a, normal);
  const double square = dot(to_center, to_center);
  const auto is_inside = [&](int corner) { return squared_distance(point(corner), origin + to_center) < square; };
  const int next = triangulation.neighbors[cell][place];
  bool is_taken = is_inside(corners[place]);
  double least = triangulation.circumradii[cell];
  if (next >= 0) {
    const auto& others = triangulation.cells[next];
    const int* opposite = std::ranges::find_if(others, [&](int c) { return std::ranges::count(corners, c) == 0; });
    is_taken = is_taken || is_inside(*opposite);
    least = std::min(least, triangulation.circumradii[next]);
  }
  return is_taken ? least : std::min(least, std::sqrt(square));
}

Primitive_set delaunay_layer(Context& context) {
  const auto triangulation = context.get(delaunay_3_key);
  Primitive_set set = primitives_in_space();
  set.vertices = triangulation->points;
  set.is_complex = true;
  std::vector<std::array<int, 2>> places;
  for (int c = 0; c < static_cast<int>(triangulation->cells.size()); ++c) {
    for (int i = 0; i < 4; ++i) {
      if (triangulation->neighbors[c][i] > c) continue;
      const auto& corners = triangulation->cells[c];
      set.triangles.push_back({corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]});
      places.push_back({c, i});
    }
  }
  Values radius{"radius", "units of the input", std::vector<double>(places.size())};
  parallel_for(places.size(), context.progress(),
               [&](std::size_t t) { radius.data[t] = empty_radius(*triangulation, places[t][0], places[t][1]); });
  set.values.push_back(std::move(radius));
  set = select(set, std::vector<bool>(set.element_count(), true));
  set.known_topology = Topology{1, {1, 0, 0}};
  return set;
}

Primitive_set voronoi_layer(Context& context) {
  const auto triangulation = context.get(delaunay_3_key);
  const auto faces = context.get(voronoi_faces_3_key);
  if (faces->size() == 0)
    throw Unavailable("all Voronoi faces are unbounded: no sample lies inside of the convex hull");
  Primitive_set set = primitives_in_space();
  set.vertices = triangulation->circumcenters;
  set.polygon_offsets = faces->offsets;
  set.polygon_vertices = faces->vertices;
  Values distances{"distance", "units of the input", {}};
  for (const auto& [a, b] : faces->sites)
    distances.data.push_back(distance(triangulation->points[a], triangulation->points[b]));
  set.values.push_back(std::move(distances));
  set.is_complex = true;
  return select(set, std::vector<bool>(set.element_count(), true));
}

/// Of the triangle of this number the Voronoi edge; of one on the hull, whose edge is a ray, where that starts.
Element_description describe_triangle(Context& context, std::size_t element) {
  const auto triangulation = context.get(delaunay_3_key);
  Element_description description;
  description.dual.dimension = 3;
  std::size_t number = 0;
  for (int c = 0; c < static_cast<int>(triangulation->cells.size()); ++c) {
    for (int i = 0; i < 4; ++i) {
      const int next = triangulation->neighbors[c][i];
      if (next > c || number++ != element) continue;
      description.dual.vertices.push_back(triangulation->circumcenters[c]);
      if (next < 0) {
        description.dual.points.push_back(0);
        return description;
      }
      description.dual.vertices.push_back(triangulation->circumcenters[next]);
      description.dual.segments.push_back({0, 1});
      description.facts.push_back(fact("length of the Voronoi edge",
                                       distance(triangulation->circumcenters[c], triangulation->circumcenters[next])));
      return description;
    }
  }
  return description;
}

/// Of a Voronoi face the two samples that are nearest to it, and the Delaunay edge between them.
Element_description describe_voronoi_face(Context& context, std::size_t element) {
  const auto triangulation = context.get(delaunay_3_key);
  const auto faces = context.get(voronoi_faces_3_key);
  Element_description description;
  if (element >= faces->size()) return description;
  const auto& sites = faces->sites[element];
  description.facts.push_back({"samples", enumeration(sites)});
  description.dual.dimension = 3;
  for (const int site : sites) description.dual.vertices.push_back(triangulation->points[site]);
  description.dual.points = {0, 1};
  description.dual.segments.push_back({0, 1});
  return description;
}

}  // namespace

std::vector<Point_3> sample_points(Context& context) {
  if (!context.input(mesh_input)) {
    const auto cloud = context.input(cloud_input);
    if (!cloud || cloud->empty()) throw Unavailable("there are neither points nor a mesh: open some");
    return *cloud;
  }
  return context.get(surface_samples_3_key)->points;
}

void warn_of_duplicates(Context& context, std::size_t count, std::size_t all) {
  if (count > 0)
    context.warn(std::to_string(count) + " of " + std::to_string(all) +
                 " samples equal another one and are merged with it");
}

void register_delaunay_3(Registry& registry) {
  registry.begin_module({"delaunay-3", "Delaunay and Voronoi", "The diagrams that everything else is read from."});
  registry.add_structure<Delaunay_3>(delaunay_3_key, compute_delaunay);
  registry.add_structure<Voronoi_faces_3>(voronoi_faces_3_key, [](Context& context) {
    return bounded_voronoi_faces(*context.get(delaunay_3_key), context.progress());
  });
  const char* stage = "Diagram";
  Layer_spec triangles = make_layer(
      "delaunay", "Delaunay triangulation", stage,
      "Joins four samples iff the sphere through them has no sample inside: the triangles of these tetrahedra, with "
      "the "
      "radius of the smallest empty ball that touches their corners. [B. Delaunay 1934; CGAL, 3D Triangulations]",
      {168, 150, 120}, delaunay_layer);
  triangles.describe = describe_triangle;
  registry.add_layer(std::move(triangles));
  Layer_spec voronoi = make_layer(
      "voronoi", "Voronoi diagram", stage,
      "The points of space that have more than one nearest sample: the bounded faces, with the distance of the two "
      "samples between which they lie. Unbounded faces are left out. [G. Voronoi 1908; CGAL, 3D Triangulations]",
      {150, 170, 190}, voronoi_layer);
  voronoi.describe = describe_voronoi_face;
  registry.add_layer(std::move(voronoi));
}

}  // namespace mesecina

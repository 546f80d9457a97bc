// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format.h"
#include "core/formats/layer_balls.h"
#include "core/formats/spatial_readers.h"
#include "core/formats/writers.h"

namespace mesecina {

namespace {

bool has_faces(const Primitive_set& set) { return !set.triangles.empty() || set.polygon_count() > 0; }
bool has_balls(const Primitive_set& set) { return !layer_balls(set).empty(); }

}  // namespace

Formats spatial_formats() {
  Formats formats;
  formats.readers = {
      {"OFF meshes and points", {"off"}, read_off},
      {"Wavefront meshes and points", {"obj"}, read_obj},
      {"PLY meshes, points and balls", {"ply"}, read_ply},
      {"STL meshes", {"stl"}, read_stl},
      {"INRIMAGE volumes, of which the surface at Otsu's threshold is read", {"inr"}, read_inr},
      {"Points and balls in space, one per line", {"xyz", "pts", "pwn", "csv", "txt"}, read_spatial_table},
      {"Weighted points", {"cin"}, read_cin},
      {"WOFF balls", {"woff"}, read_woff},
      {"MOFF medial axes, of which the balls are read", {"moff"}, read_moff},
      {"MA medial meshes, of which the balls are read", {"ma"}, read_ma},
  };
  formats.layer_writers = {
      {"json", "json", "everything about a layer, losslessly; the default", write_json_layer},
      {"csv", "csv",
       "a table of elements: element, kind, id, coordinates x0 y0 z0 x1 y1 z1 (rays: start and direction; triangles: "
       "three corners), radius, values; polygons as ring",
       write_csv_layer},
      {"ply", "ply",
       "binary: vertices with radius, triangles and polygons as faces, and edges, with their values; no rays",
       write_ply_layer},
      {"off", "off",
       "vertices, triangles and polygons; segments as faces of two vertices, but no sides of faces; no radii, no "
       "values",
       write_off_layer},
      {"obj", "obj",
       "Wavefront: triangles and polygons, lines and points beside them; balls as their centers, no rays, no values",
       write_obj_layer},
      {"stl", "stl", "binary, single precision: triangles, and polygons as triangles; nothing else", write_stl_layer,
       "triangles", has_faces},
      {"ma", "ma",
       "medial mesh of Q-MAT, MATFP and Blender's MAT add-on: vertices with radius, edges, triangles; only for layers "
       "with radii",
       write_ma_layer, "balls", has_balls},
      {"woff", "woff", "the balls of a layer, x y z radius", write_woff_layer, "balls", has_balls},
      {"moff", "moff", "the balls of a layer as a medial axis without faces", write_moff_layer, "balls", has_balls},
  };
  formats.input_writers = {
      {"woff", "woff", std::string(balls_input.id), write_woff_balls},
      {"moff", "moff", std::string(balls_input.id), write_moff_balls},
      {"csv", "csv", std::string(balls_input.id), write_csv_balls},
      {"ma", "ma", std::string(balls_input.id), write_ma_balls},
      {"xyz", "xyz", std::string(cloud_input.id), write_xyz_cloud},
      {"off", "off", std::string(mesh_input.id), write_off_mesh},
      {"obj", "obj", std::string(mesh_input.id), write_obj_mesh},
      {"ply", "ply", std::string(mesh_input.id), write_ply_mesh},
      {"stl", "stl", std::string(mesh_input.id), write_stl_mesh},
  };
  return formats;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/inputs_3/module.h"

#include "core/graph.h"
#include "geometries/primitives_3.h"

namespace mesecina {

namespace {

Primitive_set mesh_layer(Context& context) {
  const auto mesh = context.input(mesh_input);
  if (!mesh || mesh->triangles.empty()) throw Unavailable("there is no mesh: open one (off, obj, ply or stl)");
  Primitive_set set = primitives_in_space();
  set.vertices = mesh->vertices;
  set.triangles = mesh->triangles;
  set.is_complex = true;
  return set;
}

Primitive_set cloud_layer(Context& context) {
  const auto cloud = context.input(cloud_input);
  if (!cloud || cloud->empty()) throw Unavailable("there are no points: open some (xyz, pts or ply)");
  return point_primitives(*cloud);
}

Primitive_set given_balls_layer(Context& context) {
  const auto balls = context.input(balls_input);
  if (!balls || balls->empty()) throw Unavailable("there are no balls: open some (woff, moff, cin, ma or ply)");
  return ball_primitives(*balls);
}

}  // namespace

void register_inputs_3(Registry& registry) {
  registry.begin_module({"inputs-3", "Input", "What was read."});
  const char* stage = "Input";
  Layer_spec mesh = make_layer("mesh", "Mesh", stage, "The triangles that were read; polygons as triangles.",
                               {170, 175, 185}, mesh_layer);
  mesh.style.visible = true;
  registry.add_layer(std::move(mesh));
  Layer_spec points =
      make_layer("points", "Points", stage, "The points that were read, in their order.", {30, 30, 34}, cloud_layer);
  points.style.visible = true;
  registry.add_layer(std::move(points));
  Layer_spec balls = make_layer("given-balls", "Given balls", stage, "The balls that were read, in their order.",
                                {38, 84, 150}, given_balls_layer);
  balls.style.visible = true;
  registry.add_layer(std::move(balls));
}

}  // namespace mesecina

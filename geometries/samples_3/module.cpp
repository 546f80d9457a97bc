// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/samples_3/module.h"

#include "core/formats/number.h"
#include "core/graph.h"
#include "geometries/delaunay_3/module.h"
#include "geometries/power_crust_3/module.h"
#include "geometries/primitives_3.h"
#include "geometries/surface_error_3/module.h"
#include "geometries/union_3/module.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

namespace {

constexpr const char* repair_automatic = "auto";
constexpr const char* repair_off = "off";
constexpr const char* repair_wrap = "wrap";

Solid_3 compute_solid(Context& context) {
  const auto mesh = context.input(mesh_input);
  if (!mesh) throw Unavailable("there is no mesh: open one (off, obj, ply or stl)");
  const std::string name = context.setting(repair_setting);
  const Repair repair = name == repair_off ? Repair::off : name == repair_wrap ? Repair::wrap : Repair::automatic;
  Solid_3 solid = make_solid(mesh, repair, context.progress());
  context.note("repair", solid.treatment);
  for (const std::string& remark : solid.remarks) context.warn(remark);
  return solid;
}

Ball_approximation_3 compute_approximation(Context& context) {
  const auto solid = context.get(solid_3_key);
  Box box;
  for (const Point_3& p : solid->surface.vertices) box.add(p);
  Ball_approximation_3 result = approximate_by_balls(*solid, context.setting(delta_setting) * box.diagonal(),
                                                     context.setting(perturbation_setting), context.progress());
  if (result.is_exhausted)
    context.warn("The balls of " + std::to_string(result.samples.points.size()) +
                 " samples hang together in another way than the solid, and more would be too many. Choose a smaller "
                 "delta.");
  return result;
}

/// Given balls, moved as given-perturbation says; none where there are none.
std::vector<Ball_3> balls_that_were_given(Context& context) {
  const auto given = context.input(balls_input);
  if (!given || given->empty()) return {};
  const double part = context.setting(given_perturbation_setting);
  return part > 0 ? perturbed(*given, part) : *given;
}

/// Those of a mesh or of points.
std::vector<Ball_3> balls_that_were_computed(Context& context) {
  if (const auto cloud = context.input(cloud_input); !context.input(mesh_input) && cloud && !cloud->empty())
    return inner_polar_balls(*context.get(polar_balls_3_key), context.setting(perturbation_setting));
  return context.get(ball_approximation_3_key)->balls;
}

std::vector<Ball_3> compute_balls(Context& context) {
  const std::string source = context.setting(ball_source_3_setting);
  if (source == ball_source_3_computed) return balls_that_were_computed(context);
  std::vector<Ball_3> balls = balls_that_were_given(context);
  if (source == ball_source_3_given) {
    if (balls.empty()) throw Unavailable("there are no given balls: add or open some, or choose another {ball-source}");
    return balls;
  }
  if (balls.empty()) return balls_that_were_computed(context);
  if (!context.input(mesh_input)) return balls;
  try {
    const auto approximation = context.get(ball_approximation_3_key);
    balls.insert(balls.end(), approximation->balls.begin(), approximation->balls.end());
  } catch (const Unavailable& error) {
    context.warn("Given balls alone: the mesh has none. " + std::string(error.what()));
  }
  return balls;
}

/// Who looks at the balls of a mesh wants to know how well they stand for it.
Primitive_set ball_layer(Context& context) {
  Primitive_set set = ball_primitives(*context.get(balls_3_key));
  if (are_balls_of_mesh(context)) context.get(surface_error_3_key);
  return set;
}

/// With the edges of the dual complex that end at it.
Element_description describe_ball(Context& context, std::size_t element) {
  const auto balls = context.get(balls_3_key);
  Element_description description;
  if (element >= balls->size()) return description;
  Primitive_set& star = description.dual;
  star.dimension = 3;
  const int ball = static_cast<int>(element);
  star.vertices.push_back((*balls)[element].center);
  const auto dual = context.get(dual_3_key);
  for (const Dual_3::Edge& edge : dual->edges) {
    if (edge.balls[0] != ball && edge.balls[1] != ball) continue;
    star.segments.push_back({0, static_cast<int>(star.vertices.size())});
    const int other = edge.balls[0] == ball ? edge.balls[1] : edge.balls[0];
    star.vertices.push_back(dual->regular->balls[other].center);
  }
  description.facts.push_back(fact("center", (*balls)[element].center));
  description.facts.push_back({"neighbours in the dual complex", std::to_string(star.segments.size())});
  return description;
}

void add_settings(Registry& registry) {
  {
    Setting_spec setting;
    setting.id = ball_source_3_setting.id;
    setting.label = "Balls from";
    setting.help =
        "Where structures of a union of balls take their balls from. automatic: given balls together with those of the "
        "mesh; without a mesh the given ones, or if there are none those of the points. given: the balls that were "
        "added or read. computed: those of the mesh or of the points.";
    setting.default_value = std::string(ball_source_3_automatic);
    setting.choices = {ball_source_3_automatic, ball_source_3_given, ball_source_3_computed};
    setting.tags = {"union", "balls"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = repair_setting.id;
    setting.label = "Repair";
    setting.help =
        "What is done with a mesh that does not bound a solid. auto: the mildest treatment that gives one. off: "
        "nothing; "
        "such a mesh is refused. wrap: always a surface around it.";
    setting.default_value = std::string(repair_automatic);
    setting.choices = {repair_automatic, repair_off, repair_wrap};
    setting.tags = {"mesh"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = delta_setting.id;
    setting.label = "Sampling distance";
    setting.help =
        "Every point of the surface has a sample within this distance; where the balls would deviate from the "
        "surface by more than a third of it, or the solid is thin, there are more. Half of it gives four times the "
        "balls. [B. Miklos: The Scale Axis Transform, 2010, section 6.1.1]";
    setting.unit = "fraction of the diagonal";
    setting.default_value = 0.01;
    setting.minimum = 1e-5;
    setting.maximum = 0.5;
    setting.tags = {"balls", "density"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = perturbation_setting.id;
    setting.label = "Perturbation of poles";
    setting.help =
        "The centers of balls that come from a mesh or from points are moved by up to this part of their radius, "
        "always in the same "
        "way. "
        "Many of them go through one sample, where rounding would decide on how their union is connected. [B. Miklos: "
        "The Scale Axis Transform, 2010, section 6.1.3]";
    setting.unit = "fraction of the radius";
    setting.default_value = 1e-4;
    setting.minimum = 0;
    setting.maximum = 0.1;
    setting.tags = {"balls"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = given_perturbation_setting.id;
    setting.label = "Perturbation of given balls";
    setting.help =
        "Given balls are moved by up to this part of their radius and grow by about three times that, always in the "
        "same "
        "way. 0: they are taken as they are. 1e-6 (1e-4 for balls that come from samples) mends medial axes of balls "
        "in special positions (grids, many spheres "
        "through one point), where rounding decides; a warning says so.";
    setting.unit = "fraction of the radius";
    setting.default_value = 0.0;
    setting.minimum = 0;
    setting.maximum = 0.01;
    setting.tags = {"balls"};
    registry.add_setting(std::move(setting));
  }
}

}  // namespace

bool are_balls_of_mesh(Context& context) {
  const std::string source = context.setting(ball_source_3_setting);
  if (source == ball_source_3_given || !context.input(mesh_input)) return false;
  const auto given = context.input(balls_input);
  return source == ball_source_3_computed || !given || given->empty();
}

void register_samples_3(Registry& registry) {
  registry.begin_module({"samples-3", "Balls of a mesh", "A solid, samples of its surface, and balls inside it."});
  add_settings(registry);
  registry.add_structure<Solid_3>(solid_3_key, compute_solid);
  registry.add_structure<Ball_approximation_3>(ball_approximation_3_key, compute_approximation);
  registry.add_structure<Surface_samples_3>(
      surface_samples_3_key, [](Context& context) { return context.get(ball_approximation_3_key)->samples; });
  registry.add_structure<std::vector<Ball_3>>(balls_3_key, compute_balls);
  const char* stage = "Balls";
  registry.add_layer(make_layer("solid", "Solid", stage,
                                "The closed surface that stands for the mesh, oriented outward, as {repair} says.",
                                {150, 160, 175}, [](Context& context) {
                                  const auto solid = context.get(solid_3_key);
                                  Primitive_set set = primitives_in_space();
                                  set.vertices = solid->surface.vertices;
                                  set.triangles = solid->surface.triangles;
                                  set.is_complex = true;
                                  return set;
                                }));
  registry.add_layer(make_layer(
      "samples", "Samples", stage,
      "Points of the surface: every point of it has one within {delta}, and there are more where the balls would "
      "deviate "
      "from it or the solid is thin.",
      {30, 30, 34}, [](Context& context) { return point_primitives(context.get(surface_samples_3_key)->points); }));
  Layer_spec balls =
      make_layer("balls", "Balls", stage,
                 "The balls whose union is looked at: given ones, and after them the inner poles of the samples of a "
                 "mesh; without both, the inner poles of points that were read. {ball-source} chooses otherwise. Of a "
                 "mesh alone, statistics tell how far their union is from it. [N. Amenta, S. Choi, R. "
                 "Kolluri: The power crust, unions of balls, and the medial axis transform, 2001]",
                 {60, 110, 170}, ball_layer);
  balls.describe = describe_ball;
  registry.add_layer(std::move(balls));
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/scale_axis_3/module.h"

#include <limits>
#include <memory>

#include "core/graph.h"
#include "geometries/primitives_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/union_3/module.h"

namespace mesecina {

namespace {

constexpr Setting<double> min_angle_setting{"scale-axis-min-angle"};
constexpr Setting<double> sampling_setting{"sampling-min-angle"};
constexpr Setting<std::int64_t> rim_setting{"rim-smoothing"};

std::shared_ptr<const Dual_3> grown_dual(Context& context) {
  const double scale = context.setting(scale_3_setting);
  if (scale == 1) return context.get(dual_3_key);
  Regular_3 regular = regular_triangulation(grown(*context.get(balls_3_key), scale), context.progress());
  return std::make_shared<const Dual_3>(
      dual_complex(std::make_shared<const Regular_3>(std::move(regular)), context.progress()));
}

Medial_complex_3 compute_grown_axis(Context& context) {
  if (context.setting(scale_3_setting) == 1) return *context.get(medial_axis_3_key);
  const Union_vertices_3 vertices = union_vertices(grown_dual(context), context.progress());
  Medial_complex_3 axis = union_medial_axis(vertices, context.progress());
  warn_of_special_positions(context, axis, *vertices.dual);
  return axis;
}

Pruned_axis_3 compute_pruned(Context& context) {
  const auto grown_axis = context.get(grown_medial_axis_3_key);
  const std::vector<double> angles = angle_of_faces(*grown_axis, context.progress());
  Pruned_complex_3 kept =
      without_small_sheets(*grown_axis, angles, context.setting(min_angle_setting), context.progress());
  Pruned_axis_3 pruned;
  pruned.complex = std::move(kept.complex);
  pruned.angles.reserve(kept.faces.size());
  for (const int face : kept.faces) pruned.angles.push_back(angles[face]);
  pruned.sheets = std::move(kept.sheets);
  if (const auto steps = context.setting(rim_setting); steps > 0)
    pruned.complex = with_smooth_rims(std::move(pruned.complex), static_cast<int>(steps));
  return pruned;
}

Primitive_set scale_axis_layer(Context& context) {
  const auto axis = context.get(scale_axis_3_key);
  const auto pruned = context.get(pruned_axis_3_key);
  Primitive_set set = primitives_in_space();
  set.vertices = axis->centers;
  set.radii = axis->radii;
  set.points = axis->points;
  set.segments = axis->edges;
  set.triangles = axis->triangles;
  set.is_complex = true;
  const std::size_t others = set.points.size() + set.segments.size();
  Values angle{"angle", "degrees", std::vector<double>(others, std::numeric_limits<double>::infinity())};
  Values sheet{"sheet", "", std::vector<double>(others, -1)};
  for (const int face : axis->face_of_triangle) {
    angle.data.push_back(pruned->angles[face]);
    sheet.data.push_back(pruned->sheets.sheet_of_face[face]);
  }
  set.values.push_back(std::move(angle));
  set.values.push_back(std::move(sheet));
  return set;
}

Primitive_set scale_axis_ball_layer(Context& context) {
  const auto axis = context.get(scale_axis_3_key);
  std::vector<Ball_3> balls;
  balls.reserve(axis->centers.size());
  for (std::size_t b = 0; b < axis->centers.size(); ++b) balls.push_back({axis->centers[b], axis->radii[b]});
  return ball_primitives(balls);
}

Primitive_set grown_axis_layer(Context& context) {
  const auto axis = context.get(grown_medial_axis_3_key);
  Primitive_set set = medial_primitives(*axis);
  add_medial_values(set, "angle", "degrees", angle_values(*axis, context.progress()));
  add_medial_values(set, "lambda", "units of the input", lambda_values(*axis));
  return set;
}

void add_settings(Registry& registry) {
  {
    Setting_spec setting;
    setting.id = scale_3_setting.id;
    setting.label = "Scale";
    setting.help =
        "Factor s by which balls grow before the medial axis is taken. Balls that a larger neighbour covers are gone: "
        "the larger the factor, the simpler the shape. 1: nothing is simplified; 1.1 to 1.5 are usual. [B. Miklos: The "
        "Scale Axis Transform, 2010, section 5.2]";
    setting.unit = "factor";
    setting.default_value = 1.1;
    setting.minimum = 1;
    setting.maximum = 100;
    setting.tags = {"scale axis"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = min_angle_setting.id;
    setting.label = "Least contact angle";
    setting.help =
        "Sheets of the grown medial axis whose largest contact angle is smaller are taken for artefacts of the spheres "
        "of the grown union and removed, as long as topology stays. 0 keeps all. [B. Miklos: The Scale Axis Transform, "
        "2010, section 6.1.3]";
    setting.unit = "degrees";
    setting.default_value = 30.0;
    setting.minimum = 0;
    setting.maximum = 180;
    setting.tags = {"scale axis", "threshold"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = sampling_setting.id;
    setting.label = "Sampling angle";
    setting.help =
        "Faces of the scale axis are split until neighbouring balls, shrunk back, meet at no less than this angle. "
        "Larger: more balls, a smoother shape. [B. Miklos: The Scale Axis Transform, 2010, section 6.1.2]";
    setting.unit = "degrees";
    setting.default_value = 150.0;
    setting.minimum = 0;
    setting.maximum = 179;
    setting.tags = {"scale axis", "density"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = rim_setting.id;
    setting.label = "Rim smoothing";
    setting.help =
        "How often the rims of sheets are smoothed: each vertex moves half of the way to the middle of its neighbours, "
        "and its ball stays inside. [B. Miklos: The Scale Axis Transform, 2010, section 6.1.3]";
    setting.unit = "steps";
    setting.default_value = std::int64_t{0};
    setting.minimum = 0;
    setting.maximum = 1000;
    setting.tags = {"scale axis"};
    registry.add_setting(std::move(setting));
  }
}

}  // namespace

void register_scale_axis_3(Registry& registry) {
  registry.begin_module(
      {"scale-axis-3", "Scale axis",
       "The scale axis transform of the union of the balls. [B. Miklos, J. Giesen, M. Pauly: Discrete "
       "scale axis representations for 3D geometry, 2010]"});
  add_settings(registry);
  registry.add_structure<Medial_complex_3>(grown_medial_axis_3_key, compute_grown_axis);
  registry.add_structure<Pruned_axis_3>(pruned_axis_3_key, compute_pruned);
  registry.add_structure<Ball_complex_3>(scale_axis_3_key, [](Context& context) {
    return sampled(context.get(pruned_axis_3_key)->complex, context.setting(scale_3_setting),
                   context.setting(sampling_setting), context.progress());
  });
  const char* stage = "Scale axis";
  registry.add_layer(make_layer("grown-medial-axis", "Medial axis of the grown shape", stage,
                                "The medial axis of the union of the grown balls, with all its sheets.",
                                {120, 120, 125}, grown_axis_layer));
  registry.add_layer(make_layer("scale-axis", "Scale axis", stage,
                                "The medial axis of the grown shape without sheets of small contact angle, sampled as "
                                "{sampling-min-angle} says; radii are shrunk back. [B. Miklos, J. Giesen, M. Pauly: "
                                "Discrete scale axis representations for 3D geometry, 2010]",
                                {20, 110, 40}, scale_axis_layer));
  registry.add_layer(make_layer("scale-axis-balls", "Scale axis: balls", stage,
                                "The balls of the scale axis, shrunk back by the factor {scale}. [B. Miklos: The Scale "
                                "Axis Transform, 2010, section 5.2]",
                                {50, 140, 70}, scale_axis_ball_layer));
}

}  // namespace mesecina

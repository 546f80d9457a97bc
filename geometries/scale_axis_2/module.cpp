// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/scale_axis_2/module.h"

#include <limits>

#include "core/graph.h"
#include "geometries/primitives_2.h"
#include "geometries/union_2/module.h"

namespace mesecina {

namespace {

/// The Voronoi diagram that the grown medial axis is read from.
constexpr Key<Union_voronoi_2> grown_voronoi_2_key{"grown-voronoi-2"};

/// Growing by 1 changes nothing: the union of the medial disks of a union is that union.
constexpr double no_growth = 1;

Primitive_set disk_layer(std::vector<Point_3> centers, const std::vector<double>& radii) {
  Primitive_set set;
  set.vertices = std::move(centers);
  for (std::size_t b = 0; b < radii.size(); ++b) set.balls.push_back({static_cast<int>(b), radii[b]});
  set.values.push_back({"radius", "units of the input", radii});
  return set;
}

Primitive_set grown_disk_layer(Context& context) {
  const auto axis = context.get(union_medial_axis_2_key);
  const Balls_2 balls = grown(medial_balls(*axis), context.setting(scale_setting));
  return disk_layer(lifted(balls.centers), balls.radii);
}

Primitive_set scale_axis_layer(Context& context) {
  const auto axis = context.get(scale_axis_2_key);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Primitive_set set;
  set.is_complex = true;
  set.vertices = lifted(axis->centers);
  set.segments = axis->edges;
  std::vector<bool> has_edge(axis->centers.size(), false);
  for (const auto& [a, b] : axis->edges) has_edge[a] = has_edge[b] = true;
  Values angle{"angle", "degrees", {}};
  Values monotone{"angle-monotone", "degrees", {}};
  for (std::size_t b = 0; b < has_edge.size(); ++b) {
    if (has_edge[b]) continue;
    set.points.push_back(static_cast<int>(b));
    angle.data.push_back(infinity);
    monotone.data.push_back(infinity);
  }
  angle.data.insert(angle.data.end(), axis->angles.begin(), axis->angles.end());
  monotone.data.insert(monotone.data.end(), axis->monotone_angles.begin(), axis->monotone_angles.end());
  set.values.push_back(std::move(angle));
  set.values.push_back(std::move(monotone));
  return set;
}

Element_description describe_scale_axis(Context& context, std::size_t element) {
  const auto axis = context.get(scale_axis_2_key);
  const Primitive_set set = scale_axis_layer(context);
  Element_description description;
  if (element >= set.element_count()) return description;
  const auto add = [&](int disk) { add_disk(description.dual, axis->centers[disk], axis->radii[disk]); };
  if (element < set.points.size()) {
    description.facts.push_back(fact("radius", axis->radii[set.points[element]]));
    add(set.points[element]);
    return description;
  }
  const auto [a, b] = set.segments[element - set.points.size()];
  description.facts.push_back(
      {"radii at the ends", format_number(axis->radii[a]) + " and " + format_number(axis->radii[b])});
  add(a);
  add(b);
  return description;
}

Element_description describe_disk(const std::vector<Point_2>& centers, const std::vector<double>& radii,
                                  std::size_t element) {
  Element_description description;
  if (element >= radii.size()) return description;
  description.facts.push_back(fact("center", centers[element]));
  description.facts.push_back(fact("radius", radii[element]));
  return description;
}

void add_settings(Registry& registry) {
  {
    Setting_spec setting;
    setting.id = scale_setting.id;
    setting.label = "Scale";
    setting.help =
        "Factor s by which medial disks grow before the medial axis is taken again. Disks that a larger neighbour "
        "covers are gone: the larger the factor, the simpler the shape. 1: nothing is simplified; 1.1 to 1.5 are "
        "usual. "
        "[B. Miklos: The Scale Axis Transform, 2010, section 5.2]";
    setting.unit = "factor";
    setting.default_value = 1.2;
    setting.minimum = 1;
    setting.maximum = 100;
    setting.tags = {"scale axis"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = scale_axis_min_angle_setting.id;
    setting.label = "Least contact angle";
    setting.help =
        "Branches of the grown medial axis that end with a smaller contact angle are taken for artefacts of the arcs "
        "of "
        "the grown union and removed, as long as topology stays. 0 keeps all. [B. Miklos: The Scale Axis Transform, "
        "2010, section 6.1.2]";
    setting.unit = "degrees";
    setting.default_value = 30.0;
    setting.minimum = 0;
    setting.maximum = 180;
    setting.tags = {"scale axis", "threshold"};
    registry.add_setting(std::move(setting));
  }
  {
    Setting_spec setting;
    setting.id = sampling_min_angle_setting.id;
    setting.label = "Sampling angle";
    setting.help =
        "Edges of the scale axis are cut until neighbouring disks, shrunk back, meet at no less than this angle. "
        "Larger: more disks, a smoother shape. [B. Miklos: The Scale Axis Transform, 2010, section 6.1.2]";
    setting.unit = "degrees";
    setting.default_value = 150.0;
    setting.minimum = 0;
    setting.maximum = 179;
    setting.tags = {"scale axis", "density"};
    registry.add_setting(std::move(setting));
  }
}

void add_structures(Registry& registry) {
  registry.add_structure<Union_boundary_2>(grown_boundary_2_key, [](Context& context) {
    const double scale = context.setting(scale_setting);
    if (scale == no_growth) return *context.get(union_boundary_2_key);
    const auto axis = context.get(union_medial_axis_2_key);
    return union_boundary(std::make_shared<const Balls_2>(grown(medial_balls(*axis), scale)), 0, context.progress());
  });
  registry.add_structure<Union_voronoi_2>(grown_voronoi_2_key, [](Context& context) {
    Union_voronoi_2 voronoi = union_voronoi(context.get(grown_boundary_2_key), context.progress());
    if (voronoi.lost_chords > 0)
      context.warn(std::to_string(voronoi.lost_chords) +
                   " arcs of the grown boundary are too short for the precision of coordinates: the scale axis may be "
                   "wrong there");
    return voronoi;
  });
  registry.add_structure<Union_medial_axis_2>(grown_medial_axis_2_key, [](Context& context) {
    return union_medial_axis(*context.get(grown_voronoi_2_key), false, context.progress());
  });
  registry.add_structure<Scale_axis_2>(scale_axis_2_key, [](Context& context) {
    return scale_axis(*context.get(grown_medial_axis_2_key), context.setting(scale_setting),
                      context.setting(scale_axis_min_angle_setting), context.setting(sampling_min_angle_setting),
                      context.progress());
  });
  registry.add_structure<Union_boundary_2>(scale_axis_shape_2_key, [](Context& context) {
    const auto axis = context.get(scale_axis_2_key);
    Balls_2 balls;
    balls.centers = axis->centers;
    balls.radii = axis->radii;
    return union_boundary(std::make_shared<const Balls_2>(std::move(balls)), 0, context.progress());
  });
}

}  // namespace

void register_scale_axis_2(Registry& registry) {
  registry.begin_module({"scale-axis-2", "Scale axis",
                         "The scale axis transform of the union of the disks. [J. Giesen, B. Miklos, M. Pauly, C. "
                         "Wormser: The scale axis transform, 2009]"});
  add_settings(registry);
  add_structures(registry);
  const char* stage = "Scale axis";
  {
    Layer_spec layer;
    layer.id = "grown-union";
    layer.label = "Grown shape";
    layer.stage = stage;
    layer.help = "The union of the medial disks, all grown by the factor {scale}.";
    layer.style = look({165, 165, 175}, 1.5);
    layer.style.filled = true;
    layer.style.opacity = 0.6;
    layer.build = [](Context& context) { return boundary_primitives(*context.get(grown_boundary_2_key)); };
    layer.describe = [](Context& context, std::size_t element) {
      return describe_boundary_element(*context.get(grown_boundary_2_key), element);
    };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "scale-axis-shape";
    layer.label = "Scale axis: shape";
    layer.stage = stage;
    layer.help =
        "The simplified shape: the union of the disks of the scale axis, shrunk back. [B. Miklos: The Scale Axis "
        "Transform, 2010, section 5.2]";
    layer.style = look({60, 160, 80}, 1.5);
    layer.style.filled = true;
    layer.style.opacity = 0.6;
    layer.build = [](Context& context) { return boundary_primitives(*context.get(scale_axis_shape_2_key)); };
    layer.describe = [](Context& context, std::size_t element) {
      return describe_boundary_element(*context.get(scale_axis_shape_2_key), element);
    };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "grown-disks";
    layer.label = "Grown medial disks";
    layer.stage = stage;
    layer.help = "The medial disks of the union with radii times the factor scale.";
    layer.style = look({150, 150, 160}, 1);
    layer.style.opacity = 0.6;
    layer.build = grown_disk_layer;
    layer.describe = [](Context& context, std::size_t element) {
      const Balls_2 balls = grown(medial_balls(*context.get(union_medial_axis_2_key)), context.setting(scale_setting));
      return describe_disk(balls.centers, balls.radii, element);
    };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "scale-axis-disks";
    layer.label = "Scale axis: disks";
    layer.stage = stage;
    layer.help =
        "The disks of the scale axis transform: medial disks of the grown shape, sampled as {sampling-min-angle} says, "
        "shrunk back by the factor {scale}.";
    layer.style = look({50, 140, 70}, 1);
    layer.style.opacity = 0.5;
    layer.build = [](Context& context) {
      const auto axis = context.get(scale_axis_2_key);
      return disk_layer(lifted(axis->centers), axis->radii);
    };
    layer.describe = [](Context& context, std::size_t element) {
      const auto axis = context.get(scale_axis_2_key);
      return describe_disk(axis->centers, axis->radii, element);
    };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "grown-medial-axis";
    layer.label = "Medial axis of the grown shape";
    layer.stage = stage;
    layer.help = "The medial axis of the union of the grown medial disks, with all its branches.";
    layer.style = look({120, 120, 125}, 1.5);
    layer.build = [](Context& context) {
      return union_axis_primitives(*context.get(grown_medial_axis_2_key), context.setting(complete_faces_only_setting));
    };
    layer.describe = [](Context& context, std::size_t element) {
      return describe_union_axis_element(*context.get(grown_medial_axis_2_key),
                                         context.setting(complete_faces_only_setting), element);
    };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "scale-axis";
    layer.label = "Scale axis";
    layer.stage = stage;
    layer.help =
        "The medial axis of the grown shape (complete edges) without branches of small contact angle. At scale 1 and "
        "{scale-axis-min-angle} 0 it is the medial axis. [J. Giesen, B. Miklos, M. Pauly, C. Wormser 2009; B. Miklos: "
        "The Scale Axis Transform, 2010]";
    layer.style = look({20, 110, 40}, 2.5);
    layer.build = scale_axis_layer;
    layer.describe = describe_scale_axis;
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina

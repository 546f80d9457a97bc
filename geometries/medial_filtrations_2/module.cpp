// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_filtrations_2/module.h"

#include <algorithm>
#include <limits>

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/filtration/filtration.h"
#include "geometries/medial_filtrations_2/ball_scale_2.h"
#include "geometries/primitives_2.h"
#include "geometries/union_2/module.h"

namespace mesecina {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr Key<Ball_scale_2> ball_scale_2_key{"ball-scale-2"};

Ball_scale_2 compute_ball_scale(Context& context) {
  return ball_scale(*context.get(delaunay_2_key), *context.get(medial_axis_2_key), context.progress());
}

std::shared_ptr<Ball_scale_2> compute_ball_scale_update(Context& context,
                                                        const std::shared_ptr<Ball_scale_2>& previous) {
  return std::make_shared<Ball_scale_2>(
      update_ball_scale(*previous, *context.get(delaunay_2_key), *context.get(medial_axis_2_key), context.progress()));
}

Importance_2 compute_scale(Context& context) {
  const auto axis = context.get(medial_axis_2_key);
  const auto balls = context.get(ball_scale_2_key);
  Importance_2 importance;
  importance.balls = balls->values;
  importance.edges.reserve(axis->edges.size());
  for (const auto& [a, b] : axis->edges) importance.edges.push_back(std::min(importance.balls[a], importance.balls[b]));
  return importance;
}

/// One way to measure the importance of the parts of the axis; all else is the same for all of them.
struct Measure {
  std::string name;
  std::string label;
  std::string unit;
  Key<Importance_2> importance;
  Key<Importance_2> monotone;
  Key<Union_boundary_2> shape;
  std::string_view limit;
  std::string definition;
  Color color;
};

std::string monotone_name(const Measure& measure) { return measure.name + "-monotone"; }

Importance_2 compute_monotone(Context& context, const Measure& measure) {
  const auto axis = context.get(medial_axis_2_key);
  const auto importance = context.get(measure.importance);
  Importance_2 result;
  result.edges =
      topology_preserving(axis->centers.size(), axis->edges, importance->edges, axis->contacts, context.progress());
  // A ball without edges is a component of its own: it stays whatever the limit.
  result.balls = largest_of_edges(axis->centers.size(), axis->edges, result.edges, infinity);
  return result;
}

Primitive_set filtered_axis_layer(Context& context, const Measure& measure) {
  const auto axis = context.get(medial_axis_2_key);
  const auto plain = context.get(measure.importance);
  const auto monotone = context.get(measure.monotone);
  const std::vector<int> isolated = isolated_balls(*axis);
  Primitive_set set = axis_primitives(*axis, isolated);
  const auto add_values = [&](std::string name, const Importance_2& importance) {
    Values values{std::move(name), measure.unit, {}};
    values.data.reserve(set.element_count());
    for (const int ball : isolated) values.data.push_back(importance.balls[ball]);
    values.data.insert(values.data.end(), importance.edges.begin(), importance.edges.end());
    set.values.push_back(std::move(values));
  };
  add_values(measure.name, *plain);
  add_values(monotone_name(measure), *monotone);
  return set;
}

/// Per disk the largest value of its edges: the limit keeps exactly the disks at the ends of kept edges.
std::vector<double> values_of_disks(const Medial_axis_2& axis, const Importance_2& importance) {
  std::vector<double> values = largest_of_edges(axis.centers.size(), axis.edges, importance.edges, -infinity);
  for (std::size_t b = 0; b < values.size(); ++b)
    if (values[b] == -infinity) values[b] = importance.balls[b];
  return values;
}

/// Boundary of the union of the disks that the limit keeps.
Union_boundary_2 compute_shape(Context& context, const Measure& measure) {
  const auto axis = context.get(medial_axis_2_key);
  const auto balls = context.get(inner_voronoi_balls_2_key);
  const double limit = context.setting(Setting<double>{measure.limit});
  const std::vector<double> values = context.setting(topology_preserving_setting)
                                         ? context.get(measure.monotone)->balls
                                         : values_of_disks(*axis, *context.get(measure.importance));
  std::vector<bool> is_kept(balls->balls.size(), false);
  for (std::size_t b = 0; b < values.size(); ++b)
    if (values[b] >= limit) is_kept[balls->ball_of_triangle[axis->triangles[b]]] = true;
  std::vector<int> kept;
  for (std::size_t b = 0; b < is_kept.size(); ++b)
    if (is_kept[b]) kept.push_back(static_cast<int>(b));
  return union_boundary(std::make_shared<const Balls_2>(subset(balls->balls, kept)), 0, context.progress());
}

Primitive_set filtered_disk_layer(Context& context, const Measure& measure) {
  const auto axis = context.get(medial_axis_2_key);
  const auto plain = context.get(measure.importance);
  const auto monotone = context.get(measure.monotone);
  Primitive_set set;
  set.vertices = lifted(axis->centers);
  set.balls.reserve(axis->centers.size());
  for (std::size_t b = 0; b < axis->centers.size(); ++b) set.balls.push_back({static_cast<int>(b), axis->radii[b]});
  set.values.push_back({measure.name, measure.unit, values_of_disks(*axis, *plain)});
  set.values.push_back({monotone_name(measure), measure.unit, monotone->balls});
  set.values.push_back({"radius", "units of the input", axis->radii});
  return set;
}

Element_description describe_medial_disk(Context& context, std::size_t element) {
  const auto axis = context.get(medial_axis_2_key);
  const auto triangulation = context.get(delaunay_2_key);
  Element_description description;
  if (element >= axis->centers.size()) return description;
  description.facts.push_back(fact("center", axis->centers[element]));
  // Of more than three contacts those of one triangle, then the others.
  const auto& corners = triangulation->triangles[axis->triangles[element]];
  for (const int corner : corners) add_point(description.dual, triangulation->points[corner]);
  description.dual.triangles.push_back({0, 1, 2});
  for (const int contact : contacts_of_ball(*triangulation, *axis, static_cast<int>(element)))
    if (std::ranges::find(corners, contact) == corners.end())
      add_point(description.dual, triangulation->points[contact]);
  return description;
}

void add_measure(Registry& registry, const Measure& measure) {
  registry.add_structure<Importance_2>(measure.monotone,
                                       [measure](Context& context) { return compute_monotone(context, measure); });
  const auto add_cut = [&](Layer_spec& layer) {
    layer.cut_value = measure.name;
    layer.cut_setting = measure.limit;
    layer.cut_switch = topology_preserving_setting.id;
    layer.cut_value_when_switched = monotone_name(measure);
  };
  registry.add_structure<Union_boundary_2>(measure.shape,
                                           [measure](Context& context) { return compute_shape(context, measure); });
  {
    Layer_spec layer;
    layer.id = measure.name + "-medial-axis-shape";
    layer.label = measure.label + ": shape";
    layer.stage = "Filtration";
    layer.help = "The union of the medial disks at the kept parts of the medial axis filtered by " + measure.name +
                 ": what they reconstruct of the shape. " + measure.definition;
    layer.style = look(measure.color, 1.5);
    layer.style.filled = true;
    layer.style.opacity = 0.6;
    layer.build = [measure](Context& context) { return boundary_primitives(*context.get(measure.shape)); };
    layer.describe = [measure](Context& context, std::size_t element) {
      return describe_boundary_element(*context.get(measure.shape), element);
    };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = measure.name + "-medial-axis-disks";
    layer.label = measure.label + ": medial disks";
    layer.stage = "Filtration";
    layer.help =
        "The medial disks at the kept parts of the medial axis filtered by " + measure.name + ". " + measure.definition;
    layer.style = look(measure.color, 1);
    layer.style.opacity = 0.5;
    layer.build = [measure](Context& context) { return filtered_disk_layer(context, measure); };
    layer.describe = describe_medial_disk;
    add_cut(layer);
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = measure.name + "-medial-axis";
    layer.label = measure.label;
    layer.stage = "Filtration";
    layer.help = "The parts of the medial axis whose " + measure.name + " reaches {" + std::string(measure.limit) +
                 "}" + "; with {topology-preserving} only ends are shortened. " + measure.definition;
    layer.style = look(measure.color, 2.5);
    layer.build = [measure](Context& context) { return filtered_axis_layer(context, measure); };
    layer.describe = describe_axis_element;
    add_cut(layer);
    registry.add_layer(std::move(layer));
  }
}

}  // namespace

void register_medial_filtrations_2(Registry& registry) {
  registry.begin_module({"medial-filtrations-2", "Filtrations of the medial axis",
                         "What is left of the medial axis when unimportant parts are removed."});
  {
    Setting_spec setting;
    setting.id = topology_preserving_setting.id;
    setting.label = "Preserve topology";
    setting.help =
        "On: a part goes only when all beyond it has gone, so no component falls apart, no cycle opens and none "
        "vanishes. "
        "Off: a plain threshold. [B. Miklos: The Scale Axis Transform, 2010, sections 5.1 and 6.2]";
    setting.default_value = true;
    setting.tags = {"filtration"};
    registry.add_setting(std::move(setting));
  }
  add_filtration_limits(registry, "disk");

  registry.add_structure<Ball_scale_2>(ball_scale_2_key, compute_ball_scale, compute_ball_scale_update);
  registry.add_structure<Importance_2>(scale_2_key, compute_scale);

  add_measure(registry, {"lambda",
                         "Lambda medial axis",
                         "units of the input",
                         lambda_2_key,
                         {"lambda-monotone-2"},
                         {"lambda-shape-2"},
                         lambda_limit_setting.id,
                         "Lambda is half the distance of the contact points. [F. Chazal, A. Lieutier 2005]",
                         {70, 120, 40}});
  add_measure(registry, {"angle",
                         "Angle medial axis",
                         "degrees",
                         angle_2_key,
                         {"angle-monotone-2"},
                         {"angle-shape-2"},
                         angle_limit_setting.id,
                         "The angle is that under which the contact points are seen, at its largest along an edge. "
                         "[M. Foskey, M. Lin, D. Manocha 2003]",
                         {130, 80, 180}});
  add_measure(registry,
              {"scale",
               "Scale medial axis",
               "factor",
               scale_2_key,
               {"scale-monotone-2"},
               {"scale-shape-2"},
               scale_limit_setting.id,
               "The scale of a medial disk is the factor at which a single larger one covers it when all grow: the "
               "least d(c, c') / (r' - r). [B. Miklos: The Scale Axis Transform, 2010, section 6.2]",
               {215, 90, 20}});
}

}  // namespace mesecina

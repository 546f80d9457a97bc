// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/medial_filtrations_3/module.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/medial_filtrations_3/medial_scale_3.h"
#include "geometries/primitives_2.h"
#include "geometries/primitives_3.h"
#include "geometries/samples_3/module.h"
#include "geometries/scale_axis_3/scale_axis_3.h"
#include "geometries/union_3/module.h"

namespace mesecina {

namespace {

/// One way to measure the importance of the parts of the axis.
struct Measure {
  const char* name;
  const char* unit;
  Key<Medial_values_3> importance;
};
constexpr Measure lambda{"lambda", "units of the input", lambda_3_key};
constexpr Measure angle{"angle", "degrees", angle_3_key};
constexpr Measure scale{"scale", "factor", scale_3_key};

void add_importance(Context& context, Primitive_set& set, const Measure& measure) {
  add_medial_values(set, measure.name, measure.unit, *context.get(measure.importance));
}

Primitive_set axis_layer(Context& context) {
  const auto axis = context.get(medial_axis_3_key);
  Primitive_set set = medial_primitives(*axis);
  for (const Measure& measure : {angle, lambda, scale}) add_importance(context, set, measure);
  add_medial_values(set, "sheet", "", sheet_values(*axis));
  return set;
}

/// Per face a segment between its contacts, with the element number of the face in the medial axis as its own.
Primitive_set contact_layer(Context& context) {
  const auto axis = context.get(medial_axis_3_key);
  const auto sources = context.get(source_balls_3_key);
  constexpr std::size_t spheres_per_contact = 3;
  Primitive_set set = primitives_in_space();
  for (const char* end : {"from", "to"})
    for (std::size_t i = 0; i < spheres_per_contact; ++i)
      set.values.push_back({std::string(end) + "-ball-" + std::to_string(i), "", {}});
  const std::size_t first = axis->centers.size() + axis->edges.size();
  for (std::size_t f = 0; f < axis->face_count(); ++f) {
    const int vertex = static_cast<int>(set.vertices.size());
    set.segments.push_back({vertex, vertex + 1});
    set.ids.push_back(static_cast<std::int64_t>(first + f));
    for (std::size_t which = 0; which < 2; ++which) {
      set.vertices.push_back(axis->contacts[f][which]);
      for (std::size_t i = 0; i < spheres_per_contact; ++i)
        set.values[which * spheres_per_contact + i].data.push_back(sources->of_contact(f, which)[i]);
    }
  }
  return set;
}

/// Outlined around its center.
void add_ball(Primitive_set& set, const Ball_3& ball) {
  set.balls.push_back({static_cast<int>(set.vertices.size()), ball.radius});
  set.vertices.push_back(ball.center);
}

void describe_vertex(const Medial_complex_3& axis, std::size_t vertex, Element_description& description) {
  description.facts.push_back(fact("radius", axis.radii[vertex]));
  description.facts.push_back(fact("center", axis.centers[vertex]));
  if (axis.balls[vertex] >= 0) description.facts.push_back({"ball", std::to_string(axis.balls[vertex])});
  add_ball(description.dual, {axis.centers[vertex], axis.radii[vertex]});
}

/// The contacts, the segment between them, and the balls on whose spheres they lie.
void describe_face(Context& context, const Medial_complex_3& axis, std::size_t face, Element_description& description) {
  const auto sources = context.get(source_balls_3_key);
  const auto balls = context.get(balls_3_key);
  Primitive_set& dual = description.dual;
  dual.segments.push_back({0, 1});
  dual.points = {0, 1};
  std::vector<int> shown;
  constexpr std::array names{"contact 1", "contact 2"};
  constexpr std::array names_of_balls{"balls at contact 1", "balls at contact 2"};
  for (std::size_t which = 0; which < 2; ++which) {
    const auto around = sources->of_contact(face, which);
    dual.vertices.push_back(axis.contacts[face][which]);
    description.facts.push_back(fact(names[which], axis.contacts[face][which]));
    description.facts.push_back({names_of_balls[which], enumeration(around)});
    shown.insert(shown.end(), around.begin(), around.end());
  }
  std::ranges::sort(shown);
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  for (const int ball : shown) add_ball(dual, (*balls)[ball]);
}

/// Of a vertex the medial ball, of an edge those at its ends, of a face what it touches.
Element_description describe_part(Context& context, std::size_t element) {
  const auto axis = context.get(medial_axis_3_key);
  Element_description description;
  description.dual.dimension = 3;
  const std::size_t first_face = axis->centers.size() + axis->edges.size();
  if (element < axis->centers.size()) {
    describe_vertex(*axis, element, description);
  } else if (element < first_face) {
    for (const int end : axis->edges[element - axis->centers.size()])
      add_ball(description.dual, {axis->centers[end], axis->radii[end]});
  } else if (element < first_face + axis->face_count()) {
    describe_face(context, *axis, element - first_face, description);
  }
  return description;
}

/// Of the segment between the contacts of a face what is known of the face.
Element_description describe_contacts(Context& context, std::size_t element) {
  const auto axis = context.get(medial_axis_3_key);
  return describe_part(context, axis->centers.size() + axis->edges.size() + element);
}

void add_filtration(Registry& registry, const Measure& measure, const char* id, const char* label, const char* help,
                    std::string_view limit, Color color) {
  Layer_spec layer = make_layer(id, label, "Filtration", help, color, [measure](Context& context) {
    Primitive_set set = medial_primitives(*context.get(medial_axis_3_key));
    add_importance(context, set, measure);
    return set;
  });
  layer.describe = describe_part;
  layer.cut_value = measure.name;
  layer.cut_setting = limit;
  registry.add_layer(std::move(layer));
}

}  // namespace

void register_medial_filtrations_3(Registry& registry) {
  registry.begin_module({"medial-filtrations-3", "Filtrations of the medial axis",
                         "The medial axis of the union of the balls, and what is left of it when unimportant parts are "
                         "removed."});
  add_filtration_limits(registry, "ball");
  registry.add_structure<Medial_values_3>(
      lambda_3_key, [](Context& context) { return lambda_values(*context.get(medial_axis_3_key)); });
  registry.add_structure<Medial_values_3>(
      angle_3_key, [](Context& context) { return angle_values(*context.get(medial_axis_3_key), context.progress()); });
  registry.add_structure<Medial_values_3>(
      scale_3_key, [](Context& context) { return scale_values(*context.get(medial_axis_3_key), context.progress()); });
  registry.add_structure<Source_balls_3>(source_balls_3_key, [](Context& context) {
    return source_balls(*context.get(medial_axis_3_key), *context.get(union_vertices_3_key));
  });

  Layer_spec medial_axis = make_layer(
      "medial-axis", "Medial axis", "Union of balls",
      "The medial axis of the union of the balls, exact but for incomplete faces: the singular faces of the dual "
      "complex, and the Voronoi diagram of V(U) in the rest of it. Values of edges and vertices are the largest of the "
      "faces around them. [N. Amenta, R. Kolluri: The medial axis of a union of balls, 2001]",
      {60, 130, 90}, axis_layer);
  medial_axis.describe = describe_part;
  registry.add_layer(std::move(medial_axis));
  Layer_spec contacts = make_layer(
      "medial-contacts", "Contact points", "Union of balls",
      "For each face of the medial axis the two points where its medial balls touch the boundary of the union, joined "
      "by a segment whose id is the number of the face among the elements of the medial axis. Its values are the "
      "source balls: numbers of three balls on whose spheres each contact lies. [N. Amenta, R. Kolluri: The medial "
      "axis of a union of balls, 2001]",
      {170, 130, 60}, contact_layer);
  contacts.describe = describe_contacts;
  registry.add_layer(std::move(contacts));
  add_filtration(
      registry, lambda, "lambda-medial-axis", "Lambda medial axis",
      "The faces of the medial axis whose lambda reaches {lambda-limit}, and what bounds them. Lambda is half the "
      "distance of the contact points; of edges without faces it is the radius of the circle of contact. [F. Chazal, "
      "A. Lieutier 2005]",
      lambda_limit_setting.id, {70, 120, 40});
  add_filtration(
      registry, angle, "angle-medial-axis", "Angle medial axis",
      "The faces of the medial axis whose angle reaches {angle-limit}, and what bounds them. The angle is that "
      "under which the contact points are seen, at its largest on a face. [M. Foskey, M. Lin, D. Manocha "
      "2003]",
      angle_limit_setting.id, {130, 80, 180});
  add_filtration(registry, scale, "scale-medial-axis", "Scale medial axis",
                 "The faces of the medial axis whose scale reaches {scale-limit}, and what bounds them. The scale of a "
                 "medial ball is the factor at which a single larger one covers it when all grow: the least "
                 "d(c, c') / (r' - r); that of a face is the least of its vertices. [B. Miklos: The Scale Axis "
                 "Transform, 2010, section 6.2]",
                 scale_limit_setting.id, {215, 90, 20});
}

}  // namespace mesecina

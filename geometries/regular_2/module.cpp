// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/regular_2/module.h"

#include "core/graph.h"
#include "geometries/balls_2/module.h"
#include "geometries/primitives_2.h"

namespace mesecina {

namespace {

std::int64_t edge_number(int triangle, int corner) { return std::int64_t{3} * triangle + corner; }

/// Disks on a line: the radical axes of neighbours, each as two rays.
void add_radical_axes(Primitive_set& set, const Regular_2& regular) {
  const Balls_2& balls = *regular.balls;
  for (std::size_t i = 1; i < regular.line.size(); ++i) {
    const int a = regular.line[i - 1];
    const int b = regular.line[i];
    const Point_2& p = balls.centers[a];
    const Point_2& q = balls.centers[b];
    const double length = distance(p, q);
    const double along =
        (length + (balls.radii[a] - balls.radii[b]) * (balls.radii[a] + balls.radii[b]) / length) / (2 * length);
    const Point_3 direction{(q.y - p.y) / length, (p.x - q.x) / length, 0};
    const int v = static_cast<int>(set.vertices.size());
    set.vertices.push_back(lifted(Point_2{p.x + along * (q.x - p.x), p.y + along * (q.y - p.y)}));
    set.rays.push_back({v, direction});
    set.rays.push_back({v, {-direction.x, -direction.y, 0}});
    set.ids.insert(set.ids.end(), 2, static_cast<std::int64_t>(i - 1));
  }
}

/// The disks at the ends of an edge with this number.
std::array<int, 2> ends_of_edge(const Regular_2& regular, std::int64_t number) {
  if (regular.dimension < 2) return {regular.line[number], regular.line[number + 1]};
  return regular.edge(static_cast<int>(number / 3), static_cast<int>(number % 3));
}

Element_description describe_edge(Context& context, std::size_t element, bool as_power_edge) {
  const auto regular = context.get(regular_2_key);
  const Primitive_set set = as_power_edge && regular->dimension == 2
                                ? power_diagram_primitives(*regular, *context.get(power_vertices_2_key))
                            : as_power_edge ? power_diagram_primitives(*regular, {})
                                            : regular_triangulation_primitives(*regular);
  Element_description description;
  if (element >= set.element_count()) return description;
  const auto ends = ends_of_edge(*regular, set.id(element));
  const Balls_2& balls = *regular->balls;
  description.facts.push_back({"between disks", enumeration(ends)});
  description.facts.push_back(
      {"radii", format_number(balls.radii[ends[0]]) + " and " + format_number(balls.radii[ends[1]])});
  description.facts.push_back(
      fact("distance of the centers", distance(balls.centers[ends[0]], balls.centers[ends[1]])));
  for (const int ball : ends) add_disk(description.dual, balls.centers[ball], balls.radii[ball]);
  if (as_power_edge) add_segment(description.dual, balls.centers[ends[0]], balls.centers[ends[1]]);
  return description;
}

Primitive_set hidden_layer(Context& context) {
  const auto regular = context.get(regular_2_key);
  const Balls_2& balls = *regular->balls;
  Primitive_set set;
  Values radius{"radius", "units of the input", {}};
  for (std::size_t b = 0; b < balls.size(); ++b) {
    if (regular->is_hidden[b] == 0) continue;
    add_disk(set, balls.centers[b], balls.radii[b]);
    set.ids.push_back(static_cast<std::int64_t>(b));
    radius.data.push_back(balls.radii[b]);
  }
  set.values.push_back(std::move(radius));
  return set;
}

}  // namespace

Primitive_set regular_triangulation_primitives(const Regular_2& regular) {
  Primitive_set set;
  set.vertices = lifted(regular.balls->centers);
  set.is_complex = true;
  for (std::size_t i = 1; i < regular.line.size(); ++i) {
    set.segments.push_back({regular.line[i - 1], regular.line[i]});
    set.ids.push_back(static_cast<std::int64_t>(i - 1));
  }
  for (int t = 0; t < static_cast<int>(regular.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!regular.edge_is_listed(t, i)) continue;
      set.segments.push_back(regular.edge(t, i));
      set.ids.push_back(edge_number(t, i));
    }
  }
  return set;
}

Primitive_set power_diagram_primitives(const Regular_2& regular, const Power_vertices_2& power) {
  Primitive_set set;
  if (regular.dimension < 2) {
    add_radical_axes(set, regular);
    return set;
  }
  set.vertices = lifted(power.vertices);
  std::vector<std::int64_t> ray_ids;
  for (int t = 0; t < static_cast<int>(regular.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!regular.edge_is_listed(t, i)) continue;
      if (const int u = regular.neighbors[t][i]; u >= 0) {
        set.segments.push_back({t, u});
        set.ids.push_back(edge_number(t, i));
        continue;
      }
      const auto [a, b] = regular.edge(t, i);
      const Point_2& p = regular.balls->centers[a];
      const Point_2& q = regular.balls->centers[b];
      const double length = distance(p, q);
      set.rays.push_back({t, {(q.y - p.y) / length, (p.x - q.x) / length, 0}});
      ray_ids.push_back(edge_number(t, i));
    }
  }
  set.ids.insert(set.ids.end(), ray_ids.begin(), ray_ids.end());
  return set;
}

void register_regular_2(Registry& registry) {
  registry.begin_module({"regular-2", "Power diagram", "Which disk is nearest in the power distance."});
  registry.add_structure<Regular_2>(regular_2_key, [](Context& context) {
    return regular_triangulation(context.get(balls_2_key), context.progress());
  });
  registry.add_structure<Power_vertices_2>(power_vertices_2_key, [](Context& context) {
    return power_vertices(*context.get(regular_2_key), context.progress());
  });
  constexpr const char* paper = " [H. Edelsbrunner, N. Shah 1996; CGAL, 2D Regular Triangulations]";
  {
    Layer_spec layer;
    layer.id = "hidden-balls";
    layer.label = "Hidden balls";
    layer.stage = "Power diagram";
    layer.help =
        "The disks without a power cell: everywhere some other disk is nearer in the power distance. They add nothing "
        "to the union.";
    layer.style = look({190, 60, 60}, 1.5);
    layer.build = hidden_layer;
    layer.describe = [](Context& context, std::size_t element) {
      const auto regular = context.get(regular_2_key);
      for (std::size_t b = 0; b < regular->is_hidden.size(); ++b)
        if (regular->is_hidden[b] != 0 && element-- == 0) return describe_ball(*regular->balls, b);
      return Element_description{};
    };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "regular-triangulation";
    layer.label = "Regular triangulation";
    layer.stage = "Power diagram";
    layer.help =
        std::string("Joins the centers of two disks iff their power cells share an edge: dual to the power diagram.") +
        paper;
    layer.style = look({120, 130, 200}, 1);
    layer.build = [](Context& context) {
      const auto regular = context.get(regular_2_key);
      if (regular->dimension < 1) throw Unavailable("needs at least 2 disks with different centers");
      return regular_triangulation_primitives(*regular);
    };
    layer.describe = [](Context& context, std::size_t element) { return describe_edge(context, element, false); };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "power-diagram";
    layer.label = "Power diagram";
    layer.stage = "Power diagram";
    layer.help = std::string(
                     "Gives every point to the disk to which its power distance |x - c|^2 - r^2 is least: convex "
                     "cells.") +
                 paper;
    layer.style = look({150, 155, 165}, 1);
    layer.build = [](Context& context) {
      const auto regular = context.get(regular_2_key);
      if (regular->dimension < 1) throw Unavailable("needs at least 2 disks with different centers");
      if (regular->dimension < 2) return power_diagram_primitives(*regular, {});
      return power_diagram_primitives(*regular, *context.get(power_vertices_2_key));
    };
    layer.describe = [](Context& context, std::size_t element) { return describe_edge(context, element, true); };
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/power_crust_2/module.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/graph.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/primitives_2.h"
#include "geometries/samples_2/module.h"

namespace mesecina {

namespace {

constexpr const char* paper = " [N. Amenta, S. Choi, R. Kolluri: The power crust, 2001]";

Polar_balls_2 compute_polar_balls(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  if (triangulation->dimension < 2) throw Unavailable("needs at least 3 samples that are not on one line");
  const auto voronoi = context.get(voronoi_2_key);
  Progress& progress = context.progress();
  const auto poles = std::make_shared<const Poles_2>(find_poles(*triangulation, *voronoi, progress));
  const auto regular = std::make_shared<const Regular_2>(regular_triangulation(poles->balls, progress));
  Polar_balls_2 polar = label_poles(poles, regular, progress);
  if (polar.unlabelled_count > 0)
    context.warn(std::to_string(polar.unlabelled_count) + " of " + std::to_string(poles->size()) +
                 " poles have nothing to tell on which side they are; they count as outer");
  if (!polar.contradictions.empty())
    context.warn("both poles are on one side at " + std::to_string(polar.contradictions.size()) +
                     " samples: the curve is open, noisy, too sparsely sampled or sharp there",
                 sample_places(context, polar.contradictions));
  return polar;
}

/// Vertices of a layer, each taken over from an array when it is first used.
class Used_vertices {
 public:
  explicit Used_vertices(std::size_t count) : numbers_(count, -1) {}
  int use(Primitive_set& set, const std::vector<Point_2>& points, int index) {
    int& number = numbers_[index];
    if (number < 0) {
      number = static_cast<int>(set.vertices.size());
      set.vertices.push_back(lifted(points[index]));
    }
    return number;
  }

 private:
  std::vector<int> numbers_;
};

double lesser_confidence(const Polar_balls_2& polar, std::span<const int> poles) {
  double least = 1;
  for (const int pole : poles) least = std::min(least, polar.confidence[pole]);
  return least;
}

/// From its sample away from the shape.
Point_2 direction_to_infinity(const Poles_2& poles, int pole) {
  const Point_2& sample = (*poles.balls->samples)[poles.samples_of(pole).front()];
  const Point_2& center = poles.balls->centers[pole];
  const double length = distance(sample, center);
  return {(center.x - sample.x) / length, (center.y - sample.y) / length};
}

/// The finite poles of one side that have a label.
std::vector<int> poles_of_side(const Polar_balls_2& polar, bool inner) {
  std::vector<int> result;
  for (int p = 0; p < static_cast<int>(polar.poles->finite_count()); ++p)
    if (polar.confidence[p] > 0 && (polar.is_inner[p] != 0) == inner) result.push_back(p);
  return result;
}

Primitive_set pole_layer(Context& context, bool inner, bool as_disks) {
  const auto polar = context.get(polar_balls_2_key);
  const Balls_2& balls = *polar->poles->balls;
  Primitive_set set;
  Values radius{"radius", "units of the input", {}};
  Values confidence{"confidence", "", {}};
  for (const int pole : poles_of_side(*polar, inner)) {
    if (as_disks) {
      add_disk(set, balls.centers[pole], balls.radii[pole]);
    } else {
      add_point(set, balls.centers[pole]);
    }
    set.ids.push_back(polar->poles->triangles[pole]);
    radius.data.push_back(balls.radii[pole]);
    confidence.data.push_back(polar->confidence[pole]);
  }
  set.values = {std::move(radius), std::move(confidence)};
  return set;
}

/// "1, 2 and 3", or the first of them and how many more there are.
std::string short_enumeration(std::span<const int> numbers) {
  constexpr std::size_t most = 12;
  if (numbers.size() <= most) return enumeration(numbers);
  std::string text;
  for (const int number : numbers.first(most)) text += std::to_string(number) + ", ";
  return text + "and " + std::to_string(numbers.size() - most) + " more";
}

Element_description describe_pole(Context& context, std::size_t element, bool inner) {
  const auto polar = context.get(polar_balls_2_key);
  const std::vector<int> shown = poles_of_side(*polar, inner);
  Element_description description;
  if (element >= shown.size()) return description;
  const int pole = shown[element];
  const Poles_2& poles = *polar->poles;
  const Balls_2& balls = *poles.balls;
  for (const bool first : {true, false}) {
    std::vector<int> samples;
    for (const int s : poles.samples_of(pole))
      if ((poles.first[s] == pole) == first) samples.push_back(s);
    if (!samples.empty())
      description.facts.push_back(
          {first ? "first pole of samples" : "second pole of samples", short_enumeration(samples)});
  }
  description.facts.push_back(fact("center", balls.centers[pole]));
  if (polar->regular->is_hidden[pole] != 0) description.facts.push_back({"power cell", "none: hidden"});
  add_disk(description.dual, balls.centers[pole], balls.radii[pole]);
  for (const int s : poles.samples_of(pole)) add_point(description.dual, (*balls.samples)[s]);
  return description;
}

/// Edges of the regular triangulation between finite poles, then those with one end at infinity.
std::vector<Regular_edge> finite_edges(const Polar_balls_2& polar) {
  std::vector<Regular_edge> result;
  for (const bool with_infinite : {false, true}) {
    for (int t = 0; t < static_cast<int>(polar.regular->triangles.size()); ++t) {
      for (int i = 0; i < 3; ++i) {
        if (!polar.regular->edge_is_listed(t, i)) continue;
        const auto [a, b] = polar.regular->edge(t, i);
        if (polar.poles->is_infinite(a) && polar.poles->is_infinite(b)) continue;
        if ((polar.poles->is_infinite(a) || polar.poles->is_infinite(b)) == with_infinite) result.push_back({t, i});
      }
    }
  }
  return result;
}

Primitive_set triangulation_layer(Context& context) {
  const auto polar = context.get(polar_balls_2_key);
  Primitive_set set;
  Used_vertices vertices(polar->poles->finite_count());
  const auto vertex = [&](int pole) { return vertices.use(set, polar->poles->balls->centers, pole); };
  for (const auto& [t, i] : finite_edges(*polar)) {
    const auto [a, b] = polar->regular->edge(t, i);
    set.ids.push_back(edge_id(t, i));
    if (!polar->poles->is_infinite(a) && !polar->poles->is_infinite(b)) {
      set.segments.push_back({vertex(a), vertex(b)});
    } else {
      const int finite = std::min(a, b);
      set.rays.push_back({vertex(finite), lifted(direction_to_infinity(*polar->poles, std::max(a, b)))});
    }
  }
  return set;
}

/// Of the power edge of an edge on the hull of the regular triangulation.
Point_2 power_ray_direction(const Polar_balls_2& polar, const Regular_edge& edge) {
  const auto [a, b] = polar.regular->edge(edge.triangle, edge.corner);
  const Point_2& p = polar.poles->balls->centers[a];
  const Point_2& q = polar.poles->balls->centers[b];
  const double length = distance(p, q);
  // Centers at infinity of nearly equal samples may be equal after rounding.
  if (length == 0) return direction_to_infinity(*polar.poles, std::max(a, b));
  return {(q.y - p.y) / length, (p.x - q.x) / length};
}

Primitive_set power_edge_layer(const Polar_balls_2& polar, const Polar_diagram_2& diagram,
                               const std::vector<Regular_edge>& edges) {
  Primitive_set set;
  Used_vertices vertices(diagram.vertices.size());
  const auto vertex = [&](int triangle) {
    return vertices.use(set, diagram.vertices, diagram.vertex_of_triangle[triangle]);
  };
  Values confidence{"confidence", "", {}};
  for (const Regular_edge& edge : edges) {
    set.ids.push_back(edge_id(edge.triangle, edge.corner));
    confidence.data.push_back(lesser_confidence(polar, polar.regular->edge(edge.triangle, edge.corner)));
    if (const int other = polar.regular->neighbors[edge.triangle][edge.corner]; other >= 0) {
      set.segments.push_back({vertex(edge.triangle), vertex(other)});
    } else {
      set.rays.push_back({vertex(edge.triangle), lifted(power_ray_direction(polar, edge))});
    }
  }
  set.values.push_back(std::move(confidence));
  return set;
}

std::string name_of_pole(const Polar_balls_2& polar, int pole) {
  if (polar.poles->is_infinite(pole))
    return "outer, at infinity, of sample " + std::to_string(polar.poles->samples_of(pole).front());
  return (polar.confidence[pole] == 0 ? "without a label, "
          : polar.is_inner[pole] != 0 ? "inner, "
                                      : "outer, ") +
         ("radius " + format_number(polar.poles->balls->radii[pole]));
}

void add_pole(Primitive_set& set, const Polar_balls_2& polar, int pole) {
  const Balls_2& balls = *polar.poles->balls;
  if (!polar.poles->is_infinite(pole)) {
    add_disk(set, balls.centers[pole], balls.radii[pole]);
    return;
  }
  const int sample = static_cast<int>(set.vertices.size());
  add_point(set, (*balls.samples)[polar.poles->samples_of(pole).front()]);
  set.rays.push_back({sample, lifted(direction_to_infinity(*polar.poles, pole))});
}

Element_description describe_edge(const Polar_balls_2& polar, const Regular_edge& edge) {
  const auto [a, b] = polar.regular->edge(edge.triangle, edge.corner);
  Element_description description;
  description.facts.push_back({"one pole", name_of_pole(polar, a)});
  description.facts.push_back({"other pole", name_of_pole(polar, b)});
  const double cosine = -intersection_cosine(*polar.poles->balls, a, b);
  if (std::abs(cosine) <= 1)
    description.facts.push_back(fact("disks meet at", std::acos(cosine) * (180 / std::numbers::pi), "degrees"));
  description.facts.push_back(
      {"confidence", format_number(polar.confidence[a]) + " and " + format_number(polar.confidence[b])});
  add_pole(description.dual, polar, a);
  add_pole(description.dual, polar, b);
  return description;
}

/// For layers whose elements are edges, in the order that `list` gives them.
template <class List>
auto describe_listed_edge(const List& list) {
  return [list](Context& context, std::size_t element) {
    const auto polar = context.get(polar_balls_2_key);
    const std::vector<Regular_edge> edges = list(context, *polar);
    return element < edges.size() ? describe_edge(*polar, edges[element]) : Element_description{};
  };
}

std::vector<Regular_edge> diagram_edges(Context& context, const Polar_balls_2& polar) {
  return power_edges(polar, *context.get(polar_power_diagram_2_key));
}

std::vector<Regular_edge> crust_edges(Context& context, const Polar_balls_2& polar) {
  return power_crust(polar, *context.get(polar_power_diagram_2_key));
}

Primitive_set crust_layer(Context& context) {
  const auto polar = context.get(polar_balls_2_key);
  Primitive_set set = power_edge_layer(*polar, *context.get(polar_power_diagram_2_key), crust_edges(context, *polar));
  if (set.is_empty()) throw Unavailable("no pole lies inside: the samples enclose nothing (is the curve closed?)");
  set.is_complex = true;
  return set;
}

Primitive_set shape_layer(Context& context) {
  const auto polar = context.get(polar_balls_2_key);
  const Power_shape_2 shape = power_shape(*polar);
  Primitive_set set;
  set.is_complex = true;
  Values confidence{"confidence", "", {}};
  Used_vertices vertices(polar->poles->finite_count());
  const auto vertex = [&](int pole) { return vertices.use(set, polar->poles->balls->centers, pole); };
  for (const int pole : shape.isolated) {
    set.points.push_back(vertex(pole));
    confidence.data.push_back(polar->confidence[pole]);
  }
  for (const auto& edge : shape.edges) {
    set.segments.push_back({vertex(edge[0]), vertex(edge[1])});
    confidence.data.push_back(lesser_confidence(*polar, edge));
  }
  for (const auto& triangle : shape.triangles) {
    set.triangles.push_back({vertex(triangle[0]), vertex(triangle[1]), vertex(triangle[2])});
    confidence.data.push_back(lesser_confidence(*polar, triangle));
  }
  if (set.is_empty()) throw Unavailable("no pole lies inside: the samples enclose nothing (is the curve closed?)");
  set.values.push_back(std::move(confidence));
  return set;
}

void add_pole_layers(Registry& registry, bool inner) {
  const std::string side = inner ? "inner" : "outer";
  const std::string title = inner ? "Inner" : "Outer";
  const Color color = inner ? Color{205, 105, 40} : Color{70, 130, 150};
  {
    Layer_spec layer;
    layer.id = side + "-polar-disks";
    layer.label = title + " polar disks";
    layer.stage = "Power crust";
    layer.help =
        (inner ? "The disks around the inner poles that touch their samples; their union approximates the shape."
               : "The disks around the outer poles that touch their samples; with the half-planes outside of "
                 "the hull their union approximates the complement of the shape.") +
        std::string(paper);
    layer.style = look(color, 1);
    layer.style.opacity = 0.6;
    layer.build = [inner](Context& context) { return pole_layer(context, inner, true); };
    layer.describe = [inner](Context& context, std::size_t e) { return describe_pole(context, e, inner); };
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = side + "-poles";
    layer.label = title + " poles";
    layer.stage = "Power crust";
    layer.help =
        "The poles " + std::string(inner ? "inside" : "outside") +
        " of the shape. Poles of a sample: the farthest vertex of its Voronoi cell, and the farthest one on the "
        "other side of the sample." +
        paper;
    layer.style = look(color);
    layer.style.point_size = 4;
    layer.build = [inner](Context& context) { return pole_layer(context, inner, false); };
    layer.describe = [inner](Context& context, std::size_t e) { return describe_pole(context, e, inner); };
    registry.add_layer(std::move(layer));
  }
}

}  // namespace

void register_power_crust_2(Registry& registry) {
  registry.begin_module(
      {"power-crust-2", "Power crust", "Curve and shape between the inner and the outer poles of the samples."});
  registry.add_structure<Polar_balls_2>(polar_balls_2_key, compute_polar_balls);
  registry.add_structure<Polar_diagram_2>(polar_power_diagram_2_key, [](Context& context) {
    return polar_power_diagram(*context.get(polar_balls_2_key), context.progress());
  });
  {
    Layer_spec layer;
    layer.id = "power-shape";
    layer.label = "Power shape";
    layer.stage = "Power crust";
    layer.help = std::string(
                     "The triangles, edges and vertices of the regular triangulation of the poles between inner poles "
                     "alone: a complex with the topology of the shape, near its medial axis.") +
                 paper;
    layer.style = look({140, 50, 100}, 2);
    layer.style.filled = true;
    layer.style.opacity = 0.8;
    layer.build = shape_layer;
    registry.add_layer(std::move(layer));
  }
  add_pole_layers(registry, false);
  add_pole_layers(registry, true);
  {
    Layer_spec layer;
    layer.id = "polar-triangulation";
    layer.label = "Polar triangulation";
    layer.stage = "Power crust";
    layer.help = std::string(
                     "The regular triangulation of the polar disks. Rays go to the poles at infinity, those of the "
                     "samples on the hull.") +
                 paper;
    layer.style = look({170, 150, 180}, 1);
    layer.build = triangulation_layer;
    layer.describe = describe_listed_edge([](Context&, const Polar_balls_2& polar) { return finite_edges(polar); });
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "polar-power-diagram";
    layer.label = "Polar power diagram";
    layer.stage = "Power crust";
    layer.help =
        std::string("The power diagram of the polar disks; beyond the hull that of the half-planes outside of it.") +
        paper;
    layer.style = look({140, 165, 160}, 1);
    layer.build = [](Context& context) {
      const auto polar = context.get(polar_balls_2_key);
      return power_edge_layer(*polar, *context.get(polar_power_diagram_2_key), diagram_edges(context, *polar));
    };
    layer.describe = describe_listed_edge(diagram_edges);
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "power-crust";
    layer.label = "Power crust";
    layer.stage = "Power crust";
    layer.help =
        std::string(
            "The edges of the power diagram of the poles between inner and outer ones: closed polygons through the "
            "samples of a densely sampled curve.") +
        paper;
    layer.style = look({60, 60, 170}, 2);
    layer.build = crust_layer;
    layer.describe = describe_listed_edge(crust_edges);
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina

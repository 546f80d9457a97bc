// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/power_crust_3/module.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/delaunay_3/module.h"
#include "geometries/primitives_3.h"

namespace mesecina {

namespace {

constexpr const char* paper =
    " [N. Amenta, S. Choi, R. Kolluri: The power crust, unions of balls, and the medial axis transform, 2001]";
constexpr const char* nothing_inside = "no pole lies inside: the points enclose nothing (is the surface closed?)";

/// Where these samples are; those that the user gave as points are elements of these.
std::vector<Place> sample_places(Context& context, std::span<const Point_3> points, std::span<const int> samples) {
  const bool is_cloud = !context.input(mesh_input);
  std::vector<Place> places;
  for (const int sample : samples) {
    if (places.size() == most_places) break;
    places.push_back({points[sample], is_cloud ? std::string(cloud_input.id) : std::string(),
                      is_cloud ? static_cast<std::size_t>(sample) : 0});
  }
  return places;
}

Polar_balls_3 compute_polar_balls(Context& context) {
  Progress& progress = context.progress();
  const std::vector<Point_3> points = sample_points(context);
  const auto poles = std::make_shared<const Poles_3>(find_poles(points, progress));
  const auto regular = std::make_shared<const Regular_3>(regular_triangulation(poles->balls, progress));
  Polar_balls_3 polar = label_poles(poles, regular, progress);
  warn_of_duplicates(context, static_cast<std::size_t>(std::ranges::count(poles->first, -1)), poles->sample_count);
  if (polar.unlabelled_count > 0)
    context.warn(std::to_string(polar.unlabelled_count) + " of " + std::to_string(poles->size()) +
                 " poles have nothing to tell on which side they are; they count as outer");
  if (!polar.contradictions.empty())
    context.warn("both poles are on one side at " + std::to_string(polar.contradictions.size()) +
                     " samples: the surface is open, noisy, too sparsely sampled or sharp there",
                 sample_places(context, points, polar.contradictions));
  return polar;
}

double lesser_confidence(const Polar_balls_3& polar, std::span<const int> poles) {
  double least = 1;
  for (const int pole : poles) least = std::min(least, polar.confidence[pole]);
  return least;
}

Primitive_set pole_layer(Context& context, bool inner) {
  const auto polar = context.get(polar_balls_3_key);
  std::vector<Ball_3> balls;
  Values sample{"sample", "", {}};
  Values confidence{"confidence", "", {}};
  std::vector<std::int64_t> ids;
  for (int p = 0; p < static_cast<int>(polar->poles->finite_count); ++p) {
    if (polar->confidence[p] == 0 || (polar->is_inner[p] != 0) != inner) continue;
    balls.push_back(polar->poles->balls[p]);
    sample.data.push_back(polar->poles->samples_of(p).front());
    confidence.data.push_back(polar->confidence[p]);
    ids.push_back(p);
  }
  Primitive_set set = ball_primitives(balls);
  set.values.push_back(std::move(sample));
  set.values.push_back(std::move(confidence));
  set.ids = std::move(ids);
  return set;
}

/// Both poles of each sample that has two, as segments from the sample; those at infinity are left out.
Primitive_set pair_layer(Context& context) {
  const auto polar = context.get(polar_balls_3_key);
  const Poles_3& poles = *polar->poles;
  Primitive_set set = primitives_in_space();
  Values confidence{"confidence", "", {}};
  Values inside{"inside", "", {}};
  Values radius{"radius", "units of the input", {}};
  for (int s = 0; s < static_cast<int>(poles.sample_count); ++s) {
    if (poles.first[s] < 0 || poles.second[s] < 0) continue;
    const double sure = std::max(0.0, -intersection_cosine(poles, poles.first[s], poles.second[s]));
    const int sample = static_cast<int>(set.vertices.size());
    set.vertices.push_back(poles.points[s]);
    for (const int pole : {poles.first[s], poles.second[s]}) {
      if (poles.is_infinite(pole)) continue;
      set.segments.push_back({sample, static_cast<int>(set.vertices.size())});
      set.vertices.push_back(poles.balls[pole].center);
      confidence.data.push_back(sure);
      inside.data.push_back(polar->is_inner[pole]);
      radius.data.push_back(poles.balls[pole].radius);
      set.ids.push_back(s);
    }
  }
  set.values = {std::move(confidence), std::move(inside), std::move(radius)};
  return set;
}

Primitive_set conflict_layer(Context& context) {
  const auto polar = context.get(polar_balls_3_key);
  std::vector<Point_3> samples;
  for (const int s : polar->contradictions) samples.push_back(polar->poles->points[s]);
  Primitive_set set = point_primitives(std::move(samples));
  set.ids.assign(polar->contradictions.begin(), polar->contradictions.end());
  return set;
}

Primitive_set crust_layer(Context& context) {
  const auto polar = context.get(polar_balls_3_key);
  const auto crust = context.get(power_crust_3_key);
  if (crust->face_count() == 0) throw Unavailable(nothing_inside);
  Primitive_set set = primitives_in_space();
  set.vertices = crust->vertices;
  set.polygon_offsets = crust->face_offsets;
  set.polygon_vertices = crust->face_vertices;
  set.is_complex = true;
  Values confidence{"confidence", "", {}};
  for (const auto& poles : crust->poles) confidence.data.push_back(lesser_confidence(*polar, poles));
  set.values.push_back(std::move(confidence));
  return select(set, std::vector<bool>(set.element_count(), true));
}

Primitive_set shape_layer(Context& context) {
  const auto polar = context.get(polar_balls_3_key);
  const auto shape = context.get(power_shape_3_key);
  Primitive_set set = primitives_in_space();
  Values confidence{"confidence", "", {}};
  for (const Ball_3& ball : shape->regular->balls) set.vertices.push_back(ball.center);
  for (int v = 0; v < static_cast<int>(shape->vertices.size()); ++v) {
    if (shape->vertices[v] != Simplex_kind_3::singular) continue;
    set.points.push_back(v);
    confidence.data.push_back(polar->confidence[v]);
  }
  for (const Dual_3::Edge& edge : shape->edges) {
    set.segments.push_back(edge.balls);
    confidence.data.push_back(lesser_confidence(*polar, edge.balls));
  }
  for (const Dual_3::Triangle& triangle : shape->triangles) {
    set.triangles.push_back(triangle.balls);
    confidence.data.push_back(lesser_confidence(*polar, triangle.balls));
  }
  if (set.is_empty()) throw Unavailable(nothing_inside);
  set.values.push_back(std::move(confidence));
  set.is_complex = true;
  set = select(set, std::vector<bool>(set.element_count(), true));
  set.known_topology = topology(*shape);
  return set;
}

}  // namespace

void register_power_crust_3(Registry& registry) {
  registry.begin_module(
      {"power-crust-3", "Power crust", "Surface and shape between the inner and the outer poles of the samples."});
  registry.add_structure<Polar_balls_3>(polar_balls_3_key, compute_polar_balls);
  registry.add_structure<Power_crust_3>(power_crust_3_key, [](Context& context) {
    return power_crust(*context.get(polar_balls_3_key), context.progress());
  });
  registry.add_structure<Dual_3>(power_shape_3_key, [](Context& context) {
    return power_shape(*context.get(polar_balls_3_key), context.progress());
  });
  const char* stage = "Power crust";
  const std::string poles =
      " of the shape, as balls that touch their samples, the first of which is their value. Poles of a sample: the "
      "farthest vertex of its Voronoi cell, and the farthest one on the other side of the sample.";
  registry.add_layer(
      make_layer("power-shape", "Power shape", stage,
                 (std::string("The tetrahedra, triangles, edges and vertices of the regular triangulation of the poles "
                              "between inner poles alone: a complex with the topology of the shape, near its medial "
                              "axis. Its tetrahedra are not drawn, but count.") +
                  paper)
                     .c_str(),
                 {140, 50, 100}, shape_layer));
  registry.add_layer(make_layer(
      "outer-poles", "Outer poles", stage,
      ("The poles outside" + poles + " Those at infinity, of samples on the convex hull, are not shown." + paper)
          .c_str(),
      {70, 130, 150}, [](Context& context) { return pole_layer(context, false); }));
  registry.add_layer(make_layer("inner-poles", "Inner poles", stage, ("The poles inside" + poles + paper).c_str(),
                                {205, 105, 40}, [](Context& context) { return pole_layer(context, true); }));
  registry.add_layer(make_layer("power-crust", "Power crust", stage,
                                (std::string("The faces of the power diagram of the poles between inner and outer "
                                             "ones: a closed surface through the samples of a densely sampled one.") +
                                 paper)
                                    .c_str(),
                                {60, 60, 170}, crust_layer));
  Layer_spec pairs = make_layer(
      "polar-pairs", "Polar pairs", stage,
      (std::string("The two poles of each sample, joined to it by segments whose id is the sample: their direction is "
                   "about that of the normal. Values are the confidence, minus the cosine of the angle between the "
                   "poles as the sample sees them (1 where they are opposite, 0 where the angle is not obtuse), "
                   "whether the pole is inside (1) or outside (0), and its radius. Poles at infinity are not shown.") +
       paper)
          .c_str(),
      {150, 140, 60}, pair_layer);
  pairs.style.line_width = 1;
  pairs.style.value = "confidence";
  registry.add_layer(std::move(pairs));
  Layer_spec conflicts = make_layer("label-conflicts", "Label conflicts", stage,
                                    "Samples with both poles on one side: the surface is open, noisy, too sparsely "
                                    "sampled or sharp there. Empty for a densely sampled smooth closed surface.",
                                    {215, 30, 50}, conflict_layer);
  conflicts.style.point_size = 8;
  registry.add_layer(std::move(conflicts));
}

}  // namespace mesecina

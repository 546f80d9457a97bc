// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/balls_2/module.h"

#include <numeric>

#include "core/graph.h"
#include "geometries/delaunay_2/module.h"
#include "geometries/labels_2/module.h"
#include "geometries/power_crust_2/module.h"
#include "geometries/primitives_2.h"

namespace mesecina {

Element_description describe_ball(const Balls_2& balls, std::size_t ball) {
  Element_description description;
  if (ball >= balls.size()) return description;
  const int b = static_cast<int>(ball);
  description.facts.push_back(fact("center", balls.centers[ball]));
  description.facts.push_back(fact("radius", balls.radii[ball]));
  const auto contacts = balls.contacts_of(b);
  if (!contacts.empty()) description.facts.push_back({"touches samples", enumeration(contacts)});
  add_disk(description.dual, balls.centers[ball], balls.radii[ball]);
  for (const int sample : contacts) add_point(description.dual, (*balls.samples)[sample]);
  return description;
}

namespace {

Circumscribed_balls_2 compute_inner_voronoi(Context& context) {
  const auto triangulation = context.get(delaunay_2_key);
  const auto voronoi = context.get(voronoi_2_key);
  const auto labels = context.get(labels_2_key);
  auto result = circumscribed_balls(*triangulation, *voronoi, labels->is_inner, context.progress());
  if (result.balls.size() == 0)
    throw Unavailable("no Voronoi vertex lies inside: the samples enclose nothing (is the curve closed?)");
  return result;
}

Balls_2 compute_balls(Context& context) {
  const std::string source = context.setting(ball_source_setting);
  const auto disks = context.input(disks_input);
  const bool has_disks = disks && !disks->empty();
  if (source == ball_source_drawn || (source == ball_source_automatic && has_disks)) {
    if (!has_disks)
      throw Unavailable("there are no disks: draw, generate or open some, or choose another {ball-source}");
    return given_balls(*disks);
  }
  const bool has_samples = context.input(points_input) != nullptr || context.input(outline_input) != nullptr;
  if (!has_samples)
    throw Unavailable(
        source == ball_source_automatic
            ? "there are no disks, and no points or outline to take them from: draw, generate or open some"
            : "there are no points or outline to take disks from: choose another {ball-source}, or draw some");
  if (source == ball_source_inner_poles) {
    const auto triangulation = context.get(delaunay_2_key);
    const auto chosen = context.get(polar_balls_2_key)->inner_triangles(triangulation->triangles.size());
    Balls_2 balls = circumscribed_balls(*triangulation, *context.get(voronoi_2_key), chosen, context.progress()).balls;
    if (balls.size() == 0) throw Unavailable("no pole lies inside: the samples enclose nothing (is the curve closed?)");
    return balls;
  }
  return context.get(inner_voronoi_balls_2_key)->balls;
}

Primitive_set ball_layer(Context& context, bool as_disks) {
  const auto balls = context.get(balls_2_key);
  Primitive_set set;
  set.vertices = lifted(balls->centers);
  for (std::size_t b = 0; b < balls->size(); ++b) {
    if (as_disks) {
      set.balls.push_back({static_cast<int>(b), balls->radii[b]});
    } else {
      set.points.push_back(static_cast<int>(b));
    }
  }
  set.values.push_back({"radius", "units of the input", balls->radii});
  return set;
}

}  // namespace

void register_balls_2(Registry& registry) {
  registry.begin_module({"balls-2", "Balls", "The disks whose union is looked at: drawn, or taken from samples."});
  {
    Setting_spec setting;
    setting.id = ball_source_setting.id;
    setting.label = "Balls from";
    setting.help =
        "Where structures of a union of disks take their disks from. automatic: the drawn disks if there are any, else "
        "the inner Voronoi disks. drawn: the disks that were drawn or read. inner-voronoi: the Voronoi disks of the "
        "samples that are centered inside. inner-poles: those of them that are farthest from some sample.";
    setting.default_value = std::string(ball_source_automatic);
    setting.choices = {std::string(ball_source_automatic), std::string(ball_source_drawn),
                       std::string(ball_source_inner_voronoi), std::string(ball_source_inner_poles)};
    setting.tags = {"union", "disks"};
    registry.add_setting(std::move(setting));
  }
  registry.add_structure<Circumscribed_balls_2>(inner_voronoi_balls_2_key, compute_inner_voronoi);
  registry.add_structure<Balls_2>(balls_2_key, compute_balls);
  const auto describe = [](Context& context, std::size_t element) {
    return describe_ball(*context.get(balls_2_key), element);
  };
  {
    Layer_spec layer;
    layer.id = "balls";
    layer.label = "Balls";
    layer.stage = "Power diagram";
    layer.help = "The disks whose union is looked at, as {ball-source} says.";
    layer.style = look({60, 110, 170}, 1);
    layer.style.opacity = 0.7;
    layer.build = [](Context& context) { return ball_layer(context, true); };
    layer.describe = describe;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "ball-centers";
    layer.label = "Ball centers";
    layer.stage = "Power diagram";
    layer.help = "The centers of the disks whose union is looked at.";
    layer.style = look({40, 80, 140});
    layer.style.point_size = 4;
    layer.build = [](Context& context) { return ball_layer(context, false); };
    layer.describe = describe;
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina

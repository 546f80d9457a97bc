// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/inputs_2/module.h"

#include <utility>

#include "core/graph.h"
#include "geometries/primitives_2.h"

namespace mesecina {

namespace {

Primitive_set point_layer(Context& context) {
  const auto points = context.input(points_input);
  if (!points || points->empty()) throw Unavailable("there are no points: draw, generate or open some");
  Primitive_set set;
  set.vertices = lifted(*points);
  set.points.resize(points->size());
  for (std::size_t i = 0; i < points->size(); ++i) set.points[i] = static_cast<int>(i);
  set.is_complex = true;
  return set;
}

Primitive_set outline_layer(Context& context) {
  const auto outline = context.input(outline_input);
  if (!outline || outline->rings.empty())
    throw Unavailable("there is no outline: draw one or open a polygon or a picture");
  Primitive_set set;
  set.polygon_offsets.push_back(0);
  for (const Ring_2& ring : outline->rings) {
    for (const Point_2& p : ring) {
      set.polygon_vertices.push_back(static_cast<int>(set.vertices.size()));
      set.vertices.push_back(lifted(p));
    }
    set.polygon_offsets.push_back(static_cast<int>(set.polygon_vertices.size()));
  }
  return set;
}

Primitive_set disk_layer(Context& context) {
  const auto disks = context.input(disks_input);
  if (!disks || disks->empty()) throw Unavailable("there are no disks: draw, generate or open some");
  Primitive_set set;
  Values radius{"radius", "units of the input", {}};
  set.vertices.reserve(disks->size());
  set.balls.reserve(disks->size());
  radius.data.reserve(disks->size());
  for (const Disk_2& disk : *disks) {
    add_disk(set, disk.center, disk.radius);
    radius.data.push_back(disk.radius);
  }
  set.values.push_back(std::move(radius));
  return set;
}

Primitive_set image_layer(Context& context) {
  const auto image = context.input(image_input);
  if (!image) throw Unavailable("there is no picture: open one (png, gif, bmp or jpg)");
  Primitive_set set;
  set.image = image;
  return set;
}

Element_description describe_point(Context& context, std::size_t element) {
  const auto points = context.input(points_input);
  Element_description description;
  if (points && element < points->size()) description.facts.push_back(fact("position", (*points)[element]));
  return description;
}

Element_description describe_disk(Context& context, std::size_t element) {
  const auto disks = context.input(disks_input);
  Element_description description;
  if (!disks || element >= disks->size()) return description;
  description.facts.push_back(fact("center", (*disks)[element].center));
  description.facts.push_back(fact("radius", (*disks)[element].radius));
  return description;
}

Element_description describe_ring(Context& context, std::size_t element) {
  const auto outline = context.input(outline_input);
  Element_description description;
  if (!outline || element >= outline->rings.size()) return description;
  const Ring_2& ring = outline->rings[element];
  double length = 0;
  double twice_area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_2& p = ring[i];
    const Point_2& q = ring[(i + 1) % ring.size()];
    length += distance(p, q);
    twice_area += (p.x - ring[0].x) * (q.y - ring[0].y) - (p.y - ring[0].y) * (q.x - ring[0].x);
  }
  description.facts.push_back({"vertices", std::to_string(ring.size())});
  description.facts.push_back(fact("length", length));
  description.facts.push_back(fact("signed area", twice_area / 2));
  return description;
}

}  // namespace

void register_inputs_2(Registry& registry) {
  registry.begin_module({"inputs-2", "Input", "What was drawn, generated or read."});
  {
    Layer_spec layer;
    layer.id = "image";
    layer.label = "Picture";
    layer.stage = "Input";
    layer.help = "The picture that was opened, one unit per pixel. Its silhouette is the outline.";
    layer.style.opacity = 0.5;
    layer.build = image_layer;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "outline";
    layer.label = "Outline";
    layer.stage = "Input";
    layer.help = "The polygons of the shape; inside is what an odd number of rings surround.";
    layer.style = look({60, 64, 72});
    layer.style.visible = true;
    layer.build = outline_layer;
    layer.describe = describe_ring;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "disks";
    layer.label = "Disks";
    layer.stage = "Input";
    layer.help = "The disks that were drawn, generated or read, in their order.";
    layer.style = look({38, 84, 150});
    layer.style.visible = true;
    layer.build = disk_layer;
    layer.describe = describe_disk;
    registry.add_layer(std::move(layer));
  }
  {
    Layer_spec layer;
    layer.id = "points";
    layer.label = "Points";
    layer.stage = "Input";
    layer.help = "The points that were drawn, generated or read, in their order.";
    layer.style = look({30, 30, 34});
    layer.style.visible = true;
    layer.style.point_size = 5;
    layer.build = point_layer;
    layer.describe = describe_point;
    registry.add_layer(std::move(layer));
  }
}

}  // namespace mesecina

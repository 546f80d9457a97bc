// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/formats/number.h"
#include "core/graph.h"
#include "core/primitives.h"
#include "core/registry.h"

namespace mesecina {

inline Primitive_set primitives_in_space() {
  Primitive_set set;
  set.dimension = 3;
  return set;
}

/// Points, each with a vertex of its own.
inline Primitive_set point_primitives(std::vector<Point_3> points) {
  Primitive_set set = primitives_in_space();
  set.vertices = std::move(points);
  set.points.resize(set.vertices.size());
  for (std::size_t i = 0; i < set.points.size(); ++i) set.points[i] = static_cast<int>(i);
  return set;
}

/// Balls with their radius as a value, each with a vertex of its own.
inline Primitive_set ball_primitives(const std::vector<Ball_3>& balls) {
  Primitive_set set = primitives_in_space();
  Values radius{"radius", "units of the input", {}};
  set.vertices.reserve(balls.size());
  set.balls.reserve(balls.size());
  radius.data.reserve(balls.size());
  for (const auto& [center, r] : balls) {
    set.balls.push_back({static_cast<int>(set.vertices.size()), r});
    set.vertices.push_back(center);
    radius.data.push_back(r);
  }
  set.values.push_back(std::move(radius));
  return set;
}

inline Fact fact(std::string name, const Point_3& p) {
  return {std::move(name), "(" + format_number(p.x) + ", " + format_number(p.y) + ", " + format_number(p.z) + ")"};
}

/// A layer in a colour.
inline Layer_spec make_layer(const char* id, const char* label, const char* stage, const char* help, Color color,
                             std::function<Primitive_set(Context&)> build) {
  Layer_spec layer;
  layer.id = id;
  layer.label = label;
  layer.stage = stage;
  layer.help = help;
  layer.style.color = color;
  layer.build = std::move(build);
  return layer;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/samples_2/module.h"

#include <limits>
#include <numeric>

#include "core/graph.h"
#include "geometries/primitives_2.h"

namespace mesecina {

namespace {

Primitive_set sample_layer(Context& context) {
  const auto samples = context.get(samples_2_key);
  Primitive_set set;
  set.vertices = lifted(samples->points);
  set.points.resize(samples->points.size());
  std::iota(set.points.begin(), set.points.end(), 0);
  return set;
}

Element_description describe_sample(Context& context, std::size_t element) {
  const auto samples = context.get(samples_2_key);
  Element_description description;
  if (element < samples->points.size()) description.facts.push_back(fact("position", samples->points[element]));
  return description;
}

}  // namespace

std::vector<Place> sample_places(Context& context, std::span<const int> samples) {
  const auto all = context.get(samples_2_key);
  const auto points = context.input(points_input);
  std::vector<Place> places;
  for (const int sample : samples) {
    if (places.size() == most_places) break;
    const auto number = static_cast<std::size_t>(sample);
    const Point_2& at = all->points[number];
    const bool is_given = points && number < points->size();
    places.push_back({{at.x, at.y, 0}, is_given ? std::string(points_input.id) : std::string(), is_given ? number : 0});
  }
  return places;
}

void register_samples_2(Registry& registry) {
  registry.begin_module({"samples-2", "Sampling", "Points that stand for the shape."});
  {
    Setting_spec setting;
    setting.id = sampling_step_setting.id;
    setting.label = "Sampling step";
    setting.help =
        "Longest piece into which the segments of an outline are cut, as a fraction of the diagonal of its bounding "
        "box. "
        "Smaller: the medial axis follows the outline more closely and takes longer. 0: the vertices alone.";
    setting.unit = "fraction of the diagonal";
    setting.default_value = 0.005;
    setting.minimum = 0;
    setting.maximum = 1;
    setting.tags = {"outline", "density"};
    registry.add_setting(std::move(setting));
  }
  registry.add_structure<Samples_2>(samples_2_key, [](Context& context) {
    Samples_2 samples;
    if (const auto points = context.input(points_input)) samples.points = *points;
    const auto outline = context.input(outline_input);
    if (outline && !outline->rings.empty()) {
      const double step = context.setting(sampling_step_setting) * diagonal(*outline);
      std::vector<Point_2> along = sample_outline(*outline, step > 0 ? step : std::numeric_limits<double>::infinity());
      if (samples.points.empty()) samples.outline = outline;
      samples.points.insert(samples.points.end(), along.begin(), along.end());
    }
    if (samples.points.empty())
      throw Unavailable("there is nothing to sample: draw, generate or open points or an outline");
    return samples;
  });
  Layer_spec layer;
  layer.id = "samples";
  layer.label = "Samples";
  layer.stage = "Input";
  layer.help =
      "The points that every structure starts from: those drawn or read, then those along the outline, as far apart as "
      "{sampling-step} says. Other layers number samples in this order.";
  layer.style = look({90, 96, 104});
  layer.style.point_size = 3;
  layer.build = sample_layer;
  layer.describe = describe_sample;
  registry.add_layer(std::move(layer));
}

}  // namespace mesecina

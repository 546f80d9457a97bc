// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_look.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesecina {

namespace {

constexpr Color missing_color{128, 128, 128};
constexpr int interpolated_texels = 256;

Color_map_texture make_color_map_texture(const Color_map& map) {
  const bool stepped = map.rule() == Color_map::Rule::stepped;
  const int count = stepped ? static_cast<int>(map.stops().size()) : interpolated_texels;
  std::vector<std::uint8_t> rgb;
  for (int i = 0; i < count; ++i) {
    const Color color = stepped ? map.category(i) : map.lookup(static_cast<double>(i) / (count - 1));
    rgb.insert(rgb.end(), {color.red, color.green, color.blue});
  }
  return {Gl_texture::line(rgb), count};
}

}  // namespace

Element_numbers::Element_numbers(const std::vector<double>& values) {
  double smallest = std::numeric_limits<double>::infinity();
  double greatest = -smallest;
  for (double value : values) {
    if (!std::isnan(value)) sorted_.push_back(value);
    if (!std::isfinite(value)) continue;
    smallest = std::min(smallest, value);
    greatest = std::max(greatest, value);
  }
  std::ranges::sort(sorted_);
  sorted_.erase(std::unique(sorted_.begin(), sorted_.end()), sorted_.end());
  if (smallest <= greatest) {
    base_ = smallest;
    const double spread = greatest - smallest;
    // Whole numbers stay whole unless they would not be exact.
    if (std::isfinite(spread) && spread > 0 && (spread > 1e6 || spread < 1)) unit_ = spread;
  }
  pairs_.reserve(2 * values.size());
  for (double value : values) {
    pairs_.push_back(std::isnan(value) ? 0 : shown(value));
    pairs_.push_back(std::isnan(value) ? -1 : lowest_rank(value));
  }
}

float Element_numbers::lowest_rank(double limit) const {
  return static_cast<float>(std::ranges::lower_bound(sorted_, limit) - sorted_.begin());
}

float Element_numbers::highest_rank(double limit) const {
  return static_cast<float>(std::ranges::upper_bound(sorted_, limit) - sorted_.begin()) - 1;
}

const Element_numbers* Layer_numbers::find(const Primitive_set& set, const std::string& name) {
  const auto known = numbers_.find(name);
  if (known != numbers_.end()) return &known->second;
  const Values* values = set.find_values(name);
  if (!values || values->data.size() != set.element_count()) return nullptr;
  return &numbers_.emplace(name, Element_numbers(values->data)).first->second;
}

const Value_range& Layer_numbers::range(const Scene_layer& layer) {
  if (!range_ || !has_same_colors(range_layer_, layer)) {
    range_ = value_range(layer);
    range_layer_ = layer;
    range_layer_.primitives.reset();
  }
  return *range_;
}

bool has_same_colors(const Scene_layer& a, const Scene_layer& b) {
  Style style = a.style;
  style.visible = b.style.visible;
  style.opacity = b.style.opacity;
  style.point_size = b.style.point_size;
  style.line_width = b.style.line_width;
  style.filled = b.style.filled;
  return a.cut == b.cut && style == b.style;
}

const Color_map_texture& Color_map_textures::of(const Color_map& map) {
  const auto known = textures_.find(map.name());
  if (known != textures_.end()) return known->second;
  const auto made = textures_.emplace(map.name(), make_color_map_texture(map)).first;
  uploaded_bytes_ += 3 * static_cast<std::size_t>(made->second.texels);
  return made->second;
}

Gl_look look_of(const Scene_layer& layer, Layer_numbers& numbers_of_set, Color_map_textures& maps) {
  const Primitive_set& set = *layer.primitives;
  const Style& style = layer.style;
  Gl_look look;
  if (layer.cut) {
    if (const Element_numbers* cut = numbers_of_set.find(set, layer.cut->value)) {
      look.cut = layer.cut->value;
      look.lowest_cut_rank = cut->lowest_rank(layer.cut->minimum);
    }
  }
  const Element_numbers* numbers = style.value.empty() ? nullptr : numbers_of_set.find(set, style.value);
  if (!numbers) return look;
  look.threshold = style.value;
  if (style.threshold_minimum || style.threshold_maximum) {
    look.threshold_ranks[0] = style.threshold_minimum ? numbers->lowest_rank(*style.threshold_minimum) : 0;
    if (style.threshold_maximum) look.threshold_ranks[1] = numbers->highest_rank(*style.threshold_maximum);
  }
  const Color_map* map = find_color_map(style.color_map);
  if (!map || map->rule() == Color_map::Rule::solid) return look;
  if (map->rule() == Color_map::Rule::hashed) {
    look.rule = Color_rule::packed_colors;
    return look;
  }
  const Value_range& range = numbers_of_set.range(layer);
  look.number = style.value;
  look.map = &maps.of(*map);
  look.range = {numbers->shown(range.minimum), numbers->shown(range.maximum)};
  look.rule = Color_rule::interpolated_map;
  if (map->rule() == Color_map::Rule::stepped) {
    look.rule = range.whole_numbers ? Color_rule::classes_of_map : Color_rule::stepped_map;
    const double count = look.map->texels;
    double class_of_base = std::fmod(std::round(numbers->base()), count);
    if (class_of_base < 0) class_of_base += count;
    look.class_of_number = {static_cast<float>(numbers->unit()), static_cast<float>(class_of_base)};
  }
  return look;
}

void set_look(Gl_program& program, const Scene_layer& layer, const Gl_look& look) {
  const Style& style = layer.style;
  program.set("threshold_ranks", look.threshold_ranks);
  program.set("lowest_cut_rank", look.lowest_cut_rank);
  program.set("color_rule", static_cast<int>(look.rule));
  program.set("color", to_floats(style.color, style.opacity));
  program.set("missing_color", to_floats(missing_color, style.opacity));
  program.set("range", look.range);
  program.set("reversed", style.color_map_reversed);
  program.set("texels", look.map ? look.map->texels : 2);
  program.set("class_of_number", look.class_of_number);
  program.set("color_map", 0);
  glBindTexture(GL_TEXTURE_1D, look.map ? look.map->texture.id() : 0);
}

std::array<float, 4> to_floats(const Color& color, double alpha) {
  return {color.red / 255.0F, color.green / 255.0F, color.blue / 255.0F, static_cast<float>(alpha)};
}

float packed_color(std::size_t element) {
  const Color color = hashed_color(element);
  return static_cast<float>((color.red << 16) + (color.green << 8) + color.blue);
}

}  // namespace mesecina

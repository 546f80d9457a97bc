// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/color_bars.h"

#include <algorithm>
#include <cmath>

#include "core/formats/number.h"
#include "layers/color_map.h"
#include "layers/scene_shapes.h"

namespace mesecina {
namespace {

constexpr double least_strip_width = 180;
constexpr double strip_height = 10;
constexpr double padding = 8;
constexpr double margin = 10;
constexpr double gap = 4;
/// Room for tick texts that reach beyond the strip.
constexpr double overhang = 8;
/// Pixels, a little more than the font needs.
constexpr double average_character = 0.52 * Color_bar_look::text_size;
constexpr double digit = 0.64 * Color_bar_look::text_size;
constexpr double longest_title = 400;
constexpr long long most_classes = 12;

std::size_t count_characters(std::string_view utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

/// At most `longest` characters, the last an ellipsis if something was cut off.
std::string shortened(const std::string& utf8, std::size_t longest) {
  if (count_characters(utf8) <= longest) return utf8;
  std::size_t end = 0;
  for (std::size_t count = 0; end < utf8.size(); ++end) {
    const bool starts_character = (static_cast<unsigned char>(utf8[end]) & 0xc0) != 0x80;
    if (starts_character && ++count == longest) break;
  }
  return utf8.substr(0, end) + "…";
}

std::string title_of(const Scene_layer& layer, const Values& values) {
  std::string title = layer.label.empty() ? layer.id : layer.label;
  title += ": " + values.name;
  if (!values.unit.empty()) title += " (" + values.unit + ")";
  return title;
}

/// Without the digits that only rounding brought in.
std::string tick_text(double value) {
  if (value == 0) return "0";
  const double magnitude = std::pow(10, 11 - std::floor(std::log10(std::abs(value))));
  const double rounded = std::round(value * magnitude) / magnitude;
  return format_number(std::isfinite(rounded) ? rounded : value);
}

void add_classes(Color_bar& bar, const Color_map& map, const Value_range& range) {
  const auto first = static_cast<long long>(range.minimum);
  const auto count = static_cast<long long>(range.maximum) - first + 1;
  for (long long i = 0; i < count; ++i) {
    const double left = static_cast<double>(i) / static_cast<double>(count);
    const double right = static_cast<double>(i + 1) / static_cast<double>(count);
    bar.stops.push_back({left, map.category(first + i)});
    bar.stops.push_back({right, map.category(first + i)});
    bar.ticks.push_back({(left + right) / 2, std::to_string(first + i)});
  }
}

void add_bands(Color_bar& bar, const Color_map& map, bool reversed) {
  const std::size_t count = map.stops().size();
  for (std::size_t i = 0; i < count; ++i) {
    const double left = static_cast<double>(i) / static_cast<double>(count);
    const double right = static_cast<double>(i + 1) / static_cast<double>(count);
    const Color color = map.lookup(reversed ? 1 - (left + right) / 2 : (left + right) / 2);
    bar.stops.push_back({left, color});
    bar.stops.push_back({right, color});
  }
}

void add_gradient(Color_bar& bar, const Color_map& map, bool reversed) {
  for (const Color_map::Stop& stop : map.stops())
    bar.stops.push_back({reversed ? 1 - stop.position : stop.position, map.lookup(stop.position)});
  if (reversed) std::reverse(bar.stops.begin(), bar.stops.end());
}

Color_bar content_of(const Scene_layer& layer, const Layer_colors& colors) {
  Color_bar bar;
  bar.title = title_of(layer, *colors.values());
  const Value_range& range = colors.range();
  const Color_map& map = *colors.map();
  const bool stepped = map.rule() == Color_map::Rule::stepped;
  if (stepped && range.whole_numbers && range.minimum == std::floor(range.minimum) &&
      range.maximum == std::floor(range.maximum) && range.maximum - range.minimum < most_classes &&
      std::abs(range.minimum) < 1e15) {
    add_classes(bar, map, range);
    return bar;
  }
  if (stepped) {
    add_bands(bar, map, layer.style.color_map_reversed);
  } else {
    add_gradient(bar, map, layer.style.color_map_reversed);
  }
  if (range.minimum == range.maximum) {
    bar.ticks.push_back({0.5, tick_text(range.minimum)});
  } else {
    for (const double value : round_ticks(range.minimum, range.maximum))
      bar.ticks.push_back({(value - range.minimum) / (range.maximum - range.minimum), tick_text(value)});
  }
  return bar;
}

/// Drops ticks whose texts would touch the one before.
void thin_out(std::vector<Color_bar::Tick>& ticks, double strip_width) {
  double free_from = -1e9;
  std::erase_if(ticks, [&](const Color_bar::Tick& tick) {
    const double half = static_cast<double>(tick.text.size()) * digit / 2;
    const double middle = tick.position * strip_width;
    if (middle - half < free_from) return true;
    free_from = middle + half + gap;
    return false;
  });
}

}  // namespace

std::vector<Color_bar> color_bars(const Scene& scene, double width, double height) {
  constexpr double text = Color_bar_look::text_size;
  constexpr double plate_height =
      2 * padding + text + gap + strip_height + Color_bar_look::tick_length + gap / 2 + text;
  std::vector<Color_bar> bars;
  double strip_width = least_strip_width;
  const double widest = width - 2 * (margin + padding + overhang);
  for (const Scene_layer& layer : scene.layers) {
    if (!is_shown(layer)) continue;
    const Layer_colors colors(layer);
    if (!colors.is_by_value()) continue;
    if (widest < strip_width || static_cast<double>(bars.size() + 1) * plate_height > height - 2 * margin) break;
    Color_bar bar = content_of(layer, colors);
    bar.title = shortened(bar.title, static_cast<std::size_t>(std::min(longest_title, widest) / average_character));
    strip_width =
        std::max(strip_width, std::ceil(static_cast<double>(count_characters(bar.title)) * average_character));
    bars.push_back(std::move(bar));
  }
  double bottom = height - margin;
  for (Color_bar& bar : bars) {
    const double top = bottom - plate_height;
    // A frame along the middle of pixels is sharp however it is drawn.
    constexpr double half_pixel = 0.5;
    const double left = std::floor(width - margin - padding - overhang - strip_width) + half_pixel;
    bar.plate = {left - overhang - padding, top, width - margin, bottom};
    bar.title_anchor = {left, top + padding + text * 0.85};
    const double strip_top = std::floor(top + padding + text + gap) + half_pixel;
    bar.strip = {left, strip_top, left + strip_width, strip_top + strip_height};
    bar.tick_base = bar.strip.bottom + Color_bar_look::tick_length + gap / 2 + text * 0.85;
    thin_out(bar.ticks, strip_width);
    bottom = top;
  }
  return bars;
}

Color ink_on(Color ground) {
  const double luminance = 0.2126 * ground.red + 0.7152 * ground.green + 0.0722 * ground.blue;
  return luminance > 128 ? Color{20, 20, 20} : Color{240, 240, 240};
}

std::vector<double> round_ticks(double low, double high) {
  const double width = high - low;
  if (!(width > 0) || !std::isfinite(width)) return {low};
  // Between numbers that differ in their last digits only, no double is rounder than they are.
  constexpr double least_part = 1e-9;
  if (width < least_part * std::max(std::abs(low), std::abs(high))) return {low, high};
  const double power = std::pow(10, std::floor(std::log10(width)));
  for (const double factor : {5.0, 2.5, 2.0, 1.0, 0.5, 0.25, 0.2, 0.1}) {
    const double step = factor * power;
    // Ends that lie on a multiple up to rounding count as ticks.
    const double first = std::ceil(low / step - 1e-9);
    const double last = std::floor(high / step + 1e-9);
    if (last - first < 2) continue;
    std::vector<double> ticks;
    for (double i = first; i <= last; ++i) ticks.push_back(std::clamp(i * step, low, high));
    return ticks;
  }
  return {low, high};
}

}  // namespace mesecina

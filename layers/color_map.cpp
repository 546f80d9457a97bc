// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/color_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "layers/color_map_tables.h"

namespace mesecina {
namespace {

using Kind = Color_map::Kind;
using Rule = Color_map::Rule;
using Stop = Color_map::Stop;

constexpr int hashed_samples = 32;

std::uint8_t to_byte(double component) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(component, 0.0, 1.0) * 255));
}

Color to_color(double red, double green, double blue) { return {to_byte(red), to_byte(green), to_byte(blue)}; }

int hex_digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

std::vector<Stop> parse_stops(std::string_view hex) {
  const std::size_t count = hex.size() / 6;
  std::vector<Stop> stops;
  stops.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto component = [&](std::size_t k) {
      return (16 * hex_digit(hex[6 * i + k]) + hex_digit(hex[6 * i + k + 1])) / 255.0;
    };
    stops.push_back(
        {static_cast<double>(i) / static_cast<double>(count - 1), component(0), component(2), component(4)});
  }
  return stops;
}

Color_map table(std::string name, Kind kind, std::string_view hex) {
  const Rule rule = kind == Kind::categorical ? Rule::stepped : Rule::interpolated;
  return {std::move(name), kind, rule, parse_stops(hex)};
}

Color_map historical(std::string name, std::vector<Stop> stops) {
  return {std::move(name), Kind::historical, Rule::interpolated, std::move(stops)};
}

std::vector<Color_map> make_color_maps() {
  using namespace color_tables;
  std::vector<Color_map> maps;
  maps.push_back(table("viridis", Kind::sequential, viridis_stops));
  maps.push_back(table("magma", Kind::sequential, magma_stops));
  maps.push_back(table("inferno", Kind::sequential, inferno_stops));
  maps.push_back(table("plasma", Kind::sequential, plasma_stops));
  maps.push_back(table("cividis", Kind::sequential, cividis_stops));
  maps.push_back(table("turbo", Kind::sequential, turbo_stops));
  maps.push_back(table("coolwarm", Kind::diverging, coolwarm_stops));
  maps.push_back(table("RdBu", Kind::diverging, rdbu_stops));
  maps.push_back(table("twilight", Kind::cyclic, twilight_stops));
  maps.push_back(table("tab10", Kind::categorical, tab10_stops));
  maps.push_back(table("okabe-ito", Kind::categorical, okabe_ito_stops));
  maps.emplace_back("solid", Kind::historical, Rule::solid, std::vector<Stop>{});
  maps.emplace_back("random", Kind::historical, Rule::hashed, std::vector<Stop>{});
  maps.push_back(historical("autumn", {{0, 1, 0, 0}, {1, 1, 1, 0}}));
  maps.push_back(historical("cool", {{0, 0, 1, 1}, {1, 1, 0, 1}}));
  maps.push_back(historical("copper", {{0, 0, 0, 0}, {0.8, 1, 0.8 * 0.7812, 0.8 * 0.4975}, {1, 1, 0.7812, 0.4975}}));
  maps.push_back(historical("gray", {{0, 0, 0, 0}, {1, 1, 1, 1}}));
  maps.push_back(historical("hot", {{0, 0, 0, 0}, {0.375, 1, 0, 0}, {0.75, 1, 1, 0}, {1, 1, 1, 1}}));
  maps.push_back(historical("hsv", {{0, 1, 0, 0},
                                    {1.0 / 6, 1, 1, 0},
                                    {2.0 / 6, 0, 1, 0},
                                    {0.5, 0, 1, 1},
                                    {4.0 / 6, 0, 0, 1},
                                    {5.0 / 6, 1, 0, 1},
                                    {1, 1, 0, 0}}));
  maps.push_back(historical(
      "jet", {{0, 0, 0, 0.5}, {0.125, 0, 0, 1}, {0.375, 0, 1, 1}, {0.625, 1, 1, 0}, {0.875, 1, 0, 0}, {1, 0.5, 0, 0}}));
  maps.push_back(historical("spring", {{0, 1, 0, 1}, {1, 1, 1, 0}}));
  maps.push_back(historical("summer", {{0, 0, 0.5, 0.4}, {1, 1, 1, 0.4}}));
  maps.push_back(historical("winter", {{0, 0, 0, 1}, {1, 0, 1, 0.5}}));
  return maps;
}

constexpr Color missing_color{128, 128, 128};

Color mapped_color(const Color_map& map, const Style& style, const Values& values, const Value_range& range,
                   std::size_t element) {
  if (map.rule() == Rule::hashed) return hashed_color(element);
  if (element >= values.data.size()) return style.color;
  const double value = values.data[element];
  if (std::isnan(value)) return missing_color;
  if (map.rule() == Rule::stepped && range.whole_numbers && std::isfinite(value))
    return map.category(std::llround(std::clamp(value, -1e15, 1e15)));
  double t = 0.5;
  if (value > range.maximum) {
    t = 1;
  } else if (value < range.minimum) {
    t = 0;
  } else if (range.maximum > range.minimum) {
    t = value / 2 - range.minimum / 2;
    t /= range.maximum / 2 - range.minimum / 2;
  }
  return map.lookup(style.color_map_reversed ? 1 - t : t, missing_color);
}

}  // namespace

Color_map::Color_map(std::string name, Kind kind, Rule rule, std::vector<Stop> stops)
    : name_(std::move(name)), kind_(kind), rule_(rule), stops_(std::move(stops)) {}

Color Color_map::lookup(double t, Color missing) const {
  if (std::isnan(t)) return missing;
  t = std::clamp(t, 0.0, 1.0);
  if (rule_ == Rule::solid) return Style{}.color;
  if (rule_ == Rule::hashed) return hashed_color(static_cast<std::size_t>(t * (hashed_samples - 1)));
  if (rule_ == Rule::stepped) {
    const auto count = static_cast<double>(stops_.size());
    return category(static_cast<long long>(std::min(t * count, count - 1)));
  }
  const auto above =
      std::upper_bound(stops_.begin(), stops_.end(), t, [](double x, const Stop& stop) { return x < stop.position; });
  if (above == stops_.end()) return to_color(stops_.back().red, stops_.back().green, stops_.back().blue);
  const Stop& high = *above;
  const Stop& low = *(above - 1);
  const double f = (t - low.position) / (high.position - low.position);
  return to_color(std::lerp(low.red, high.red, f), std::lerp(low.green, high.green, f),
                  std::lerp(low.blue, high.blue, f));
}

Color Color_map::category(long long i) const {
  if (stops_.empty()) return hashed_color(static_cast<std::size_t>(i));
  const auto count = static_cast<long long>(stops_.size());
  const Stop& stop = stops_[static_cast<std::size_t>(((i % count) + count) % count)];
  return to_color(stop.red, stop.green, stop.blue);
}

const std::vector<Color_map>& color_maps() {
  static const std::vector<Color_map> maps = make_color_maps();
  return maps;
}

const Color_map* find_color_map(std::string_view name) {
  for (const Color_map& map : color_maps())
    if (map.name() == name) return &map;
  return nullptr;
}

Color hashed_color(std::size_t element) {
  // The finalizer of SplitMix64 (Steele, Lea, Flood 2014).
  std::uint64_t bits = static_cast<std::uint64_t>(element) + 0x9e3779b97f4a7c15U;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
  bits ^= bits >> 31;
  const double hue = static_cast<double>(bits & 0xffff) / 65536;
  const double chroma = 0.55 + 0.35 * static_cast<double>((bits >> 16) & 0xff) / 255;
  const double value = 0.65 + 0.25 * static_cast<double>((bits >> 24) & 0xff) / 255;
  const auto component = [&](double offset) {
    double h = hue + offset;
    h -= std::floor(h);
    const double distance = std::abs(6 * h - 3) - 1;
    return value * (1 - chroma * (1 - std::clamp(distance, 0.0, 1.0)));
  };
  return to_color(component(0), component(2.0 / 3), component(1.0 / 3));
}

Value_range value_range(const Scene_layer& layer) {
  const Values* values = layer.primitives ? layer.primitives->find_values(layer.style.value) : nullptr;
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -minimum;
  bool whole = true;
  if (values) {
    const std::vector<bool> drawn = drawn_elements(layer);
    for (std::size_t i = 0; i < values->data.size(); ++i) {
      const double value = values->data[i];
      if (!std::isfinite(value) || (i < drawn.size() && !drawn[i])) continue;
      minimum = std::min(minimum, value);
      maximum = std::max(maximum, value);
      whole = whole && value == std::floor(value);
    }
  }
  Value_range range;
  if (minimum <= maximum) range = {minimum, maximum, whole};
  if (layer.style.range_minimum) range.minimum = *layer.style.range_minimum;
  if (layer.style.range_maximum) range.maximum = *layer.style.range_maximum;
  if (range.maximum < range.minimum) {
    if (layer.style.range_minimum && !layer.style.range_maximum) {
      range.maximum = range.minimum;
    } else if (layer.style.range_maximum && !layer.style.range_minimum) {
      range.minimum = range.maximum;
    } else {
      std::swap(range.minimum, range.maximum);
    }
  }
  return range;
}

Color color_of(const Style& style, const Values* values, const Value_range& range, std::size_t element) {
  const Color_map* map = values ? find_color_map(style.color_map) : nullptr;
  if (!map || map->rule() == Rule::solid) return style.color;
  return mapped_color(*map, style, *values, range, element);
}

Layer_colors::Layer_colors(const Scene_layer& layer) : style_(&layer.style) {
  if (!layer.primitives || layer.style.value.empty()) return;
  const Values* values = layer.primitives->find_values(layer.style.value);
  const Color_map* map = find_color_map(layer.style.color_map);
  if (!values || !map || map->rule() == Rule::solid) return;
  values_ = values;
  map_ = map;
  if (map->rule() != Rule::hashed) range_ = value_range(layer);
}

Color Layer_colors::operator()(std::size_t element) const {
  return map_ ? mapped_color(*map_, *style_, *values_, range_, element) : style_->color;
}

}  // namespace mesecina

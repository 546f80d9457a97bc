// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/canvas_background.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mesecina {

namespace {

constexpr std::array<std::string_view, 4> names = {"paper", "dark", "window", "none"};

/// Relative luminance after WCAG 2.
double luminance(Color color) {
  const auto linear = [](std::uint8_t component) {
    const double c = component / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

/// The lightness l of HSL becomes 1 - l; hue and saturation stay.
Color mirrored_in_lightness(Color color) {
  constexpr int most = 255;
  const auto [least, largest] = std::minmax({color.red, color.green, color.blue});
  const int shift = most - least - largest;
  const auto moved = [shift](std::uint8_t component) { return static_cast<std::uint8_t>(component + shift); };
  return {moved(color.red), moved(color.green), moved(color.blue)};
}

}  // namespace

std::string_view name_of(Canvas_background background) { return names.at(static_cast<std::size_t>(background)); }

std::optional<Canvas_background> background_named(std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Canvas_background>(found - names.begin());
}

Color canvas_color(Canvas_background background, Color window) {
  switch (background) {
    case Canvas_background::dark:
      return {24, 26, 30};
    case Canvas_background::window:
      return window;
    case Canvas_background::paper:
    case Canvas_background::none:
      break;
  }
  return {255, 255, 255};
}

Color visible_on(Color background, Color color) {
  const auto contrast = [&](Color c) {
    const double a = luminance(c) + 0.05;
    const double b = luminance(background) + 0.05;
    return a > b ? a / b : b / a;
  };
  constexpr double least_contrast = 3;
  constexpr double dark_background = 0.2;
  if (luminance(background) > dark_background || contrast(color) >= least_contrast) return color;
  return mirrored_in_lightness(color);
}

void make_visible_on_background(Scene& scene) {
  for (Scene_layer& layer : scene.layers) layer.style.color = visible_on(scene.background, layer.style.color);
}

}  // namespace mesecina

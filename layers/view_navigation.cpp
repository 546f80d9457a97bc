// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/view_navigation.h"

#include <algorithm>
#include <cmath>

namespace mesecina {

namespace {

constexpr double largest_coordinate = 1e100;
constexpr double smallest_scale = 1e-100;
constexpr double largest_scale = 1e100;
/// Pixels per unit in the last place of the centre's coordinates: the plane is a grid of doubles, a quarter pixel fine.
constexpr double pixels_per_ulp = 0.25;
constexpr std::size_t most_entries = 100;
constexpr std::chrono::milliseconds pause_between_gestures{500};

bool is_small_step(const View_2& from, const View_2& to) {
  constexpr double pixels = 200;
  constexpr double factor = 1.5;
  const double zoom = to.scale / from.scale;
  return zoom < factor && zoom > 1 / factor &&
         distance(from.center, to.center) * std::max(from.scale, to.scale) < pixels;
}

}  // namespace

std::optional<View_2> limited(const View_2& view) {
  if (!std::isfinite(view.center.x) || !std::isfinite(view.center.y) || !std::isfinite(view.scale) || !(view.scale > 0))
    return std::nullopt;
  View_2 result = view;
  result.center.x = std::clamp(result.center.x, -largest_coordinate, largest_coordinate);
  result.center.y = std::clamp(result.center.y, -largest_coordinate, largest_coordinate);
  const double farthest = std::max({std::abs(result.center.x), std::abs(result.center.y), 1 / largest_scale});
  const double ulp = std::nextafter(farthest, 2 * farthest) - farthest;
  result.scale = std::clamp(result.scale, smallest_scale, std::min(largest_scale, pixels_per_ulp / ulp));
  return result;
}

View_2 zoomed(const View_2& view, double factor, const Point_2& pixel, double width, double height) {
  View_2 result = view;
  result.scale *= factor;
  const auto allowed = limited(result);
  if (!allowed) return view;
  result.scale = allowed->scale;
  // c + (pixel - middle) / s is the point under the pixel, before and after.
  const double change = 1 / view.scale - 1 / result.scale;
  result.center.x += (pixel.x - width / 2) * change;
  result.center.y += (height / 2 - pixel.y) * change;
  return limited(result).value_or(view);
}

View_2 panned(const View_2& view, double dx, double dy) {
  View_2 result = view;
  result.center.x -= dx / view.scale;
  result.center.y += dy / view.scale;
  return limited(result).value_or(view);
}

void View_history::remember(const View_2& view) {
  if (!views_.empty() && views_.back() == view) return;
  views_.push_back(view);
  if (views_.size() > most_entries) views_.erase(views_.begin());
}

void View_history::begin_gesture(const View_2& view) {
  remember(view);
  in_gesture_ = true;
}

void View_history::end_gesture() {
  in_gesture_ = false;
  last_step_.reset();
}

void View_history::step(const View_2& from, const View_2& to, Time now) {
  if (in_gesture_ || from == to) return;
  if (!is_small_step(from, to)) {
    jump(from, to);
    return;
  }
  const bool goes_on = last_step_ && now - *last_step_ < pause_between_gestures;
  last_step_ = now;
  if (!goes_on) remember(from);
}

void View_history::jump(const View_2& from, const View_2& to) {
  last_step_.reset();
  if (!in_gesture_ && from != to) remember(from);
}

std::optional<View_2> View_history::take(const View_2& current) {
  last_step_.reset();
  while (!views_.empty()) {
    const View_2 view = views_.back();
    views_.pop_back();
    if (view != current) return view;
  }
  return std::nullopt;
}

}  // namespace mesecina

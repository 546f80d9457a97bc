// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/edits_3.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/input_elements.h"

namespace mesecina {

namespace {

template <class T>
std::size_t count_of(const Inputs& inputs, Input_key<std::vector<T>> key) {
  const auto all = inputs.get(key);
  return all ? all->size() : 0;
}

std::vector<std::size_t> numbers(std::size_t first, std::size_t count) {
  std::vector<std::size_t> result(count);
  std::iota(result.begin(), result.end(), first);
  return result;
}

/// Of those that are there.
template <class T>
std::vector<T> chosen(const Inputs& inputs, Input_key<std::vector<T>> key, const std::vector<std::size_t>& selected) {
  std::vector<T> result;
  const auto all = inputs.get(key);
  if (!all) return result;
  result.reserve(selected.size());
  for (const std::size_t i : selected)
    if (i < all->size()) result.push_back((*all)[i]);
  return result;
}

}  // namespace

Selection_3 all_of(const Inputs& inputs, const Reach_3& reach) {
  return {reach.points ? numbers(0, count_of(inputs, cloud_input)) : std::vector<std::size_t>(),
          reach.balls ? numbers(0, count_of(inputs, balls_input)) : std::vector<std::size_t>()};
}

Selection_3 toggled(const Selection_3& first, const Selection_3& second) {
  Selection_3 result;
  std::ranges::set_symmetric_difference(first.points, second.points, std::back_inserter(result.points));
  std::ranges::set_symmetric_difference(first.balls, second.balls, std::back_inserter(result.balls));
  return result;
}

Selection_3 united(const Selection_3& first, const Selection_3& second) {
  Selection_3 result;
  std::ranges::set_union(first.points, second.points, std::back_inserter(result.points));
  std::ranges::set_union(first.balls, second.balls, std::back_inserter(result.balls));
  return result;
}

bool contains(const Selection_3& selection, const Selection_3& part) {
  return std::ranges::includes(selection.points, part.points) && std::ranges::includes(selection.balls, part.balls);
}

Selection_3 restricted(const Selection_3& selection, const Inputs& inputs) {
  Selection_3 result = selection;
  std::erase_if(result.points, [count = count_of(inputs, cloud_input)](std::size_t i) { return i >= count; });
  std::erase_if(result.balls, [count = count_of(inputs, balls_input)](std::size_t i) { return i >= count; });
  return result;
}

std::vector<Point_3> positions(const Inputs& inputs, const Selection_3& selection) {
  std::vector<Point_3> result = chosen(inputs, cloud_input, selection.points);
  for (const Ball_3& ball : selected_balls(inputs, selection)) result.push_back(ball.center);
  return result;
}

std::vector<Ball_3> selected_balls(const Inputs& inputs, const Selection_3& selection) {
  return chosen(inputs, balls_input, selection.balls);
}

Inputs moved(const Inputs& inputs, const Selection_3& selection, const Point_3& shift) {
  const Inputs result = changed_elements(inputs, cloud_input, selection.points, [&](Point_3& p) { p = p + shift; });
  return changed_elements(result, balls_input, selection.balls,
                          [&](Ball_3& ball) { ball.center = ball.center + shift; });
}

Inputs resized(const Inputs& inputs, const Selection_3& selection, double factor) {
  return changed_elements(inputs, balls_input, selection.balls, [factor](Ball_3& ball) {
    const double radius = ball.radius * factor;
    if (radius > 0 && std::isfinite(radius)) ball.radius = radius;
  });
}

Inputs without(const Inputs& inputs, const Selection_3& selection) {
  return without_elements(without_elements(inputs, cloud_input, selection.points), balls_input, selection.balls);
}

std::pair<Inputs, Selection_3> duplicated(const Inputs& inputs, const Selection_3& selection, const Point_3& shift) {
  const Selection_3 known = restricted(selection, inputs);
  std::vector<Point_3> points = chosen(inputs, cloud_input, known.points);
  for (Point_3& point : points) point = point + shift;
  std::vector<Ball_3> balls = selected_balls(inputs, known);
  for (Ball_3& ball : balls) ball.center = ball.center + shift;
  Selection_3 copies{numbers(count_of(inputs, cloud_input), points.size()),
                     numbers(count_of(inputs, balls_input), balls.size())};
  return {with_elements(with_elements(inputs, cloud_input, points), balls_input, balls), std::move(copies)};
}

Inputs with_point(const Inputs& inputs, std::size_t index, const Point_3& point) {
  return changed_elements(inputs, cloud_input, {index}, [&point](Point_3& changed) { changed = point; });
}

Inputs with_ball(const Inputs& inputs, std::size_t index, const Ball_3& ball) {
  return changed_elements(inputs, balls_input, {index}, [&ball](Ball_3& changed) { changed = ball; });
}

}  // namespace mesecina

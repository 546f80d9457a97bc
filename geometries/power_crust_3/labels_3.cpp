// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/outcome.h"
#include "geometries/pole_labelling.h"
#include "geometries/power_crust_3/pole_neighbors_3.h"
#include "geometries/power_crust_3/power_crust_3.h"
#include "geometries/scatter.h"

namespace mesecina {

namespace {

Point_3 unit_vector(const Point_3& from, const Point_3& to) { return (1 / distance(from, to)) * (to - from); }

/// A point that both balls have on their spheres; -1 for none.
int shared_contact(const Poles_3& poles, int a, int b) {
  auto one = poles.contacts_of(a);
  auto two = poles.contacts_of(b);
  if (two.size() < one.size()) std::swap(one, two);
  for (const int point : one)
    if (std::ranges::binary_search(two, point)) return point;
  return -1;
}

void find_labels(const Poles_3& poles, const Regular_3& regular, Polar_balls_3& result, const Progress& progress) {
  const Ball_neighbors_3 neighbors = neighbors_of_balls(regular);
  Pole_labelling labelling(poles.size());
  for (int p = static_cast<int>(poles.finite_count); p < static_cast<int>(poles.size()); ++p) labelling.add_outer(p);
  labelling.run(result.is_inner, result.confidence, progress, [&](int pole, const auto& offer) {
    for (const int s : poles.samples_of(pole)) {
      const int other = poles.opposite(pole, s);
      if (other < 0 || labelling.is_labelled(other)) continue;
      const Point_3& sample = poles.points[s];
      offer(other, false,
            -dot(unit_vector(sample, poles.balls[pole].center), unit_vector(sample, poles.balls[other].center)));
    }
    for (const int other : neighbors.of(pole)) {
      if (labelling.is_labelled(other)) continue;
      if (const double depth = intersection_cosine(poles, pole, other); depth > 0) offer(other, true, depth);
    }
  });
}

}  // namespace

double intersection_cosine(const Poles_3& poles, int a, int b) {
  if (poles.balls[a].radius < poles.balls[b].radius) std::swap(a, b);
  const int shared = shared_contact(poles, a, b);
  const Point_3& p = poles.points[shared >= 0 ? shared : poles.contacts_of(a).front()];
  const Point_3& q = poles.points[shared >= 0 ? shared : poles.contacts_of(b).front()];
  const Point_3 to_a = unit_vector(p, poles.balls[a].center);
  const Point_3 to_b = unit_vector(q, poles.balls[b].center);
  const Point_3 offset = p - q;
  // (ra^2 + rb^2 - d^2) / (2 ra rb), but without the differences of large numbers when a is very large.
  return dot(to_a, to_b) + dot(offset, to_b) / poles.balls[a].radius -
         (dot(offset, offset) / (2 * poles.balls[a].radius) + dot(offset, to_a)) / poles.balls[b].radius;
}

Polar_balls_3 label_poles(std::shared_ptr<const Poles_3> poles, std::shared_ptr<const Regular_3> regular,
                          Progress& progress) {
  progress.begin_stage("labels of poles");
  Polar_balls_3 result;
  result.is_inner.assign(poles->size(), 0);
  result.confidence.assign(poles->size(), 0);
  find_labels(*poles, *regular, result, progress);
  result.unlabelled_count = static_cast<std::size_t>(std::ranges::count(result.confidence, 0.0));
  for (int s = 0; s < static_cast<int>(poles->first.size()); ++s) {
    const int first = poles->first[s];
    const int second = poles->second[s];
    if (first < 0 || second < 0 || result.confidence[first] == 0 || result.confidence[second] == 0) continue;
    if (result.is_inner[first] == result.is_inner[second]) result.contradictions.push_back(s);
  }
  result.poles = std::move(poles);
  result.regular = std::move(regular);
  return result;
}

std::vector<Ball_3> inner_polar_balls(const Polar_balls_3& polar, double perturbation) {
  std::vector<Ball_3> balls;
  for (std::size_t p = 0; p < polar.poles->finite_count; ++p) {
    if (polar.is_inner[p] == 0) continue;
    const auto& [center, radius] = polar.poles->balls[p];
    const std::uint64_t number = 3 * balls.size();
    const Point_3 shift{scattered(number), scattered(number + 1), scattered(number + 2)};
    balls.push_back({center + (perturbation * radius) * shift, radius});
  }
  if (balls.empty()) throw Unavailable("no pole lies inside: the points enclose nothing (is the surface closed?)");
  return balls;
}

}  // namespace mesecina

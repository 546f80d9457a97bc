// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/balls_2/balls_2.h"

#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/disjoint_sets.h"
#include "core/formats/number.h"
#include "core/outcome.h"

namespace mesecina {

int Balls_2::common_contact(std::span<const int> disks) const {
  if (contact_offsets.empty() || disks.empty()) return -1;
  for (const int sample : contacts_of(disks.front())) {
    const auto touches = [&](int ball) {
      const auto own = contacts_of(ball);
      return std::ranges::find(own, sample) != own.end();
    };
    if (std::all_of(disks.begin() + 1, disks.end(), touches)) return sample;
  }
  return -1;
}

Balls_2 given_balls(std::span<const Disk_2> disks) {
  Balls_2 balls;
  balls.centers.reserve(disks.size());
  balls.radii.reserve(disks.size());
  for (std::size_t i = 0; i < disks.size(); ++i) {
    const auto& [center, radius] = disks[i];
    if (!std::isfinite(center.x) || !std::isfinite(center.y) || !std::isfinite(radius) || radius < 0)
      throw Unavailable("disk " + std::to_string(i) + " has center (" + format_number(center.x) + ", " +
                        format_number(center.y) + ") and radius " + format_number(radius) +
                        ": numbers must be finite, the radius not negative");
    balls.centers.push_back(center);
    balls.radii.push_back(radius);
  }
  return balls;
}

namespace {

/// Per triangle the least triangle with the same circle.
std::vector<int> circle_classes(const Delaunay_2& triangulation, Progress& progress) {
  Disjoint_sets classes(triangulation.triangles.size());
  std::vector<int> least(classes.size());
  for (int t = 0; t < static_cast<int>(least.size()); ++t) {
    if (t % 8192 == 0) progress.check();
    for (int i = 0; i < 3; ++i) {
      const int u = triangulation.neighbors[t][i];
      if (u >= 0 && u <= t && have_one_circle(triangulation, t, i)) classes.join(t, u);
    }
  }
  for (int t = 0; t < static_cast<int>(least.size()); ++t) least[t] = classes.find(t);
  return least;
}

/// Sorts triangles by their Voronoi vertices. Comparing asks whether to stop: the sort has no other place for it.
struct Hilbert_traits {
  using Point_2 = int;
  struct Less {
    const std::vector<mesecina::Point_2>* vertices;
    const Progress* progress;
    double mesecina::Point_2::*coordinate;
    bool operator()(int t, int u) const {
      progress->check();
      return (*vertices)[t].*coordinate < (*vertices)[u].*coordinate;
    }
  };
  using Less_x_2 = Less;
  using Less_y_2 = Less;
  const std::vector<mesecina::Point_2>* vertices;
  const Progress* progress;
  Less less_x_2_object() const { return {vertices, progress, &mesecina::Point_2::x}; }
  Less less_y_2_object() const { return {vertices, progress, &mesecina::Point_2::y}; }
};

}  // namespace

Circumscribed_balls_2 circumscribed_balls(const Delaunay_2& triangulation, const Voronoi_2& voronoi,
                                          std::span<const std::uint8_t> is_chosen, Progress& progress) {
  Circumscribed_balls_2 result;
  const int count = static_cast<int>(triangulation.triangles.size());
  const std::vector<int> circle = circle_classes(triangulation, progress);
  std::vector<int> ball_of_circle(count, -1);
  Balls_2& balls = result.balls;
  constexpr int chosen = -2;
  for (int t = 0; t < count; ++t) {
    if (is_chosen[t] == 0 || ball_of_circle[circle[t]] == chosen) continue;
    ball_of_circle[circle[t]] = chosen;
    result.triangles.push_back(t);
  }
  CGAL::hilbert_sort(result.triangles.begin(), result.triangles.end(), Hilbert_traits{&voronoi.vertices, &progress});
  for (const int t : result.triangles) {
    ball_of_circle[circle[t]] = static_cast<int>(balls.centers.size());
    balls.centers.push_back(voronoi.vertices[t]);
    balls.radii.push_back(voronoi.radii[t]);
  }
  progress.check();
  std::vector<std::vector<int>> further(result.triangles.size());
  result.ball_of_triangle.assign(count, -1);
  for (int t = 0; t < count; ++t) {
    const int ball = ball_of_circle[circle[t]];
    result.ball_of_triangle[t] = ball;
    if (ball >= 0 && t != result.triangles[ball])
      further[ball].insert(further[ball].end(), triangulation.triangles[t].begin(), triangulation.triangles[t].end());
  }
  balls.samples = std::make_shared<const std::vector<Point_2>>(triangulation.points);
  balls.contact_offsets.push_back(0);
  for (std::size_t b = 0; b < result.triangles.size(); ++b) {
    auto& own = further[b];
    const auto& corners = triangulation.triangles[result.triangles[b]];
    own.insert(own.end(), corners.begin(), corners.end());
    std::ranges::sort(own);
    own.erase(std::unique(own.begin(), own.end()), own.end());
    balls.contacts.insert(balls.contacts.end(), own.begin(), own.end());
    balls.contact_offsets.push_back(static_cast<int>(balls.contacts.size()));
  }
  return result;
}

Balls_2 subset(const Balls_2& balls, std::span<const int> kept) {
  Balls_2 result;
  result.samples = balls.samples;
  const bool has_contacts = !balls.contact_offsets.empty();
  if (has_contacts) result.contact_offsets.push_back(0);
  for (const int ball : kept) {
    result.centers.push_back(balls.centers[ball]);
    result.radii.push_back(balls.radii[ball]);
    if (!balls.center_rests.empty()) result.center_rests.push_back(balls.center_rests[ball]);
    if (!has_contacts) continue;
    const auto contacts = balls.contacts_of(ball);
    result.contacts.insert(result.contacts.end(), contacts.begin(), contacts.end());
    result.contact_offsets.push_back(static_cast<int>(result.contacts.size()));
  }
  return result;
}

Balls_2 grown(const Balls_2& balls, double factor) {
  if (factor == 1) return balls;
  Balls_2 result;
  result.centers = balls.centers;
  result.radii.reserve(balls.size());
  for (const double radius : balls.radii) result.radii.push_back(radius * factor);
  return result;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/scale_axis_2/scale_axis_2.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/outcome.h"
#include "geometries/filtration/filtration.h"

namespace mesecina {

namespace {

constexpr int most_halvings = 24;
constexpr std::size_t most_disks = 20'000'000;
constexpr double largest_sampling_angle = 179;

class Sampler {
 public:
  Sampler(Scale_axis_2& result, const Union_medial_axis_2& axis, double scale, double min_angle)
      : result_(result),
        axis_(axis),
        scale_(scale),
        least_cosine_(std::cos((180 - std::min(min_angle, largest_sampling_angle)) * (std::numbers::pi / 180))) {}

  /// Samples an edge of the axis between two disks of the result.
  void add_edge(int e, int a, int b, double angle, double monotone_angle) {
    contact_ = axis_.boundary->vertices[axis_.contacts[e][0]];
    angle_ = angle;
    monotone_angle_ = monotone_angle;
    halve(a, b, 0);
  }

 private:
  void halve(int a, int b, int depth) {
    if (depth == most_halvings || meet_deeply(a, b)) {
      result_.edges.push_back({a, b});
      result_.angles.push_back(angle_);
      result_.monotone_angles.push_back(monotone_angle_);
      return;
    }
    const Point_2 middle = midpoint(result_.centers[a], result_.centers[b]);
    const int m = static_cast<int>(result_.centers.size());
    if (result_.centers.size() >= most_disks)
      throw Unavailable("the scale axis would need more than 20 million disks: choose a smaller {sampling-min-angle}");
    result_.centers.push_back(middle);
    result_.radii.push_back(distance(middle, contact_) / scale_);
    halve(a, m, depth + 1);
    halve(m, b, depth + 1);
  }

  bool meet_deeply(int a, int b) const {
    const double ra = result_.radii[a];
    const double rb = result_.radii[b];
    const double d = distance(result_.centers[a], result_.centers[b]);
    return ra * ra + rb * rb - d * d >= 2 * ra * rb * least_cosine_;
  }

  Scale_axis_2& result_;
  const Union_medial_axis_2& axis_;
  double scale_;
  double least_cosine_;
  Point_2 contact_;
  double angle_ = 0;
  double monotone_angle_ = 0;
};

}  // namespace

Balls_2 medial_balls(const Union_medial_axis_2& axis) {
  Balls_2 balls;
  balls.centers = axis.centers;
  balls.radii = axis.radii;
  return balls;
}

Scale_axis_2 scale_axis(const Union_medial_axis_2& grown_axis, double scale, double min_angle,
                        double sampling_min_angle, Progress& progress) {
  std::vector<int> complete;
  std::vector<bool> is_in_axis(grown_axis.centers.size(), true);
  for (int e = 0; e < static_cast<int>(grown_axis.edges.size()); ++e) {
    if (grown_axis.kinds[e] == Axis_edge_kind::incomplete) {
      is_in_axis[grown_axis.edges[e][1]] = false;
    } else {
      complete.push_back(e);
    }
  }
  const std::vector<double> angle_of_edge = angle_of_edges(grown_axis);
  std::vector<std::array<int, 2>> edges;
  std::vector<std::array<int, 2>> names;
  std::vector<double> angles;
  for (const int e : complete) {
    edges.push_back(grown_axis.edges[e]);
    names.push_back(grown_axis.contacts[e]);
    angles.push_back(angle_of_edge[e]);
  }
  progress.check();
  const std::vector<double> monotone = topology_preserving(grown_axis.centers.size(), edges, angles, names, progress);

  Scale_axis_2 result;
  std::vector<bool> has_edge(grown_axis.centers.size(), false);
  std::vector<bool> is_kept(grown_axis.centers.size(), false);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (const int ball : edges[i]) {
      has_edge[ball] = true;
      if (monotone[i] >= min_angle) is_kept[ball] = true;
    }
  }
  std::vector<int> index(grown_axis.centers.size(), -1);
  for (std::size_t b = 0; b < index.size(); ++b) {
    if (!is_kept[b] && (has_edge[b] || !is_in_axis[b])) continue;
    index[b] = static_cast<int>(result.centers.size());
    result.centers.push_back(grown_axis.centers[b]);
    result.radii.push_back(grown_axis.radii[b] / scale);
  }
  Sampler sampler(result, grown_axis, scale, sampling_min_angle);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % 4096 == 0) progress.check();
    if (monotone[i] < min_angle) continue;
    sampler.add_edge(complete[i], index[edges[i][0]], index[edges[i][1]], angles[i], monotone[i]);
  }
  return result;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/landmark_disks_2/landmark_disks_2.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometries/parallel.h"

namespace mesecina {

namespace {

double factor_to_hold(const Disk_2& landmark, const Point_2& center, double radius) {
  const double reach = distance(landmark.center, center) + radius;
  if (landmark.radius > 0) return reach / landmark.radius;
  return reach > 0 ? std::numeric_limits<double>::infinity() : 1;
}

}  // namespace

Landmark_coverage_2 landmark_coverage(std::shared_ptr<const Balls_2> balls,
                                      std::shared_ptr<const std::vector<Disk_2>> landmarks, Progress& progress) {
  Landmark_coverage_2 none{std::move(balls), std::make_shared<const std::vector<Disk_2>>(), {}, -1};
  none.factors.assign(none.balls->size(), std::numeric_limits<double>::infinity());
  return with_landmarks(std::move(none), std::move(landmarks), progress);
}

Landmark_coverage_2 with_landmarks(Landmark_coverage_2 coverage, std::shared_ptr<const std::vector<Disk_2>> landmarks,
                                   Progress& progress) {
  const Balls_2& balls = *coverage.balls;
  const std::size_t known = coverage.landmarks->size();
  parallel_for(balls.size(), progress, [&](std::size_t b) {
    for (std::size_t l = known; l < landmarks->size(); ++l)
      coverage.factors[b] =
          std::min(coverage.factors[b], factor_to_hold((*landmarks)[l], balls.centers[b], balls.radii[b]));
  });
  coverage.landmarks = std::move(landmarks);
  const auto farthest = std::ranges::max_element(coverage.factors);
  coverage.farthest = coverage.factors.empty() ? -1 : static_cast<int>(farthest - coverage.factors.begin());
  return coverage;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"
#include "geometries/balls_2/balls_2.h"

namespace mesecina {

/// How far a few disks, the landmarks, must grow to hold others, each alone.
struct Landmark_coverage_2 {
  std::shared_ptr<const Balls_2> balls;
  std::shared_ptr<const std::vector<Disk_2>> landmarks;
  /// Per disk the least factor by which the radius of some landmark is multiplied so that it holds the disk: (distance
  /// of the centers + radius) / radius of the landmark. +infinity where all landmarks are points elsewhere.
  std::vector<double> factors;
  int farthest = -1;  ///< the disk with the largest factor, of several the least; -1 without disks
};

/// O(disks * landmarks). [B. Miklos: The Scale Axis Transform, 2010, section A.5]
Landmark_coverage_2 landmark_coverage(std::shared_ptr<const Balls_2> balls,
                                      std::shared_ptr<const std::vector<Disk_2>> landmarks, Progress& progress);

/// The same of more landmarks of the same disks: those of `coverage` and, after them, others. O(disks * new landmarks).
Landmark_coverage_2 with_landmarks(Landmark_coverage_2 coverage, std::shared_ptr<const std::vector<Disk_2>> landmarks,
                                   Progress& progress);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/inputs.h"
#include "core/point.h"
#include "core/progress.h"
#include "geometries/delaunay_2/delaunay_2.h"

namespace mesecina {

/// Disks whose union is looked at. A disk is closed; radius 0 is a point.
///
/// Disks that were given are what their numbers say. Disks that come from samples are, exactly, the circumscribed disks
/// of their samples; `centers` and `radii` are then rounded. Which samples lie on which circle is known from the
/// construction, and every decision about the disks uses it: circles through one sample meet there exactly.
struct Balls_2 {
  std::vector<Point_2> centers;
  std::vector<double> radii;
  /// Null for disks that were given. Else the samples, of which every disk has at least three on its circle.
  std::shared_ptr<const std::vector<Point_2>> samples;
  std::vector<int> contact_offsets;  ///< size() + 1 offsets into `contacts`; empty when nothing is known
  /// Per disk all samples on its circle, ascending. For points (radius 0) that were given, dually, the numbers of
  /// circles that are known to pass through them: four points of one circle have one power vertex, like four circles
  /// through one point.
  std::vector<int> contacts;
  /// Of given disks, what is to be added to the centers, which are known to more digits than a double has; each less
  /// than the last digit of its coordinate. Empty: nothing.
  std::vector<Point_2> center_rests;

  std::size_t size() const { return centers.size(); }
  bool is_circumscribed() const { return samples != nullptr; }
  /// Empty when nothing is known.
  std::span<const int> contacts_of(int ball) const {
    if (contact_offsets.empty()) return {};
    return std::span(contacts).subspan(contact_offsets[ball], contact_offsets[ball + 1] - contact_offsets[ball]);
  }
  /// The least contact that all these disks have; -1 when there is none (known).
  int common_contact(std::span<const int> disks) const;
};

/// The disks with these centers and radii. Throws Unavailable when a number is not finite or a radius is negative.
Balls_2 given_balls(std::span<const Disk_2> disks);

/// The circumscribed disks of Delaunay triangles. Triangles with one circle (decided exactly) give one disk, with all
/// their corners as contacts.
struct Circumscribed_balls_2 {
  Balls_2 balls;
  std::vector<int> triangles;         ///< per disk the least of the chosen triangles that it is circumscribed to
  std::vector<int> ball_of_triangle;  ///< per Delaunay triangle; -1 for those without a disk
};
/// Disks of the triangles t with is_chosen[t], along a Hilbert curve, so that neighbours are near each other in memory.
/// A disk is chosen when one of its triangles is. O(n log n).
Circumscribed_balls_2 circumscribed_balls(const Delaunay_2& triangulation, const Voronoi_2& voronoi,
                                          std::span<const std::uint8_t> is_chosen, Progress& progress);

/// The disks `kept`, in that order, with what is known of them.
Balls_2 subset(const Balls_2& balls, std::span<const int> kept);

/// The same centers with radii times `factor` > 0; rounded, so nothing is known of contacts any more (the disks
/// themselves if the factor is 1).
Balls_2 grown(const Balls_2& balls, double factor);

}  // namespace mesecina

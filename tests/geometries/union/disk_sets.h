// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometries/balls_2/balls_2.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {

struct Named_disks {
  std::string name;
  std::vector<Disk_2> disks;
};

/// One of each special position, of at most about 20 disks each.
std::vector<Named_disks> difficult_disk_sets();

/// A way to make disk sets from a seed.
struct Disk_family {
  std::string name;
  std::function<std::vector<Disk_2>(std::uint64_t seed)> make;
};
/// Sets of at most about 16 disks, most families in special position again and again.
std::vector<Disk_family> disk_families();

/// Circumscribed disks of samples.
struct Sampled_family {
  std::string name;
  std::function<Circumscribed_balls_2(std::uint64_t seed)> make;
};
/// Inner Voronoi disks of shapes with few samples, and circumscribed disks of triangles chosen at random.
std::vector<Sampled_family> sampled_families();

/// Inner Voronoi disks: the triangulation, its labels by flooding, and the disks.
struct Sampled_shape {
  Delaunay_2 triangulation;
  Voronoi_2 voronoi;
  std::vector<std::uint8_t> is_inner;
  Circumscribed_balls_2 circumscribed;
};
Sampled_shape inner_voronoi_disks(std::span<const Point_2> samples);
/// Labels by the shape itself.
Sampled_shape inner_voronoi_disks(std::span<const Point_2> samples, const Outline_2& outline);

using Balls_check = std::function<testing::AssertionResult(const std::shared_ptr<const Balls_2>& balls)>;
/// Expects it of the difficult sets and of so many sets of each family; of each family that fails it tells the least
/// part of a set that does.
void expect_of_given_balls(std::uint64_t seeds, const Balls_check& check);
void expect_of_circumscribed_balls(std::uint64_t seeds, const Balls_check& check);

std::vector<Disk_2> scaled(std::vector<Disk_2> disks, int exponent);
std::vector<Disk_2> moved(std::vector<Disk_2> disks, double x, double y);

}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
// How the time of a step of each planar evolution grows with the data, from 3 000 to 30 000 points or disks, also of
// those whose shape is the worst: a point in the middle of a circle has all others around its cell.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <numbers>
#include <random>
#include <string>

#include "bench/curves.h"
#include "bench/table.h"
#include "core/evolution.h"
#include "geometries/modules_2.h"

namespace {

using namespace mesecina;

constexpr std::size_t few = 3'000;
constexpr std::size_t many = 30'000;

double random_part(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

std::vector<Point_2> scattered(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<Point_2> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({random_part(random), random_part(random)});
  return points;
}

/// On a circle, about even, with one point in its middle.
std::vector<Point_2> star(std::size_t count) {
  std::mt19937_64 random(7);
  std::vector<Point_2> points{{0, 0}};
  for (std::size_t i = 1; i < count; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + random_part(random)) / static_cast<double>(count);
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  return points;
}

Outline_2 frame() { return {{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}}}; }

std::vector<Disk_2> disks(std::size_t count) {
  std::vector<Disk_2> result;
  for (const Point_2& p : scattered(count)) result.push_back({p, 0.5 / std::sqrt(static_cast<double>(count))});
  return result;
}

/// Of the processor, so that what else is running does not count: of one of several steps, each from where the one
/// before ended; the least of three runs.
double seconds_of_step(const Inputs& inputs, const char* evolution, std::uint64_t steps) {
  double best = 1e300;
  constexpr int runs = 3;
  for (int run = 0; run < runs; ++run) {
    Graph graph(make_registry_2());
    graph.set_inputs(inputs);
    Progress progress({}, {}, 1);
    Evolution_result result;
    const std::clock_t start = std::clock();
    result = evolve(graph, evolution, steps, progress);
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (result.steps_done != steps) std::abort();
  }
  return best / static_cast<double>(steps);
}

void bench(Table& table, const std::string& what, const char* evolution, std::uint64_t steps,
           const std::function<Inputs(std::size_t)>& inputs) {
  constexpr double largest_exponent = 1.3;
  const double large = seconds_of_step(inputs(many), evolution, steps);
  const double exponent =
      std::log(large / seconds_of_step(inputs(few), evolution, steps)) / std::log(double{many} / few);
  table.row(what + ", 30 000: a step", large, "s");
  table.row(what + ", 3 000 to 30 000: growth exponent of a step", exponent, "", largest_exponent);
}

}  // namespace

int main() {
  Table table;
  bench(table, "Lloyd, scattered points", "lloyd", 2,
        [](std::size_t count) { return Inputs().with(points_input, scattered(count)); });
  bench(table, "Lloyd, points around one", "lloyd", 1,
        [](std::size_t count) { return Inputs().with(points_input, star(count)); });
  bench(table, "Lloyd, points around one in an outline", "lloyd", 1,
        [](std::size_t count) { return Inputs().with(points_input, star(count)).with(outline_input, frame()); });
  bench(table, "Lloyd, scattered points in an outline of as many", "lloyd", 1, [](std::size_t count) {
    std::vector<Point_2> points = scattered(count);
    for (Point_2& p : points) p = {100 * p.x - 50, 100 * p.y - 50};
    return Inputs().with(points_input, points).with(outline_input, noisy_star(count, 3));
  });
  for (const char* evolution : {"laplacian-smoothing", "subdivision", "noise"})
    bench(table, std::string(evolution) + ", points along a curve", evolution, 2,
          [](std::size_t count) { return Inputs().with(points_input, smooth_curve(count)); });
  bench(table, "Landmarks, the 50 that follow each other", "max-min-landmarks", 50,
        [](std::size_t count) { return Inputs().with(points_input, smooth_curve(count)); });
  bench(table, "Landmark disks, the 50 that follow each other", "landmark-disks", 50,
        [](std::size_t count) { return Inputs().with(disks_input, disks(count)); });
  bench(table, "Stepped growing of disks", "stepped-growing", 1,
        [](std::size_t count) { return Inputs().with(disks_input, disks(count)); });
  return table.all_met() ? 0 : 1;
}

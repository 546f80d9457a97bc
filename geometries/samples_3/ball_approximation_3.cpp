// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/samples_3/ball_approximation_3.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "core/outcome.h"
#include "geometries/parallel.h"
#include "geometries/samples_3/graded_grid_3.h"
#include "geometries/samples_3/refine_samples_3.h"
#include "geometries/union_3/union_3.h"

namespace mesecina {

namespace {

class Approximation {
 public:
  Approximation(const Solid_3& solid, double distance, double perturbation, Progress& progress)
      : solid_(solid), distance_(distance), perturbation_(perturbation), progress_(progress) {}

  Ball_approximation_3 compute() {
    sample_evenly();
    settle(most_rounds);
    take(current_.poles);
    int vain_rounds = 0;
    for (int round = 0; round < most_thin_rounds && !is_right() && vain_rounds < most_vain_rounds; ++round) {
      const bool is_better = take(with_thin_cells());
      if (is_right() || even_count_ > most_samples_of_thin || !refine(true)) break;
      settle(most_thin_rounds);
      vain_rounds = take(current_.poles) || is_better ? 0 : vain_rounds + 1;
    }
    if (!best_)
      throw Unavailable("no Voronoi vertex of the " + std::to_string(even_count_) +
                        " samples lies inside: the solid is thinner than delta; choose a smaller delta");
    return std::move(*best_);
  }

 private:
  static constexpr int most_rounds = 10;
  static constexpr int most_vain_rounds = 2;
  static constexpr int most_thin_rounds = 3;
  /// Of more, none are added in thin parts.
  static constexpr std::size_t most_samples_of_thin = 50'000;
  static constexpr int most_pit_rounds = 2;
  static constexpr double gap_part = 0.32;
  static constexpr double pit_part = 0.38;
  static constexpr double finest_part = 1.0 / 8;
  static constexpr double finest_part_of_thin = 1.0 / 64;

  /// Samples of a thin solid may all lie in a plane; then there are more.
  void sample_evenly() {
    constexpr int most_halvings = 6;
    constexpr std::size_t most_in_plane = 50'000;
    double spacing = distance_;
    for (int halving = 0;; ++halving) {
      current_.samples = sample_surface(solid_.surface, spacing, progress_);
      even_count_ = current_.samples.points.size();
      try {
        triangulate_samples(current_, solid_, progress_);
        return;
      } catch (const Unavailable& reason) {
        if (halving == most_halvings || even_count_ > most_in_plane)
          throw Unavailable("the " + std::to_string(even_count_) + " samples of the surface make no tetrahedron (" +
                            reason.what() + "): the solid is thinner than delta; choose a smaller delta");
      }
      spacing /= 2;
    }
  }

  void settle(int rounds) {
    for (int round = 0; round < rounds; ++round)
      if (!refine(false)) return;
  }
  /// Whether samples were added.
  bool refine(bool also_thin_parts) {
    progress_.begin_stage("more samples");
    const double finest = (also_thin_parts ? finest_part_of_thin : finest_part) * distance_;
    std::vector<double> wanted = wanted_spacing(current_, also_thin_parts, finest);
    if (is_too_much(wanted)) {
      is_exhausted_ = true;
      wanted = current_.samples.spacing;
    }
    if (add_samples(current_, solid_.surface, wanted, gap_part * distance_, progress_) == 0) return false;
    triangulate_samples(current_, solid_, progress_);
    return true;
  }

  bool is_too_much(const std::vector<double>& wanted) const {
    constexpr double factor = 1.5;
    constexpr double always = 50'000;
    double count = 0;
    for (std::size_t s = 0; s < wanted.size(); ++s) {
      const double ratio = current_.samples.spacing[s] / wanted[s];
      count += ratio * ratio;
    }
    return count > factor * static_cast<double>(even_count_) + always;
  }

  std::vector<int> with_thin_cells() {
    constexpr double factor = 2;
    std::vector<int> cells = current_.poles;
    std::vector<int> thin = thin_cells(current_.samples, current_.delaunay, factor);
    std::vector<Point_3> centers;
    centers.reserve(thin.size());
    for (const int c : thin) centers.push_back(current_.delaunay.circumcenters[c]);
    const auto inside = are_inside(solid_, centers, progress_);
    for (std::size_t i = 0; i < thin.size(); ++i)
      if (inside[i] != 0) cells.push_back(thin[i]);
    return cells;
  }

  /// Keeps the balls of the cells if their union is nearer to the topology of the solid than the best until now, with
  /// further ones where it has pits. Returns whether.
  bool take(std::vector<int> cells) {
    make_unique(cells);
    Ball_approximation_3 next = union_of(cells);
    if (next.balls.empty()) return false;
    std::int64_t difference = difference_to_solid(*next.dual);
    if (best_ && difference >= difference_) return false;
    for (int round = 0; round < most_pit_rounds; ++round) {
      const std::vector<int> more = cells_in_pits(next, cells);
      if (more.empty()) break;
      cells.insert(cells.end(), more.begin(), more.end());
      make_unique(cells);
      Ball_approximation_3 filled = union_of(cells);
      const std::int64_t its_difference = difference_to_solid(*filled.dual);
      if (its_difference > difference) break;
      next = std::move(filled);
      difference = its_difference;
    }
    difference_ = difference;
    next.samples = current_.samples;
    next.even_sample_count = even_count_;
    next.is_exhausted = is_exhausted_ && difference != 0;
    best_ = std::move(next);
    return true;
  }

  static void make_unique(std::vector<int>& cells) {
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    if (!cells.empty() && cells.front() < 0) cells.erase(cells.begin());
  }

  Ball_approximation_3 union_of(const std::vector<int>& cells) {
    Ball_approximation_3 result;
    result.balls = balls_of_cells(current_.delaunay, cells, perturbation_);
    if (result.balls.empty()) return result;
    result.regular = std::make_shared<const Regular_3>(regular_triangulation(result.balls, progress_));
    result.dual = std::make_shared<const Dual_3>(dual_complex(result.regular, progress_));
    return result;
  }

  /// Where the boundary of the union lies deep in the solid, it is deepest where three spheres meet. Per such place an
  /// inner Voronoi vertex whose ball holds it, as deep as possible. `cells` are those of the balls.
  std::vector<int> cells_in_pits(const Ball_approximation_3& balls, const std::vector<int>& cells) {
    const double limit = pit_part * distance_;
    const Union_vertices_3 vertices = union_vertices(balls.dual, progress_);
    // Most lie next to a sample that one of their balls touches.
    std::vector<std::uint8_t> is_near(vertices.points.size(), 0);
    parallel_for(is_near.size(), progress_, [&](std::size_t v) {
      for (const int ball : vertices.balls_of(static_cast<int>(v)))
        for (const int s : current_.delaunay.cells[cells[ball]])
          if (squared_distance(vertices.points[v], current_.samples.points[s]) <= limit * limit) is_near[v] = 1;
    });
    std::vector<int> nearest(vertices.points.size(), -1);
    if (std::ranges::count(is_near, 0) > 0) {
      Graded_grid_3 grid(current_.samples.covering_radius);
      for (std::size_t s = 0; s < current_.samples.points.size(); ++s)
        grid.add(current_.samples.points[s], current_.samples.spacing[s]);
      parallel_for(nearest.size(), progress_, [&](std::size_t v) {
        if (is_near[v] != 0) return;
        const Point_3& p = vertices.points[v];
        double least = 4 * distance_ * distance_;
        grid.for_near(p, 2 * distance_, [&](int s) {
          const double square = squared_distance(p, grid.point(s));
          if (square >= least) return;
          least = square;
          nearest[v] = s;
        });
        if (least <= limit * limit) nearest[v] = -1;
      });
    }
    std::vector<Point_3> places;
    std::vector<int> samples;
    for (std::size_t v = 0; v < nearest.size(); ++v) {
      if (nearest[v] < 0) continue;
      places.push_back(vertices.points[v]);
      samples.push_back(nearest[v]);
    }
    const std::vector<double> depths = distances_to_surface(solid_, places, progress_);
    std::vector<int> found;
    std::vector<std::vector<int>> stars(depths.size());
    std::vector<int> slot(current_.samples.points.size(), -1);
    std::vector<int> wanted;
    for (std::size_t i = 0; i < depths.size(); ++i) {
      if (depths[i] <= limit) continue;
      if (slot[samples[i]] < 0) slot[samples[i]] = static_cast<int>(i);
      wanted.push_back(static_cast<int>(i));
    }
    if (wanted.empty()) return found;
    const Delaunay_3& delaunay = current_.delaunay;
    for (std::size_t c = 0; c < delaunay.cells.size(); ++c)
      for (const int s : delaunay.cells[c])
        if (slot[s] >= 0) stars[slot[s]].push_back(static_cast<int>(c));
    for (const int i : wanted) {
      double deepest = 0;
      int best = -1;
      // The cells whose spheres hold a point are next to each other, some of them at its nearest sample.
      for (const int c : stars[slot[samples[i]]]) {
        const double depth = delaunay.circumradii[c] - mesecina::distance(places[i], delaunay.circumcenters[c]);
        if (depth <= deepest) continue;
        deepest = depth;
        best = c;
      }
      if (best >= 0) found.push_back(best);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<Point_3> centers;
    centers.reserve(found.size());
    for (const int c : found) centers.push_back(delaunay.circumcenters[c]);
    const auto inside = are_inside(solid_, centers, progress_);
    std::vector<int> inner;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (inside[i] != 0) inner.push_back(found[i]);
    return inner;
  }

  /// Of surfaces that are no manifolds the topology is not known.
  std::int64_t difference_to_solid(const Dual_3& dual) const {
    if (!solid_.topology) return 0;
    const auto found = topology(dual).betti;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) sum += std::abs(found[i] - solid_.topology->betti[i]);
    return sum;
  }
  bool is_right() const { return best_ && difference_ == 0; }

  const Solid_3& solid_;
  double distance_;
  double perturbation_;
  Progress& progress_;
  Sampled_balls_3 current_;
  std::size_t even_count_ = 0;
  std::optional<Ball_approximation_3> best_;
  std::int64_t difference_ = 0;
  bool is_exhausted_ = false;
};

}  // namespace

Ball_approximation_3 approximate_by_balls(const Solid_3& solid, double distance, double perturbation,
                                          Progress& progress) {
  return Approximation(solid, distance, perturbation, progress).compute();
}

}  // namespace mesecina

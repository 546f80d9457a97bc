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
#include "geometries/samples_3/refine_samples_3.h"
#include "geometries/samples_3/union_defects_3.h"
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
    std::size_t count = 0;
    while (look() && count < most_balls_of_repairs && vain_rounds_ < most_vain_rounds && repair())
      count += best_->balls.size();
    if (!best_)
      throw Unavailable("no Voronoi vertex of the " + std::to_string(even_count_) +
                        " samples lies inside: the solid is thinner than {delta}; choose a smaller {delta}");
    return std::move(*best_);
  }

 private:
  static constexpr int most_rounds = 10;
  static constexpr int most_vain_rounds = 6;
  /// In all rounds together.
  static constexpr std::size_t most_balls_of_repairs = 600'000;
  static constexpr int most_rounds_of_repair = 3;
  static constexpr int no_number = -1;
  static constexpr double gap_part = 0.32;
  /// How deep the boundary of the union may lie in the solid, and how far out of it.
  static constexpr double pit_part = 0.38;
  /// Smaller balls between the others would never end.
  static constexpr double least_loose_part = 0.004;
  static constexpr double finest_part = 1.0 / 8;
  static constexpr double finest_part_of_repair = 1.0 / 16;

  /// How far a union is from what it should be; less is better.
  struct Faults {
    std::int64_t betti = 0;  ///< sum of the differences of Betti numbers
    std::size_t places = 0;  ///< where the boundaries are too far from each other
    auto operator<=>(const Faults&) const = default;
  };

  /// Samples of a thin solid may all lie in a plane; then there are more.
  void sample_evenly() {
    constexpr int most_halvings = 6;
    constexpr std::size_t most_in_plane = 50'000;
    double spacing = distance_;
    for (int halving = 0;; ++halving) {
      current_ = {};
      current_.samples = sample_surface(solid_.surface, spacing, progress_);
      even_count_ = current_.samples.points.size();
      try {
        current_.triangulate(solid_, progress_);
        return;
      } catch (const Unavailable& reason) {
        if (halving == most_halvings || even_count_ > most_in_plane)
          throw Unavailable("the " + std::to_string(even_count_) + " samples of the surface make no tetrahedron (" +
                            reason.what() + "): the solid is thinner than {delta}; choose a smaller {delta}");
      }
      spacing /= 2;
    }
  }

  void settle(int rounds) {
    for (int round = 0; round < rounds; ++round)
      if (!refine({}, finest_part)) return;
  }
  /// Adds samples, around some more than elsewhere. Returns whether there were any.
  bool refine(std::span<const int> crowded, double part) {
    progress_.begin_stage("more samples");
    std::vector<double> wanted = wanted_spacing(current_, crowded, part * distance_);
    if (is_too_much(wanted)) wanted = current_.samples.spacing;
    if (add_samples(current_, solid_.surface, wanted, gap_part * distance_, progress_) == 0) return false;
    const std::vector<int> renewed = current_.triangulate(solid_, progress_);
    std::erase_if(fillings_, [&](int c) { return std::ranges::binary_search(renewed, c); });
    std::erase_if(shrunk_, [&](int c) { return std::ranges::binary_search(renewed, c); });
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

  /// Makes the union of the balls, keeps it if it is the best until now, and notes what is wrong with it. Returns
  /// whether something is.
  bool look() {
    std::vector<int> cells = current_.poles();
    cells.insert(cells.end(), fillings_.begin(), fillings_.end());
    make_unique(cells);
    Ball_approximation_3 next = union_of(cells);
    if (next.balls.empty()) return false;
    ++vain_rounds_;
    places_.clear();
    crowded_.clear();
    has_shrunk_ = false;
    Faults faults;
    const auto compare_surfaces = [&] {
      find_bumps(cells);
      find_pits(next, cells);
    };
    at_once(progress_, compare_surfaces, [&] { faults.betti = difference_to_solid(*next.dual); });
    faults.places = places_.size() + crowded_.size();
    has_wrong_topology_ = faults.betti != 0;
    if (faults.betti != 0) find_defects(next, cells);
    if (!best_ || faults < faults_) {
      faults_ = faults;
      vain_rounds_ = 0;
      next.samples = current_.samples;
      next.even_sample_count = even_count_;
      best_ = std::move(next);
    }
    best_->is_exhausted = faults_.betti != 0;
    return !places_.empty() || !crowded_.empty() || has_shrunk_;
  }

  /// Adds balls, and samples where there are none to add. Returns whether there is anything new.
  bool repair() {
    const std::size_t count = fillings_.size() + loose_.size();
    fill_places();
    const bool is_filled = has_shrunk_ || fillings_.size() + loose_.size() > count;
    make_unique(crowded_);
    if (crowded_.empty() || !refine(crowded_, finest_part_of_repair)) return is_filled;
    settle(most_rounds_of_repair);
    return true;
  }

  static void make_unique(std::vector<int>& cells) {
    std::ranges::sort(cells);
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    if (!cells.empty() && cells.front() < 0) cells.erase(cells.begin());
  }

  Ball_approximation_3 union_of(const std::vector<int>& cells) {
    Ball_approximation_3 result;
    // Balls of before stay where they are. But where balls nearly touch, the perturbation decides what hangs together.
    if (has_wrong_topology_) perturb_anew();
    const Delaunay_3& delaunay = current_.delaunay();
    numbers_.resize(delaunay.cells.size(), no_number);
    const auto add = [&](const Point_3& center, double radius, int& number) {
      if (number == no_number) number = next_number_++;
      result.balls.push_back({moved(center, perturbation_ * radius, static_cast<std::size_t>(number)), radius});
    };
    result.balls.reserve(cells.size() + loose_.size());
    for (const int c : cells) add(delaunay.circumcenters[c], delaunay.circumradii[c], numbers_[c]);
    const std::vector<int> nearest = nearest_samples(loose_);
    const std::vector<double> depths = distances_to_surface(solid_, loose_, progress_);
    loose_numbers_.resize(loose_.size(), no_number);
    for (std::size_t i = 0; i < loose_.size(); ++i) {
      const double radius = nearest[i] >= 0 ? distance(loose_[i], current_.samples.points[nearest[i]]) : depths[i];
      add(loose_[i], radius, loose_numbers_[i]);
    }
    shrink(result.balls, cells);
    result.regular = std::make_shared<const Regular_3>(triangulation_.triangulate(result.balls, progress_));
    result.dual = std::make_shared<const Dual_3>(dual_complex(result.regular, progress_));
    return result;
  }

  void perturb_anew() {
    numbers_.clear();
    loose_numbers_.clear();
    next_number_ = 0;
  }

  /// Small balls that reach far out of the solid; large ones do not, as they would hold samples.
  void find_bumps(const std::vector<int>& cells) {
    constexpr double largest = 2;
    const Delaunay_3& delaunay = current_.delaunay();
    std::vector<int> small;
    std::vector<Point_3> centers;
    for (const int c : cells) {
      if (delaunay.circumradii[c] > largest * distance_) continue;
      small.push_back(c);
      centers.push_back(delaunay.circumcenters[c]);
    }
    const std::vector<double> depths = distances_to_surface(solid_, centers, progress_);
    for (std::size_t i = 0; i < small.size(); ++i)
      if (delaunay.circumradii[small[i]] - depths[i] > pit_part * distance_)
        crowded_.insert(crowded_.end(), delaunay.cells[small[i]].begin(), delaunay.cells[small[i]].end());
    make_unique(crowded_);
  }

  /// Where the boundary of the union lies deep in the solid: it is deepest where three spheres meet, or two.
  void find_pits(const Ball_approximation_3& balls, const std::vector<int>& cells) {
    const double limit = pit_part * distance_;
    const Union_vertices_3 vertices = union_vertices(balls.dual, progress_);
    // Most lie next to a sample that one of their balls touches.
    std::vector<std::uint8_t> is_near(vertices.points.size(), 0);
    parallel_for(is_near.size(), progress_, [&](std::size_t v) {
      for (const int ball : vertices.balls_of(static_cast<int>(v)))
        if (ball < std::ssize(cells))
          for (const int s : current_.delaunay().cells[cells[ball]])
            if (squared_distance(vertices.points[v], current_.samples.points[s]) <= limit * limit) is_near[v] = 1;
    });
    std::vector<Point_3> candidates = deep_arc_points(*balls.regular, limit / 2, progress_);
    for (std::size_t v = 0; v < is_near.size(); ++v)
      if (is_near[v] == 0) candidates.push_back(vertices.points[v]);
    const std::vector<int> nearest = nearest_samples(candidates);
    std::vector<Point_3> open;
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (nearest[i] >= 0 && distance(candidates[i], current_.samples.points[nearest[i]]) > limit)
        open.push_back(candidates[i]);
    const std::vector<double> depths = distances_to_surface(solid_, open, progress_);
    std::vector<Point_3> deep;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (depths[i] > limit) deep.push_back(open[i]);
    const auto inside = are_inside(solid_, deep, progress_);
    for (std::size_t i = 0; i < deep.size(); ++i)
      if (inside[i] != 0) places_.push_back(deep[i]);
  }

  void find_defects(const Ball_approximation_3& balls, const std::vector<int>& cells) {
    std::vector<int> bridged;
    for (const Union_defect_3& defect : union_defects(*balls.regular, solid_, distance_, progress_)) {
      if (defect.is_hole) {
        places_.push_back(defect.place);
      } else {
        for (const int ball : defect.balls)
          if (ball >= 0) bridged.push_back(ball);
      }
    }
    const std::size_t before = shrunk_.size() + shrunk_loose_.size();
    for (const int ball : bridged) {
      if (ball < std::ssize(cells))
        shrunk_.push_back(cells[ball]);
      else
        shrunk_loose_.push_back(ball - static_cast<int>(cells.size()));
    }
    make_unique(shrunk_);
    make_unique(shrunk_loose_);
    has_shrunk_ = shrunk_.size() + shrunk_loose_.size() > before;
  }

  /// Balls that reach out of the solid to others keep a quarter of what reaches out.
  void shrink(std::vector<Ball_3>& balls, const std::vector<int>& cells) {
    std::vector<int> numbers;
    for (const int c : shrunk_)
      if (const auto found = std::ranges::lower_bound(cells, c); found != cells.end() && *found == c)
        numbers.push_back(static_cast<int>(found - cells.begin()));
    for (const int i : shrunk_loose_) numbers.push_back(static_cast<int>(cells.size()) + i);
    std::vector<Point_3> centers;
    centers.reserve(numbers.size());
    for (const int number : numbers) centers.push_back(balls[number].center);
    const std::vector<double> depths = distances_to_surface(solid_, centers, progress_);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      double& radius = balls[numbers[i]].radius;
      radius = std::min(radius, depths[i] + (radius - depths[i]) / 4);
    }
  }

  /// -1 where none is within twice its spacing.
  std::vector<int> nearest_samples(const std::vector<Point_3>& places) {
    std::vector<int> nearest(places.size(), -1);
    parallel_for(nearest.size(), progress_, [&](std::size_t i) {
      double least = 4 * distance_ * distance_;
      current_.grid().for_near(places[i], 2 * distance_, [&](int s) {
        const double square = squared_distance(places[i], current_.grid().point(s));
        if (square > least || (square == least && s > nearest[i])) return;
        least = square;
        nearest[i] = s;
      });
    });
    return nearest;
  }

  /// Of cells with balls that hold the place the deepest ones first: they are next to each other, and some of them at
  /// its nearest sample.
  std::vector<int> cells_around(const Point_3& place, int sample) const {
    const Delaunay_3& delaunay = current_.delaunay();
    const int first = current_.poles()[sample];
    if (first < 0) return {};
    const auto depth = [&](int c) { return delaunay.circumradii[c] - distance(place, delaunay.circumcenters[c]); };
    std::vector<int> seen{first};
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (const int next : delaunay.neighbors[seen[i]]) {
        if (next < 0 || std::ranges::count(seen, next) > 0) continue;
        if (depth(next) > 0 || std::ranges::count(delaunay.cells[next], sample) > 0) seen.push_back(next);
      }
    }
    std::erase_if(seen, [&](int c) { return depth(c) <= 0; });
    std::ranges::sort(seen, {}, [&](int c) { return std::pair(-depth(c), c); });
    constexpr std::size_t most = 16;
    if (seen.size() > most) seen.resize(most);
    return seen;
  }

  /// For each noted place the ball of an inner Voronoi vertex that holds it and does not reach far out of the solid.
  /// Where the solid is much thinner than the spacing there is none: then the empty ball around the place itself, and
  /// if that reaches far out, too, there shall be samples.
  void fill_places() {
    const std::vector<int> nearest = nearest_samples(places_);
    std::vector<std::vector<int>> around(places_.size());
    parallel_for(places_.size(), progress_, [&](std::size_t i) {
      if (nearest[i] >= 0) around[i] = cells_around(places_[i], nearest[i]);
    });
    std::vector<int> cells;
    for (const auto& part : around) cells.insert(cells.end(), part.begin(), part.end());
    make_unique(cells);
    std::vector<Point_3> centers;
    centers.reserve(cells.size());
    for (const int c : cells) centers.push_back(current_.delaunay().circumcenters[c]);
    const auto inside = are_inside(solid_, centers, progress_);
    const std::vector<double> depths = distances_to_surface(solid_, centers, progress_);
    const auto is_good = [&](int c) {
      const auto i = static_cast<std::size_t>(std::ranges::lower_bound(cells, c) - cells.begin());
      return inside[i] != 0 && current_.delaunay().circumradii[c] - depths[i] <= pit_part * distance_;
    };
    const std::vector<double> depths_of_places = distances_to_surface(solid_, places_, progress_);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (nearest[i] < 0) continue;
      const double radius = distance(places_[i], current_.samples.points[nearest[i]]);
      const auto found = std::ranges::find_if(around[i], is_good);
      if (found != around[i].end() && std::ranges::binary_search(shrunk_, *found)) {
        if (depths_of_places[i] < least_loose_part * distance_) continue;
        shrunk_loose_.push_back(static_cast<int>(loose_.size()));
        loose_.push_back(places_[i]);
      } else if (found != around[i].end()) {
        fillings_.push_back(*found);
      } else if (radius - depths_of_places[i] <= pit_part * distance_) {
        loose_.push_back(places_[i]);
      } else {
        crowded_.push_back(nearest[i]);
      }
    }
    make_unique(fillings_);
  }

  /// Of surfaces that are no manifolds the topology is not known.
  std::int64_t difference_to_solid(const Dual_3& dual) const {
    if (!solid_.topology) return 0;
    const auto found = topology(dual).betti;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < found.size(); ++i) sum += std::abs(found[i] - solid_.topology->betti[i]);
    return sum;
  }

  const Solid_3& solid_;
  double distance_;
  double perturbation_;
  Progress& progress_;
  Sampled_balls_3 current_;
  std::size_t even_count_ = 0;
  int vain_rounds_ = 0;              ///< since the best
  Growing_regular_3 triangulation_;  ///< of the balls of the last union
  std::optional<Ball_approximation_3> best_;
  Faults faults_;                  ///< of the best
  std::vector<int> shrunk_;        ///< cells whose balls reach less far out of the solid
  std::vector<int> shrunk_loose_;  ///< the same for numbers in `loose_`
  bool has_shrunk_ = false;        ///< there are more of them than before
  std::vector<int> fillings_;      ///< cells whose balls join those of poles
  std::vector<Point_3> places_;    ///< that the union should hold
  std::vector<Point_3> loose_;     ///< centers of balls between samples, which join those of poles
  // By which the balls of cells and those between samples are moved.
  std::vector<int> numbers_;
  std::vector<int> loose_numbers_;
  int next_number_ = 0;
  bool has_wrong_topology_ = false;  ///< the last union
  std::vector<int> crowded_;         ///< samples around which there should be more
};

}  // namespace

Ball_approximation_3 approximate_by_balls(const Solid_3& solid, double distance, double perturbation,
                                          Progress& progress) {
  return Approximation(solid, distance, perturbation, progress).compute();
}

}  // namespace mesecina

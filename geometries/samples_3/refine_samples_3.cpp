// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/samples_3/refine_samples_3.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

#include "geometries/parallel.h"
#include "geometries/samples_3/graded_grid_3.h"

namespace mesecina {

namespace {

/// How much the wanted spacing grows with the distance.
constexpr double slope = 0.3;
/// Samples keep this part of the wanted spacing from each other.
constexpr double spacing_part = 0.7;
/// Those that are added for a gap keep this part.
constexpr double gap_spacing_part = 0.45;
/// Nearer to a sample another one does not help.
constexpr double least_part = 0.1;
/// Where the balls are so large, compared with the spacing, and the normals so near to each other, there are no gaps: a
/// ball whose sphere passes between samples deviates by a quarter of the spacing.
constexpr double least_radius_of_smooth = 2;
constexpr double cosine_of_smooth = 0.9;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Per vertex of the triangulation its cells.
struct Cells_at_samples {
  std::vector<int> offsets;
  std::vector<int> cells;
};

Cells_at_samples stars_of(const Delaunay_3& delaunay) {
  Cells_at_samples stars;
  stars.offsets.assign(delaunay.points.size() + 1, 0);
  for (const auto& corners : delaunay.cells)
    for (const int v : corners) ++stars.offsets[v + 1];
  std::partial_sum(stars.offsets.begin(), stars.offsets.end(), stars.offsets.begin());
  stars.cells.resize(stars.offsets.back());
  std::vector<int> next(stars.offsets.begin(), stars.offsets.end() - 1);
  for (std::size_t c = 0; c < delaunay.cells.size(); ++c)
    for (const int v : delaunay.cells[c]) stars.cells[next[v]++] = static_cast<int>(c);
  return stars;
}

/// Makes spacings change slowly along the edges of the triangulation, starting from those that are less than before.
void grade(const Delaunay_3& delaunay, const std::vector<double>& before, std::vector<double>& wanted) {
  using Step = std::pair<double, int>;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
  std::vector<int> lowered;
  for (std::size_t s = 0; s < wanted.size(); ++s)
    if (wanted[s] < before[s]) lowered.push_back(static_cast<int>(s));
  if (lowered.empty()) return;
  const Cells_at_samples stars = stars_of(delaunay);
  const auto for_neighbors = [&](int sample, const auto& use) {
    for (int k = stars.offsets[sample]; k < stars.offsets[sample + 1]; ++k)
      for (const int other : delaunay.cells[stars.cells[k]])
        if (other != sample) use(other, distance(delaunay.points[sample], delaunay.points[other]));
  };
  // Around a sample that wants more the others want it too: nothing fits between them otherwise.
  constexpr double reach = 1.5;
  std::vector<double> spread = wanted;
  for (const int sample : lowered) {
    for_neighbors(sample, [&](int other, double d) {
      if (d < reach * before[sample]) spread[other] = std::min(spread[other], wanted[sample]);
    });
  }
  wanted = std::move(spread);
  for (std::size_t s = 0; s < wanted.size(); ++s)
    if (wanted[s] < before[s]) queue.emplace(wanted[s], static_cast<int>(s));
  while (!queue.empty()) {
    const auto [spacing, sample] = queue.top();
    queue.pop();
    if (spacing > wanted[sample]) continue;
    const double here = spacing;
    for_neighbors(sample, [&](int other, double d) {
      const double there = here + slope * d;
      if (there >= wanted[other]) return;
      wanted[other] = there;
      queue.emplace(there, other);
    });
  }
}

using Corners = std::array<Point_3, 3>;

Point_3 middle_of(const Corners& t) { return (1.0 / 3) * (t[0] + t[1] + t[2]); }

struct Candidate {
  Point_3 point;
  double spacing = 0;
  bool fills_a_gap = false;
  int triangle = 0;
};

/// What matters of a sample to the surface around it.
struct Near {
  Point_3 sample;
  double wanted = 0;
  Point_3 pole;
  /// Squares of its radius less and plus the gap; negative for no pole.
  double inner_square = -1;
  double outer_square = -1;
};

/// Per sample: what is around it has changed, and there may be gaps around it.
struct Restless {
  std::vector<std::uint8_t> is_open;
  std::vector<std::uint8_t> is_rough;
};

Restless find_restless(const Sampled_balls_3& balls, const std::vector<double>& wanted, Progress& progress) {
  const Surface_samples_3& samples = balls.samples;
  const Delaunay_3& delaunay = balls.delaunay();
  Restless restless{std::vector<std::uint8_t>(wanted.size()), std::vector<std::uint8_t>(wanted.size())};
  for (std::size_t s = 0; s < wanted.size(); ++s) {
    const bool is_less = wanted[s] < samples.spacing[s];
    restless.is_open[s] = is_less || balls.is_settled[s] == 0 ? 1 : 0;
    const int pole = balls.poles()[s];
    const bool is_thin = pole < 0 || delaunay.circumradii[pole] <= least_radius_of_smooth * samples.covering_radius;
    restless.is_rough[s] = is_less || is_thin ? 1 : 0;
  }
  constexpr double reach = 2;
  const double square = reach * reach * samples.covering_radius * samples.covering_radius;
  parallel_for(delaunay.cells.size(), progress, [&](std::size_t c) {
    const auto& corners = delaunay.cells[c];
    for (int i = 0; i < 4; ++i) {
      for (int j = i + 1; j < 4; ++j) {
        const int s = corners[i];
        const int t = corners[j];
        if (dot(samples.normals[s], samples.normals[t]) > cosine_of_smooth ||
            squared_distance(samples.points[s], samples.points[t]) > square)
          continue;
        std::atomic_ref(restless.is_rough[s]).store(1, std::memory_order_relaxed);
        std::atomic_ref(restless.is_rough[t]).store(1, std::memory_order_relaxed);
      }
    }
  });
  return restless;
}

/// Looks for places of the surface where samples are missing. Each thread has its own notes.
class Search {
 public:
  struct Notes {
    std::vector<Corners> pieces;
    Point_3 center;
    double reach = -1;        ///< around the center: `near` and `is_settled` hold for what is within
    bool is_settled = false;  ///< nothing is to be looked at there
    std::vector<Near> near;
    bool is_even = false;  ///< all of these want the coarsest spacing
    std::vector<Candidate> found;
  };

  Search(const Sampled_balls_3& balls, const Triangle_mesh_3& surface, double gap, const Restless& restless,
         const Progress& progress)
      : balls_(balls),
        surface_(surface),
        wanted_(balls.samples.spacing),
        gap_(gap),
        coarsest_(balls.samples.covering_radius),
        grid_(balls.grid()),
        open_(coarsest_),
        rough_(coarsest_),
        owner_(surface.vertices.size(), -1) {
    const auto add_where = [&](const std::vector<std::uint8_t>& is_wanted, Graded_grid_3& grid) {
      for (std::size_t s = 0; s < is_wanted.size(); ++s)
        if (is_wanted[s] != 0) grid.add(balls.samples.points[s], coarsest_);
    };
    const auto find_owners = [&] {
      for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (const int v : surface.triangles[t])
          if (owner_[v] < 0) owner_[v] = static_cast<int>(t);
    };
    at_once(
        progress, [&] { add_where(restless.is_open, open_); },
        [&] {
          add_where(restless.is_rough, rough_);
          find_owners();
        });
  }

  void look_at(int triangle, Notes& notes) const {
    const auto& [a, b, c] = surface_.triangles[triangle];
    notes.pieces.assign(1, {surface_.vertices[a], surface_.vertices[b], surface_.vertices[c]});
    bool is_split = false;
    while (!notes.pieces.empty()) {
      const Corners piece = notes.pieces.back();
      const bool is_whole = !is_split;
      notes.pieces.pop_back();
      const Point_3 middle = middle_of(piece);
      const double radius =
          std::max({distance(middle, piece[0]), distance(middle, piece[1]), distance(middle, piece[2])});
      if (radius > coarsest_) {
        is_split = true;
        split(piece, notes.pieces);
        continue;
      }
      if (!(distance(middle, notes.center) + radius <= notes.reach)) gather(middle, radius, notes);
      if (notes.is_settled) continue;
      const double spacing = spacing_at(middle, notes);
      if (radius > largest * spacing) {
        is_split = true;
        split(piece, notes.pieces);
      } else {
        look_at_grid(piece, spacing, triangle, is_whole, notes);
      }
    }
  }

 private:
  /// What is near to a piece, and a little farther: the next one is likely to be next to it.
  void gather(const Point_3& middle, double radius, Notes& notes) const {
    constexpr double slack = 0.4;
    notes.center = middle;
    notes.reach = std::min(radius + slack * coarsest_, coarsest_);
    notes.near.clear();
    const auto has_any = [&](const Graded_grid_3& grid, double part) {
      const double reach = notes.reach + part * coarsest_;
      return grid.any_near(middle, reach,
                           [&](int i) { return squared_distance(middle, grid.point(i)) <= reach * reach; });
    };
    if (radius <= largest * coarsest_) notes.reach = std::min(notes.reach, largest * coarsest_);
    // What is near is all that matters; where nothing of it is new, nothing is.
    notes.is_settled = !has_any(open_, spacing_part) || !has_any(rough_, 1);
    if (notes.is_settled) return;
    notes.is_even = true;
    if (radius > largest * coarsest_) {
      // It will be split.
      notes.reach = -1;
      return;
    }
    grid_.for_near(middle, notes.reach + spacing_part * coarsest_, [&](int s) {
      Near& near = notes.near.emplace_back();
      near.sample = grid_.point(s);
      near.wanted = wanted_[s];
      if (const int pole = balls_.poles()[s]; pole >= 0) {
        near.pole = balls_.delaunay().circumcenters[pole];
        const double radius_of_pole = balls_.delaunay().circumradii[pole];
        const double inner = std::max(radius_of_pole - gap_, 0.0);
        near.inner_square = inner * inner;
        near.outer_square = (radius_of_pole + gap_) * (radius_of_pole + gap_);
      }
      notes.is_even = notes.is_even && near.wanted >= coarsest_;
    });
    notes.reach = std::min(notes.reach, largest * spacing_at(middle, notes));
  }

  double spacing_at(const Point_3& p, const Notes& notes) const {
    double spacing = coarsest_;
    if (notes.is_even) return spacing;
    for (const Near& near : notes.near) spacing = std::min(spacing, near.wanted + slope * distance(p, near.sample));
    return spacing;
  }

  static void split(const Corners& t, std::vector<Corners>& pieces) {
    const Point_3 a = midpoint(t[0], t[1]);
    const Point_3 b = midpoint(t[1], t[2]);
    const Point_3 c = midpoint(t[2], t[0]);
    pieces.push_back({t[0], a, c});
    pieces.push_back({a, t[1], b});
    pieces.push_back({c, b, t[2]});
    pieces.push_back({a, b, c});
  }

  /// Of whole triangles, corners and edges are looked at once.
  void look_at_grid(const Corners& t, double spacing, int triangle, bool is_whole, Notes& notes) const {
    constexpr double step_part = 0.35;
    const auto& corners = surface_.triangles[triangle];
    const double longest = std::max({distance(t[0], t[1]), distance(t[1], t[2]), distance(t[2], t[0])});
    const int n = std::max(1, static_cast<int>(std::ceil(longest / (step_part * spacing))));
    const auto is_mine = [&](int i, int j) {
      if (!is_whole) return true;
      const int k = n - i - j;
      if (k == n) return owner_[corners[0]] == triangle;
      if (i == n) return owner_[corners[1]] == triangle;
      if (j == n) return owner_[corners[2]] == triangle;
      // The neighbor has the edge the other way round.
      if (j == 0) return corners[0] < corners[1];
      if (k == 0) return corners[1] < corners[2];
      if (i == 0) return corners[2] < corners[0];
      return true;
    };
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n - i; ++j) {
        if (!is_mine(i, j)) continue;
        const double u = static_cast<double>(i) / n;
        const double v = static_cast<double>(j) / n;
        look_at_point(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]), triangle, notes);
      }
    }
  }

  void look_at_point(const Point_3& x, int triangle, Notes& notes) const {
    const double spacing = spacing_at(x, notes);
    const double too_near = least_part * spacing;
    double nearest = infinity;
    for (const Near& near : notes.near) {
      nearest = std::min(nearest, squared_distance(x, near.sample));
      if (nearest <= too_near * too_near) return;
    }
    if (nearest >= spacing_part * spacing * (spacing_part * spacing)) {
      notes.found.push_back({x, spacing, false, triangle});
      return;
    }
    bool has_pole = false;
    bool is_close = false;
    for (const Near& near : notes.near) {
      const double square = squared_distance(x, near.pole);
      if (square < near.inner_square) {
        notes.found.push_back({x, spacing, true, triangle});
        return;
      }
      is_close = is_close || square <= near.outer_square;
      has_pole = has_pole || near.outer_square > 0;
    }
    if (has_pole && !is_close) notes.found.push_back({x, spacing, true, triangle});
  }

  /// Of the spacing in the middle: so far from it all is known that matters. The grid tells of a sample that wants w
  /// within 2 w, and spacings grow with the slope; farther away, points could come too near to samples unseen.
  static constexpr double largest = 0.65;

  const Sampled_balls_3& balls_;
  const Triangle_mesh_3& surface_;
  const std::vector<double>& wanted_;
  double gap_;
  double coarsest_;
  const Graded_grid_3& grid_;
  Graded_grid_3 open_;
  Graded_grid_3 rough_;
  std::vector<int> owner_;  ///< per vertex a triangle that has it
};

}  // namespace

std::vector<double> wanted_spacing(const Sampled_balls_3& balls, std::span<const int> crowded, double finest) {
  // A little less is not worth more samples.
  constexpr double enough = 0.8;
  const std::vector<double>& before = balls.samples.spacing;
  std::vector<double> wanted = before;
  const auto halve = [&](std::size_t s) {
    const double spacing = std::max(before[s] / 2, finest);
    if (spacing < enough * before[s]) wanted[s] = spacing;
  };
  for (std::size_t s = 0; s < wanted.size(); ++s)
    if (balls.poles()[s] < 0) halve(s);
  for (const int s : crowded) halve(static_cast<std::size_t>(s));
  grade(balls.delaunay(), before, wanted);
  return wanted;
}

std::vector<int> Sampled_balls_3::triangulate(const Solid_3& solid, Progress& progress) {
  struct Pole {
    Point_3 center;
    double radius = -1;
    bool operator==(const Pole&) const = default;
  };
  const auto pole_of = [&](std::size_t sample) -> Pole {
    const int c = poles()[sample];
    if (c < 0) return {};
    return {delaunay().circumcenters[c], delaunay().circumradii[c]};
  };
  std::vector<Pole> before(poles().size());
  for (std::size_t s = 0; s < before.size(); ++s) before[s] = pole_of(s);
  std::vector<int> renewed;
  const auto add_to_triangulation = [&] {
    renewed = triangulation_.add(std::span(samples.points).subspan(delaunay().points.size()), progress);
  };
  const auto add_to_grid = [&] {
    if (!grid_) grid_.emplace(samples.covering_radius);
    for (std::size_t s = grid_->size(); s < samples.points.size(); ++s)
      grid_->add(samples.points[s], samples.spacing[s]);
  };
  at_once(progress, add_to_triangulation, add_to_grid);
  is_settled.resize(samples.points.size(), 0);
  for (const int s : poles_.update(samples, delaunay(), renewed, solid, progress))
    if (s >= std::ssize(before) || !(pole_of(s) == before[s])) is_settled[s] = 0;
  return renewed;
}

void Sampled_balls_3::set_spacing(std::vector<double> spacing) {
  if (spacing == samples.spacing) return;
  samples.spacing = std::move(spacing);
  grid_.emplace(samples.covering_radius);
  for (std::size_t s = 0; s < samples.points.size(); ++s) grid_->add(samples.points[s], samples.spacing[s]);
}

std::size_t add_samples(Sampled_balls_3& balls, const Triangle_mesh_3& surface, const std::vector<double>& wanted,
                        double gap, Progress& progress) {
  const Restless restless = find_restless(balls, wanted, progress);
  balls.set_spacing(wanted);
  const Search search(balls, surface, gap, restless, progress);
  constexpr std::size_t block = 4096;
  const std::size_t count = surface.triangles.size();
  std::vector<std::vector<Candidate>> found((count + block - 1) / block);
  parallel_blocks(found.size(), progress, [&](std::size_t b) {
    Search::Notes notes;
    for (std::size_t t = b * block; t < std::min(count, (b + 1) * block); ++t)
      search.look_at(static_cast<int>(t), notes);
    found[b] = std::move(notes.found);
  });

  Graded_grid_3 added(balls.samples.covering_radius);
  std::vector<double> spacings;
  balls.is_settled.assign(wanted.size(), 1);
  for (const auto& part : found) {
    for (const Candidate& candidate : part) {
      double spacing = candidate.spacing;
      double nearest = infinity;
      added.for_near(candidate.point, spacing, [&](int i) {
        const double d = distance(added.point(i), candidate.point);
        nearest = std::min(nearest, d);
        spacing = std::min(spacing, spacings[i] + slope * d);
      });
      if (nearest < (candidate.fills_a_gap ? gap_spacing_part : spacing_part) * spacing) continue;
      added.add(candidate.point, spacing);
      spacings.push_back(spacing);
      const auto& [a, b, c] = surface.triangles[candidate.triangle];
      const Point_3 normal =
          cross(surface.vertices[b] - surface.vertices[a], surface.vertices[c] - surface.vertices[a]);
      const double length = std::sqrt(dot(normal, normal));
      balls.samples.points.push_back(candidate.point);
      balls.samples.normals.push_back(length > 0 ? (1 / length) * normal : normal);
      balls.samples.spacing.push_back(spacing);
    }
  }
  return spacings.size();
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/disjoint_sets.h"
#include "geometries/parallel.h"
#include "geometries/union_3/orthogonal_spheres_3.h"
#include "geometries/union_3/regular_3.h"

namespace mesecina {

namespace {

/// The cells that have each ball.
struct Stars {
  std::vector<int> offsets;
  std::vector<int> cells;
};

Stars stars_of_balls(const Regular_3& regular) {
  Stars stars;
  stars.offsets.assign(regular.balls.size() + 1, 0);
  for (const auto& corners : regular.cells)
    for (const int ball : corners)
      if (ball >= 0) ++stars.offsets[ball + 1];
  std::partial_sum(stars.offsets.begin(), stars.offsets.end(), stars.offsets.begin());
  stars.cells.resize(stars.offsets.back());
  std::vector<int> next(stars.offsets.begin(), stars.offsets.end() - 1);
  for (std::size_t c = 0; c < regular.cells.size(); ++c)
    for (const int ball : regular.cells[c])
      if (ball >= 0) stars.cells[next[ball]++] = static_cast<int>(c);
  return stars;
}

/// What the cells around an edge say of it.
struct Edge_star {
  int other = 0;
  bool has_cell = false;
  bool has_gap = false;  ///< a cell around it is not in the complex
  bool has_triangle = false;
};

class Dual_builder {
 public:
  Dual_builder(std::shared_ptr<const Regular_3> regular, Progress& progress)
      : regular_(*regular), progress_(progress), spheres_(regular_.balls) {
    result_.regular = std::move(regular);
  }

  Dual_3 build() {
    progress_.begin_stage("dual complex");
    Stars stars;
    const auto classify_across_facets = [&] {
      classify_cells();
      classify_triangles();
    };
    at_once(progress_, classify_across_facets, [&] { stars = stars_of_balls(regular_); });
    classify_edges_and_vertices(stars);
    return std::move(result_);
  }

 private:
  void classify_cells() {
    result_.has_cell.assign(regular_.cells.size(), 0);
    result_.is_flat.assign(regular_.cells.size(), 0);
    parallel_for(regular_.cells.size(), progress_, [&](std::size_t c) {
      if (regular_.is_infinite(static_cast<int>(c))) return;
      const auto sign = spheres_.sign(regular_.cells[c]);
      result_.has_cell[c] = sign != CGAL::LARGER;
      result_.is_flat[c] = sign == CGAL::EQUAL;
    });
  }

  /// The three other places of a cell, so that the normal of these corners points away from the i-th.
  static std::array<int, 3> places_across(int i) {
    constexpr std::array<std::array<int, 3>, 4> places{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    return places[i];
  }

  void classify_triangles() {
    const std::size_t count = regular_.cells.size();
    has_triangle_.assign(count, {});
    std::vector<std::array<Simplex_kind_3, 4>> kinds(count);
    constexpr std::size_t block = 8192;
    const std::size_t blocks = (count + block - 1) / block;
    const auto for_facets = [&](std::size_t b, const auto& use) {
      for (std::size_t c = b * block; c < std::min(count, (b + 1) * block); ++c)
        for (int i = 0; i < 4; ++i) use(static_cast<int>(c), i, kinds[c][i]);
    };
    std::vector<std::size_t> first(blocks + 1, 0);
    parallel_blocks(blocks, progress_, [&](std::size_t b) {
      std::size_t found = 0;
      for_facets(b, [&](int c, int i, Simplex_kind_3& kind) {
        kind = c < regular_.neighbors[c][i] ? kind_of_triangle(c, i) : Simplex_kind_3::outside;
        if (kind != Simplex_kind_3::outside) ++found;
      });
      first[b + 1] = found;
    });
    std::partial_sum(first.begin(), first.end(), first.begin());
    result_.triangles.resize(first.back());
    parallel_blocks(blocks, progress_, [&](std::size_t b) {
      std::size_t next = first[b];
      for_facets(b, [&](int c, int i, Simplex_kind_3 kind) {
        if (kind == Simplex_kind_3::outside) return;
        const int across = regular_.neighbors[c][i];
        Dual_3::Triangle& triangle = result_.triangles[next++];
        const auto places = places_across(i);
        for (int k = 0; k < 3; ++k) triangle.balls[k] = regular_.cells[c][places[k]];
        triangle.cells = {c, across};
        triangle.kind = kind;
        has_triangle_[c][i] = true;
        has_triangle_[across][place_of(across, c, triangle.balls)] = true;
      });
    });
  }

  /// The place of `cell` across from which `neighbor` lies with these corners in common.
  int place_of(int cell, int neighbor, const std::array<int, 3>& common) const {
    for (int i = 0; i < 4; ++i) {
      if (regular_.neighbors[cell][i] == neighbor && std::ranges::count(common, regular_.cells[cell][i]) == 0) return i;
    }
    return 0;
  }

  Simplex_kind_3 kind_of_triangle(int cell, int place) const {
    std::array<int, 3> balls{};
    const auto places = places_across(place);
    for (int k = 0; k < 3; ++k) balls[k] = regular_.cells[cell][places[k]];
    if (std::ranges::min(balls) < 0) return Simplex_kind_3::outside;
    const int across = regular_.neighbors[cell][place];
    const int cells_in = result_.has_cell[cell] + result_.has_cell[across];
    if (cells_in == 2) return Simplex_kind_3::interior;
    if (cells_in == 1) return Simplex_kind_3::regular;
    if (spheres_.sign(balls) == CGAL::LARGER) return Simplex_kind_3::outside;
    const int apex = regular_.cells[cell][place];
    const int other = regular_.cells[across][place_of(across, cell, balls)];
    for (const int opposite : {apex, other}) {
      if (opposite >= 0 && spheres_.is_in_conflict(opposite, balls)) return Simplex_kind_3::outside;
    }
    return Simplex_kind_3::singular;
  }

  void classify_edges_and_vertices(const Stars& stars) {
    const std::size_t count = regular_.balls.size();
    result_.vertices.assign(count, Simplex_kind_3::outside);
    // Each block has an array of all balls.
    constexpr std::size_t most_blocks = 16;
    constexpr std::size_t least_block = 1024;
    const std::size_t block = std::max(least_block, count / most_blocks + 1);
    const std::size_t blocks = (count + block - 1) / block;
    std::vector<std::vector<Dual_3::Edge>> edges(blocks);
    parallel_blocks(blocks, progress_, [&](std::size_t b) {
      std::vector<int> slot(count, -1);
      std::vector<Edge_star> star;
      for (std::size_t v = b * block; v < std::min(count, (b + 1) * block); ++v)
        if (regular_.cell_of_ball[v] >= 0) classify_star(static_cast<int>(v), stars, slot, star, edges[b]);
    });
    for (const auto& part : edges) result_.edges.insert(result_.edges.end(), part.begin(), part.end());
  }

  void classify_star(int ball, const Stars& stars, std::vector<int>& slot, std::vector<Edge_star>& star,
                     std::vector<Dual_3::Edge>& edges) {
    star.clear();
    const std::span<const int> cells(stars.cells.data() + stars.offsets[ball],
                                     stars.cells.data() + stars.offsets[ball + 1]);
    for (const int cell : cells) {
      const auto& corners = regular_.cells[cell];
      for (int i = 0; i < 4; ++i) {
        const int other = corners[i];
        if (other < 0 || other == ball) continue;
        if (slot[other] < 0) {
          slot[other] = static_cast<int>(star.size());
          star.push_back({other});
        }
        Edge_star& edge = star[slot[other]];
        edge.has_cell = edge.has_cell || result_.has_cell[cell];
        edge.has_gap = edge.has_gap || !result_.has_cell[cell];
        for (int k = 0; k < 4; ++k)
          if (k != i && corners[k] != ball && has_triangle_[cell][k]) edge.has_triangle = true;
      }
    }
    bool has_edge = false;
    bool has_gap = false;
    for (const Edge_star& edge : star) {
      const Simplex_kind_3 kind = kind_of_edge(ball, edge, cells);
      has_gap = has_gap || edge.has_gap;
      if (kind == Simplex_kind_3::outside) continue;
      has_edge = true;
      if (ball < edge.other) edges.push_back({{ball, edge.other}, kind});
    }
    for (const Edge_star& edge : star) slot[edge.other] = -1;
    Simplex_kind_3& kind = result_.vertices[ball];
    if (has_edge) {
      kind = has_gap ? Simplex_kind_3::regular : Simplex_kind_3::interior;
    } else {
      const bool is_taken = std::ranges::any_of(
          star, [&](const Edge_star& edge) { return spheres_.is_in_conflict(edge.other, std::array{ball}); });
      kind = is_taken ? Simplex_kind_3::outside : Simplex_kind_3::singular;
    }
  }

  Simplex_kind_3 kind_of_edge(int ball, const Edge_star& edge, std::span<const int> cells) const {
    if (edge.has_triangle) return edge.has_gap ? Simplex_kind_3::regular : Simplex_kind_3::interior;
    if (spheres_.sign(std::array{ball, edge.other}) == CGAL::LARGER) return Simplex_kind_3::outside;
    for (const int cell : cells) {
      const auto& corners = regular_.cells[cell];
      if (std::ranges::count(corners, edge.other) == 0) continue;
      for (const int opposite : corners) {
        if (opposite >= 0 && opposite != ball && opposite != edge.other &&
            spheres_.is_in_conflict(opposite, std::array{ball, edge.other}))
          return Simplex_kind_3::outside;
      }
    }
    return Simplex_kind_3::singular;
  }

  const Regular_3& regular_;
  Progress& progress_;
  Orthogonal_spheres_3 spheres_;
  std::vector<std::array<bool, 4>> has_triangle_;  ///< per cell and place
  Dual_3 result_;
};

}  // namespace

Dual_3 dual_complex(std::shared_ptr<const Regular_3> regular, Progress& progress) {
  return Dual_builder(std::move(regular), progress).build();
}

Topology topology(const Dual_3& dual) {
  const Regular_3& regular = *dual.regular;
  Topology result;
  Disjoint_sets parts(regular.balls.size());
  for (const Dual_3::Edge& edge : dual.edges) parts.join(edge.balls[0], edge.balls[1]);
  std::int64_t vertices = 0;
  for (std::size_t v = 0; v < dual.vertices.size(); ++v) {
    if (dual.vertices[v] == Simplex_kind_3::outside) continue;
    ++vertices;
    if (parts.find(static_cast<int>(v)) == static_cast<int>(v)) ++result.betti[0];
  }
  // Cavities are the parts of the complement, which cells and triangles that are not in the complex join.
  const std::size_t count = regular.cells.size();
  Disjoint_sets rest(count + 1);
  const int outer = static_cast<int>(count);
  std::vector<std::array<bool, 4>> is_wall(count);
  for (const Dual_3::Triangle& triangle : dual.triangles) {
    for (int side = 0; side < 2; ++side) {
      const int cell = triangle.cells[side];
      for (int i = 0; i < 4; ++i) {
        if (regular.neighbors[cell][i] == triangle.cells[1 - side] &&
            std::ranges::count(triangle.balls, regular.cells[cell][i]) == 0)
          is_wall[cell][i] = true;
      }
    }
  }
  std::int64_t cells = 0;
  for (std::size_t c = 0; c < count; ++c) {
    if (dual.has_cell[c]) {
      ++cells;
      continue;
    }
    if (regular.is_infinite(static_cast<int>(c))) rest.join(static_cast<int>(c), outer);
    for (int i = 0; i < 4; ++i)
      if (!is_wall[c][i]) rest.join(static_cast<int>(c), regular.neighbors[c][i]);
  }
  for (std::size_t c = 0; c < count; ++c) {
    const int cell = static_cast<int>(c);
    if (!dual.has_cell[c] && rest.find(cell) == cell && rest.find(outer) != cell) ++result.betti[2];
  }
  result.euler = vertices - static_cast<std::int64_t>(dual.edges.size()) +
                 static_cast<std::int64_t>(dual.triangles.size()) - cells;
  result.betti[1] = result.betti[0] + result.betti[2] - result.euler;
  return result;
}

}  // namespace mesecina

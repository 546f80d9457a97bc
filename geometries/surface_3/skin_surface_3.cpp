// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_3/skin_surface_3.h"

#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/outcome.h"
#include "geometries/parallel.h"
#include "geometries/surface_3/closed_mesh_3.h"
#include "geometries/surface_3/mixed_complex_3.h"

namespace mesecina {

namespace {

using Corner = Mixed_complex_3::Corner;
using Place = Mixed_complex_3::Place;

/// A tetrahedron of the mixed complex's subdivision: its corners are those of an ascending chain of faces.
struct Flag {
  std::array<std::uint8_t, 4> faces{};  ///< the places of the simplex and, shifted by 4, of the dual
  bool is_positive = false;             ///< orientation, where that of the cell is
};

/// From a ball of a cell and the cell itself, each step adds a ball to the simplex or takes one from the dual.
constexpr std::array<Flag, 192> make_flags() {
  std::array<Flag, 192> flags{};
  std::size_t count = 0;
  std::array<int, 4> order{0, 1, 2, 3};
  do {
    bool is_even = true;
    for (int i = 0; i < 4; ++i)
      for (int j = i + 1; j < 4; ++j) is_even = is_even == (order[i] < order[j]);
    for (unsigned added = 0; added < 8; ++added) {
      Flag flag{{}, is_even};
      unsigned simplex = 1U << static_cast<unsigned>(order[0]);
      unsigned dual = 15;
      flag.faces[0] = static_cast<std::uint8_t>(simplex | dual << 4U);
      for (int step = 1; step < 4; ++step) {
        const unsigned ball = 1U << static_cast<unsigned>(order[step]);
        if ((added >> static_cast<unsigned>(step - 1) & 1U) != 0) {
          simplex |= ball;
        } else {
          dual &= ~ball;
          flag.is_positive = !flag.is_positive;
        }
        flag.faces[step] = static_cast<std::uint8_t>(simplex | dual << 4U);
      }
      flags[count++] = flag;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return flags;
}
constexpr std::array<Flag, 192> flags = make_flags();

/// A tetrahedron through which the surface goes.
struct Cut {
  std::array<int, 4> corners{};   ///< those inside of the surface first
  std::array<int, 4> vertices{};  ///< from each corner inside to each one outside: three or four
  int ball = 0;                   ///< the mixed cell is of a simplex that has it
  std::uint8_t inside = 0;        ///< how many corners are
  bool is_positive = false;       ///< orientation of the corners
};

class Skin_mesher {
 public:
  Skin_mesher(const Regular_3& regular, double shrink_factor, double tolerance, Progress& progress)
      : regular_(regular),
        shrink_factor_(shrink_factor),
        tolerance_(tolerance),
        progress_(progress),
        complex_(regular, shrink_factor, progress) {}

  Triangle_mesh_3 mesh() {
    progress_.begin_stage("skin surface");
    cut();
    place_vertices();
    make_triangles();
    refine();
    Triangle_mesh_3 mesh;
    mesh.vertices = std::move(vertices_);
    mesh.triangles.reserve(triangles_.size());
    for (const Triangle& triangle : triangles_) mesh.triangles.push_back(triangle.vertices);
    return mesh;
  }

 private:
  /// Edges are divided at most so often, each into halves.
  static constexpr int most_rounds = 12;
  /// Of the corners of a cut: weights of those inside, which add up to `one`, and of the others, which do so, too. Each
  /// segment from a mixture of corners inside to one of those outside meets the surface once, mostly.
  using Mixture = std::array<std::uint16_t, 4>;
  static constexpr std::uint16_t one = 1U << static_cast<unsigned>(most_rounds);
  struct Triangle {
    std::array<int, 3> vertices{};
    int cut = 0;
    std::array<Mixture, 3> mixtures{};
  };

  /// For loops that are as long as i gets large.
  void check_often(std::size_t i) const {
    constexpr std::size_t often = 16384;
    if (i % often == 0) progress_.check();
  }
  template <class Element>
  void sort(std::vector<Element>& elements) const {
    parallel_region(progress_, [&] {
      tbb::parallel_sort(elements.begin(), elements.end(), [&](const Element& a, const Element& b) {
        progress_.check();
        return a < b;
      });
    });
  }

  void cut() {
    constexpr std::size_t block = 512;
    const std::size_t count = regular_.cells.size();
    struct Found {
      std::vector<Cut> cuts;
      std::vector<Corner> corners;  ///< four for each
    };
    std::vector<Found> parts((count + block - 1) / block);
    parallel_blocks(parts.size(), progress_, [&](std::size_t b) {
      for (std::size_t c = b * block; c < std::min(count, (b + 1) * block); ++c)
        if (!regular_.is_infinite(static_cast<int>(c))) cut_cell(static_cast<int>(c), parts[b].cuts, parts[b].corners);
    });
    std::vector<Corner> corners;
    for (Found& part : parts) {
      cuts_.insert(cuts_.end(), part.cuts.begin(), part.cuts.end());
      corners.insert(corners.end(), part.corners.begin(), part.corners.end());
      part = {};
    }
    corners_ = corners;
    sort(corners_);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    corners_.shrink_to_fit();
    progress_.check();
    parallel_for(cuts_.size(), progress_, [&](std::size_t i) {
      for (int k = 0; k < 4; ++k)
        cuts_[i].corners[k] =
            static_cast<int>(std::ranges::lower_bound(corners_, corners[4 * i + k]) - corners_.begin());
    });
  }

  void cut_cell(int cell, std::vector<Cut>& cuts, std::vector<Corner>& corners) const {
    std::array<Corner, 256> corner_of;
    std::array<bool, 256> is_inside{};
    bool has_inside = false;
    bool has_outside = false;
    for (unsigned dual = 1; dual < 16; ++dual) {
      for (unsigned simplex = dual; simplex > 0; simplex = (simplex - 1) & dual) {
        const unsigned face = simplex | dual << 4U;
        corner_of[face] = complex_.corner(cell, simplex, dual);
        is_inside[face] = complex_.is_inside(corner_of[face]);
        (is_inside[face] ? has_inside : has_outside) = true;
      }
    }
    if (!has_inside || !has_outside) return;
    for (const Flag& flag : flags) {
      const auto& f = flag.faces;
      if (is_inside[f[0]] == is_inside[f[1]] && is_inside[f[1]] == is_inside[f[2]] &&
          is_inside[f[2]] == is_inside[f[3]])
        continue;
      // Corners at the same point are those of faces next to each other.
      if (corner_of[f[0]] == corner_of[f[1]] || corner_of[f[1]] == corner_of[f[2]] ||
          corner_of[f[2]] == corner_of[f[3]])
        continue;
      Cut cut;
      cut.ball = regular_.cells[cell][std::countr_zero(static_cast<unsigned>(f[0]))];
      cut.is_positive = flag.is_positive;
      for (const bool wanted : {true, false}) {
        for (const unsigned face : f)
          if (is_inside[face] == wanted) corners.push_back(corner_of[face]);
        if (wanted)
          cut.inside = static_cast<std::uint8_t>(std::ranges::count_if(f, [&](unsigned i) { return is_inside[i]; }));
      }
      // To sort them takes as many swaps as there are pairs in wrong order.
      for (int i = 0; i < 4; ++i)
        for (int j = i + 1; j < 4; ++j)
          if (!is_inside[f[i]] && is_inside[f[j]]) cut.is_positive = !cut.is_positive;
      cuts.push_back(cut);
    }
  }

  void place_vertices() {
    places_.resize(corners_.size());
    reaches_.resize(corners_.size());
    parallel_for(corners_.size(), progress_, [&](std::size_t i) {
      const Place& place = places_[i] = complex_.place(corners_[i]);
      reaches_[i] = distance(place.point, place.dual_point) + std::sqrt(std::abs(place.weight)) + tolerance_;
    });
    struct Use {
      std::array<int, 2> corners;
      int cut;
      int place;
      auto operator<=>(const Use&) const = default;
    };
    corners_ = {};
    std::vector<Use> uses;
    uses.reserve(4 * cuts_.size());
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      check_often(i);
      int place = 0;
      for (int a = 0; a < cuts_[i].inside; ++a)
        for (int b = cuts_[i].inside; b < 4; ++b)
          uses.push_back({{cuts_[i].corners[a], cuts_[i].corners[b]}, static_cast<int>(i), place++});
    }
    sort(uses);
    std::vector<const Use*> first;
    for (const Use& use : uses) {
      if (first.empty() || first.back()->corners != use.corners) first.push_back(&use);
      cuts_[use.cut].vertices[use.place] = static_cast<int>(first.size()) - 1;
    }
    vertices_.resize(first.size());
    parallel_for(first.size(), progress_, [&](std::size_t v) {
      const Use& use = *first[v];
      vertices_[v] = meet(places_[use.corners[0]], places_[use.corners[1]], cuts_[use.cut].ball);
    });
  }

  /// Where the segment from a place inside to one outside, in one mixed cell, meets the surface: there the value is a
  /// quadratic function of the way.
  Point_3 meet(const Place& inside, const Place& outside, int ball) const {
    const Point_3& origin = regular_.balls[ball].center;
    // What is far away has few digits.
    const bool is_inside_nearer =
        squared_distance(inside.dual_point, origin) <= squared_distance(outside.dual_point, origin);
    const Place& from = is_inside_nearer ? inside : outside;
    const Place& to = is_inside_nearer ? outside : inside;
    const Point_3 way = to.point - from.point;
    const Point_3 dual_way = to.dual_point - from.dual_point;
    const double s = shrink_factor_;
    const double constant = complex_.value(from);
    const double linear =
        2 * s * dot(from.dual_point - origin, dual_way) - (1 - s) * (to.weight - from.weight - dot(way, way));
    const double quadratic = s * dot(dual_way, dual_way) - (1 - s) * dot(way, way);
    const double discriminant = std::max(0.0, linear * linear - 4 * quadratic * constant);
    const double root = -(linear + std::copysign(std::sqrt(discriminant), linear)) / 2;
    const auto is_on_way = [](double t) { return t >= 0 && t <= 1; };
    double t = constant / root;
    if (!is_on_way(t) && is_on_way(root / quadratic)) t = root / quadratic;
    if (!is_on_way(t)) {
      const double change = constant - complex_.value(to);
      t = change == 0 ? 0 : std::clamp(constant / change, 0.0, 1.0);
    }
    return (1 - s) * (from.point + t * way) + s * (from.dual_point + t * dual_way);
  }

  void make_triangles() {
    triangles_.reserve(3 * cuts_.size() / 2);
    for (std::size_t c = 0; c < cuts_.size(); ++c) {
      check_often(c);
      const Cut& cut = cuts_[c];
      const auto add = [&](int i, int j, int k) {
        if (!cut.is_positive) std::swap(j, k);
        Triangle triangle{{cut.vertices[i], cut.vertices[j], cut.vertices[k]}, static_cast<int>(c), {}};
        const int outside = 4 - cut.inside;
        const auto mixture = [&](int vertex) {
          Mixture result{};
          result[vertex / outside] = one;
          result[cut.inside + vertex % outside] = one;
          return result;
        };
        triangle.mixtures = {mixture(i), mixture(j), mixture(k)};
        triangles_.push_back(triangle);
      };
      add(0, 1, cut.inside == 2 ? 3 : 2);
      if (cut.inside == 2) add(0, 3, 2);
    }
  }

  Place mixed(const Cut& cut, const Mixture& mixture, int begin, int end) const {
    Place result;
    double sum = 0;
    for (int i = begin; i < end; ++i) sum += mixture[i] / reaches_[cut.corners[i]];
    const auto part = [&](int i) { return mixture[i] / (sum * reaches_[cut.corners[i]]); };
    for (int i = begin; i < end; ++i) {
      const Place& place = places_[cut.corners[i]];
      result.point = result.point + part(i) * place.point;
      result.dual_point = result.dual_point + part(i) * place.dual_point;
      result.weight += part(i) * place.weight;
      for (int j = begin; j < i; ++j)
        result.weight -= part(i) * part(j) * squared_distance(place.point, places_[cut.corners[j]].point);
    }
    const auto& [center, radius] = regular_.balls[cut.ball];
    result.dual_power = squared_distance(result.dual_point, center) - radius * radius;
    return result;
  }
  /// Nothing where both mixtures are on the same side of the surface, as may be where it passes an edge twice.
  std::optional<Point_3> on_surface(const Cut& cut, const Mixture& mixture) const {
    const Place inside = mixed(cut, mixture, 0, cut.inside);
    const Place outside = mixed(cut, mixture, cut.inside, 4);
    if (complex_.value(inside) > 0 || complex_.value(outside) < 0) return std::nullopt;
    return meet(inside, outside, cut.ball);
  }

  static Mixture halfway(const Mixture& a, const Mixture& b) {
    Mixture result{};
    for (int i = 0; i < 4; ++i) result[i] = static_cast<std::uint16_t>((a[i] + b[i]) / 2);
    return result;
  }

  /// Divides edges that are too far from the surface, on both sides.
  void refine() {
    std::vector<Triangle> fresh = std::move(triangles_);
    triangles_.clear();
    for (int round = 0; !fresh.empty(); ++round) {
      progress_.check();
      std::vector<std::uint8_t> is_wanted(round < most_rounds ? fresh.size() : 0);  // a bit for each edge
      parallel_for(is_wanted.size(), progress_, [&](std::size_t i) {
        for (int k = 0; k < 3; ++k)
          if (is_far(fresh[i], k))
            is_wanted[i] = static_cast<std::uint8_t>(is_wanted[i] | 1U << static_cast<unsigned>(k));
      });
      struct Middle {
        std::array<int, 2> edge;
        int triangle;
        int place;
        auto operator<=>(const Middle&) const = default;
      };
      std::vector<Middle> middles;
      for (std::size_t i = 0; i < is_wanted.size(); ++i)
        for (int k = 0; k < 3; ++k)
          if ((is_wanted[i] >> static_cast<unsigned>(k) & 1U) != 0)
            middles.push_back({edge_of(fresh[i], k), static_cast<int>(i), k});
      sort(middles);
      middles.erase(
          std::unique(middles.begin(), middles.end(), [](const auto& a, const auto& b) { return a.edge == b.edge; }),
          middles.end());
      const std::size_t before = vertices_.size();
      vertices_.resize(before + middles.size());
      parallel_for(middles.size(), progress_, [&](std::size_t m) {
        const Triangle& triangle = fresh[middles[m].triangle];
        vertices_[before + m] = *on_surface(cuts_[triangle.cut], middle_of(triangle, middles[m].place));
      });
      std::vector<Triangle> next;
      for (std::size_t i = 0; i < fresh.size(); ++i) {
        check_often(i);
        const Triangle& triangle = fresh[i];
        if (middles.empty()) {
          triangles_.push_back(triangle);
          continue;
        }
        std::array<int, 3> divided{};
        for (int k = 0; k < 3; ++k) {
          const auto edge = edge_of(triangle, k);
          const auto found = std::ranges::lower_bound(middles, edge, {}, &Middle::edge);
          divided[k] =
              found != middles.end() && found->edge == edge ? static_cast<int>(before + (found - middles.begin())) : -1;
        }
        divide(triangle, divided, next);
      }
      fresh = std::move(next);
    }
  }

  /// From its k-th corner to the next one, ascending.
  static std::array<int, 2> edge_of(const Triangle& triangle, int k) {
    const auto [a, b] = std::minmax(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
    return {a, b};
  }
  static Mixture middle_of(const Triangle& triangle, int k) {
    return halfway(triangle.mixtures[k], triangle.mixtures[(k + 1) % 3]);
  }

  bool is_far(const Triangle& triangle, int k) const {
    const auto [a, b] = edge_of(triangle, k);
    const Point_3 way = vertices_[b] - vertices_[a];
    const double square = dot(way, way);
    // No arc is as far from a shorter chord.
    if (square <= tolerance_ * tolerance_) return false;
    const auto middle = on_surface(cuts_[triangle.cut], middle_of(triangle, k));
    if (!middle) return false;
    const Point_3 to = *middle - vertices_[a];
    const double part = std::clamp(dot(to, way) / square, 0.0, 1.0);
    const Point_3 off = to - part * way;
    return dot(off, off) > tolerance_ * tolerance_;
  }

  /// Those that need not be divided are done.
  void divide(const Triangle& triangle, const std::array<int, 3>& divided, std::vector<Triangle>& next) {
    const auto count = std::ranges::count_if(divided, [](int vertex) { return vertex >= 0; });
    if (count == 0) {
      triangles_.push_back(triangle);
      return;
    }
    std::array<int, 6> vertices{};
    std::array<Mixture, 6> mixtures{};
    // So that the first edge is divided, and the last one is not, if there is one of each.
    int turn = 0;
    while (count < 3 && !(divided[turn] >= 0 && divided[(turn + 2) % 3] < 0)) ++turn;
    for (int k = 0; k < 3; ++k) {
      const int from = (k + turn) % 3;
      vertices[k] = triangle.vertices[from];
      mixtures[k] = triangle.mixtures[from];
      vertices[3 + k] = divided[from];
      mixtures[3 + k] = middle_of(triangle, from);
    }
    const auto add = [&](int i, int j, int k) {
      next.push_back({{vertices[i], vertices[j], vertices[k]}, triangle.cut, {mixtures[i], mixtures[j], mixtures[k]}});
    };
    if (count == 1) {
      add(0, 3, 2);
      add(3, 1, 2);
    } else if (count == 2) {
      add(3, 1, 4);
      add(0, 3, 4);
      add(0, 4, 2);
    } else {
      add(0, 3, 5);
      add(3, 1, 4);
      add(5, 4, 2);
      add(3, 4, 5);
    }
  }

  const Regular_3& regular_;
  double shrink_factor_;
  double tolerance_;
  Progress& progress_;
  Mixed_complex_3 complex_;
  std::vector<Cut> cuts_;
  std::vector<Corner> corners_;
  std::vector<Place> places_;  ///< per corner
  /// Per corner: by how much it counts less in a mixture, so that corners far away are not all that counts.
  std::vector<double> reaches_;
  std::vector<Point_3> vertices_;
  std::vector<Triangle> triangles_;
};

/// Balls with a radius, around the origin and of a size of about 1, so that nothing overflows.
struct Moved_balls {
  std::vector<Ball_3> balls;
  Point_3 middle;    ///< where the origin was
  int exponent = 0;  ///< of two, by which lengths were multiplied
};

Moved_balls moved_to_origin(const std::vector<Ball_3>& balls) {
  Moved_balls moved;
  Box box;
  double size = 0;
  for (const Ball_3& ball : balls) {
    if (!(ball.radius > 0)) continue;
    moved.balls.push_back(ball);
    box.add(ball.center);
    size = std::max(size, ball.radius);
  }
  if (moved.balls.empty()) throw Unavailable("there are no balls with a radius");
  const auto between = [](double low, double high) { return low / 2 + high / 2; };
  moved.middle = {between(box.lower.x, box.upper.x), between(box.lower.y, box.upper.y),
                  between(box.lower.z, box.upper.z)};
  for (const double half : {box.upper.x - moved.middle.x, box.upper.y - moved.middle.y, box.upper.z - moved.middle.z})
    size = std::max(size, half);
  moved.exponent = -std::ilogb(size);
  for (auto& [center, radius] : moved.balls) {
    const auto scaled = [&](double x, double origin) { return std::ldexp(x - origin, moved.exponent); };
    center = {scaled(center.x, moved.middle.x), scaled(center.y, moved.middle.y), scaled(center.z, moved.middle.z)};
    radius = std::ldexp(radius, moved.exponent);
  }
  // Smaller ones have no square.
  constexpr double least = 1e-150;
  std::erase_if(moved.balls, [](const Ball_3& ball) { return ball.radius < least; });
  return moved;
}

/// Balls of which the shrunk ones are those given, and around them points so far away that all other power cells are
/// bounded and no patch of the surface reaches theirs. `balls`: as those moved to the origin.
std::vector<Ball_3> surrounded(const std::vector<Ball_3>& balls, double shrink_factor) {
  std::vector<Ball_3> grown;
  grown.reserve(balls.size() + 4);
  for (const auto& [center, radius] : balls) grown.push_back({center, radius / std::sqrt(shrink_factor)});
  constexpr double far = 256;
  const double size = far / shrink_factor;
  for (const Point_3& d : {Point_3{1, 1, 1}, Point_3{1, -1, -1}, Point_3{-1, 1, -1}, Point_3{-1, -1, 1}})
    grown.push_back({size * d, 0});
  return grown;
}

}  // namespace

Triangle_mesh_3 skin_surface(const std::vector<Ball_3>& balls, double shrink_factor, double tolerance,
                             Progress& progress) {
  const Moved_balls moved = moved_to_origin(balls);
  constexpr double finest = 1e-7;
  const double scaled_tolerance = std::max(finest, std::ldexp(tolerance, moved.exponent));
  const auto triangulated = [&] {
    const Regular_3 regular = regular_triangulation(surrounded(moved.balls, shrink_factor), progress);
    return Skin_mesher(regular, shrink_factor, scaled_tolerance, progress).mesh();
  };
  Triangle_mesh_3 mesh = triangulated();
  // What is cut out of thin cells is thin.
  constexpr double short_part = 0.25;
  std::vector<int> pieces(mesh.triangles.size(), 0);
  collapse_short_edges(mesh, pieces, short_part * scaled_tolerance, progress);
  const auto placed = [&](double x, double origin) { return origin + std::ldexp(x, -moved.exponent); };
  for (Point_3& p : mesh.vertices)
    p = {placed(p.x, moved.middle.x), placed(p.y, moved.middle.y), placed(p.z, moved.middle.z)};
  return mesh;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/surface_error_3/surface_error_3.h"

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "geometries/parallel.h"
#include "geometries/solid_3/surface_locator_3.h"
#include "geometries/surface_error_3/union_distance_3.h"

namespace mesecina {

namespace {

constexpr std::size_t block = 256;

/// Calls body(begin, end) for blocks of [0, count).
template <class Body>
void parallel_small_blocks(std::size_t count, Progress& progress, const Body& body) {
  parallel_blocks((count + block - 1) / block, progress,
                  [&](std::size_t b) { body(b * block, std::min(count, (b + 1) * block)); });
}

/// A piece of the surface.
struct Piece {
  Corners_3 corners;
  int ball = 0;         ///< position of the nearest one to its middle
  double distance = 0;  ///< of its middle to that ball
};

Point_3 middle_of(const Corners_3& t) { return (1.0 / 3) * (t[0] + t[1] + t[2]); }

/// Of a disk around the middle that holds the piece.
double radius_of(const Corners_3& t) {
  const Point_3 middle = middle_of(t);
  return std::sqrt(
      std::max({squared_distance(middle, t[0]), squared_distance(middle, t[1]), squared_distance(middle, t[2])}));
}

/// Every point of the piece is at most so far from the boundary of the union. A point outside of the union is not
/// farther from it than from one ball, which is a convex function; one inside leaves it on the way to the same piece
/// moved outward.
bool is_surely_near(const Piece& piece, double limit, const Union_distance_3& balls) {
  const Ball_3& ball = balls.ball_at(piece.ball);
  const double reach = limit + ball.radius;
  for (const Point_3& p : piece.corners)
    if (squared_distance(p, ball.center) > reach * reach) return false;
  const Point_3 normal = cross(piece.corners[1] - piece.corners[0], piece.corners[2] - piece.corners[0]);
  const double length = std::sqrt(dot(normal, normal));
  if (length == 0) return false;
  const Point_3 step = (limit / length) * normal;
  return balls.is_free({piece.corners[0] + step, piece.corners[1] + step, piece.corners[2] + step});
}

/// Breadth first, so that bounds of all pieces of one size are known before smaller ones are looked at.
class From_input {
 public:
  From_input(const Surface_locator_3& surface, const Union_distance_3& balls, double tolerance)
      : balls_(balls), tolerance_(tolerance) {
    // Neighbors in this order are near to each other.
    pieces_.reserve(surface.corners().size());
    for (const Corners_3& corners : surface.corners()) pieces_.push_back({corners});
  }

  /// The largest distance found; `resolution` is raised where it was given up.
  double run(double& resolution, Progress& progress) {
    constexpr std::size_t most_pieces = 20'000'000;
    while (!pieces_.empty()) {
      if (pieces_.size() > most_pieces) {
        for (const Piece& piece : pieces_) resolution = std::max(resolution, radius_of(piece.corners));
        break;
      }
      look_at_middles(progress);
      refine(progress);
    }
    return found_;
  }

 private:
  void look_at_middles(Progress& progress) {
    parallel_small_blocks(pieces_.size(), progress, [&](std::size_t begin, std::size_t end) {
      int guess = pieces_[begin].ball;
      for (std::size_t i = begin; i < end; ++i) {
        Piece& piece = pieces_[i];
        const Union_distance_3::Nearest nearest = balls_.nearest(middle_of(piece.corners), guess);
        guess = piece.ball = nearest.position;
        piece.distance = nearest.distance;
      }
    });
    // In a ball a point is at least as deep in the union.
    for (const Piece& piece : pieces_) found_ = std::max(found_, std::abs(piece.distance));
  }

  void refine(Progress& progress) {
    const double limit = found_ + tolerance_;
    std::vector<std::uint8_t> is_done(pieces_.size(), 0);
    std::vector<double> depths(pieces_.size(), 0);
    parallel_small_blocks(pieces_.size(), progress, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Piece& piece = pieces_[i];
        const double radius = radius_of(piece.corners);
        if (piece.distance >= 0 && piece.distance + radius <= limit) {
          is_done[i] = 1;
        } else if (is_surely_near(piece, limit, balls_)) {
          is_done[i] = 1;
        } else if (radius <= tolerance_ || 2 * radius <= limit) {
          if (piece.distance < 0) depths[i] = balls_.depth(middle_of(piece.corners));
          is_done[i] = radius <= tolerance_ || (piece.distance < 0 && depths[i] + radius <= limit) ? 1 : 0;
        }
      }
    });
    for (const double depth : depths) found_ = std::max(found_, depth);
    std::vector<Piece> smaller;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (is_done[i]) continue;
      const auto& [a, b, c] = pieces_[i].corners;
      const Point_3 ab = midpoint(a, b);
      const Point_3 bc = midpoint(b, c);
      const Point_3 ca = midpoint(c, a);
      for (const Corners_3& corners : {Corners_3{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        smaller.push_back({corners, pieces_[i].ball, 0});
    }
    pieces_ = std::move(smaller);
  }

  const Union_distance_3& balls_;
  double tolerance_;
  double found_ = 0;
  std::vector<Piece> pieces_;
};

/// Of a triangle: every point of it is at most so far from the nearest corner.
double covering_radius(const Corners_3& t) {
  std::array<double, 3> squares{squared_distance(t[0], t[1]), squared_distance(t[1], t[2]),
                                squared_distance(t[2], t[0])};
  std::ranges::sort(squares);
  if (squares[2] >= squares[0] + squares[1]) return std::sqrt(squares[2]) / 2;
  const Point_3 normal = cross(t[1] - t[0], t[2] - t[0]);
  return std::sqrt(squares[0] * squares[1] * squares[2] / dot(normal, normal)) / 2;
}

/// Looks for the point of a patch that is farthest from the surface.
class Patch_search {
 public:
  Patch_search(const Union_boundary_3& boundary, const Union_distance_3& balls, const Surface_locator_3& surface,
               double found, double tolerance)
      : boundary_(boundary), balls_(balls), surface_(surface), tolerance_(tolerance), found_(found) {}

  double found() const { return found_; }

  /// `guess` is the position of a triangle that may be near.
  void go_to(std::size_t patch, int guess) {
    const int number = boundary_.patch_balls[patch];
    ball_ = boundary_.dual->regular->balls[number];
    neighbors_ = balls_.neighbors(number);
    guess_ = guess;
    collect_outline(patch);
  }

  /// What can be said of a patch at once.
  struct Glance {
    bool is_small = false;  ///< the patch is surely between its outline and its middle
    double at_middle = 0;   ///< distance of the middle
    double reach = 0;       ///< no point of the patch is farther from the middle
  };
  Glance glance() {
    if (!is_small_) return {};
    return {true, distance_at(middle_, neighbors_), reach_};
  }

  /// Searches the patch. Distances are those of its middle, and of vertices.
  void run(double at_middle, const std::vector<double>& at_vertices) {
    if (!is_small_) {
      for (int octant = 0; octant < 8; ++octant) {
        const auto sign = [octant](int bit) { return (octant & bit) != 0 ? -1.0 : 1.0; };
        const Corners_3 corners{Point_3{sign(1), 0, 0}, {0, sign(2), 0}, {0, 0, sign(4)}};
        look_at(corners, distances_at(corners, neighbors_), neighbors_);
      }
      return;
    }
    for (const Outline& outline : outline_) {
      const Union_boundary_3::Arc& arc = *outline.arc;
      if (arc.from >= 0) {
        const std::array<double, 3> distances{at_middle, at_vertices[arc.from], at_vertices[arc.to]};
        if (bound({middle_, outline.from, outline.to}, distances) + outline.height <= found_ + tolerance_) continue;
      }
      // So many steps that the arc is at most half of the tolerance from its chords.
      const double step = 2 * std::sqrt(tolerance_ / std::max(arc.radius, tolerance_));
      const int steps = std::max(1, static_cast<int>(std::ceil(arc.angle / step)));
      Point_3 from = outline.from;
      double at_from = distance_at(from, neighbors_);
      for (int k = 1; k <= steps; ++k) {
        const Point_3 to = direction_to(arc.point(k, steps));
        const double at_to = distance_at(to, neighbors_);
        look_at({middle_, from, to}, {at_middle, at_from, at_to}, neighbors_);
        from = to;
        at_from = at_to;
      }
    }
  }

 private:
  /// An arc of the outline; `from` and `to` are directions.
  struct Outline {
    const Union_boundary_3::Arc* arc = nullptr;
    Point_3 from;
    Point_3 to;
    double height = 0;  ///< over its chord
  };

  void collect_outline(std::size_t patch) {
    outline_.clear();
    Point_3 sum;
    for (int i = boundary_.patch_offsets[patch]; i < boundary_.patch_offsets[patch + 1]; ++i) {
      for (const Union_boundary_3::Side& side : boundary_.loop(i)) {
        const Union_boundary_3::Arc& arc = boundary_.arcs[side.arc];
        const double height =
            arc.angle < std::numbers::pi ? arc.radius * (1 - std::cos(arc.angle / 2)) : 2 * arc.radius;
        outline_.push_back({&arc, direction_to(arc.point(0, 1)), direction_to(arc.point(1, 1)), height});
        sum = sum + outline_.back().from + outline_.back().to + direction_to(arc.point(1, 2));
      }
    }
    const double length = std::sqrt(dot(sum, sum));
    is_small_ = length > 0;
    if (!is_small_) return;
    middle_ = (1 / length) * sum;
    constexpr double most_reach = 1.2;
    reach_ = 0;
    for (const auto& [arc, from, to, height] : outline_)
      reach_ = std::max(reach_, ball_.radius * distance(middle_, from) + height);
    is_small_ = reach_ <= most_reach * ball_.radius;
  }

  Point_3 direction_to(const Point_3& p) const {
    const Point_3 out = p - ball_.center;
    return (1 / std::sqrt(dot(out, out))) * out;
  }

  /// To the surface, of the point in this direction. Counts when the point is on the boundary.
  double distance_at(const Point_3& direction, std::span<const int> neighbors) {
    const Point_3 p = ball_.center + ball_.radius * direction;
    const Surface_locator_3::Nearest nearest = surface_.nearest(p, guess_);
    guess_ = nearest.position;
    const double distance = std::sqrt(nearest.squared_distance);
    if (distance > found_ && is_exposed(p, neighbors)) found_ = distance;
    return distance;
  }
  std::array<double, 3> distances_at(const Corners_3& directions, std::span<const int> neighbors) {
    const double first = distance_at(directions[0], neighbors);
    const double second = distance_at(directions[1], neighbors);
    return {first, second, distance_at(directions[2], neighbors)};
  }
  bool is_exposed(const Point_3& p, std::span<const int> neighbors) const {
    const std::vector<Ball_3>& all = boundary_.dual->regular->balls;
    return std::ranges::none_of(
        neighbors, [&](int i) { return squared_distance(all[i].center, p) < all[i].radius * all[i].radius; });
  }

  /// No point of the part of the sphere between three directions is farther from the surface, when these are the
  /// distances of its corners.
  double bound(const Corners_3& directions, const std::array<double, 3>& distances) const {
    // On the sphere it is a little farther to the corners than in their plane.
    const double flat = std::min(1.0, covering_radius(directions));
    return std::ranges::max(distances) + ball_.radius * std::sqrt(2 - 2 * std::sqrt(1 - flat * flat));
  }

  /// The part of the sphere between three directions, of which only these balls cover anything.
  void look_at(const Corners_3& directions, const std::array<double, 3>& distances, std::span<const int> neighbors) {
    const Point_3 sum = directions[0] + directions[1] + directions[2];
    const Point_3 direction = (1 / std::sqrt(dot(sum, sum))) * sum;
    const double reach = ball_.radius * std::sqrt(std::max({squared_distance(direction, directions[0]),
                                                            squared_distance(direction, directions[1]),
                                                            squared_distance(direction, directions[2])}));
    if (bound(directions, distances) <= found_ + tolerance_ || reach <= tolerance_) return;
    const std::vector<Ball_3>& all = boundary_.dual->regular->balls;
    const Point_3 middle = ball_.center + ball_.radius * direction;
    std::vector<int> near;
    for (const int i : neighbors) {
      const double square = squared_distance(all[i].center, middle);
      const double inner = all[i].radius - reach;
      if (inner > 0 && square <= inner * inner) return;
      const double outer = all[i].radius + reach;
      if (square < outer * outer) near.push_back(i);
    }
    const auto between = [](const Point_3& p, const Point_3& q) {
      const Point_3 both = p + q;
      return (1 / std::sqrt(dot(both, both))) * both;
    };
    const auto& [a, b, c] = directions;
    const Corners_3 middles{between(a, b), between(b, c), between(c, a)};
    const std::array<double, 3> at_middles = distances_at(middles, near);
    look_at({a, middles[0], middles[2]}, {distances[0], at_middles[0], at_middles[2]}, near);
    look_at({middles[0], b, middles[1]}, {at_middles[0], distances[1], at_middles[1]}, near);
    look_at({middles[2], middles[1], c}, {at_middles[2], at_middles[1], distances[2]}, near);
    look_at(middles, at_middles, near);
  }

  const Union_boundary_3& boundary_;
  const Union_distance_3& balls_;
  const Surface_locator_3& surface_;
  double tolerance_;
  double found_;
  int guess_ = 0;
  Ball_3 ball_;
  std::span<const int> neighbors_;
  std::vector<Outline> outline_;
  Point_3 middle_;
  bool is_small_ = false;
  double reach_ = 0;
};

/// What is found at vertices and in the middle of patches nearly is the result, so that few patches need more.
double to_input(const Union_boundary_3& boundary, const Union_distance_3& balls, const Surface_locator_3& surface,
                double tolerance, Progress& progress) {
  std::vector<double> distances(boundary.vertices.size());
  std::vector<int> guesses(boundary.vertices.size());
  parallel_small_blocks(boundary.vertices.size(), progress, [&](std::size_t begin, std::size_t end) {
    int guess = 0;
    for (std::size_t v = begin; v < end; ++v) {
      const Surface_locator_3::Nearest nearest = surface.nearest(boundary.vertices[v], guess);
      guess = guesses[v] = nearest.position;
      distances[v] = std::sqrt(nearest.squared_distance);
    }
  });
  double found = distances.empty() ? 0 : std::ranges::max(distances);
  const auto guess_at = [&](std::size_t patch) {
    if (boundary.patch_offsets[patch] == boundary.patch_offsets[patch + 1]) return 0;
    const int v = boundary.arcs[boundary.loop(boundary.patch_offsets[patch]).front().arc].from;
    return v < 0 ? 0 : guesses[v];
  };
  // Which patches share a search does not depend on threads.
  std::vector<Patch_search::Glance> glances(boundary.patch_count());
  std::vector<double> largest(boundary.patch_count(), 0);
  const auto search_all = [&](const auto& look_at) {
    const double threshold = found;
    parallel_small_blocks(boundary.patch_count(), progress, [&](std::size_t begin, std::size_t end) {
      Patch_search search(boundary, balls, surface, threshold, tolerance);
      for (std::size_t i = begin; i < end; ++i) look_at(search, i);
      largest[begin] = search.found();
    });
    for (const double distance : largest) found = std::max(found, distance);
  };
  search_all([&](Patch_search& search, std::size_t i) {
    search.go_to(i, guess_at(i));
    glances[i] = search.glance();
  });
  // What is far is mostly on large patches, of small balls at thin parts and sharp edges.
  for (const bool small : {false, true}) {
    const double limit = found + tolerance;
    search_all([&](Patch_search& search, std::size_t i) {
      const Patch_search::Glance& glance = glances[i];
      if (glance.is_small != small || (small && glance.at_middle + glance.reach <= limit)) return;
      search.go_to(i, guess_at(i));
      search.run(glance.at_middle, distances);
    });
  }
  return found;
}

}  // namespace

Surface_error_3 surface_error(const Solid_3& solid, const Union_boundary_3& boundary, double resolution,
                              Progress& progress) {
  progress.begin_stage("Error");
  const Surface_locator_3& surface = *solid.locator;
  const double diagonal = surface.tree().box().diagonal();
  // Half is for what is between arcs and their chords.
  const double tolerance = resolution * diagonal / 2;
  const Union_distance_3 balls(boundary, progress);
  Surface_error_3 result;
  double reached = 2 * tolerance;
  result.to_input = to_input(boundary, balls, surface, tolerance, progress) / diagonal;
  progress.report(0.5);
  result.from_input = From_input(surface, balls, tolerance).run(reached, progress) / diagonal;
  result.resolution = reached / diagonal;
  return result;
}

}  // namespace mesecina

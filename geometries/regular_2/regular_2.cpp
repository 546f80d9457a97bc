// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/regular_2/regular_2.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_face_base_2.h>
#include <CGAL/Regular_triangulation_vertex_base_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <string>

#include "core/outcome.h"
#include "geometries/parallel.h"
#include "geometries/regular_2/power_predicates.h"

namespace mesecina {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// A disk as CGAL's triangulation sees it: a number, and about where it is.
struct Site {
  int ball = -1;
  double approximate_x = 0;
  double approximate_y = 0;
  double x() const { return approximate_x; }
  double y() const { return approximate_y; }
};

/// Traits of CGAL's regular triangulation that hand every decision to Power_predicates.
class Ball_traits {
 public:
  using FT = double;
  using Point_2 = Site;
  using Weighted_point_2 = Site;
  using Segment_2 = Kernel::Segment_2;
  using Line_2 = Kernel::Line_2;
  using Ray_2 = Kernel::Ray_2;
  using Triangle_2 = Kernel::Triangle_2;

  struct Construct_point_2 {
    using result_type = const Site&;
    const Site& operator()(const Site& site) const { return site; }
  };
  struct Construct_weighted_point_2 {
    using result_type = const Site&;
    const Site& operator()(const Site& site) const { return site; }
  };
  struct Predicate {
    const Power_predicates* predicates = nullptr;
  };
  struct Compare_x_2 : Predicate {
    CGAL::Comparison_result operator()(const Site& p, const Site& q) const {
      return predicates->compare_x(p.ball, q.ball);
    }
  };
  struct Compare_y_2 : Predicate {
    CGAL::Comparison_result operator()(const Site& p, const Site& q) const {
      return predicates->compare_y(p.ball, q.ball);
    }
  };
  struct Orientation_2 : Predicate {
    CGAL::Orientation operator()(const Site& p, const Site& q, const Site& r) const {
      return predicates->orientation(p.ball, q.ball, r.ball);
    }
  };
  struct Power_side_of_oriented_power_circle_2 : Predicate {
    CGAL::Oriented_side operator()(const Site& p, const Site& q, const Site& r, const Site& t) const {
      return predicates->power_side(p.ball, q.ball, r.ball, t.ball);
    }
    CGAL::Oriented_side operator()(const Site& p, const Site& q, const Site& t) const {
      return predicates->power_side(p.ball, q.ball, t.ball);
    }
    CGAL::Oriented_side operator()(const Site& p, const Site& t) const {
      return predicates->power_side(p.ball, t.ball);
    }
  };
  struct Compare_power_distance_2 : Predicate {
    CGAL::Comparison_result operator()(const Site& at, const Site& p, const Site& q) const {
      return predicates->compare_power_distance(at.ball, p.ball, q.ball);
    }
  };

  Ball_traits() = default;
  explicit Ball_traits(const Power_predicates& predicates) : predicates_(&predicates) {}
  Construct_point_2 construct_point_2_object() const { return {}; }
  Construct_weighted_point_2 construct_weighted_point_2_object() const { return {}; }
  Compare_x_2 compare_x_2_object() const { return {predicates_}; }
  Compare_y_2 compare_y_2_object() const { return {predicates_}; }
  Orientation_2 orientation_2_object() const { return {predicates_}; }
  Power_side_of_oriented_power_circle_2 power_side_of_oriented_power_circle_2_object() const { return {predicates_}; }
  Compare_power_distance_2 compare_power_distance_2_object() const { return {predicates_}; }

 private:
  const Power_predicates* predicates_ = nullptr;
};

struct Array_index {
  int value = -1;
};

}  // namespace

}  // namespace mesecina

namespace CGAL {

/// Walks on rounded centers first, and ends them with exact decisions.
template <>
struct Triangulation_structural_filtering_traits<mesecina::Ball_traits> {
  using Use_structural_filtering_tag = Tag_true;
};

}  // namespace CGAL

namespace mesecina {

namespace {

using Vertex_base = CGAL::Regular_triangulation_vertex_base_2<Ball_traits>;
using Face_base = CGAL::Triangulation_face_base_with_info_2<Array_index, Ball_traits,
                                                            CGAL::Regular_triangulation_face_base_2<Ball_traits>>;
using Triangulation =
    CGAL::Regular_triangulation_2<Ball_traits, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;

/// For CGAL::hilbert_sort, which has no other place to ask whether to stop.
struct Sort_traits {
  using Point_2 = Site;
  struct Less_x_2 {
    const Progress* progress;
    bool operator()(const Site& p, const Site& q) const {
      progress->check();
      return p.approximate_x < q.approximate_x;
    }
  };
  struct Less_y_2 {
    const Progress* progress;
    bool operator()(const Site& p, const Site& q) const {
      progress->check();
      return p.approximate_y < q.approximate_y;
    }
  };
  const Progress* progress;
  Less_x_2 less_x_2_object() const { return {progress}; }
  Less_y_2 less_y_2_object() const { return {progress}; }
};

/// The order in which disks are inserted, and per place in it the place of an earlier disk that is near; -1 where there
/// is none.
struct Insertion_order {
  std::vector<Site> sites;
  std::vector<int> near;
};

/// Rounds of random disks, each four times as large as the one before, along a Hilbert curve in each: random enough for
/// the expected number of changes, and with near disks near in memory. The number of a disk decides its round.
/// [N. Amenta, S. Choi, G. Rote: Incremental constructions con BRIO, 2003]
std::vector<int> rounds_of(const std::vector<Site>& sites) {
  constexpr int last_round = 14;
  std::vector<int> rounds;
  rounds.reserve(sites.size());
  for (const Site& site : sites) {
    auto random = (static_cast<std::uint64_t>(site.ball) + 1) * 0x9e3779b97f4a7c15U;
    random = (random ^ (random >> 30)) * 0xbf58476d1ce4e5b9U;
    random = (random ^ (random >> 27)) * 0x94d049bb133111ebU;
    random ^= random >> 31;
    rounds.push_back(std::max(0, last_round - std::countr_zero(random | (std::uint64_t{1} << 60)) / 2));
  }
  return rounds;
}

/// The disks that take part, behind three whose centers are not on a line; none if there are no such three.
Insertion_order insertion_order(const Balls_2& balls, const std::vector<std::uint8_t>& is_left_out,
                                const Power_predicates& predicates, const Progress& progress) {
  std::vector<Site> curve;
  curve.reserve(balls.size());
  for (std::size_t b = 0; b < balls.size(); ++b)
    if (is_left_out[b] == 0) curve.push_back({static_cast<int>(b), balls.centers[b].x, balls.centers[b].y});
  const auto are_at_one_place = [&](const Site& p, const Site& q) {
    return predicates.compare_x(p.ball, q.ball) == CGAL::EQUAL && predicates.compare_y(p.ball, q.ball) == CGAL::EQUAL;
  };
  std::size_t second = 1;
  while (second < curve.size() && are_at_one_place(curve[0], curve[second])) ++second;
  std::size_t third = second + 1;
  while (third < curve.size() &&
         predicates.orientation(curve[0].ball, curve[second].ball, curve[third].ball) == CGAL::COLLINEAR) {
    progress.check();
    ++third;
  }
  if (third >= curve.size()) return {};
  const std::array first{curve[0].ball, curve[second].ball, curve[third].ball};

  CGAL::hilbert_sort(curve.begin(), curve.end(), Sort_traits{&progress});
  const int count = static_cast<int>(curve.size());
  std::vector<int> rounds = rounds_of(curve);
  for (int i = 0; i < count; ++i)
    if (const auto place = std::ranges::find(first, curve[i].ball); place != first.end())
      rounds[i] = static_cast<int>(place - first.begin()) - static_cast<int>(first.size());
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&rounds](int i) { return rounds[i]; });

  // Taking disks away from the last to the first, each is between two earlier ones on the curve.
  std::vector<int> place(count);
  for (int i = 0; i < count; ++i) place[order[i]] = i;
  std::vector<int> previous(count);
  std::vector<int> next(count);
  for (int i = 0; i < count; ++i) {
    previous[i] = i - 1;
    next[i] = i + 1 < count ? i + 1 : -1;
  }
  Insertion_order result;
  result.near.assign(count, -1);
  for (int i = count - 1; i > 0; --i) {
    const int at = order[i];
    const int p = previous[at];
    const int q = next[at];
    const auto squared_distance_to = [&](int other) {
      return squared_distance(Point_2{curve[at].approximate_x, curve[at].approximate_y},
                              Point_2{curve[other].approximate_x, curve[other].approximate_y});
    };
    result.near[i] = place[p < 0 ? q : q < 0 ? p : squared_distance_to(p) <= squared_distance_to(q) ? p : q];
    if (p >= 0) next[p] = q;
    if (q >= 0) previous[q] = p;
  }
  result.sites.reserve(count);
  for (const int i : order) result.sites.push_back(curve[i]);
  return result;
}

/// All centers on a line: the lower envelope of the power distances along it.
void connect_along_line(Regular_2& regular, const Power_predicates& predicates, const Progress& progress) {
  const Balls_2& balls = *regular.balls;
  std::vector<int> order(balls.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int a, int b) {
    progress.check();
    if (const auto x = predicates.compare_x(a, b); x != CGAL::EQUAL) return x == CGAL::SMALLER;
    if (const auto y = predicates.compare_y(a, b); y != CGAL::EQUAL) return y == CGAL::SMALLER;
    const auto size = predicates.power_side(a, b);
    return size != CGAL::ON_ORIENTED_BOUNDARY ? size == CGAL::ON_NEGATIVE_SIDE : a < b;
  });
  auto& line = regular.line;
  for (const int b : order) {
    const bool repeats_center = !line.empty() && predicates.compare_x(line.back(), b) == CGAL::EQUAL &&
                                predicates.compare_y(line.back(), b) == CGAL::EQUAL;
    // Of one center the largest disk came first.
    if (repeats_center) continue;
    while (line.size() >= 2 && predicates.power_side(line[line.size() - 2], b, line.back()) != CGAL::ON_POSITIVE_SIDE)
      line.pop_back();
    line.push_back(b);
  }
  regular.is_hidden.assign(balls.size(), 1);
  for (const int b : line) regular.is_hidden[b] = 0;
  regular.vertex_count = line.size();
  regular.dimension = std::min(1, static_cast<int>(line.size()) - 1);
}

Triangulation triangulate(const Insertion_order& order, const Power_predicates& predicates, Progress& progress) {
  Triangulation triangulation{Ball_traits(predicates)};
  // Per place in the order a vertex near it: its own, or where it is hidden one of the face that hides it. The face of
  // a vertex that others hid since is the one that hides it.
  std::vector<Triangulation::Vertex_handle> vertices;
  vertices.reserve(order.sites.size());
  for (std::size_t i = 0; i < order.sites.size(); ++i) {
    const Site& site = order.sites[i];
    if (i % 1024 == 0) progress.report(0.9 * static_cast<double>(i) / static_cast<double>(order.sites.size()));
    Triangulation::Face_handle hint;
    if (order.near[i] >= 0) hint = vertices[order.near[i]]->face();
    Triangulation::Locate_type type{};
    int place = 0;
    const auto face = triangulation.locate(site, type, place, hint);
    // CGAL would keep hidden disks in lists and hand them on at each flip.
    if (type == Triangulation::FACE && triangulation.dimension() == 2 &&
        triangulation.power_test(face, site, true) == CGAL::ON_NEGATIVE_SIDE) {
      vertices.push_back(face->vertex(0));
      continue;
    }
    const auto vertex = triangulation.insert(site, type, face, place);
    if (type == Triangulation::VERTEX && site.ball < vertex->point().ball &&
        predicates.power_side(vertex->point().ball, site.ball) == CGAL::ON_ORIENTED_BOUNDARY)
      vertex->point().ball = site.ball;
    vertices.push_back(vertex);
  }
  return triangulation;
}

/// Triangles are numbered by their least disk, so that those of near disks are near in memory if the disks are.
void fill_arrays(Regular_2& regular, Triangulation& triangulation, const Progress& progress) {
  const auto least_ball = [](const auto& face) {
    return std::min({face->vertex(0)->point().ball, face->vertex(1)->point().ball, face->vertex(2)->point().ball});
  };
  std::vector<int> next(regular.balls->size() + 1, 0);
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face)
    ++next[least_ball(face) + 1];
  for (std::size_t b = 1; b < next.size(); ++b) next[b] += next[b - 1];
  const int count = next.back();
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
    face->info().value = triangulation.is_infinite(face) ? -1 : next[least_ball(face)]++;
  progress.check();
  regular.triangles.resize(count);
  regular.neighbors.resize(count);
  regular.is_hidden.assign(regular.balls->size(), 1);
  regular.vertex_count = 0;
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    const int t = face->info().value;
    for (int i = 0; i < 3; ++i) {
      const int ball = face->vertex(i)->point().ball;
      regular.triangles[t][i] = ball;
      regular.neighbors[t][i] = face->neighbor(i)->info().value;
      if (regular.is_hidden[ball] != 0) {
        regular.is_hidden[ball] = 0;
        ++regular.vertex_count;
      }
    }
  }
  regular.dimension = 2;
}

/// Vertices whose power cell has no area: all their power vertices coincide in one or two points, or in one where the
/// cell is a ray.
std::vector<int> flat_vertices(const Regular_2& regular, const Power_predicates& predicates, const Progress& progress) {
  const int count = static_cast<int>(regular.triangles.size());
  std::vector<int> power_vertex(count);
  std::iota(power_vertex.begin(), power_vertex.end(), 0);
  const auto root = [&](int t) {
    while (power_vertex[t] != t) t = power_vertex[t] = power_vertex[power_vertex[t]];
    return t;
  };
  bool has_any = false;
  for (int t = 0; t < count; ++t) {
    if (t % 8192 == 0) progress.check();
    for (int i = 0; i < 3; ++i) {
      const int u = regular.neighbors[t][i];
      if (u < 0 || u > t) continue;
      const auto& [a, b, c] = regular.triangles[t];
      const int d = regular.triangles[u][regular.mirror_corner(t, i)];
      if (predicates.power_side(a, b, c, d) != CGAL::ON_ORIENTED_BOUNDARY) continue;
      power_vertex[root(t)] = root(u);
      has_any = true;
    }
  }
  if (!has_any) return {};

  /// Per disk up to two of its power vertices, and whether there are more.
  struct Cell {
    std::array<int, 2> corners{-1, -1};
    bool has_more = false;
    bool is_on_hull = false;
    std::array<int, 2> hull_neighbors{-1, -1};
  };
  std::vector<Cell> cells(regular.balls->size());
  for (int t = 0; t < count; ++t) {
    const int corner = root(t);
    for (int i = 0; i < 3; ++i) {
      Cell& cell = cells[regular.triangles[t][i]];
      if (cell.corners[0] == -1) {
        cell.corners[0] = corner;
      } else if (cell.corners[0] != corner) {
        if (cell.corners[1] == -1) {
          cell.corners[1] = corner;
        } else if (cell.corners[1] != corner) {
          cell.has_more = true;
        }
      }
      if (regular.neighbors[t][i] >= 0) continue;
      const auto [p, q] = regular.edge(t, i);
      cells[p].is_on_hull = cells[q].is_on_hull = true;
      cells[p].hull_neighbors[0] = q;
      cells[q].hull_neighbors[1] = p;
    }
  }
  std::vector<int> flat;
  for (std::size_t b = 0; b < cells.size(); ++b) {
    const Cell& cell = cells[b];
    if (regular.is_hidden[b] != 0 || cell.has_more) continue;
    if (!cell.is_on_hull) {
      flat.push_back(static_cast<int>(b));
    } else if (cell.corners[1] == -1 && predicates.orientation(cell.hull_neighbors[0], static_cast<int>(b),
                                                               cell.hull_neighbors[1]) == CGAL::COLLINEAR) {
      flat.push_back(static_cast<int>(b));
    }
  }
  return flat;
}

}  // namespace

Regular_2 regular_triangulation(std::shared_ptr<const Balls_2> balls, Progress& progress) {
  Regular_2 regular;
  regular.balls = std::move(balls);
  const Power_predicates predicates(*regular.balls, progress);
  const Power_predicates::Upward_rounding rounding;
  std::vector<std::uint8_t> is_left_out(regular.balls->size(), 0);
  while (true) {
    const Insertion_order order = insertion_order(*regular.balls, is_left_out, predicates, progress);
    if (order.sites.empty()) {
      connect_along_line(regular, predicates, progress);
      return regular;
    }
    Triangulation triangulation = triangulate(order, predicates, progress);
    fill_arrays(regular, triangulation, progress);
    // Every circumscribed disk keeps the triangles that it is circumscribed to in its cell; every point is in its own.
    const auto is_point = [](double radius) { return radius == 0; };
    if (regular.balls->is_circumscribed() || std::ranges::all_of(regular.balls->radii, is_point)) return regular;
    const std::vector<int> flat = flat_vertices(regular, predicates, progress);
    if (flat.empty()) return regular;
    for (const int ball : flat) is_left_out[ball] = 1;
  }
}

Power_vertices_2 power_vertices(const Regular_2& triangulation, Progress& progress) {
  Power_vertices_2 result;
  const std::size_t count = triangulation.triangles.size();
  result.vertices.resize(count);
  result.powers.resize(count);
  const Balls_2& balls = *triangulation.balls;
  std::vector<std::uint8_t> is_doubtful(count, 0);
  // From the least disk on, so that rounding does not depend on the order of the corners.
  const auto from_least = [](const std::array<int, 3>& corners) {
    const auto least = static_cast<std::size_t>(std::ranges::min_element(corners) - corners.begin());
    return std::array{corners[least], corners[(least + 1) % 3], corners[(least + 2) % 3]};
  };
  const auto offset = [&balls](int from, int to) {
    const Point_2& p = balls.centers[from];
    const Point_2& q = balls.centers[to];
    if (balls.center_rests.empty()) return Point_2{q.x - p.x, q.y - p.y};
    const Point_2& rest_p = balls.center_rests[from];
    const Point_2& rest_q = balls.center_rests[to];
    return Point_2{(q.x - p.x) + (rest_q.x - rest_p.x), (q.y - p.y) + (rest_q.y - rest_p.y)};
  };
  parallel_for(count, progress, [&](std::size_t t) {
    const std::array<int, 3> corners = from_least(triangulation.triangles[t]);
    if (balls.is_circumscribed()) {
      const int sample = balls.common_contact(corners);
      is_doubtful[t] = sample < 0;
      if (sample >= 0) result.vertices[t] = (*balls.samples)[sample];
      return;
    }
    const auto [a, b, c] = corners;
    const auto [bx, by] = offset(a, b);
    const auto [cx, cy] = offset(a, c);
    const double ra = balls.radii[a];
    const auto lift = [ra](double x, double y, double r) { return x * x + y * y - (r - ra) * (r + ra); };
    const double b2 = lift(bx, by, balls.radii[b]);
    const double c2 = lift(cx, cy, balls.radii[c]);
    const double twice_cross = 2 * (bx * cy - by * cx);
    const double zx = (cy * b2 - by * c2) / twice_cross;
    const double zy = (bx * c2 - cx * b2) / twice_cross;
    constexpr double smallest_trusted_part = 1e-3;
    is_doubtful[t] = !(std::abs(twice_cross) > smallest_trusted_part * (std::abs(bx * cy) + std::abs(by * cx)));
    result.vertices[t] = {balls.centers[a].x + zx, balls.centers[a].y + zy};
    result.powers[t] = zx * zx + zy * zy - ra * ra;
  });
  if (std::ranges::find(is_doubtful, 1) == is_doubtful.end()) return result;
  const Power_predicates predicates(balls, progress);
  for (std::size_t t = 0; t < count; ++t) {
    if (t % 4096 == 0) progress.check();
    if (is_doubtful[t] == 0) continue;
    const auto [a, b, c] = from_least(triangulation.triangles[t]);
    const auto [point, power] = predicates.power_vertex(a, b, c);
    result.vertices[t] = point;
    result.powers[t] = power;
  }
  return result;
}

}  // namespace mesecina

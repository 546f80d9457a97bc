// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>

#include "geometries/labels_2/labels_2.h"
#include "geometries/samples_2/samples_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

struct Diagram {
  Delaunay_2 triangulation;
  Voronoi_2 voronoi;
  Crust_2 crust;
};

Diagram diagram(std::span<const Point_2> points) {
  Progress progress;
  Delaunay_2 d = delaunay(points, progress);
  Voronoi_2 v = voronoi(d, progress);
  Crust_2 crust = one_step_crust(d, progress);
  return {std::move(d), std::move(v), std::move(crust)};
}

Labels_2 flood(const Diagram& diagram) {
  Progress progress;
  return flood_labels(diagram.triangulation, diagram.crust, progress);
}

/// |log(cot * cot)| of a Delaunay edge; infinite where one of the angles is not acute, and on the hull.
double sureness(const Delaunay_2& d, int t, int i) {
  const auto [p, q] = d.edge(t, i);
  const auto cotangent = [&](int apex) {
    const Point_2 a{d.points[p].x - d.points[apex].x, d.points[p].y - d.points[apex].y};
    const Point_2 b{d.points[q].x - d.points[apex].x, d.points[q].y - d.points[apex].y};
    return (a.x * b.x + a.y * b.y) / std::abs(a.x * b.y - a.y * b.x);
  };
  const int n = d.neighbors[t][i];
  if (n == -1) return std::numeric_limits<double>::infinity();
  const double product = cotangent(d.triangles[t][i]) * cotangent(d.triangles[n][d.mirror_corner(t, i)]);
  return product > 0 ? std::abs(std::log(product)) : std::numeric_limits<double>::infinity();
}

/// Union-find that knows on which side each element is.
class Sides {
 public:
  explicit Sides(std::size_t count) : parent_(count), flipped_(count, false) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  /// False when the opposite is known already.
  bool demand(int a, int b, bool differ) {
    const auto [root_a, side_a] = find(a);
    const auto [root_b, side_b] = find(b);
    if (root_a == root_b) return (side_a != side_b) == differ;
    parent_[root_a] = root_b;
    flipped_[root_a] = (side_a != side_b) != differ;
    return true;
  }

 private:
  std::pair<int, bool> find(int a) const {
    bool side = false;
    for (; parent_[a] != a; a = parent_[a]) side = side != flipped_[a];
    return {a, side};
  }
  std::vector<int> parent_;
  std::vector<bool> flipped_;
};

struct Weighted_edge {
  double sureness = 0;
  int triangle = 0;
  int neighbor = 0;
  bool differ = false;
};

/// No labels can keep every demand of edges surer than this or as sure; so the surest conflict is at least this sure,
/// and exactly this sure when the surest edges go first. nullopt without contradictions.
std::optional<double> surest_unavoidable_conflict(const Diagram& g) {
  const Delaunay_2& d = g.triangulation;
  std::vector<Weighted_edge> edges;
  const int outside = static_cast<int>(d.triangles.size());
  for (int t = 0; t < outside; ++t) {
    for (int i = 0; i < 3; ++i) {
      if (!d.edge_is_listed(t, i)) continue;
      const int n = d.neighbors[t][i];
      edges.push_back({sureness(d, t, i), t, n == -1 ? outside : n, g.crust.contains(t, i)});
    }
  }
  std::ranges::stable_sort(edges, std::greater{}, &Weighted_edge::sureness);
  Sides sides(d.triangles.size() + 1);
  for (const Weighted_edge& edge : edges)
    if (!sides.demand(edge.triangle, edge.neighbor, edge.differ)) return edge.sureness;
  return std::nullopt;
}

void expect_conflicts_are_right(const Diagram& g, const Labels_2& labels) {
  ASSERT_EQ(labels.is_inner.size(), g.triangulation.triangles.size());
  for (const std::uint8_t label : labels.is_inner) EXPECT_LE(label, 1);
  EXPECT_EQ(sorted_edges(labels.conflicts), conflicts_by_definition(g.triangulation, g.crust, labels.is_inner));
}

void expect_flood_is_right(std::span<const Point_2> points) {
  const Diagram g = diagram(points);
  const Labels_2 labels = flood(g);
  expect_conflicts_are_right(g, labels);
  if (g.triangulation.dimension < 2) {
    EXPECT_TRUE(labels.conflicts.empty());
    return;
  }
  EXPECT_EQ(labels.conflicts.empty(), crust_separates(g.triangulation, g.crust));
}

void expect_surest_edges_first(std::span<const Point_2> points) {
  const Diagram g = diagram(points);
  const Labels_2 labels = flood(g);
  const std::optional<double> unavoidable = surest_unavoidable_conflict(g);
  ASSERT_EQ(unavoidable.has_value(), !labels.conflicts.empty());
  if (!unavoidable) return;
  const std::vector<Edge> conflicts = sorted_edges(labels.conflicts);
  double surest = 0;
  const Delaunay_2& d = g.triangulation;
  for (int t = 0; t < static_cast<int>(d.triangles.size()); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (std::ranges::binary_search(conflicts, sorted_edge(d.edge(t, i))))
        surest = std::max(surest, sureness(d, t, i));
    }
  }
  if (std::isinf(*unavoidable)) {
    EXPECT_TRUE(std::isinf(surest));
  } else {
    EXPECT_NEAR(surest, *unavoidable, 1e-9 * (1 + *unavoidable));
  }
}

TEST(Flood_labels, are_inside_and_outside_of_dense_samples) {
  for (const Smooth_shape& shape : smooth_shapes()) {
    SCOPED_TRACE(shape.name);
    const Diagram g = diagram(shape.samples());
    const Labels_2 labels = flood(g);
    EXPECT_TRUE(labels.conflicts.empty());
    ASSERT_EQ(labels.is_inner.size(), g.triangulation.triangles.size());
    for (std::size_t t = 0; t < labels.is_inner.size(); ++t)
      EXPECT_EQ(labels.is_inner[t] != 0, shape.is_inside(g.voronoi.vertices[t])) << "triangle " << t;
  }
}

TEST(Flood_labels, list_every_conflict) {
  for (const auto& sets : {difficult_point_sets(), general_point_sets()}) {
    for (const auto& [name, points] : sets) {
      SCOPED_TRACE(name);
      expect_flood_is_right(points);
    }
  }
  for (std::uint64_t seed = 0; seed < 30; ++seed) expect_flood_is_right(noisy_curve(150, 0.05, seed));
}

TEST(Flood_labels, list_every_conflict_of_real_shapes) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("xy")) {
    SCOPED_TRACE(file.filename());
    expect_flood_is_right(points_of(file));
    expect_surest_edges_first(points_of(file));
  }
}

TEST(Flood_labels, give_way_at_the_least_sure_edges) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    expect_surest_edges_first(noisy_curve(200, 0.03, seed));
    expect_surest_edges_first(uniform_points(100, seed));
  }
}

TEST(Flood_labels, open_curve_has_conflicts) {
  const Diagram g = diagram(spiral_arc(200));
  EXPECT_FALSE(crust_separates(g.triangulation, g.crust));
  EXPECT_FALSE(flood(g).conflicts.empty());
  expect_conflicts_are_right(g, flood(g));
}

TEST(Flood_labels, without_conflicts_do_not_depend_on_the_order_of_points) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<Point_2> points = flower(900, 0.3, 5, 0.8, seed);
    const std::vector<int> permutation = random_permutation(static_cast<int>(points.size()), seed);
    std::vector<Point_2> permuted;
    for (const int i : permutation) permuted.push_back(points[i]);
    const auto label_of_triangle = [](const Diagram& g, const Labels_2& labels, std::span<const int> names) {
      std::map<Triangle, bool> result;
      for (std::size_t t = 0; t < labels.is_inner.size(); ++t) {
        Triangle corners = g.triangulation.triangles[t];
        for (int& corner : corners) corner = names[corner];
        std::ranges::sort(corners);
        result[corners] = labels.is_inner[t] != 0;
      }
      return result;
    };
    std::vector<int> identity(points.size());
    std::iota(identity.begin(), identity.end(), 0);
    const Diagram a = diagram(points);
    const Diagram b = diagram(permuted);
    const Labels_2 labels_a = flood(a);
    const Labels_2 labels_b = flood(b);
    EXPECT_TRUE(labels_a.conflicts.empty());
    EXPECT_EQ(label_of_triangle(a, labels_a, identity), label_of_triangle(b, labels_b, permutation));
  }
}

void expect_outline_labels_are_right(const Outline_2& outline, double step, bool expect_agreement) {
  Progress progress;
  const Diagram g = diagram(sample_outline(outline, step));
  const Labels_2 labels = outline_labels(g.triangulation, g.voronoi, g.crust, outline, progress);
  expect_conflicts_are_right(g, labels);
  for (std::size_t t = 0; t < labels.is_inner.size(); ++t) {
    const Point_2& center = g.voronoi.vertices[t];
    if (is_on_boundary(outline, center)) continue;
    EXPECT_EQ(labels.is_inner[t] != 0, exact_is_inside(outline, center)) << "triangle " << t;
  }
  EXPECT_EQ(labels.conflicts.empty(), expect_agreement);
}

constexpr double vertices_only = std::numeric_limits<double>::infinity();

TEST(Outline_labels, of_dense_samples_agree_with_the_crust) {
  for (const Smooth_shape& shape : smooth_shapes()) {
    SCOPED_TRACE(shape.name);
    expect_outline_labels_are_right(shape.outline(), vertices_only, true);
  }
}

TEST(Outline_labels, of_sparse_samples_conflict_with_the_crust) {
  // A comb: its teeth are closer to each other than the vertices along them.
  Ring_2 comb{{0, 0}, {8, 0}};
  for (int tooth = 7; tooth >= 0; --tooth) {
    comb.push_back({tooth + 0.9, 10.0 + 0.1 * tooth});
    comb.push_back({tooth + 0.5, 10.2 - 0.05 * tooth});
    comb.push_back({tooth + 0.1, 1.0 + 0.03 * tooth});
  }
  expect_outline_labels_are_right({{comb}}, vertices_only, false);
  expect_outline_labels_are_right({{flower(14, 0.6, 5)}}, vertices_only, false);
}

TEST(Outline_labels, of_real_outlines) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("wkt")) {
    const Outline_2 outline = outline_of(file);
    if (vertices_of(outline).size() > 1300) continue;
    SCOPED_TRACE(file.filename());
    Progress progress;
    const Diagram g = diagram(sample_outline(outline, diagonal(outline) / 200));
    const Labels_2 labels = outline_labels(g.triangulation, g.voronoi, g.crust, outline, progress);
    expect_conflicts_are_right(g, labels);
    const std::vector<std::uint8_t> expected = is_inside(outline, g.voronoi.vertices, progress);
    EXPECT_EQ(labels.is_inner, expected);
  }
}

}  // namespace
}  // namespace mesecina::test

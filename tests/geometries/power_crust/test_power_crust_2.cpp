// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "geometries/labels_2/labels_2.h"
#include "geometries/samples_2/samples_2.h"
#include "tests/geometries/oracles.h"
#include "tests/geometries/power_crust/polar_pipeline.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

constexpr double pi = std::numbers::pi;

double distance_to_segment(const Point_2& x, const Point_2& p, const Point_2& q) {
  const double along = ((x.x - p.x) * (q.x - p.x) + (x.y - p.y) * (q.y - p.y)) / squared_distance(p, q);
  const double t = std::clamp(along, 0.0, 1.0);
  return distance(x, {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
}

double distance_to_curves(const Point_2& x, const std::vector<Closed_curve>& curves) {
  double least = std::numeric_limits<double>::infinity();
  for (const Closed_curve& curve : curves)
    for (std::size_t i = 0; i < curve.size(); ++i)
      least = std::min(least, distance_to_segment(x, curve[i], curve[(i + 1) % curve.size()]));
  return least;
}

double longest_edge(const std::vector<Closed_curve>& curves) {
  double longest = 0;
  for (const Closed_curve& curve : curves)
    for (std::size_t i = 0; i < curve.size(); ++i)
      longest = std::max(longest, distance(curve[i], curve[(i + 1) % curve.size()]));
  return longest;
}

double farthest_from_crust(const std::vector<Point_2>& points, const Polar_pipeline& pipeline) {
  const auto segments = crust_segments(pipeline);
  const auto& vertices = pipeline.diagram.vertices;
  double farthest = 0;
  for (const Point_2& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : segments) least = std::min(least, distance_to_segment(p, vertices[a], vertices[b]));
    farthest = std::max(farthest, least);
  }
  return farthest;
}

/// Every vertex has two edges of the crust, and there are no rays.
testing::AssertionResult is_closed(const Polar_pipeline& pipeline) {
  std::vector<int> degree(pipeline.diagram.vertices.size(), 0);
  for (const auto& [a, b] : crust_segments(pipeline)) {
    if (b < 0) return testing::AssertionFailure() << "a ray";
    ++degree[a];
    ++degree[b];
  }
  for (std::size_t v = 0; v < degree.size(); ++v)
    if (degree[v] != 0 && degree[v] != 2) return testing::AssertionFailure() << degree[v] << " edges at vertex " << v;
  return testing::AssertionSuccess();
}

std::size_t wrong_labels(const Polar_pipeline& pipeline, const std::function<bool(const Point_2&)>& is_inside_shape) {
  std::size_t wrong = 0;
  for (std::size_t p = 0; p < pipeline.poles->finite_count(); ++p)
    if ((pipeline.polar.is_inner[p] != 0) != is_inside_shape(pipeline.balls().centers[p])) ++wrong;
  return wrong;
}

TEST(Power_crust, OfDenselySampledSmoothCurvesIsRight) {
  for (const Smooth_shape& shape : smooth_shapes()) {
    SCOPED_TRACE(shape.name);
    const std::vector<Point_2> samples = shape.samples();
    const Polar_pipeline pipeline = power_crust_of(samples);
    EXPECT_EQ(wrong_labels(pipeline, shape.is_inside), 0u);
    EXPECT_EQ(pipeline.polar.unlabelled_count, 0u);
    EXPECT_TRUE(pipeline.polar.contradictions.empty());

    const int curves = static_cast<int>(shape.curves.size());
    EXPECT_TRUE(is_closed(pipeline));
    EXPECT_EQ(betti_of_crust(pipeline), (std::array{curves, curves}));
    const std::array<int, 2> expected = shape.name == "annulus" ? std::array{1, 1} : std::array{curves, 0};
    EXPECT_EQ(betti_of_shape(pipeline), expected);

    Box box;
    for (const Point_2& p : samples) box.add(p);
    const double near = 0.3 * longest_edge(shape.curves);
    for (const auto& segment : crust_segments(pipeline)) {
      for (const int vertex : segment) {
        const Point_2& p = pipeline.diagram.vertices[vertex];
        EXPECT_LT(distance_to_curves(p, shape.curves), near);
      }
    }
    EXPECT_LT(farthest_from_crust(samples, pipeline), 1e-8 * box.diagonal());
    Random random(4);
    for (int i = 0; i < 300; ++i) {
      const double x = random.uniform(2 * box.lower.x, 2 * box.upper.x);
      const Point_2 p{x, random.uniform(2 * box.lower.y, 2 * box.upper.y)};
      if (distance_to_curves(p, shape.curves) > near) {
        EXPECT_EQ(pipeline.is_in_inner_cell(p), shape.is_inside(p)) << p.x << " " << p.y;
      }
    }
  }
}

TEST(Power_crust, ComesNearerWithTheSquareOfTheDistanceOfSamples) {
  const auto error = [](int count) {
    const Polar_pipeline pipeline = power_crust_of(ellipse(2, 1, count));
    double largest = 0;
    for (const auto& segment : crust_segments(pipeline)) {
      for (const int vertex : segment) {
        const Point_2& p = pipeline.diagram.vertices[vertex];
        largest = std::max(largest, std::abs(std::hypot(p.x / 2, p.y) - 1));
      }
    }
    return largest;
  };
  const double coarse = error(100);
  const double fine = error(400);
  EXPECT_LT(coarse, 3 * std::pow(2 * pi / 100, 2));
  EXPECT_GT(coarse, 12 * fine);
  EXPECT_GT(fine, 0);
}

/// The boundary of a rectangle with corners (0,0) and (4,2), turned by an angle.
Closed_curve rectangle(int per_unit, double angle) {
  const std::array<Point_2, 5> corners = {{{0, 0}, {4, 0}, {4, 2}, {0, 2}, {0, 0}}};
  Closed_curve result;
  for (std::size_t c = 0; c + 1 < corners.size(); ++c) {
    const int count = per_unit * static_cast<int>(distance(corners[c], corners[c + 1]));
    for (int i = 0; i < count; ++i) {
      const double t = static_cast<double>(i) / count;
      const double x = corners[c].x + t * (corners[c + 1].x - corners[c].x);
      const double y = corners[c].y + t * (corners[c + 1].y - corners[c].y);
      result.push_back({std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y});
    }
  }
  return result;
}

TEST(Power_crust, OfARectangleFollowsItsStraightEdges) {
  // Turned, the samples of an edge are not quite on a line: some poles are 1e12 and more away.
  for (const double angle : {0.0, 0.1, 0.7, 1.234}) {
    for (const int per_unit : {4, 20}) {
      SCOPED_TRACE(testing::Message() << angle << ", " << per_unit << " samples per unit");
      const Closed_curve curve = rectangle(per_unit, angle);
      const Polar_pipeline pipeline = power_crust_of(curve);
      EXPECT_EQ(pipeline.polar.unlabelled_count, 0u);
      EXPECT_TRUE(pipeline.polar.contradictions.empty());
      EXPECT_TRUE(is_closed(pipeline));
      EXPECT_EQ(betti_of_crust(pipeline), (std::array{1, 1}));
      EXPECT_EQ(betti_of_shape(pipeline), (std::array{1, 0}));
      for (const auto& segment : crust_segments(pipeline)) {
        for (const int vertex : segment) {
          EXPECT_LT(distance_to_curves(pipeline.diagram.vertices[vertex], {curve}), 1e-5);
        }
      }
    }
  }
}

TEST(Power_crust, CirclesThroughOneSampleShareAVertex) {
  for (const auto& samples : {flower(500, 0.3, 5, 0.8), rectangle(8, 0), rectangle(8, 0.7)}) {
    const Polar_pipeline pipeline = power_crust_of(samples);
    const Regular_2& regular = *pipeline.polar.regular;
    std::map<int, int> vertex_at_sample;
    for (std::size_t t = 0; t < regular.triangles.size(); ++t) {
      const int sample = regular.balls->common_contact(regular.triangles[t]);
      if (sample < 0) continue;
      const int vertex = pipeline.diagram.vertex_of_triangle[t];
      EXPECT_EQ(vertex_at_sample.emplace(sample, vertex).first->second, vertex);
      EXPECT_EQ(pipeline.diagram.vertices[vertex], samples[sample]);
    }
    EXPECT_GT(vertex_at_sample.size(), 10u);
    EXPECT_LT(pipeline.diagram.vertices.size(), regular.triangles.size());
    for (const auto& [t, i] : power_edges(pipeline.polar, pipeline.diagram)) {
      const int u = regular.neighbors[t][i];
      if (u >= 0) {
        EXPECT_NE(pipeline.diagram.vertex_of_triangle[t], pipeline.diagram.vertex_of_triangle[u]);
      }
    }
  }
}

TEST(Power_crust, OfNestedCurvesAlternates) {
  std::vector<Point_2> samples;
  const std::array<double, 4> radii = {4, 3, 1.5, 0.5};
  for (const double radius : radii)
    for (const Point_2& p : ellipse(radius, radius, static_cast<int>(60 * radius) + 40, 0.5, 3)) samples.push_back(p);
  const Polar_pipeline pipeline = power_crust_of(samples);
  EXPECT_TRUE(is_closed(pipeline));
  EXPECT_EQ(betti_of_crust(pipeline), (std::array{4, 4}));
  EXPECT_EQ(betti_of_shape(pipeline), (std::array{2, 2}));
  EXPECT_EQ(wrong_labels(pipeline,
                         [](const Point_2& p) {
                           const double r = std::hypot(p.x, p.y);
                           return (r > 3 && r < 4) || (r > 0.5 && r < 1.5);
                         }),
            0u);
}

TEST(Power_crust, OfThreePointsIsATriangleAroundOneInnerPole) {
  const Polar_pipeline pipeline = power_crust_of(std::vector<Point_2>{{0, 0}, {4, 1}, {1, 3}});
  EXPECT_EQ(pipeline.poles->finite_count(), 1u);
  EXPECT_TRUE(pipeline.polar.is_inner[0] != 0);
  EXPECT_TRUE(is_closed(pipeline));
  EXPECT_EQ(power_crust(pipeline.polar, pipeline.diagram).size(), 3u);
  EXPECT_EQ(power_shape(pipeline.polar).isolated, std::vector<int>{0});
}

/// The labelling as the paper says it, with a linear search for the surest pole.
struct Plain_labels {
  std::vector<int> is_inner;
  std::vector<double> confidence;
};
Plain_labels plain_labels(const Polar_pipeline& pipeline) {
  const Poles_2& poles = *pipeline.poles;
  const Balls_2& balls = pipeline.balls();
  const int count = static_cast<int>(poles.size());
  std::vector<std::set<int>> neighbors(count);
  for (const auto& [a, b, c] : pipeline.polar.regular->triangles) {
    neighbors[a].insert({b, c});
    neighbors[b].insert({a, c});
    neighbors[c].insert({a, b});
  }
  std::vector<double> inner(count, 0);
  std::vector<double> outer(count, 0);
  for (int p = static_cast<int>(poles.finite_count()); p < count; ++p) outer[p] = 1;
  Plain_labels labels{std::vector<int>(count, -1), std::vector<double>(count, 0)};
  while (true) {
    int best = -1;
    double highest = 0;
    for (int p = 0; p < count; ++p) {
      if (labels.is_inner[p] >= 0 || (inner[p] == 0 && outer[p] == 0)) continue;
      const bool both = inner[p] > 0 && outer[p] > 0;
      const double priority = both ? std::abs(inner[p] - outer[p]) - 1 : std::max(inner[p], outer[p]);
      if (best >= 0 && priority <= highest) continue;
      best = p;
      highest = priority;
    }
    if (best < 0) return labels;
    labels.is_inner[best] = inner[best] > outer[best] ? 1 : 0;
    labels.confidence[best] = std::max(inner[best], outer[best]);
    const auto tell = [&](int other, bool same, double cosine) {
      auto& side = (labels.is_inner[best] == 1) == same ? inner : outer;
      if (cosine > 0) side[other] = std::max(side[other], labels.confidence[best] * std::min(cosine, 1.0));
    };
    for (int s = 0; s < static_cast<int>(poles.first.size()); ++s) {
      if (poles.second[s] < 0 || (poles.first[s] != best && poles.second[s] != best)) continue;
      const int other = poles.first[s] == best ? poles.second[s] : poles.first[s];
      const Point_2& at = (*balls.samples)[s];
      const Point_2& p = balls.centers[best];
      const Point_2& q = balls.centers[other];
      const double dot = (p.x - at.x) * (q.x - at.x) + (p.y - at.y) * (q.y - at.y);
      tell(other, false, -dot / distance(p, at) / distance(q, at));
    }
    for (const int other : neighbors[best]) tell(other, true, intersection_cosine(balls, best, other));
  }
}

TEST(Power_crust, LabelsGoFromTheSurestOn) {
  std::vector<Named_points> sets = general_point_sets();
  sets.push_back({"open spiral", spiral_arc(150)});
  sets.push_back({"sparse flower", flower(40, 0.5, 7, 0.9)});
  sets.push_back({"jittered flower", flower(600, 0.3, 5, 0.8)});
  for (const auto& [name, points] : sets) {
    SCOPED_TRACE(name);
    const Polar_pipeline pipeline = power_crust_of(points);
    const Plain_labels expected = plain_labels(pipeline);
    std::size_t different = 0;
    for (std::size_t p = 0; p < expected.is_inner.size(); ++p) {
      EXPECT_NEAR(pipeline.polar.confidence[p], expected.confidence[p], 1e-9);
      if (pipeline.polar.is_inner[p] != std::max(expected.is_inner[p], 0)) ++different;
    }
    EXPECT_EQ(different, 0u);
  }
}

/// The circles through triples of points.
Balls_2 circles_through(const std::vector<std::array<Point_2, 3>>& triples) {
  Balls_2 balls;
  std::vector<Point_2> samples;
  balls.contact_offsets.push_back(0);
  for (const auto& triple : triples) {
    const Exact_point center = exact_circumcenter(triple[0], triple[1], triple[2]);
    balls.centers.push_back({CGAL::to_double(center.x), CGAL::to_double(center.y)});
    balls.radii.push_back(distance(balls.centers.back(), triple[0]));
    for (const Point_2& p : triple) {
      balls.contacts.push_back(static_cast<int>(samples.size()));
      samples.push_back(p);
    }
    balls.contact_offsets.push_back(static_cast<int>(balls.contacts.size()));
  }
  balls.samples = std::make_shared<const std::vector<Point_2>>(std::move(samples));
  return balls;
}

TEST(Power_crust, CosineOfDisksIsThatOfTheirCircles) {
  const auto circle = [](double x, double radius) {
    return std::array<Point_2, 3>{{{x - radius, 0}, {x, radius}, {x + radius, 0}}};
  };
  const Balls_2 balls = circles_through({circle(0, 3), circle(5, 4), circle(7, 4), circle(0, 3), circle(1, 2)});
  EXPECT_NEAR(intersection_cosine(balls, 0, 1), 0, 1e-15);
  EXPECT_NEAR(intersection_cosine(balls, 0, 2), -1, 1e-15);
  EXPECT_NEAR(intersection_cosine(balls, 0, 3), 1, 1e-15);
  EXPECT_NEAR(intersection_cosine(balls, 0, 4), 1, 1e-15);
  EXPECT_NEAR(intersection_cosine(balls, 1, 2), 1 - 4.0 / 32, 1e-15);
  EXPECT_NEAR(intersection_cosine(balls, 2, 1), 1 - 4.0 / 32, 1e-15);

  // A disk of radius 5e15 is nearly the half-plane below y = 0.
  const Balls_2 flat = circles_through(
      {{{{-1, 0}, {0, 1e-16}, {1, 0}}}, {{{0.4, 0.1}, {0.5, 0.6}, {0.6, 0.1}}}, {{{-0.3, 0}, {0, 0.3}, {0.3, 0}}}});
  const double height = flat.centers[1].y;
  EXPECT_NEAR(intersection_cosine(flat, 0, 1), -height / flat.radii[1], 1e-12);
  EXPECT_NEAR(intersection_cosine(flat, 2, 0), 0, 1e-12);
}

TEST(Power_crust, KeepsItsPromisesForDifficultSamples) {
  std::vector<Named_points> sets = difficult_point_sets();
  sets.push_back({"noisy curve", noisy_curve(300, 0.05, 4)});
  sets.push_back({"open spiral", spiral_arc(200)});
  for (const auto& [name, points] : sets) {
    SCOPED_TRACE(name);
    Progress progress;
    if (delaunay(points, progress).dimension < 2) continue;
    const Polar_pipeline pipeline = power_crust_of(points);
    const Polar_balls_2& polar = pipeline.polar;
    const Poles_2& poles = *pipeline.poles;
    for (int p = 0; p < static_cast<int>(poles.size()); ++p) {
      if (poles.is_infinite(p)) {
        EXPECT_EQ(polar.confidence[p], 1);
      }
      EXPECT_GE(polar.confidence[p], 0);
      EXPECT_LE(polar.confidence[p], 1);
      if (poles.is_infinite(p) || polar.confidence[p] == 0) {
        EXPECT_EQ(polar.is_inner[p], 0);
      }
    }
    EXPECT_EQ(polar.unlabelled_count, static_cast<std::size_t>(std::ranges::count(polar.confidence, 0.0)));
    for (int s = 0; s < static_cast<int>(points.size()); ++s) {
      const bool has_both = poles.first[s] >= 0 && poles.second[s] >= 0 && polar.confidence[poles.first[s]] > 0 &&
                            polar.confidence[poles.second[s]] > 0;
      EXPECT_EQ(std::ranges::binary_search(polar.contradictions, s),
                has_both && polar.is_inner[poles.first[s]] == polar.is_inner[poles.second[s]]);
    }
    std::vector<int> degree(pipeline.diagram.vertices.size(), 0);
    for (const auto& segment : crust_segments(pipeline))
      for (const int vertex : segment)
        if (vertex >= 0) ++degree[vertex];
    EXPECT_TRUE(std::ranges::all_of(degree, [](int d) { return d % 2 == 0; }));
  }
}

/// The samples on the circles of the inner poles; as they were before the permutation.
std::set<std::set<int>> inner_circles(const Polar_pipeline& pipeline, const std::vector<int>& original) {
  std::set<std::set<int>> result;
  for (int p = 0; p < static_cast<int>(pipeline.poles->finite_count()); ++p) {
    if (pipeline.polar.is_inner[p] == 0) continue;
    std::set<int> circle;
    for (const int s : pipeline.balls().contacts_of(p)) circle.insert(original[s]);
    result.insert(std::move(circle));
  }
  return result;
}

TEST(Power_crust, DoesNotDependOnTheOrderOfTheSamples) {
  std::vector<Named_points> sets = general_point_sets();
  sets.push_back({"jittered flower", flower(600, 0.3, 5, 0.8)});
  for (const auto& [name, points] : sets) {
    SCOPED_TRACE(name);
    std::vector<int> identity(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) identity[i] = static_cast<int>(i);
    const auto expected = inner_circles(power_crust_of(points), identity);
    EXPECT_FALSE(expected.empty());
    const std::vector<int> permutation = random_permutation(static_cast<int>(points.size()), 12);
    std::vector<Point_2> permuted;
    for (const int i : permutation) permuted.push_back(points[i]);
    EXPECT_EQ(inner_circles(power_crust_of(permuted), permutation), expected);
  }
}

TEST(Power_crust, DuplicatesChangeNothing) {
  const std::vector<Point_2> curve = flower(300, 0.3, 5, 0.8);
  std::vector<Point_2> doubled = curve;
  doubled.insert(doubled.end(), curve.begin(), curve.begin() + 100);
  const Polar_pipeline once = power_crust_of(curve);
  const Polar_pipeline twice = power_crust_of(doubled);
  EXPECT_EQ(once.polar.is_inner, twice.polar.is_inner);
  EXPECT_EQ(once.polar.confidence, twice.polar.confidence);
  EXPECT_EQ(once.balls().centers, twice.balls().centers);
}

TEST(Power_crust, InnerTrianglesChooseTheInnerPolarDisks) {
  const Polar_pipeline pipeline = power_crust_of(rectangle(4, 0));
  Progress progress;
  const auto chosen = pipeline.polar.inner_triangles(pipeline.delaunay->triangles.size());
  const auto disks = circumscribed_balls(*pipeline.delaunay, voronoi(*pipeline.delaunay, progress), chosen, progress);
  std::multiset<std::vector<int>> expected;
  std::multiset<std::vector<int>> actual;
  for (int p = 0; p < static_cast<int>(pipeline.poles->finite_count()); ++p) {
    const auto contacts = pipeline.balls().contacts_of(p);
    if (pipeline.polar.is_inner[p] != 0) expected.emplace(contacts.begin(), contacts.end());
  }
  for (int b = 0; b < static_cast<int>(disks.balls.size()); ++b) {
    const auto contacts = disks.balls.contacts_of(b);
    actual.emplace(contacts.begin(), contacts.end());
  }
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(actual, expected);
}

TEST(Power_crust, LabelsOfRealShapesAgreeWithTheirOutlines) {
  MESECINA_NEED_DATA();
  const std::set<std::string> exact = {"bat",      "camel",    "chipmunk",    "giraffe",  "glyph_8",
                                       "glyph_R",  "kangaroo", "rough_camel", "sym_gear", "cad_1002_tray_bottom",
                                       "glyph_amp"};
  const std::set<std::string> one_piece = {"bat",     "camel",       "chipmunk",       "elephant",
                                           "giraffe", "rough_camel", "rough_elephant", "switzerland"};
  std::size_t seen = 0;
  for (const auto& file : planar_files("wkt")) {
    const std::string name = file.stem().string();
    // One crosses itself: it has no inside. The stripes lie nearer to each other than their vertices.
    if (name == "bad_selfcrossing_giraffe" || name == "zebra_stripes") continue;
    SCOPED_TRACE(name);
    const Outline_2 outline = outline_of(file);
    const Polar_pipeline pipeline = power_crust_of(sample_outline(outline, 0.001 * diagonal(outline)));
    Progress progress;
    const auto inside = is_inside(outline, pipeline.balls().centers, progress);
    std::size_t wrong = 0;
    for (std::size_t p = 0; p < pipeline.poles->finite_count(); ++p)
      if (pipeline.polar.is_inner[p] != inside[p]) ++wrong;
    const double allowed_share = exact.contains(name) ? 0 : 0.01;
    EXPECT_LE(static_cast<double>(wrong), allowed_share * static_cast<double>(pipeline.poles->finite_count()));
    if (one_piece.contains(name)) {
      EXPECT_EQ(betti_of_shape(pipeline), (std::array{1, 0}));
    }
    seen += exact.count(name);
  }
  EXPECT_EQ(seen, exact.size());
}

}  // namespace
}  // namespace mesecina::test

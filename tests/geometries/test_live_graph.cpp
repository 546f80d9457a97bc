// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>

#include "core/graph.h"
#include "geometries/modules_2.h"
#include "tests/geometries/shapes.h"

/// A graph that lives through a session of random edits against one that sees the last state only.
namespace mesecina::test {
namespace {

const std::vector<std::string> compared_layers = {"delaunay",         "voronoi",     "one-step-crust",
                                                  "label-conflicts",  "medial-axis", "lambda-medial-axis",
                                                  "scale-medial-axis"};

/// Coordinates of its vertices, in increasing order, then its values.
using Element = std::vector<double>;

void append_sorted(Element& element, std::vector<Point_3> vertices) {
  std::ranges::sort(vertices, [](const Point_3& p, const Point_3& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
  for (const Point_3& p : vertices) element.insert(element.end(), {p.x, p.y});
}

/// What the set shows, to the last digit, whatever the order of its parts.
std::vector<Element> elements_of(const Primitive_set& set) {
  std::vector<Element> elements;
  for (const int v : set.points) append_sorted(elements.emplace_back(), {set.vertices[v]});
  for (const auto& [a, b] : set.segments) append_sorted(elements.emplace_back(), {set.vertices[a], set.vertices[b]});
  for (const Ray& ray : set.rays) {
    append_sorted(elements.emplace_back(), {set.vertices[ray.from]});
    elements.back().insert(elements.back().end(), {ray.direction.x, ray.direction.y});
  }
  EXPECT_EQ(elements.size(), set.element_count());
  for (const Values& values : set.values)
    for (std::size_t i = 0; i < elements.size(); ++i) elements[i].push_back(values.data[i]);
  std::ranges::sort(elements);
  return elements;
}

testing::AssertionResult is_equal(const std::vector<Element>& found, const std::vector<Element>& expected) {
  if (found == expected) return testing::AssertionSuccess();
  std::vector<Element> surplus;
  std::vector<Element> missing;
  std::ranges::set_difference(found, expected, std::back_inserter(surplus));
  std::ranges::set_difference(expected, found, std::back_inserter(missing));
  testing::AssertionResult result = testing::AssertionFailure();
  result << surplus.size() << " elements not expected, " << missing.size() << " missing;";
  for (const auto& [name, elements] : {std::pair("not expected", surplus), std::pair("missing", missing)}) {
    if (elements.empty()) continue;
    result << " first " << name << ":";
    for (const double x : elements.front()) result << " " << x;
  }
  return result;
}

class Session {
 public:
  Session(std::vector<Point_2> points, std::uint64_t seed)
      : random_(seed), points_(std::move(points)), live_(make_registry_2()) {
    give();
  }

  void step(int number) {
    const std::string what = edit();
    SCOPED_TRACE(testing::Message() << "step " << number << ": " << what << ", " << points_.size() << " points");
    give();
    if (random_.chance(0.3)) cancel_somewhere();
    Graph fresh(make_registry_2());
    fresh.set_inputs(live_.inputs());
    fresh.set_settings(live_.settings());
    Progress progress;
    for (const std::string& id : compared_layers) {
      // Some are not looked at after each step, and then have several edits to catch up with.
      if (random_.chance(0.3)) continue;
      SCOPED_TRACE(id);
      const Outcome<Primitive_set> found = live_.layer(id, progress);
      const Outcome<Primitive_set> expected = fresh.layer(id, progress);
      ASSERT_EQ(found.reason, expected.reason);
      ASSERT_EQ(live_.warnings(id), fresh.warnings(id));
      if (!expected) continue;
      ASSERT_TRUE(is_equal(elements_of(*found.value), elements_of(*expected.value)));
    }
  }

  /// Whether the incremental paths ran: else nothing was tested.
  bool has_updated() const {
    return std::ranges::any_of(live_.stages(), [](const Graph::Stage& stage) { return stage.updated; });
  }

 private:
  Point_2 somewhere() {
    const double x = random_.uniform(-1.5, 1.5);
    return {x, random_.uniform(-1.5, 1.5)};
  }
  std::size_t any() { return static_cast<std::size_t>(random_.index(static_cast<int>(points_.size()))); }

  std::string edit() {
    const int kind = random_.index(12);
    if (points_.size() < 4 || kind == 0) {
      points_ = flower(80 + random_.index(40), 0.3, 5, 0.5, random_.next());
      return "another curve";
    }
    if (kind <= 3) {
      Point_2& p = points_[any()];
      p = {p.x + random_.uniform(-0.05, 0.05), p.y + random_.uniform(-0.05, 0.05)};
      return "small move";
    }
    if (kind == 4) {
      points_[any()] = somewhere();
      return "large move";
    }
    if (kind == 5) {
      points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(any()), somewhere());
      return "insertion";
    }
    if (kind == 6) {
      points_.erase(points_.begin() + static_cast<std::ptrdiff_t>(any()));
      return "deletion";
    }
    if (kind == 7) {
      const Point_2 p = points_[any()];
      points_.insert(points_.begin() + static_cast<std::ptrdiff_t>(any()), p);
      return "duplicate";
    }
    if (kind == 8) {
      points_[any()] = points_[any()];
      return "onto another";
    }
    if (kind == 9 && random_.chance(0.3)) {
      for (Point_2& p : points_) p.y = 1;
      return "to a line";
    }
    if (kind == 10) {
      outline_.rings.clear();
      if (random_.chance(0.6)) outline_.rings.push_back(flower(30, 0.2, 3, 0.5, random_.next()));
      hides_points_ = !outline_.rings.empty() && random_.chance(0.7);
      return "outline";
    }
    settings_ = settings_.with("sampling-step", random_.uniform(0.01, 0.1));
    settings_ = settings_.with("scale-limit", random_.uniform(1, 2));
    return "settings";
  }

  void give() {
    Inputs inputs;
    if (!hides_points_) inputs = inputs.with(points_input, points_);
    if (!outline_.rings.empty()) inputs = inputs.with(outline_input, outline_);
    live_.set_inputs(inputs);
    live_.set_settings(settings_);
  }

  /// Stops a computation in any of its stages.
  void cancel_somewhere() {
    std::stop_source source;
    int left = random_.index(20);
    Progress progress(source.get_token(), [&](std::string_view, double) {
      if (left-- == 0) source.request_stop();
    });
    try {
      for (const std::string& id : compared_layers) live_.layer(id, progress);
    } catch (const Cancelled&) {
    }
  }

  Random random_;
  std::vector<Point_2> points_;
  Outline_2 outline_;
  bool hides_points_ = false;
  Settings settings_;
  Graph live_;
};

TEST(Live_graph, shows_what_a_fresh_one_shows) {
  bool has_updated = false;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Session session(flower(100, 0.3, 5, 0.5, seed), seed);
    for (int number = 0; number < 40 && !testing::Test::HasFailure(); ++number) session.step(number);
    has_updated = has_updated || session.has_updated();
  }
  EXPECT_TRUE(has_updated);
}

TEST(Live_graph, shows_what_a_fresh_one_shows_of_random_points) {
  // Labels full of contradictions.
  for (std::uint64_t seed = 101; seed <= 108; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Session session(uniform_points(60, seed), seed);
    for (int number = 0; number < 40 && !testing::Test::HasFailure(); ++number) session.step(number);
  }
}

/// Ends and first value of each segment to six digits, in increasing order: which cocircular samples make a triangle
/// shows in the last digits, and where rounding alone makes an importance finite.
std::vector<Element> rounded_segments(const Primitive_set& set) {
  std::vector<Element> elements;
  for (std::size_t e = 0; e < set.segments.size(); ++e) {
    Element& element = elements.emplace_back();
    const auto add = [&](double value) { element.push_back(std::floor(std::min(value, 1e5) * 1e6 + 0.123)); };
    std::array<Element, 2> ends;
    for (std::size_t end = 0; end < 2; ++end) {
      const Point_3& p = set.vertices[set.segments[e][end]];
      ends[end] = {p.x, p.y};
    }
    std::ranges::sort(ends, {}, [](const Element& end) { return std::floor(end[0] * 1e6 + 0.123) + 1e-3 * end[1]; });
    for (const Element& end : ends)
      for (const double coordinate : end) add(coordinate);
    add(set.values.at(0).data[e]);
  }
  std::ranges::sort(elements);
  return elements;
}

TEST(Live_graph, shows_what_a_fresh_one_shows_of_cocircular_samples) {
  const std::vector<Point_2> start = rectangle_samples({24, 15}, 1);
  Graph live(make_registry_2());
  Random random(3);
  std::vector<Point_2> points = start;
  for (int step = 0; step < 120; ++step) {
    SCOPED_TRACE(step);
    const auto i = static_cast<std::size_t>(random.index(static_cast<int>(points.size())));
    const int kind = random.index(5);
    if (kind == 0) points[i] = {points[i].x + random.uniform(-0.1, 0.1), points[i].y + random.uniform(-0.1, 0.1)};
    if (kind == 1) points[i] = midpoint(start[i], start[(i + 1) % start.size()]);
    if (kind >= 2) points[i] = start[i];
    if (kind == 4) points = start;
    Graph fresh(make_registry_2());
    fresh.set_inputs(Inputs().with(points_input, points));
    live.set_inputs(fresh.inputs());
    Progress progress;
    for (const char* id : {"medial-axis", "angle-medial-axis", "scale-medial-axis"}) {
      SCOPED_TRACE(id);
      const Outcome<Primitive_set> found = live.layer(id, progress);
      const Outcome<Primitive_set> expected = fresh.layer(id, progress);
      ASSERT_TRUE(found && expected);
      ASSERT_TRUE(is_equal(rounded_segments(*found.value), rounded_segments(*expected.value)));
    }
  }
  EXPECT_TRUE(std::ranges::any_of(live.stages(), [](const Graph::Stage& stage) { return stage.updated; }));
}

}  // namespace
}  // namespace mesecina::test

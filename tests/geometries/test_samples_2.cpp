// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/outcome.h"
#include "geometries/samples_2/samples_2.h"
#include "tests/geometries/results.h"
#include "tests/geometries/shapes.h"

namespace mesecina::test {
namespace {

/// Walks along the rings and the samples at once.
void expect_sampling(const Outline_2& outline, double step) {
  const std::vector<Point_2> samples = sample_outline(outline, step);
  std::size_t next = 0;
  for (const Ring_2& ring : outline.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point_2& p = ring[i];
      const Point_2& q = ring[(i + 1) % ring.size()];
      ASSERT_LT(next, samples.size());
      ASSERT_EQ(samples[next], p) << "vertex " << i;
      ++next;
      const double length = distance(p, q);
      const double exact_count = length / step;
      // Up to rounding of the length, as few as possible.
      const auto fewest = static_cast<std::size_t>(std::max(1.0, std::ceil(exact_count * (1 - 1e-12))));
      const auto most = static_cast<std::size_t>(std::max(1.0, std::ceil(exact_count * (1 + 1e-12))));
      std::size_t pieces = 1;
      // Samples strictly between p and q: on the segment, in order, before the next vertex.
      while (pieces < most && next < samples.size() && !(samples[next] == q)) {
        ++pieces;
        ++next;
      }
      ASSERT_GE(pieces, fewest) << "segment " << i;
      ASSERT_LE(pieces, most) << "segment " << i;
      const double tolerance = 1e-14 * (std::abs(p.x) + std::abs(p.y) + std::abs(q.x) + std::abs(q.y));
      for (std::size_t k = 1; k < pieces; ++k) {
        const double t = static_cast<double>(k) / static_cast<double>(pieces);
        const Point_2& sample = samples[next - pieces + k];
        ASSERT_NEAR(sample.x, p.x + t * (q.x - p.x), tolerance) << "segment " << i << ", piece " << k;
        ASSERT_NEAR(sample.y, p.y + t * (q.y - p.y), tolerance) << "segment " << i << ", piece " << k;
      }
    }
  }
  EXPECT_EQ(next, samples.size());
}

TEST(Sample_outline, unit_square) {
  const Outline_2 square{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  EXPECT_EQ(sample_outline(square, 1), square.rings[0]);
  EXPECT_EQ(sample_outline(square, infinity), square.rings[0]);
  EXPECT_EQ(sample_outline(square, 0.5),
            (std::vector<Point_2>{{0, 0}, {0.5, 0}, {1, 0}, {1, 0.5}, {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}}));
  EXPECT_EQ(sample_outline(square, 0.75).size(), 8U);
  EXPECT_EQ(sample_outline(square, 0.25).size(), 16U);
  EXPECT_EQ(sample_outline(square, 0.2499).size(), 20U);
}

TEST(Sample_outline, rings_of_few_or_equal_vertices) {
  EXPECT_TRUE(sample_outline({}, 0.1).empty());
  EXPECT_TRUE(sample_outline({{{}}}, 0.1).empty());
  EXPECT_EQ(sample_outline({{{{2, 3}}}}, 0.1), (std::vector<Point_2>{{2, 3}}));
  EXPECT_EQ(sample_outline({{{{0, 0}, {1, 0}}}}, 0.5), (std::vector<Point_2>{{0, 0}, {0.5, 0}, {1, 0}, {0.5, 0}}));
  EXPECT_EQ(sample_outline({{{{2, 3}, {2, 3}, {2, 3}}}}, 0.1), (std::vector<Point_2>{{2, 3}, {2, 3}, {2, 3}}));
}

TEST(Sample_outline, keeps_vertices_and_cuts_segments_evenly) {
  Random random(1);
  for (int round = 0; round < 30; ++round) {
    Outline_2 outline;
    for (int ring = 0; ring < 3; ++ring) outline.rings.push_back(uniform_points(3 + random.index(20), random.next()));
    for (const double step : {0.001, 0.013, 0.1, 0.7, 5.0, infinity}) expect_sampling(outline, step);
  }
  for (const int exponent : {-200, 200}) expect_sampling({{scaled(flower(40), exponent)}}, std::ldexp(0.03, exponent));
}

TEST(Sample_outline, real_outlines) {
  MESECINA_NEED_DATA();
  for (const auto& file : planar_files("wkt")) {
    SCOPED_TRACE(file.filename());
    const Outline_2 outline = outline_of(file);
    expect_sampling(outline, diagonal(outline) / 500);
    EXPECT_EQ(sample_outline(outline, infinity), vertices_of(outline));
  }
}

TEST(Sample_outline, refuses_too_many_samples) {
  const Outline_2 square{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  EXPECT_THROW(sample_outline(square, 7e-8), Unavailable);
  EXPECT_THROW(sample_outline(square, 1e-300), Unavailable);
}

TEST(Diagonal, of_the_bounding_box) {
  EXPECT_EQ(diagonal({}), 0);
  EXPECT_EQ(diagonal({{{}}}), 0);
  EXPECT_EQ(diagonal({{{{5, 5}}}}), 0);
  EXPECT_DOUBLE_EQ(diagonal({{{{0, 0}, {3, 0}}, {{1, 4}, {2, 2}}}}), 5);
}

}  // namespace
}  // namespace mesecina::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr double relative_tolerance = 1. / 2000;

double area(const Ring_2& ring) {
  double doubled = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_2& p = ring[i];
    const Point_2& q = ring[(i + 1) % ring.size()];
    doubled += p.x * q.y - p.y * q.x;
  }
  return doubled / 2;
}

double diagonal(const std::vector<Ring_2>& rings) {
  Box box;
  for (const Ring_2& ring : rings)
    for (const Point_2& p : ring) box.add(p);
  return box.diagonal();
}

void expect_near(const Ring_2& found, const Ring_2& expected, double tolerance = 1e-12) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LE(distance(found[i], expected[i]), tolerance) << i;
}

class Svg : public testing::Test {
 protected:
  File_contents read(const std::string& body) const { return folder_.read("a.svg", "<svg>" + body + "</svg>"); }
  std::vector<Ring_2> rings(const std::string& body) const { return read(body).inputs.get(outline_input)->rings; }
  std::vector<Ring_2> path(const std::string& data) const { return rings("<path d=\"" + data + "\"/>"); }
  std::string error(const std::string& text) const { return folder_.error("a.svg", text); }

  /// Vertices and middles of sides are on the circle up to the tolerance.
  void expect_circle(const Ring_2& ring, const Point_2& center, double radius, double drawing_diagonal) const {
    ASSERT_GE(ring.size(), 8u);
    const double tolerance = relative_tolerance * drawing_diagonal;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      EXPECT_NEAR(distance(ring[i], center), radius, 5e-6 * radius);
      EXPECT_NEAR(distance(midpoint(ring[i], ring[(i + 1) % ring.size()]), center), radius, tolerance + 5e-6 * radius);
    }
    EXPECT_NEAR(std::abs(area(ring)), std::numbers::pi * radius * radius, 4 * std::numbers::pi * radius * tolerance);
  }

  Temporary_folder folder_;
};

TEST_F(Svg, StraightPathsInEverySpelling) {
  const Ring_2 expected = {{1, -1}, {5, -1}, {5, -4}, {1, -4}};
  for (const char* data : {"M1 1L5 1L5 4L1 4Z", "M1,1 5,1 5,4 1,4z", "m1 1 4 0 0 3-4 0z", "M1 1H5V4H1Z", "m1 1h4v3h-4z",
                           "M1 1h4v3H1z", " M 1 , 1 L 5 1 l 0 3 L +1 4e0 \n Z "})
    EXPECT_THAT(path(data), ElementsAre(expected)) << data;
}

TEST_F(Svg, CompactNumbers) {
  EXPECT_THAT(path("M1.5.5-3-.25.5.75z"), ElementsAre(Ring_2{{1.5, -.5}, {-3, .25}, {.5, -.75}}));
  EXPECT_THAT(path("M0 0L1e1-2L.5e-1 3z"), ElementsAre(Ring_2{{0, 0}, {10, 2}, {.05, -3}}));
}

TEST_F(Svg, SeveralSubpaths) {
  EXPECT_THAT(path("M0 0H9V9zM1 1v1h1z"),
              ElementsAre(Ring_2{{0, 0}, {9, 0}, {9, -9}}, Ring_2{{1, -1}, {1, -2}, {2, -2}}));
  EXPECT_THAT(path("M0 0H9V9z m20 1h1v1z"),
              ElementsAre(Ring_2{{0, 0}, {9, 0}, {9, -9}}, Ring_2{{20, -1}, {21, -1}, {21, -2}}));
  EXPECT_THAT(path("M0 0H9V9z h-3 v-5 z"),
              ElementsAre(Ring_2{{0, 0}, {9, 0}, {9, -9}}, Ring_2{{0, 0}, {-3, 0}, {-3, 5}}));
}

TEST_F(Svg, OpenSubpathsAreClosedWithAWarning) {
  const File_contents contents = read(
      "\n<path d='M0 0H9V9'/><polyline points='0,0 1,0 1,1'/>"
      "<path d='M0 0H9V9L0 0'/><polygon points='0 0 1 0 1 1'/>");
  EXPECT_EQ(contents.inputs.get(outline_input)->rings.size(), 4u);
  EXPECT_THAT(contents.warnings,
              ElementsAre("line 2: ring 1 is not closed: it starts at (0, 0) and ends at (9, -9); a segment joins them",
                          "line 2: ring 2 is not closed: it starts at (0, 0) and ends at (1, -1); a segment joins them",
                          StartsWith("outline crosses itself")));
}

TEST_F(Svg, CubicCurvesStayWithinTheTolerance) {
  const std::vector<Ring_2> found = path("M0 0C0 100 100 100 100 0z");
  ASSERT_EQ(found.size(), 1u);
  const double tolerance = relative_tolerance * diagonal(found);
  EXPECT_GT(found[0].size(), 10u);
  EXPECT_LT(found[0].size(), 100u);
  for (int i = 0; i <= 1000; ++i) {
    const double t = i / 1000.;
    const Point_2 p{100 * (3 * (1 - t) * t * t + t * t * t), -300 * (1 - t) * t};
    double nearest = 1e9;
    for (std::size_t j = 0; j + 1 < found[0].size(); ++j) {
      const Point_2& a = found[0][j];
      const Point_2& b = found[0][j + 1];
      const double along =
          std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / squared_distance(a, b), 0., 1.);
      nearest = std::min(nearest, distance(p, {a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)}));
    }
    EXPECT_LE(nearest, tolerance * 1.001) << t;
  }
}

TEST_F(Svg, RelativeSmoothAndQuadraticCurvesEqualTheirLongForms) {
  const auto expect_same = [&](const char* one, const char* other) {
    const auto a = path(one);
    const auto b = path(other);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) expect_near(a[i], b[i], 1e-9);
  };
  expect_same("M10 10c0 20 30 20 30 0z", "M10 10C10 30 40 30 40 10z");
  expect_same("M0 0C0 9 9 9 9 0S18-9 18 0z", "M0 0C0 9 9 9 9 0C9-9 18-9 18 0z");
  expect_same("M0 0C0 9 9 9 9 0s9-9 9 0z", "M0 0C0 9 9 9 9 0C9-9 18-9 18 0z");
  expect_same("M0 0H5S9 5 0 9z", "M0 0H5C5 0 9 5 0 9z");
  expect_same("M0 0Q4 8 8 0T16 0z", "M0 0Q4 8 8 0Q12-8 16 0z");
  expect_same("M0 0q4 8 8 0t8 0 8 0z", "M0 0Q4 8 8 0Q12-8 16 0Q20 8 24 0z");
  expect_same("M0 0Q6 9 9 0z", "M0 0C4 6 7 6 9 0z");
  expect_same("M0 0T5 5L9 0z", "M0 0L5 5L9 0z");
}

TEST_F(Svg, ArcsHaveTheirFourForms) {
  // From (0,0) to (1,1) on circles of radius 1 around (1,0) and (0,1).
  const auto arc = [&](const char* flags) { return path(std::string("M0 0A1 1 0 ") + flags + " 1 1z"); };
  const double quarter = std::numbers::pi / 4 - 0.5;
  const double tolerance = 0.01;
  const std::vector<std::pair<const char*, double>> expected = {
      {"0 0", quarter}, {"0 1", -quarter}, {"1 0", std::numbers::pi - quarter}, {"1 1", quarter - std::numbers::pi}};
  for (const auto& [flags, signed_area] : expected) {
    const auto found = arc(flags);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(area(found[0]), signed_area, tolerance) << flags;
    const bool around_right = std::string(flags) == "0 0" || std::string(flags) == "1 1";
    for (const Point_2& p : found[0])
      EXPECT_NEAR(distance(p, around_right ? Point_2{1, 0} : Point_2{0, -1}), 1, 1e-5) << flags;
  }
}

TEST_F(Svg, ArcsWithSpecialRadii) {
  EXPECT_THAT(path("M0 0A0 5 0 0 1 4 0L4 4z"), ElementsAre(Ring_2{{0, 0}, {4, 0}, {4, -4}}));
  EXPECT_THAT(path("M0 0A5 5 0 0 1 0 0L4 0 4 4z"), ElementsAre(Ring_2{{0, 0}, {4, 0}, {4, -4}}));
  const auto too_small = path("M-3 0A1 1 0 0 1 3 0A1-1 0 0 1-3 0z");
  ASSERT_EQ(too_small.size(), 1u);
  expect_circle(too_small[0], {0, 0}, 3, diagonal(too_small));
  const auto compact = path("M-3 0a3 3 0 016 0a3 3 0 01-6 0z");
  ASSERT_EQ(compact.size(), 1u);
  expect_circle(compact[0], {0, 0}, 3, diagonal(compact));
}

TEST_F(Svg, RotatedEllipticalArc) {
  // A half ellipse with the radii 4 and 2 turned by 90 degrees: from its lower to its upper end.
  const auto found = path("M0-4A4 2 90 0 1 0 4z");
  ASSERT_EQ(found.size(), 1u);
  for (const Point_2& p : found[0]) {
    EXPECT_NEAR(p.x * p.x / 4 + p.y * p.y / 16, 1, 1e-4);
    EXPECT_GE(p.x, -1e-9);
  }
  EXPECT_NEAR(std::abs(area(found[0])), std::numbers::pi * 4, 0.1);
}

TEST_F(Svg, Shapes) {
  EXPECT_THAT(rings("<rect x='1' y='2' width='3' height='4'/>"),
              ElementsAre(Ring_2{{1, -2}, {4, -2}, {4, -6}, {1, -6}}));
  EXPECT_THAT(rings("<polygon points='0,0 3,0,3-3'/>"), ElementsAre(Ring_2{{0, 0}, {3, 0}, {3, 3}}));
  const auto circle = rings("<circle cx='5' cy='6' r='10'/>");
  ASSERT_EQ(circle.size(), 1u);
  expect_circle(circle[0], {5, -6}, 10, diagonal(circle));
  const auto ellipse = rings("<ellipse rx='10' ry='5'/>");
  ASSERT_EQ(ellipse.size(), 1u);
  EXPECT_NEAR(std::abs(area(ellipse[0])), 50 * std::numbers::pi, 0.5);
  for (const Point_2& p : ellipse[0]) EXPECT_NEAR(p.x * p.x / 100 + p.y * p.y / 25, 1, 2e-5);
}

TEST_F(Svg, RoundedRectangle) {
  const double corner = 4 - std::numbers::pi;
  for (const char* radii : {"rx='1'", "ry='1'", "rx='1' ry='1'", "rx='auto' ry='1'"}) {
    const auto found = rings(std::string("<rect width='10' height='6' ") + radii + "/>");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(std::abs(area(found[0])), 60 - corner, 0.05) << radii;
  }
  const auto clamped = rings("<rect width='10' height='10' rx='99'/>");
  ASSERT_EQ(clamped.size(), 1u);
  expect_circle(clamped[0], {5, -5}, 5, diagonal(clamped));
}

TEST_F(Svg, Units) {
  EXPECT_THAT(rings("<rect width='1in' height='72pt'/>"), ElementsAre(Ring_2{{0, 0}, {96, 0}, {96, -96}, {0, -96}}));
  expect_near(rings("<rect width='25.4mm' height='2.54cm'/>")[0], {{0, 0}, {96, 0}, {96, -96}, {0, -96}}, 1e-9);
  const File_contents contents = read("<rect width='100%' height='100%'/><rect width='1px' height='1'/>");
  EXPECT_EQ(contents.inputs.get(outline_input)->rings.size(), 1u);
  EXPECT_THAT(contents.warnings, ElementsAre("line 1: <rect width='100%'> is left out, its unit is not known"));
}

TEST_F(Svg, TransformsNest) {
  const auto at = [&](const std::string& transform) {
    return rings("<g transform='" + transform + "'><path d='M0 0H2V1z'/></g>").front();
  };
  expect_near(at("translate(3)"), {{3, 0}, {5, 0}, {5, -1}});
  expect_near(at("translate(3,4)"), {{3, -4}, {5, -4}, {5, -5}});
  expect_near(at("scale(2)"), {{0, 0}, {4, 0}, {4, -2}});
  expect_near(at("scale(2 -3)"), {{0, 0}, {4, 0}, {4, 3}});
  expect_near(at("rotate(90)"), {{0, 0}, {0, -2}, {-1, -2}});
  expect_near(at("rotate(90 1 0)"), {{1, 1}, {1, -1}, {0, -1}});
  expect_near(at("skewX(45)"), {{0, 0}, {2, 0}, {3, -1}});
  expect_near(at("skewY(45)"), {{0, 0}, {2, -2}, {2, -3}});
  expect_near(at("matrix(1 2 3 4 5 6)"), {{5, -6}, {7, -10}, {10, -14}});
  expect_near(at("translate(1 1) scale(2),translate(1 1)"), {{3, -3}, {7, -3}, {7, -5}});
  expect_near(rings("<g transform='translate(10 0)'><g transform='scale(2)'><path transform='translate(0 1)' "
                    "d='M0 0H2V1z'/></g><path d='M0 0H2V1z'/></g>")[0],
              {{10, -2}, {14, -2}, {14, -4}});
}

TEST_F(Svg, WhatIsNotDrawnIsIgnored) {
  const std::string shape = "<path d='M0 0H1V1z'/>";
  for (const std::string& hidden : std::vector<std::string>{
           "<defs>" + shape + "</defs>", "<symbol><g>" + shape + "</g></symbol>", "<clipPath>" + shape + "</clipPath>",
           "<mask>" + shape + "</mask>", "<pattern>" + shape + "</pattern>", "<marker>" + shape + "</marker>",
           "<g display='none'>" + shape + "</g>", "<g style='fill: red; display : none'><g>" + shape + "</g></g>",
           "<path d='rubbish' display='none'/>", "<!-- " + shape + " -->", "<style><![CDATA[" + shape + "]]></style>"})
    EXPECT_THAT(rings(hidden + "<path d='M5 5H9V9z'/>"), ElementsAre(Ring_2{{5, -5}, {9, -5}, {9, -9}})) << hidden;
}

TEST_F(Svg, WhatIsNotReadIsCounted) {
  EXPECT_THAT(read("<path d='M5 5H9V9z'/><text>a</text><use href='#a'/><use href='#b'/>").warnings,
              ElementsAre("1 <text> is not read; convert it to paths to get its outline",
                          "2 <use> are not read; convert it to paths to get its outline"));
}

TEST_F(Svg, XmlSpellings) {
  const Ring_2 expected = {{0, 0}, {9, 0}, {9, -9}};
  const std::string prolog =
      "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!DOCTYPE svg PUBLIC '-//W3C>' [ <!ENTITY a \"]>\"> ]>\n";
  const auto first_ring = [&](const std::string& text) {
    return folder_.read("a.svg", text).inputs.get(outline_input)->rings.at(0);
  };
  EXPECT_EQ(first_ring(prolog + "<svg xmlns='&a;'><path id=\"a>b\" d\n=\n'M0 0H9V9z'></path></svg>\n<!-- end -->"),
            expected);
  EXPECT_EQ(first_ring("<svg:svg><svg:g><svg:path d='M0 0H9V9z'/></svg:g></svg:svg>"), expected);
  EXPECT_EQ(first_ring("<svg><path d='M0&#32;0H&#x39;V9z' name='&lt;&amp;&quot;&unknown;&'/></svg>"), expected);
  EXPECT_EQ(first_ring("<svg viewBox='0 0 1 1' width='5mm'><title>a &amp; b</title><path d='M0 0H9V9z'/></svg>"),
            expected);
}

TEST_F(Svg, DegenerateShapes) {
  const File_contents contents = read(
      "<path d=''/><path d='M1 1'/><rect width='0' height='5'/><circle r='0'/>"
      "<path d='none'/><polygon points=''/>");
  EXPECT_THAT(contents.inputs.get(outline_input)->rings, IsEmpty());
  EXPECT_THAT(contents.warnings, ElementsAre(StartsWith("the outline is empty")));
  EXPECT_THAT(read("<path d='M0 0H9z'/><path transform='scale(0)' d='M0 0C1 2 3 4 5 6z'/>").warnings,
              testing::Contains(HasSubstr("ring 2 has fewer than 3 distinct vertices")));
}

TEST_F(Svg, XmlErrors) {
  EXPECT_THAT(error("<svg>\n<path d='M0 0H9V9z'/>\n<g>\n"),
              AllOf(StartsWith("a.svg:4: expected </g>, found the end of the file"), HasSubstr("; ")));
  EXPECT_THAT(error("<svg>\n<g></svg>"), StartsWith("a.svg:2: expected </g>, found </svg>"));
  EXPECT_THAT(error("<svg></svg></svg>"), StartsWith("a.svg:1: expected no end tag, found </svg>"));
  EXPECT_THAT(error("<svg>\n<path d='M0 0"), StartsWith("a.svg:2: expected the closing quote of the value of d"));
  EXPECT_THAT(error("<svg><path d=M0/></svg>"), HasSubstr("expected a value in quotes for d, found 'M0/></svg>'"));
  EXPECT_THAT(error("<svg><path d/></svg>"), HasSubstr("expected '=' after d"));
  EXPECT_THAT(error("<svg><!-- "), HasSubstr("expected the end '-->' of a comment"));
  EXPECT_THAT(error("<svg"), HasSubstr("expected the end '>' of the tag <svg"));
  EXPECT_THAT(error("<html></html>"), StartsWith("a.svg:1: expected the first element <svg>, found <html>"));
  EXPECT_THAT(error("plain text"), StartsWith("a.svg:1: expected an <svg> element, found none"));
  EXPECT_THAT(error("<svg></svg>"), HasSubstr("expected a path, rect, circle, ellipse, polygon or polyline"));
  EXPECT_THAT(error("<svg><text/></svg>"), HasSubstr("found none but <text>"));
}

TEST_F(Svg, SyntaxErrors) {
  const auto error_in = [&](const std::string& body) { return error("<svg>\n" + body + "</svg>"); };
  EXPECT_THAT(error_in("<path d='L1 1'/>"),
              AllOf(StartsWith("a.svg:2: expected a command M or m in <path d=...>, found 'L1 1'"), HasSubstr("; ")));
  EXPECT_THAT(error_in("<path d='M1 1X2 2'/>"),
              StartsWith("a.svg:2: expected one of the commands MLHVCSQTAZ in <path d=...>, found 'X2 2'"));
  EXPECT_THAT(error_in("<path d='M1 1L2'/>"), HasSubstr("expected a number in <path d=...>, found nothing"));
  EXPECT_THAT(error_in("<path d='M1 1L2 nan'/>"), HasSubstr("expected a number in <path d=...>, found 'nan'"));
  EXPECT_THAT(error_in("<path d='M1 1L2 1e999'/>"), HasSubstr("expected a number"));
  EXPECT_THAT(error_in("<path d='M1 1A1 1 0 2 0 3 3'/>"), HasSubstr("expected a flag 0 or 1"));
  EXPECT_THAT(error_in("<polygon points='1 2 3'/>"), HasSubstr("in <polygon points=...>, found nothing"));
  EXPECT_THAT(error_in("<g transform='turn(3)'/>"), HasSubstr("expected matrix(...), translate"));
  EXPECT_THAT(error_in("<g transform='scale(1 2 3)'/>"), HasSubstr("expected the right number of arguments of scale"));
  EXPECT_THAT(error_in("<g transform='scale(1'/>"), HasSubstr("expected a number"));
  EXPECT_THAT(error_in("<rect width='wide' height='1'/>"), HasSubstr("in <rect width=...>, found 'wide'"));
  EXPECT_THAT(error_in("<path d='M1e308 0H5V5z' transform='scale(1e9)'/>"), HasSubstr("expected finite coordinates"));
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

const Ring_2 square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Ring_2 hole = {{1, 1}, {1, 2}, {2, 2}};

class Wkt : public testing::Test {
 protected:
  File_contents read(std::string_view text) const { return folder_.read("a.wkt", text); }
  std::vector<Ring_2> rings(std::string_view text) const { return read(text).inputs.get(outline_input)->rings; }
  std::string error(std::string_view text) const { return folder_.error("a.wkt", text); }

  Temporary_folder folder_;
};

TEST_F(Wkt, Polygon) {
  const File_contents contents = read("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 1 1))\n");
  EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{"outline"});
  EXPECT_THAT(contents.inputs.get(outline_input)->rings, ElementsAre(square, hole));
  EXPECT_THAT(contents.warnings, IsEmpty());
}

TEST_F(Wkt, SpellingsOfPolygon) {
  EXPECT_THAT(rings("polygon((0 0,4 0,4 4,0 4,0 0))"), ElementsAre(square));
  EXPECT_THAT(rings("\r\n  Polygon\n(\n(0\t0 , 4 0\r\n,4 4,0 +4,0 0) )"), ElementsAre(square));
  EXPECT_THAT(rings("SRID=4326;POLYGON((0 0,4 0,4 4,0 4,0 0))"), ElementsAre(square));
}

TEST_F(Wkt, MultipolygonAndCollection) {
  EXPECT_THAT(rings("MULTIPOLYGON (((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2,1 1)),((9 0,9 1,8 1,9 0)))"),
              ElementsAre(square, hole, Ring_2{{9, 0}, {9, 1}, {8, 1}}));
  EXPECT_THAT(rings("GEOMETRYCOLLECTION(POLYGON((0 0,4 0,4 4,0 4,0 0)),GEOMETRYCOLLECTION(POLYGON EMPTY,"
                    "MULTIPOLYGON(((1 1,1 2,2 2,1 1)))))"),
              ElementsAre(square, hole));
}

TEST_F(Wkt, SeveralGeometries) {
  EXPECT_THAT(rings("POLYGON((0 0,4 0,4 4,0 4,0 0))\nPOLYGON((1 1,1 2,2 2,1 1));\n"), ElementsAre(square, hole));
  const File_contents both = read("POINT(1 2)\nPOLYGON((0 0,4 0,4 4,0 4,0 0))\nMULTIPOINT((3 4),(5 6))");
  EXPECT_THAT(*both.inputs.get(points_input), ElementsAre(Point_2{1, 2}, Point_2{3, 4}, Point_2{5, 6}));
  EXPECT_THAT(both.inputs.get(outline_input)->rings, ElementsAre(square));
}

TEST_F(Wkt, Points) {
  const File_contents contents = read("MULTIPOINT(1 2, 3 4)");
  EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{"points"});
  EXPECT_THAT(*contents.inputs.get(points_input), ElementsAre(Point_2{1, 2}, Point_2{3, 4}));
}

TEST_F(Wkt, ClosedLines) {
  EXPECT_THAT(rings("LINESTRING(0 0,4 0,4 4,0 4,0 0)"), ElementsAre(square));
  EXPECT_THAT(rings("MULTILINESTRING((0 0,4 0,4 4,0 4,0 0),(1 1,1 2,2 2,1 1))"), ElementsAre(square, hole));
  EXPECT_THAT(error("POINT(1 1)\nLINESTRING(0 0,4 0,4 4)"),
              AllOf(StartsWith("a.wkt:2: expected a LINESTRING that ends where it starts, found '(0 0,4 0,4 4)'"),
                    HasSubstr("; close it")));
}

TEST_F(Wkt, HeightsAreLeftOutWithAWarning) {
  for (const char* text : {"POLYGON Z((0 0 1,4 0 2,4 4 3,0 4 4,0 0 1))", "POLYGONZ((0 0 1,4 0 2,4 4 3,0 4 4,0 0 1))",
                           "POLYGON ZM ((0 0 1 1,4 0 2 1,4 4 3 1,0 4 4 1,0 0 1 1))",
                           "POLYGON m((0 0 1,4 0 2,4 4 3,0 4 4,0 0 1))", "POLYGON((0 0 1,4 0 2,4 4 3,0 4 4,0 0 1))"}) {
    const File_contents contents = read(text);
    EXPECT_THAT(contents.inputs.get(outline_input)->rings, ElementsAre(square)) << text;
    EXPECT_THAT(contents.warnings, ElementsAre("line 1: Z and M coordinates are left out")) << text;
  }
}

TEST_F(Wkt, AnOpenRingIsClosedWithAWarning) {
  const File_contents contents = read("POINT(0 0)\nPOLYGON((0 0,4 0,4 4,0 4,0 0),\n(1 1,1 2,2 2))");
  EXPECT_THAT(contents.inputs.get(outline_input)->rings, ElementsAre(square, hole));
  EXPECT_THAT(
      contents.warnings,
      ElementsAre("line 3: ring 2 is not closed: it starts at (1, 1) and ends at (2, 2); a segment joins them"));
}

TEST_F(Wkt, EqualNeighboursAreMerged) {
  const File_contents contents = read("POLYGON((0 0,0 0,4 0,4 4,4 4,4 4,0 4,0 0,0 0))");
  EXPECT_THAT(contents.inputs.get(outline_input)->rings, ElementsAre(square));
  EXPECT_THAT(contents.warnings, IsEmpty());
}

TEST_F(Wkt, FlatRingsAreDroppedWithAWarning) {
  const File_contents contents = read("POLYGON((0 0,1 1,0 0,1 1,0 0),(0 0,4 0,4 4,0 4,0 0),(7 7,7 7,7 7))");
  EXPECT_THAT(contents.inputs.get(outline_input)->rings, ElementsAre(square));
  EXPECT_THAT(contents.warnings, ElementsAre("line 1: ring 1 has fewer than 3 distinct vertices; it is left out",
                                             "line 1: ring 3 has fewer than 3 distinct vertices; it is left out"));
}

TEST_F(Wkt, EmptyIsAnEmptyOutline) {
  for (const char* text : {"POLYGON EMPTY", "MULTIPOLYGON EMPTY", "POLYGON(EMPTY)"}) {
    const File_contents contents = read(text);
    EXPECT_THAT(contents.inputs.get(outline_input)->rings, IsEmpty()) << text;
    EXPECT_THAT(contents.warnings, testing::Contains(StartsWith("the outline is empty"))) << text;
  }
  EXPECT_THAT(*read("MULTIPOINT EMPTY").inputs.get(points_input), IsEmpty());
  EXPECT_THAT(error("GEOMETRYCOLLECTION EMPTY"), HasSubstr("expected at least one POLYGON"));
}

TEST_F(Wkt, ACrossingIsAWarning) {
  const File_contents contents = read("POLYGON((0 0,2 2,2 0,0 2,0 0))");
  EXPECT_EQ(contents.inputs.get(outline_input)->rings[0].size(), 4u);
  EXPECT_THAT(contents.warnings,
              ElementsAre("outline crosses itself 1 time near (1, 1) between segment 1 of ring 1 and segment 3 of ring "
                          "1; inside is decided by the even-odd rule"));
}

TEST_F(Wkt, CrossingsNameRingsAsTheFileNumbersThem) {
  const File_contents contents =
      read("POLYGON((9 9,9 9))\nPOLYGON((0 0,4 0,4 4,0 4,0 0))\nPOLYGON((3 1,5 1,5 2,3 2,3 1))");
  EXPECT_THAT(contents.warnings,
              ElementsAre(HasSubstr("ring 1 has fewer"),
                          AllOf(StartsWith("outline crosses itself 2 times, first near (4, 1) between segment 2 of "
                                           "ring 2 and segment 1 of ring 3"))));
}

TEST_F(Wkt, ManyWarningsAreCounted) {
  std::string text = "MULTIPOLYGON(";
  for (int i = 0; i < 1000; ++i) text += "((0 0,1 1)),";
  text += "((0 0,4 0,4 4,0 4,0 0)))";
  const File_contents contents = read(text);
  EXPECT_THAT(contents.inputs.get(outline_input)->rings, ElementsAre(square));
  EXPECT_THAT(contents.warnings, SizeIs(21));
  EXPECT_EQ(contents.warnings.back(), "and 1980 more warnings");
}

TEST_F(Wkt, Errors) {
  EXPECT_THAT(error("CIRCLE(1 2)"), AllOf(StartsWith("a.wkt:1: expected POLYGON, MULTIPOLYGON, closed LINESTRING"),
                                          HasSubstr("found 'CIRCLE(1 2)'"), HasSubstr("; convert")));
  EXPECT_THAT(error("POLYGON((0 0,1 1,\n2 x,0 0))"),
              AllOf(StartsWith("a.wkt:2: expected a finite coordinate, found 'x,0 0))'")));
  EXPECT_THAT(error("POLYGON((0 0,1 nan,0 0))"), StartsWith("a.wkt:1: expected a finite coordinate, found 'nan"));
  EXPECT_THAT(error("POLYGON((0 0,1 inf,0 0))"), StartsWith("a.wkt:1: expected a finite coordinate, found 'inf"));
  EXPECT_THAT(error("POLYGON((0 0,4 0,4 4"), AllOf(StartsWith("a.wkt:1: expected ')', found the end of the file"),
                                                   HasSubstr("; the file is cut off")));
  EXPECT_THAT(error("POLYGON((0 0,4 0,4 4,0 0)\n\n"), StartsWith("a.wkt:3: expected ')', found the end of the file"));
  EXPECT_THAT(error("POLYGON(0 0,4 0,4 4,0 0)"), StartsWith("a.wkt:1: expected '(', found '0 0,4 0"));
  EXPECT_THAT(error("POLYGON((0 0 0 0 0,4 0,4 4,0 0))"), StartsWith("a.wkt:1: expected ')', found '0,4 0"));
  EXPECT_THAT(error("POLYGON"), StartsWith("a.wkt:1: expected '(', found the end of the file"));
  EXPECT_THAT(error("SRID=4326;"), StartsWith("a.wkt:1: expected POLYGON"));
  EXPECT_THAT(error(""), StartsWith("a.wkt: expected data, found an empty file"));
  EXPECT_THAT(error("1 2\n3 4"), StartsWith("a.wkt:1: expected POLYGON"));
  EXPECT_THAT(error("POLYGON((0 0,4 0,4 4,0 0)) rubbish"), HasSubstr("found 'rubbish'"));
}

TEST_F(Wkt, DeepNestingIsAnError) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "GEOMETRYCOLLECTION(";
  EXPECT_THAT(error(text), HasSubstr("at most 100 nested collections"));
}

}  // namespace
}  // namespace mesecina

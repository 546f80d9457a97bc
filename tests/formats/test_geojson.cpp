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
using testing::StartsWith;

const Ring_2 square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Ring_2 hole = {{1, 1}, {1, 2}, {2, 2}};
const std::string square_text = "[[0,0],[4,0],[4,4],[0,4],[0,0]]";
const std::string hole_text = "[[1,1],[1,2],[2,2],[1,1]]";

class Geojson : public testing::Test {
 protected:
  File_contents read(std::string_view text) const { return folder_.read("a.geojson", text); }
  std::vector<Ring_2> rings(std::string_view text) const { return read(text).inputs.get(outline_input)->rings; }
  std::string error(std::string_view text) const { return folder_.error("a.geojson", text); }

  static std::string polygon(const std::string& coordinates) {
    return R"({"type": "Polygon", "coordinates": )" + coordinates + "}";
  }

  Temporary_folder folder_;
};

TEST_F(Geojson, Polygons) {
  EXPECT_THAT(rings(polygon("[" + square_text + "," + hole_text + "]")), ElementsAre(square, hole));
  EXPECT_THAT(rings(R"({"type":"MultiPolygon","coordinates":[[)" + square_text + "],[" + hole_text + "]]}"),
              ElementsAre(square, hole));
  EXPECT_THAT(folder_.read("a.json", polygon("[" + square_text + "]")).inputs.get(outline_input)->rings,
              ElementsAre(square));
}

TEST_F(Geojson, FeaturesAndCollections) {
  EXPECT_THAT(rings(R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{"name":"a"},"geometry":)" +
                    polygon("[" + square_text + "]") + R"(},
      {"type":"Feature","properties":null,"geometry":null},
      {"type":"Feature","geometry":{"type":"GeometryCollection","geometries":[)" +
                    polygon("[" + hole_text + "]") + "]}}]}"),
              ElementsAre(square, hole));
}

TEST_F(Geojson, Points) {
  EXPECT_THAT(*read(R"({"type":"Point","coordinates":[1.5,-2]})").inputs.get(points_input),
              ElementsAre(Point_2{1.5, -2}));
  EXPECT_THAT(*read(R"({"type":"MultiPoint","coordinates":[[1,2],[3e2,4]]})").inputs.get(points_input),
              ElementsAre(Point_2{1, 2}, Point_2{300, 4}));
}

TEST_F(Geojson, Warnings) {
  EXPECT_THAT(read(polygon("[[[0,0],[4,0],[4,4],[0,4]]]")).warnings,
              ElementsAre(StartsWith("coordinates[0]: ring 1 is not closed: it starts at (0, 0) and ends at (0, 4)")));
  EXPECT_THAT(read(polygon("[" + square_text + ",[[1,1],[2,2],[1,1]]]")).warnings,
              ElementsAre("coordinates[1]: ring 2 has fewer than 3 distinct vertices; it is left out"));
  EXPECT_THAT(read(polygon("[[[0,0,7],[4,0,7],[4,4,7],[0,4,7],[0,0,7]]]")).warnings,
              ElementsAre("at coordinates[0][0]: heights are left out"));
  EXPECT_THAT(read(polygon("[[[0,0],[2,2],[2,0],[0,2],[0,0]]]")).warnings,
              ElementsAre(StartsWith("outline crosses itself 1 time near (1, 1)")));
  EXPECT_THAT(rings(R"({"type":"MultiPolygon","coordinates":[]})"), IsEmpty());
}

TEST_F(Geojson, SyntaxErrorsHaveTheirPlace) {
  EXPECT_THAT(error("{\n\"type\": \"Polygon\",\n\"coordinates\": [[[0,0],[1,}\n"),
              AllOf(StartsWith("a.geojson:3: expected JSON, found '}' at byte 47"), HasSubstr("; ")));
  EXPECT_THAT(error("{\"type\": \"Polygon\",\n\"coordinates\": [[[0,0],"),
              StartsWith("a.geojson:2: expected JSON, found the end of the file"));
  EXPECT_THAT(error(polygon("[[[0,0],[1e999,0],[1,1],[0,0]]]")),
              AllOf(StartsWith("a.geojson: expected JSON"), HasSubstr("1e999")));
  EXPECT_THAT(error("POLYGON((0 0,1 1,0 1,0 0))"), StartsWith("a.geojson:1: expected JSON, found 'POLYGON"));
}

TEST_F(Geojson, ErrorsOfMeaningNameTheMember) {
  EXPECT_THAT(error("[]"), HasSubstr("expected a GeoJSON object, found an array of 0"));
  EXPECT_THAT(error("{}"), HasSubstr("expected a member \"type\""));
  EXPECT_THAT(error(R"({"type":"LineString","coordinates":[]})"),
              HasSubstr("at type: expected Polygon, MultiPolygon, Point, MultiPoint or a collection of them, found "
                        "'\"LineString\"'"));
  EXPECT_THAT(error(R"({"type":7})"), HasSubstr("at type: expected Polygon"));
  EXPECT_THAT(error(R"({"type":"Polygon"})"), HasSubstr("expected a member \"coordinates\""));
  EXPECT_THAT(error(polygon("[[[0,0],[1,\"2\"]]]")),
              HasSubstr("at coordinates[0][1]: expected a position [x, y], found an array of 2"));
  EXPECT_THAT(error(polygon("[[0,0],[1,2]]")),
              HasSubstr("at coordinates[0][0]: expected a position [x, y], found '0'"));
  EXPECT_THAT(error(polygon("7")), HasSubstr("at coordinates: expected an array, found '7'"));
  EXPECT_THAT(error(R"({"type":"FeatureCollection","features":[)" + polygon("[]") + ",5]}"),
              HasSubstr("at features[1]: expected a GeoJSON object, found '5'"));
  EXPECT_THAT(error(R"({"type":"FeatureCollection","features":[]})"),
              HasSubstr("expected a Polygon, MultiPolygon, Point or MultiPoint, found none"));
}

TEST_F(Geojson, DeepNestingIsAnError) {
  std::string text;
  for (int i = 0; i < 200; ++i) text += R"({"type":"GeometryCollection","geometries":[)";
  for (int i = 0; i < 200; ++i) text += "]}";
  EXPECT_THAT(error(text), HasSubstr("at most 100 nested collections"));
  EXPECT_THAT(error(std::string(1000000, '[')), HasSubstr("found the end of the file"));
  EXPECT_THAT(error(std::string(1000000, '[') + std::string(1000000, ']')), HasSubstr("expected a GeoJSON object"));
}

}  // namespace
}  // namespace mesecina

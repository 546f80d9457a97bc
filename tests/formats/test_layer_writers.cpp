// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "tests/formats/layer_sets.h"
#include "tests/growth.h"

namespace mesecina {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Json_writer, WritesTheContractedDocument) {
  const Primitive_set set = one_of_each();
  Layer_document document;
  document.layer = "medial-axis";
  document.input = "a \"b\"\n.wkt";
  document.settings = {{"angle", 0.5}, {"count", std::int64_t{3}}, {"inner", true}, {"name", std::string("x")}};
  document.primitives = &set;
  EXPECT_EQ(json::parse(written("json", document)), json::parse(R"({
      "format": "mesecina-layer", "version": 1, "layer": "medial-axis", "dimension": 2, "input": "a \"b\"\n.wkt",
      "settings": {"angle": 0.5, "count": 3, "inner": true, "name": "x"},
      "vertices": [[0,0],[1,0],[0,1],[0.1,0.25]], "points": [3], "segments": [[0,1]],
      "rays": [{"from": 1, "direction": [0.6,0.8]}],
      "arcs": [{"center": [0,0], "radius": 1, "from": 2, "to": 1, "ccw": false}],
      "triangles": [[0,1,2]], "polygons": [[1,2,3]], "balls": [{"center": 0, "radius": 2.5}],
      "values": {"lambda": [0,0.5,"inf",1.5,2,2.5,3]}})"));
}

TEST(Json_writer, KeysAreInTheirOrder) {
  Primitive_set set = one_of_each();
  set.ids = {7, 6, 5, 4, 3, 2, 1};
  set.values = {{"zeta", "", std::vector<double>(7, 1)}, {"alpha", "", std::vector<double>(7, 2)}};
  const auto document = nlohmann::ordered_json::parse(written("json", set));
  std::vector<std::string> keys;
  for (const auto& [key, value] : document.items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("format", "version", "layer", "dimension", "input", "settings", "vertices", "points",
                                "segments", "rays", "arcs", "triangles", "polygons", "balls", "ids", "values"));
  EXPECT_EQ(document["ids"].dump(), "[7,6,5,4,3,2,1]");
  EXPECT_EQ(document["values"].begin().key(), "zeta");
}

TEST(Json_writer, EmptyArraysAreLeftOutButVertices) {
  const json document = json::parse(written("json", Primitive_set()));
  EXPECT_EQ(document.size(), 7u);
  EXPECT_EQ(document["vertices"], json::array());
  EXPECT_EQ(document["settings"], json::object());
}

TEST(Json_writer, AReasonReplacesThePrimitives) {
  Layer_document document;
  document.layer = "crust";
  document.reason = "needs at least 3 points";
  document.dimension = 3;
  const json written_document = json::parse(written("json", document));
  EXPECT_EQ(written_document["reason"], "needs at least 3 points");
  EXPECT_EQ(written_document["vertices"], json::array());
  EXPECT_EQ(written_document["dimension"], 3);
}

TEST(Json_writer, SpaceHasThreeCoordinates) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{1, 2, 3}};
  set.rays = {{0, {0, 0, 1}}};
  const json document = json::parse(written("json", set));
  EXPECT_EQ(document["vertices"], json::parse("[[1,2,3]]"));
  EXPECT_EQ(document["rays"], json::parse(R"([{"from":0,"direction":[0,0,1]}])"));
}

TEST(Json_writer, DoublesReadBackExactly) {
  std::mt19937_64 random(5);
  Primitive_set set;
  std::uniform_real_distribution<double> uniform(-1e3, 1e3);
  for (int i = 0; i < 1000; ++i) set.vertices.push_back({uniform(random), uniform(random) * 1e-200, 0});
  const json document = json::parse(written("json", set));
  for (std::size_t i = 0; i < set.vertices.size(); ++i) {
    EXPECT_EQ(document["vertices"][i][0].get<double>(), set.vertices[i].x);
    EXPECT_EQ(document["vertices"][i][1].get<double>(), set.vertices[i].y);
  }
}

TEST(Json_writer, WritesAMillionVerticesQuickly) {
  Primitive_set set;
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 1000000; ++i) set.vertices.push_back({uniform(random), uniform(random), 0});
  std::string text;
  const double seconds = test::processor_seconds([&] { text = written("json", set); });
  EXPECT_GT(text.size(), 30000000u);
  EXPECT_LT(seconds, 10) << "an optimized build takes about 0.4 s";
}

TEST(Csv_writer, HasARowPerElement) {
  EXPECT_THAT(lines_of(written("csv", one_of_each())),
              ElementsAre("element,kind,id,x0,y0,x1,y1,x2,y2,radius,ring,lambda",  //
                          "0,point,0,0.1,0.25,,,,,,,0",                            //
                          "1,segment,1,0,0,1,0,,,,,0.5",                           //
                          "2,ray,2,1,0,0.6,0.8,,,,,inf",                           //
                          "3,arc,3,1,0,0,1,0,0,1,,1.5",                            //
                          "4,triangle,4,0,0,1,0,0,1,,,2",                          //
                          "5,polygon,5,,,,,,,,1 0;0 1;0.1 0.25,2.5",               //
                          "6,disk,6,0,0,,,,,2.5,,3"));
}

TEST(Csv_writer, WholeCirclesBeginAndEndInTheirVertex) {
  Primitive_set set;
  set.vertices = {{3, 2, 0}};
  set.arcs = {{{1, 2}, 2, 0, 0, false}};
  EXPECT_THAT(lines_of(written("csv", set)),
              ElementsAre("element,kind,id,x0,y0,x1,y1,x2,y2,radius", "0,arc,0,3,2,3,2,1,2,2"));
}

TEST(Csv_writer, ColumnsFollowTheSet) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{1, 2, 3}, {4, 5, 6}};
  set.segments = {{0, 1}};
  set.balls = {{1, 0.5}};
  set.ids = {70, 80};
  set.values = {{"a,\"b\"", "", {1, 2}}};
  EXPECT_THAT(lines_of(written("csv", set)), ElementsAre("element,kind,id,x0,y0,z0,x1,y1,z1,radius,\"a,\"\"b\"\"\"",
                                                         "0,segment,70,1,2,3,4,5,6,,1", "1,ball,80,4,5,6,,,,0.5,2"));
  Layer_document none;
  none.reason = "needs a point";
  EXPECT_EQ(written("csv", none), "element,kind,id,x0,y0,x1,y1,radius\n");
}

TEST(Obj_writer, WritesEveryKindItCan) {
  Primitive_set set = one_of_each();
  set.arcs.clear();
  EXPECT_THAT(lines_of(written("obj", set)),
              ElementsAre("# layer some-layer", "v 0 0 0", "v 1 0 0", "v 0 1 0", "v 0.1 0.25 0", "p 4", "l 1 2",
                          "# 1 rays are left out", "f 1 2 3",
                          "# 1 polygons, filled together by the even-odd rule, as closed lines", "l 2 3 4 2",
                          "# disk of radius 2.5", "p 1"));
}

TEST(Obj_writer, ArcsArePolylinesOfOneDegree) {
  const auto angles = [](int from, int to, bool counterclockwise) {
    Primitive_set set;
    set.vertices = {{6, 2, 0}, {1, 7, 0}};  // at 0 and 90 degrees on the circle of radius 5 around (1, 2)
    set.arcs = {{{1, 2}, 5, from, to, counterclockwise}};
    std::vector<Point_2> vertices;
    std::vector<double> result;
    for (const std::string& line : lines_of(written("obj", set))) {
      std::istringstream words(line);
      std::string kind;
      words >> kind;
      Point_2 p;
      if (kind == "v" && words >> p.x >> p.y) vertices.push_back(p);
      std::size_t vertex = 0;
      while (kind == "l" && words >> vertex) {
        const Point_2& q = vertices.at(vertex - 1);
        EXPECT_NEAR(distance(q, {1, 2}), 5, 1e-12);
        result.push_back(std::atan2(q.y - 2, q.x - 1) * 180 / 3.14159265358979);
      }
    }
    return result;
  };
  const auto expect_steps = [](const std::vector<double>& turned, std::size_t count, double step) {
    ASSERT_EQ(turned.size(), count + 1);
    for (std::size_t i = 0; i + 1 < turned.size(); ++i)
      EXPECT_NEAR(std::remainder(turned[i + 1] - turned[i] - step, 360), 0, 1e-9);
  };
  expect_steps(angles(0, 1, true), 90, 1);
  expect_steps(angles(0, 1, false), 270, -1);
  expect_steps(angles(1, 0, true), 270, 1);
  expect_steps(angles(1, 0, false), 90, -1);
  expect_steps(angles(0, 0, true), 360, 1);
  expect_steps(angles(1, 1, false), 360, -1);
}

TEST(Obj_writer, SaysWhyItIsEmpty) {
  Layer_document document;
  document.layer = "crust";
  document.reason = "needs\nmore points";
  EXPECT_EQ(written("obj", document), "# layer crust\n# empty: needs more points\n");
}

TEST(Layer_writers, WriteTheSameBytesAgain) {
  const Formats formats = planar_formats();
  for (const Layer_writer& writer : formats.layer_writers) {
    EXPECT_FALSE(writer.help.empty());
    EXPECT_EQ(formats.find_layer_writer(writer.name), &writer);
    EXPECT_EQ(written(writer.name, one_of_each()), written(writer.name, one_of_each()));
  }
  EXPECT_EQ(formats.find_layer_writer("docx"), nullptr);
  EXPECT_EQ(formats.find_picture_writer("png"), nullptr);
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "tests/formats/layer_sets.h"

namespace mesecina {
namespace {

using testing::Contains;
using testing::ElementsAre;

/// A PLY file as this reader, which is only for little-endian machines, understands it: rows of doubles; lists are
/// flattened after their count.
struct Ply {
  struct Element {
    std::vector<std::string> properties;
    std::vector<std::vector<double>> rows;
  };
  std::vector<std::string> comments;
  std::map<std::string, Element> elements;
  std::size_t left_over = 0;
};

Ply parse(const std::string& file) {
  Ply ply;
  std::istringstream header(file);
  std::vector<std::tuple<std::string, std::size_t, std::vector<std::string>>> declared;
  for (std::string line; std::getline(header, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "comment") {
      ply.comments.push_back(line.substr(8));
    } else if (word == "element") {
      std::string name;
      std::size_t count = 0;
      words >> name >> count;
      declared.emplace_back(name, count, std::vector<std::string>());
    } else if (word == "property") {
      std::string type;
      std::string name;
      words >> type;
      if (type == "list") words >> word >> word;
      words >> name;
      std::get<2>(declared.back()).push_back(type);
      ply.elements[std::get<0>(declared.back())].properties.push_back(name);
    } else {
      EXPECT_TRUE(line == "ply" || line == "format binary_little_endian 1.0") << line;
    }
  }
  std::size_t position = file.find("end_header\n") + 11;
  const auto take = [&]<class Number>(Number number) {
    std::memcpy(&number, file.data() + position, sizeof number);
    position += sizeof number;
    return number;
  };
  for (const auto& [name, count, types] : declared) {
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<double>& row = ply.elements[name].rows.emplace_back();
      for (const std::string& type : types) {
        if (type == "double") row.push_back(take(double()));
        if (type == "int") row.push_back(take(std::int32_t()));
        if (type != "list") continue;
        row.push_back(take(std::uint8_t()));
        for (int left = static_cast<int>(row.back()); left > 0; --left) row.push_back(take(std::int32_t()));
      }
    }
  }
  ply.left_over = file.size() - position;
  return ply;
}

TEST(Ply_writer, PointsAndBallsAreVerticesWithTheirValues) {
  Primitive_set set;
  set.vertices = {{1, 2, 0}, {3, 4, 0}, {5, 6, 0}};
  set.points = {2, 0};
  set.balls = {{2, 0.5}};
  set.values = {{"scale", "", {7, 8, 9}}};
  Ply ply = parse(written("ply", set));
  EXPECT_EQ(ply.elements.size(), 1u);
  EXPECT_THAT(ply.elements["vertex"].properties, ElementsAre("x", "y", "z", "radius", "scale"));
  using Row = std::vector<double>;
  EXPECT_THAT(ply.elements["vertex"].rows, ElementsAre(Row{5, 6, 0, 0, 7}, Row{1, 2, 0, 0, 8}, Row{5, 6, 0, 0.5, 9}));
  EXPECT_EQ(ply.left_over, 0u);
  EXPECT_THAT(ply.comments, ElementsAre("layer some-layer"));
}

TEST(Ply_writer, AComplexSharesItsVertices) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {5, 5, 5}};
  set.points = {3};
  set.segments = {{2, 3}, {0, 1}};
  set.triangles = {{0, 1, 2}};
  set.balls = {{0, 4}, {0, 3}, {2, 6}};
  set.values = {{"lambda star", "", {0, 1, 2, 3, 4, 5, 6}}, {"radius", "", {10, 11, 12, 13, 14, 15, 16}}};
  Ply ply = parse(written("ply", set));
  using Row = std::vector<double>;
  EXPECT_THAT(ply.elements["vertex"].properties, ElementsAre("x", "y", "z", "radius"));
  EXPECT_THAT(ply.elements["vertex"].rows,
              ElementsAre(Row{0, 0, 1, 4}, Row{1, 0, 2, 0}, Row{0, 1, 3, 6}, Row{5, 5, 5, 0}));
  EXPECT_THAT(ply.elements["face"].properties, ElementsAre("vertex_indices", "lambda_star", "value_radius"));
  EXPECT_THAT(ply.elements["face"].rows, ElementsAre(Row{3, 0, 1, 2, 3, 13}));
  EXPECT_THAT(ply.elements["edge"].properties, ElementsAre("vertex1", "vertex2", "lambda_star", "value_radius"));
  EXPECT_THAT(ply.elements["edge"].rows, ElementsAre(Row{2, 3, 1, 11}, Row{0, 1, 2, 12}));
  EXPECT_EQ(ply.left_over, 0u);
  EXPECT_THAT(ply.comments, Contains("values of 4 points and balls are left out"));
}

TEST(Ply_writer, VerticesThatArePointsHaveTheirValues) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}};
  set.radii = {4, 5, 6};
  set.points = {2, 0, 1};
  set.segments = {{0, 1}};
  set.triangles = {{0, 1, 2}};
  set.values = {{"scale", "", {7, 8, 9, 10, 11}}};
  Ply ply = parse(written("ply", set));
  using Row = std::vector<double>;
  EXPECT_THAT(ply.elements["vertex"].properties, ElementsAre("x", "y", "z", "radius", "scale"));
  EXPECT_THAT(ply.elements["vertex"].rows, ElementsAre(Row{0, 0, 1, 4, 8}, Row{1, 0, 2, 5, 9}, Row{0, 1, 3, 6, 7}));
  EXPECT_THAT(ply.elements["edge"].rows, ElementsAre(Row{0, 1, 10}));
  EXPECT_THAT(ply.elements["face"].rows, ElementsAre(Row{3, 0, 1, 2, 11}));
  EXPECT_EQ(ply.left_over, 0u);
  EXPECT_THAT(ply.comments, ElementsAre("layer some-layer"));
  // One vertex is two points, and one is none.
  set.points = {2, 2, 1};
  ply = parse(written("ply", set));
  EXPECT_THAT(ply.elements["vertex"].properties, ElementsAre("x", "y", "z", "radius"));
  EXPECT_THAT(ply.comments, Contains("values of 3 points and balls are left out"));
}

TEST(Ply_writer, ArcsAndPolygonsAreEdgesAndRaysAreCounted) {
  Ply ply = parse(written("ply", one_of_each()));
  EXPECT_EQ(ply.elements["vertex"].rows.size(), 4u + 89);
  const auto& edges = ply.elements["edge"].rows;
  ASSERT_EQ(edges.size(), 1u + 90 + 3);
  EXPECT_EQ(edges[0], (std::vector<double>{0, 1, 0.5}));
  EXPECT_EQ(edges[1][0], 2);
  EXPECT_EQ(edges[90][1], 1);
  for (std::size_t i = 1; i <= 90; ++i) {
    EXPECT_EQ(edges[i][2], 1.5);
    EXPECT_TRUE(i == 1 || edges[i][0] == edges[i - 1][1]);
    const auto& end = ply.elements["vertex"].rows[static_cast<std::size_t>(edges[i][1])];
    EXPECT_NEAR(std::hypot(end[0], end[1]), 1, 1e-12);
    EXPECT_GE(end[0], 0);
    EXPECT_GE(end[1], 0);
  }
  EXPECT_EQ(edges[91], (std::vector<double>{1, 2, 2.5}));
  EXPECT_EQ(edges[93], (std::vector<double>{3, 1, 2.5}));
  EXPECT_THAT(ply.elements["face"].rows, ElementsAre(std::vector<double>{3, 0, 1, 2, 2}));
  EXPECT_THAT(ply.comments, Contains("1 rays are left out"));
  EXPECT_EQ(ply.left_over, 0u);
}

TEST(Ply_writer, WholeCirclesAreClosed) {
  Primitive_set set;
  set.vertices = {{3, 2, 0}};
  set.arcs = {{{1, 2}, 2, 0, 0, true}};
  Ply ply = parse(written("ply", set));
  EXPECT_EQ(ply.elements["vertex"].rows.size(), 360u);
  const auto& edges = ply.elements["edge"].rows;
  ASSERT_EQ(edges.size(), 360u);
  for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_EQ(edges[i][1], edges[(i + 1) % edges.size()][0]);
  EXPECT_THAT(ply.comments, Contains("1 arcs as polylines with at most 1 degree per segment"));
}

TEST(Ply_writer, InfinityIsKept) {
  Primitive_set set;
  set.vertices = {{0, 0, 0}};
  set.points = {0};
  set.values = {{"lambda", "", {std::numeric_limits<double>::infinity()}}};
  Ply ply = parse(written("ply", set));
  EXPECT_EQ(ply.elements["vertex"].rows.at(0).at(3), std::numeric_limits<double>::infinity());
}

TEST(Ply_writer, SaysWhyItIsEmpty) {
  Layer_document document;
  document.layer = "crust";
  document.input = "a.xy";
  document.reason = "needs more points";
  Ply ply = parse(written("ply", document));
  EXPECT_THAT(ply.comments, ElementsAre("layer crust", "input a.xy", "empty: needs more points"));
  EXPECT_TRUE(ply.elements["vertex"].rows.empty());
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <ctime>
#include <random>

#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using Triangle = std::array<int, 3>;

const std::vector<Point_3> four_points = {{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {0, 0, -2}};
const Triangle_mesh_3 four_triangles{four_points, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

class Meshes : public testing::Test {
 protected:
  void expect_mesh(std::string_view name, std::string_view text, const Triangle_mesh_3& expected) const {
    const File_contents contents = folder_.read(name, text);
    ASSERT_EQ(contents.inputs.ids(), std::vector<std::string>{"mesh"}) << text;
    EXPECT_EQ(*contents.inputs.get(mesh_input), expected) << text;
    EXPECT_THAT(contents.warnings, IsEmpty());
  }
  void expect_cloud(std::string_view name, std::string_view text) const {
    const File_contents contents = folder_.read(name, text);
    ASSERT_EQ(contents.inputs.ids(), std::vector<std::string>{"cloud"}) << text;
    EXPECT_EQ(*contents.inputs.get(cloud_input), four_points) << text;
    EXPECT_THAT(contents.warnings, IsEmpty());
  }
  void expect_error(std::string_view name, std::string_view text, int line, std::string_view expected,
                    std::string_view found) const {
    std::string start(name);
    if (line != 0) start.append(":").append(std::to_string(line));
    start += ": expected ";
    EXPECT_THAT(folder_.error(name, text), AllOf(StartsWith(start), HasSubstr(std::string(expected)),
                                                 HasSubstr(std::string(", found ").append(found)), HasSubstr("; ")))
        << text;
  }

  Temporary_folder folder_{spatial_formats()};
};

TEST_F(Meshes, Off) {
  expect_mesh("a.off", "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1.5 0\n0 0 -2\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
              four_triangles);
  expect_mesh("a.OFF",
              "# c\r\nOFF 4 4 0\r\n\r\n0 0 0 # first\r\n+1 0 0\r\n0,1.5,0\r\n0 0 -2e0\r\n3 0 2 1\r\n3\t0 1 3\r\n"
              "# c\r\n3 1 2 3\r\n3 2 0 3",
              four_triangles);
  expect_mesh("a.off",
              "OFF\n4 4\n0 0 0\n1 0 0\n0 1.5 0\n0 0 -2\n3 0 2 1 255 0 0\n3 0 1 3 0.5 0.5 0.5\n3 1 2 3 7\n3 2 0 3\n",
              four_triangles);
  for (const char* keyword : {"COFF", "NOFF", "CNOFF", "STOFF"})
    expect_cloud("a.off", std::string(keyword) + " 4 0 0\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1.5 0 1 2 3\n0 0 -2 1 2 3\n");
  expect_cloud("a.off", "OFF 4 0 0\n0 0 0\n1 0 0\n0 1.5 0\n0 0 -2\n");
}

TEST_F(Meshes, OffPolygons) {
  const auto contents =
      folder_.read("a.off", "OFF 6 4 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n1 1 0\n5 5 5\n4 0 1 2 3\n2 0 1\n4 0 1 4 3\n1 0\n");
  EXPECT_THAT(contents.warnings, ElementsAre("2 faces of fewer than three corners are not read"));
  const auto mesh = contents.inputs.get(mesh_input);
  EXPECT_EQ(mesh->vertices.size(), 6u) << "also the one that no face has";
  // The second quadrangle has a reflex corner 4, from which it must be split.
  ASSERT_EQ(mesh->triangles.size(), 4u);
  EXPECT_EQ(mesh->triangles[0], (Triangle{0, 1, 2}));
  EXPECT_EQ(mesh->triangles[1], (Triangle{0, 2, 3}));
  for (std::size_t i = 2; i < 4; ++i) EXPECT_THAT(mesh->triangles[i], testing::Contains(4));
}

TEST_F(Meshes, OffErrors) {
  expect_error("a.off", "PLY\n", 1, "'OFF' in the first line", "'PLY'");
  expect_error("a.off", "4OFF 1 0 0\n1 2 3 4\n", 1, "'OFF' in the first line", "'4OFF 1 0 0'");
  expect_error("a.off", "OFF BINARY\n1 0 0\n", 1, "an OFF file of text", "'BINARY'");
  expect_error("a.off", "OFF\n", 1, "the numbers of vertices and faces", "nothing");
  expect_error("a.off", "OFF -4 0 0\n", 1, "an integer of at least 0 for the number of vertices", "'-4'");
  expect_error("a.off", "OFF\n1e9 0 0\n", 2, "an integer of at least 0", "'1e9'");
  expect_error("a.off", "OFF 9000000000000000000 9000000000000000000 0\n0 0 0\n1 1 1\n", 3,
               "9000000000000000000 vertices", "2");
  expect_error("a.off", "OFF 3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 5, "2 faces", "1");
  expect_error("a.off", "OFF 1 0 0\n0 0 0\n1 1 1\n", 3, "the end of the file after 1 vertices and 0 faces", "'1 1 1'");
  expect_error("a.off", "OFF 1 0 0\n0 nan 0\n", 2, "a finite number for y", "'nan'");
  expect_error("a.off", "OFF 1 0 0\n0 0 -inf\n", 2, "a finite number for z", "'-inf'");
  expect_error("a.off", "OFF 1 0 0\n1e999 0 0\n", 2, "a finite number for x", "'1e999'");
  expect_error("a.off", "OFF 1 0 0\n1 0\n", 2, "a finite number for z", "nothing");
  expect_error("a.off", "OFF 1 0 0\n1 0x 0\n", 2, "a finite number for y", "'0x'");
  expect_error("a.off", "OFF 2 1 0\n0 0 0\n1 1 1\n3 0 1 2\n", 4, "a vertex number from 0 to 1", "'2'");
  expect_error("a.off", "OFF 2 1 0\n0 0 0\n1 1 1\n3 0 -1 1\n", 4, "a vertex number from 0 to 1", "'-1'");
  expect_error("a.off", "OFF 2 1 0\n0 0 0\n1 1 1\n3 0 1\n", 4, "a vertex number from 0 to 1", "nothing");
  expect_error("a.off", "OFF 2 1 0\n0 0 0\n1 1 1\n99999999999 0 1 1\n", 4, "a vertex number from 0 to 1", "nothing");
  expect_error("a.off", "OFF 0 1 0\n3 0 0 0\n", 2, "no faces, as there are no vertices", "'0'");
}

TEST_F(Meshes, Obj) {
  expect_mesh("a.obj",
              "# c\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nv 0 1.5 0 0.1 0.2 0.3\nv 0 0 -2\nvn 0 0 1\nvt 0 0\n"
              "usemtl m\ns off\ng a\nf 1 3 2\nf 1/1 2/1 4/1\nf 2//1 3//1 4//1\nf 3/1/1 1/1/1 4/1/1\n",
              four_triangles);
  // Backwards from the last vertex so far, and forwards to vertices still to come.
  expect_mesh("a.obj",
              "v 0 0 0\r\nv 1 0 0\r\nv 0 1.5 0\r\nf -3 -1 -2\r\nf 1 2 4\r\nv 0 0 -2\r\nf -3 -2 -1\r\nf 3 \\\r\n 1 4",
              four_triangles);
  expect_cloud("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1.5 0\nv 0 0 -2\np 1\n");
  const auto contents = folder_.read("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2\nf 1 2 3 4\nf 1 2\nhello\n");
  EXPECT_THAT(contents.inputs.get(mesh_input)->triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(contents.warnings,
              ElementsAre("2 lines are not read, as neither vertices nor faces; the first is line 5, 'l'",
                          "1 face of fewer than three corners is not read"));
}

TEST_F(Meshes, ObjErrors) {
  expect_error("a.obj", "hello world\n", 1, "lines 'v x y z' with vertices", "none");
  expect_error("a.obj", "v 0 0\n", 1, "a finite number for z", "nothing");
  expect_error("a.obj", "v 0 0 inf\n", 1, "a finite number for z", "'inf'");
  expect_error("a.obj", "v 0 0 0\nf 1 1 0\n", 2, "a vertex number from 1, or backwards from -1 to -1", "'0'");
  expect_error("a.obj", "v 0 0 0\nf 1 -2 1\n", 2, "backwards from -1 to -1", "'-2'");
  expect_error("a.obj", "v 0 0 0\nf 1 1x 1\n", 2, "a vertex number from 1", "'1x'");
  expect_error("a.obj", "v 0 0 0\nf 1 1 99999999999\n", 2, "a vertex number from 1", "'99999999999'");
  expect_error("a.obj", "v 0 0 0\nf -2147483648 1 1\n", 2, "a vertex number from 1", "'-2147483648'");
  expect_error("a.obj", "v 0 0 0\nf 1 1 1\nf 1 7 2\nf 1 5 1\n", 3, "vertex numbers of at most 1", "7");
  expect_error("a.obj", "v 0 0 0\nf 1 1 \\\n", 2, "the rest of a face", "nothing");
}

/// The bytes of a binary STL file whose header begins with `start`, of these corners.
std::string binary_stl(std::string_view start, const std::vector<std::array<float, 9>>& facets) {
  std::string text(start);
  text.resize(80, ' ');
  const auto append = [&](auto number) {
    std::array<char, sizeof number> bytes;
    std::memcpy(bytes.data(), &number, sizeof number);
    text.append(bytes.data(), bytes.size());
  };
  append(static_cast<std::uint32_t>(facets.size()));
  for (const auto& facet : facets) {
    for (int i = 0; i < 3; ++i) append(0.0F);
    for (const float coordinate : facet) append(coordinate);
    append(std::uint16_t{0});
  }
  return text;
}

TEST_F(Meshes, StlVerticesAreWelded) {
  const Triangle_mesh_3 expected{{{0, 0, 0}, {1, 0, 0}, {0, 1.5, 0}, {1, 1.5, 0}}, {{0, 1, 2}, {2, 1, 3}}};
  for (const char* start : {"solid made by a program", "", "binary"})
    expect_mesh("a.stl", binary_stl(start, {{0, 0, 0, 1, -0.0F, 0, 0, 1.5F, 0}, {-0.0F, 1.5F, 0, 1, 0, 0, 1, 1.5F, 0}}),
                expected);
  expect_mesh(
      "a.stl",
      "solid two words\n facet normal 0 0 nan\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1.5 -0\n"
      "  endloop\n endfacet\nendsolid two words\n\nSOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 1.50 0\n"
      "VERTEX 1e0 0 0\nVERTEX 1 15e-1 0\nENDLOOP\nENDFACET\nENDSOLID\n",
      expected);
}

TEST_F(Meshes, StlWeldsManyVerticesAsAMapWould) {
  std::mt19937 random(4);
  std::uniform_int_distribution<int> coordinate(0, 20);
  std::vector<std::array<float, 9>> facets(5000);
  std::vector<Point_3> corners;
  for (auto& facet : facets) {
    for (float& number : facet) number = static_cast<float>(coordinate(random)) / 4;
    for (int i = 0; i < 9; i += 3) corners.push_back({facet[i], facet[i + 1], facet[i + 2]});
  }
  const auto mesh = folder_.read("a.stl", binary_stl("", facets)).inputs.get(mesh_input);
  std::vector<Point_3> different;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_EQ(mesh->vertices.at(static_cast<std::size_t>(mesh->triangles.at(i / 3)[i % 3])), corners[i]);
    if (std::ranges::find(different, corners[i]) == different.end()) different.push_back(corners[i]);
  }
  EXPECT_EQ(mesh->vertices, different);
}

TEST_F(Meshes, StlErrors) {
  const std::string binary = binary_stl("", {{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 1, 0, 1, 0, 0, 1, 1, 0}});
  expect_error("a.stl", binary.substr(0, binary.size() - 1), 0, "2 triangles in 184 bytes", "183 bytes");
  expect_error("a.stl", std::string("\0\0", 2), 0, "a header of 84 bytes", "2 bytes");
  const File_contents longer = folder_.read("a.stl", binary + "xy");
  EXPECT_EQ(longer.inputs.get(mesh_input)->triangles.size(), 2u);
  EXPECT_THAT(longer.warnings, ElementsAre("what follows the last triangle of the header's 2 is not read"));
  expect_error("a.stl", binary_stl("", {{0, 0, 0, 1, 0, 0, 0, NAN, 0}}), 0, "finite coordinates",
               "'nan' in triangle 1");
  expect_error("a.stl", "hello\n", 1, "'solid' or a binary STL file", "'hello'");
  expect_error("a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\n", 4, "'endloop'", "the end of the file");
  expect_error("a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nendloop\nendfacet\n", 6, "'endsolid'", "the end");
  expect_error("a.stl", "solid\nfacet\nouter loop\nvertex 0 0 0\nendfacet\n", 5, "'vertex x y z' or 'endloop'",
               "'endfacet'");
  expect_error("a.stl", "solid\nvertex 0 0 0\n", 2, "'facet', 'outer loop', 'endfacet' or 'endsolid'",
               "'vertex 0 0 0'");
  expect_error("a.stl", "solid\nouter loop\nvertex 0 inf 0\n", 3, "a finite number for y", "'inf'");
}

TEST_F(Meshes, AMillionTrianglesOfOffAreReadQuickly) {
  constexpr int side = 700;
  std::string text = "OFF\n" + std::to_string(side * side) + " " + std::to_string(2 * (side - 1) * (side - 1)) + " 0\n";
  for (int i = 0; i < side * side; ++i)
    text += std::to_string(std::sin(i)) + " " + std::to_string(i % side) + " " + std::to_string(i / side) + "\n";
  for (int i = 0; i + 1 < side; ++i) {
    for (int j = 0; j + 1 < side; ++j) {
      const int v = i * side + j;
      for (const auto& [b, c] : {std::pair(v + 1, v + side), std::pair(v + side, v + side + 1)})
        text += "3 " + std::to_string(v) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    }
  }
  const auto file = folder_.write("a.off", text);
  const auto begin = std::clock();
  const auto mesh = read_file(spatial_formats(), file).inputs.get(mesh_input);
  EXPECT_LT(std::clock() - begin, 10 * CLOCKS_PER_SEC) << "an optimized build takes about 0.15 s";
  EXPECT_EQ(mesh->triangles.size(), 2u * (side - 1) * (side - 1));
}

}  // namespace
}  // namespace mesecina

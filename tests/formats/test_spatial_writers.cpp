// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <stdexcept>

#include "core/formats/writers.h"
#include "tests/formats/layer_sets.h"
#include "tests/formats/temporary_folder.h"

namespace mesecina {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A medial axis in space: triangle 1 2 3, quadrangle 0 1 3 4 and the segment 4 5, with a radius per vertex.
Primitive_set medial_axis() {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0.5, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0.25}};
  set.radii = {0.5, 1, 0.25, 1, 0.5, 2};
  set.segments = {{4, 5}};
  set.triangles = {{1, 2, 3}};
  set.polygon_offsets = {0, 4};
  set.polygon_vertices = {0, 1, 3, 4};
  set.values = {{"angle", "degrees", {10, 20, 30}}};
  return set;
}

Primitive_set two_balls() {
  Primitive_set set;
  set.dimension = 3;
  set.vertices = {{9, 9, 9}, {1, 2, 3}, {4, 5, 6}};
  set.balls = {{2, 0.5}, {1, 1.5}};
  return set;
}

File_contents read_back(std::string_view format, const Primitive_set& set) {
  const Temporary_folder folder(spatial_formats());
  return folder.read("a." + std::string(format), written(format, set));
}

TEST(Spatial_json, HasPolygonsAndRadii) {
  const auto document = nlohmann::json::parse(written("json", medial_axis()));
  EXPECT_EQ(document["dimension"], 3);
  EXPECT_EQ(document["radii"], nlohmann::json::parse("[0.5,1,0.25,1,0.5,2]"));
  EXPECT_EQ(document["polygons"], nlohmann::json::parse("[[0,1,3,4]]"));
  EXPECT_EQ(document["triangles"], nlohmann::json::parse("[[1,2,3]]"));
  EXPECT_EQ(document["values"]["angle"], nlohmann::json::parse("[10,20,30]"));
  EXPECT_FALSE(nlohmann::json::parse(written("json", one_of_each())).contains("radii"));
}

TEST(Spatial_csv, HasThreeCoordinates) {
  EXPECT_EQ(written("csv", medial_axis()),
            "element,kind,id,x0,y0,z0,x1,y1,z1,x2,y2,z2,radius,ring,angle\n"
            "0,segment,0,0,1,0,-1,1,0.25,,,,,,10\n"
            "1,triangle,1,1,0,0,2,0.5,0,1,1,0,,,20\n"
            "2,polygon,2,,,,,,,,,,,0 0 0;1 0 0;1 1 0;0 1 0,30\n");
}

TEST(Spatial_off, HasTrianglesPolygonsAndSegments) {
  EXPECT_EQ(
      written("off", medial_axis()),
      "OFF\n# layer some-layer\n# 1 segments as faces of two vertices\n# radii are left out\n6 3 0\n0 0 0\n1 0 0\n"
      "2 0.5 0\n1 1 0\n0 1 0\n-1 1 0.25\n2 4 5\n3 1 2 3\n4 0 1 3 4\n");
  const File_contents contents = read_back("off", medial_axis());
  EXPECT_EQ(contents.inputs.get(mesh_input)->vertices, medial_axis().vertices);
  EXPECT_EQ(contents.inputs.get(mesh_input)->triangles.size(), 3u);
  EXPECT_EQ(read_back("off", two_balls()).inputs.get(cloud_input)->size(), 3u);
}

/// A square, an edge at it and a lone point, with all that bounds them.
Primitive_set listed_complex() {
  Primitive_set set;
  set.dimension = 3;
  set.is_complex = true;
  set.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 2, 0}, {3, 3, 3}};
  set.points = {0, 1, 2, 3, 4, 5};
  set.segments = {{0, 1}, {2, 1}, {2, 3}, {0, 3}, {2, 4}};
  set.polygon_offsets = {0, 4};
  set.polygon_vertices = {0, 1, 2, 3};
  return set;
}

TEST(Spatial_off, HasNoSidesOfFaces) {
  EXPECT_THAT(written("off", listed_complex()), HasSubstr("\n# 1 segments as faces of two vertices\n6 2 0\n"));
  EXPECT_THAT(written("off", listed_complex()), HasSubstr("\n2 2 4\n4 0 1 2 3\n"));
  Primitive_set no_complex = listed_complex();
  no_complex.is_complex = false;
  EXPECT_THAT(written("off", no_complex), HasSubstr("\n6 6 0\n"));
}

TEST(Spatial_obj, HasNoSidesOfFacesAndNoEndsOfLines) {
  EXPECT_THAT(written("obj", listed_complex()), HasSubstr("\nv 3 3 3\np 6\nl 3 5\nf 1 2 3 4\n"));
}

TEST(Spatial_obj, PolygonsAreFaces) {
  EXPECT_THAT(written("obj", medial_axis()), HasSubstr("\nl 5 6\nf 2 3 4\nf 1 2 4 5\n"));
  EXPECT_THAT(written("obj", medial_axis()), Not(HasSubstr("even-odd")));
  EXPECT_EQ(*read_back("obj", medial_axis()).inputs.get(mesh_input),
            *read_back("off", medial_axis()).inputs.get(mesh_input));
}

TEST(Spatial_ma, HasRadiiEdgesAndTriangles) {
  EXPECT_EQ(written("ma", medial_axis()),
            "6 8 3\nv 0 0 0 0.5\nv 1 0 0 1\nv 2 0.5 0 0.25\nv 1 1 0 1\nv 0 1 0 0.5\nv -1 1 0.25 2\n"
            "e 0 1\ne 0 3\ne 0 4\ne 1 2\ne 1 3\ne 2 3\ne 3 4\ne 4 5\nf 1 2 3\nf 0 1 3\nf 0 3 4\n# layer some-layer\n");
  const File_contents contents = read_back("ma", medial_axis());
  const auto balls = contents.inputs.get(balls_input);
  ASSERT_EQ(balls->size(), 6u);
  EXPECT_EQ(balls->at(5), (Ball_3{{-1, 1, 0.25}, 2}));
}

TEST(Spatial_ma, OfBallsAlone) {
  EXPECT_EQ(written("ma", two_balls()), "2 0 0\nv 4 5 6 0.5\nv 1 2 3 1.5\n# layer some-layer\n");
  // With cells between them every vertex needs a radius.
  Primitive_set set = two_balls();
  set.segments = {{1, 0}, {0, 1}};
  set.balls.push_back({1, 1.25});
  set.rays = {{0, {1, 0, 0}}};
  EXPECT_EQ(written("ma", set),
            "3 1 0\nv 9 9 9 0\nv 1 2 3 1.5\nv 4 5 6 0.5\ne 0 1\n# layer some-layer\n# 1 elements are left out\n");
}

TEST(Spatial_balls, AreWrittenAsWoffAndMoff) {
  EXPECT_EQ(written("woff", two_balls()), "WOFF 2 0 0\n4 5 6 0.5\n1 2 3 1.5\n# layer some-layer\n");
  EXPECT_EQ(written("moff", two_balls()), "MOFF 2 0 1\n4 5 6 0.5\n1 2 3 1.5\n# layer some-layer\n");
  for (const char* format : {"woff", "moff", "ma"}) {
    EXPECT_THAT(*read_back(format, two_balls()).inputs.get(balls_input),
                ElementsAre(Ball_3{{4, 5, 6}, 0.5}, Ball_3{{1, 2, 3}, 1.5}));
    EXPECT_EQ(read_back(format, medial_axis()).inputs.get(balls_input)->size(), 6u);
  }
  EXPECT_THAT(written("woff", medial_axis()),
              HasSubstr("\n-1 1 0.25 2\n# layer some-layer\n# 3 elements are left out\n"));
}

TEST(Spatial_balls, LayersWithoutAnySayIt) {
  Primitive_set surface = medial_axis();
  surface.radii.clear();
  for (const char* format : {"ma", "woff", "moff"}) {
    EXPECT_THAT(written(format, surface), HasSubstr("0 0")) << format;
    EXPECT_THAT(written(format, surface), HasSubstr("\n# layer some-layer\n# empty: the layer has no balls")) << format;
    EXPECT_TRUE(read_back(format, surface).inputs.get(balls_input)->empty());
    Layer_document document;
    document.layer = "scale-axis";
    document.input = "a.off";
    document.reason = "the mesh\nis open";
    EXPECT_THAT(written(format, document),
                HasSubstr("\n# layer scale-axis\n# input a.off\n# empty: the mesh is open\n"));
  }
}

TEST(Spatial_layers, SayWhyTheyAreEmpty) {
  for (const Layer_writer& writer : spatial_formats().layer_writers) {
    Layer_document document;
    document.layer = "scale-axis";
    document.reason = "the mesh is open";
    document.dimension = 3;
    std::ostringstream stream;
    ASSERT_NO_THROW(writer.write(stream, document)) << writer.name;
    EXPECT_FALSE(writer.help.empty());
    if (writer.name != "csv") {
      EXPECT_THAT(stream.str(), HasSubstr("the mesh is open"));
    }
  }
}

TEST(Spatial_ply, ReadsBackAsItsOwnMesh) {
  const File_contents contents = read_back("ply", medial_axis());
  EXPECT_EQ(*contents.inputs.get(mesh_input), *read_back("off", medial_axis()).inputs.get(mesh_input));
  EXPECT_THAT(contents.warnings,
              ElementsAre("1 row of 'edge' are not read", "radii of vertices are not read, as there are faces"));
  EXPECT_THAT(*read_back("ply", two_balls()).inputs.get(balls_input),
              ElementsAre(Ball_3{{4, 5, 6}, 0.5}, Ball_3{{1, 2, 3}, 1.5}));
}

TEST(Spatial_ply, FacesOfManyCornersAreRead) {
  Primitive_set set;
  set.dimension = 3;
  for (int i = 0; i < 300; ++i) set.vertices.push_back({std::cos(i / 50.), std::sin(i / 50.), 1});
  for (int i = 0; i < 300; ++i) set.polygon_vertices.push_back(i);
  set.polygon_offsets = {0, 300};
  EXPECT_THAT(written("ply", set), HasSubstr("property list int int vertex_indices\n"));
  EXPECT_EQ(read_back("ply", set).inputs.get(mesh_input)->triangles.size(), 298u);
  EXPECT_THAT(written("ply", medial_axis()), HasSubstr("property list uchar int vertex_indices\n"));
}

TEST(Spatial_input_writers, ComeBackExactly) {
  std::vector<double> numbers = {0, -0.0, 0.1, 1. / 3, 1e300, -1e300, 5e-324, 123456789.123456789, 1e-10, 1e22};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1000, 1000);
  while (numbers.size() < 999) numbers.push_back(uniform(random));
  std::vector<Point_3> cloud;
  std::vector<Ball_3> balls;
  Triangle_mesh_3 mesh;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    cloud.push_back({numbers[i], numbers[(7 * i) % numbers.size()], numbers[(11 * i) % numbers.size()]});
    balls.push_back({cloud.back(), std::abs(numbers[(13 * i) % numbers.size()])});
    const auto vertex = static_cast<int>(i);
    mesh.triangles.push_back({vertex, (vertex * 5) % 999, (vertex * 8) % 999});
  }
  mesh.vertices = cloud;
  const Inputs inputs = Inputs().with(cloud_input, cloud).with(balls_input, balls).with(mesh_input, mesh);
  const Temporary_folder folder(spatial_formats());
  for (const Input_writer& writer : spatial_formats().input_writers) {
    // It holds less, see below.
    if (writer.name == "stl") continue;
    std::ostringstream stream;
    writer.write(stream, inputs);
    const File_contents contents = folder.read("a." + writer.extension, stream.str());
    ASSERT_EQ(contents.inputs.ids(), std::vector<std::string>{writer.input_id}) << writer.name;
    if (writer.input_id == "cloud") {
      EXPECT_EQ(*contents.inputs.get(cloud_input), cloud);
    }
    if (writer.input_id == "balls") {
      EXPECT_EQ(*contents.inputs.get(balls_input), balls) << writer.name;
    }
    if (writer.input_id == "mesh") {
      EXPECT_EQ(*contents.inputs.get(mesh_input), mesh);
    }
    EXPECT_THAT(contents.warnings, IsEmpty());
  }
}

TEST(Spatial_input_writers, OfNothingComeBackEmpty) {
  const Temporary_folder folder(spatial_formats());
  for (const Input_writer& writer : spatial_formats().input_writers) {
    // The file of an OBJ without vertices is like any file that is no OBJ.
    if (writer.extension == "obj") continue;
    // An STL without triangles has neither points.
    if (writer.extension == "stl") continue;
    std::ostringstream stream;
    writer.write(stream, Inputs());
    const File_contents contents = folder.read("a." + writer.extension, stream.str());
    const std::string id = writer.input_id == "mesh" ? "cloud" : writer.input_id;
    EXPECT_EQ(contents.inputs.ids(), std::vector<std::string>{id}) << writer.name;
    EXPECT_EQ(bounding_box(contents.inputs).diagonal(), 0);
  }
}

/// The corners of each triangle, in single precision.
std::vector<std::array<Point_3, 3>> corners_of(const Triangle_mesh_3& mesh) {
  const auto rounded = [](const Point_3& p) {
    return Point_3{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  };
  std::vector<std::array<Point_3, 3>> corners;
  for (const auto& [a, b, c] : mesh.triangles)
    corners.push_back({rounded(mesh.vertices[a]), rounded(mesh.vertices[b]), rounded(mesh.vertices[c])});
  return corners;
}

TEST(Spatial_stl, MeshesComeBackInSinglePrecision) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1000, 1000);
  Triangle_mesh_3 mesh;
  for (int i = 0; i < 300; ++i) {
    mesh.vertices.push_back({uniform(random), uniform(random) * 1e-12, uniform(random) * 1e30});
    mesh.triangles.push_back({i, (i * 7 + 1) % 300, (i * 11 + 2) % 300});
  }
  std::ostringstream stream;
  write_stl_mesh(stream, Inputs().with(mesh_input, mesh));
  EXPECT_EQ(stream.str().size(), 84u + 50u * 300u);
  const Temporary_folder folder(spatial_formats());
  const File_contents contents = folder.read("a.stl", stream.str());
  EXPECT_THAT(contents.warnings, IsEmpty());
  const auto back = contents.inputs.get(mesh_input);
  ASSERT_NE(back, nullptr);
  EXPECT_EQ(corners_of(*back), corners_of(mesh));
  EXPECT_EQ(back->vertices.size(), 300u) << "corners in one place are one vertex";
  // The second time nothing is lost any more.
  std::ostringstream again;
  write_stl_mesh(again, contents.inputs);
  EXPECT_EQ(again.str(), stream.str());
}

TEST(Spatial_writers, EmptyFilesAreToldWithWhatThereIs) {
  const Formats formats = spatial_formats();
  const Layer_writer& stl = *formats.find_layer_writer("stl");
  const Layer_writer& woff = *formats.find_layer_writer("woff");
  EXPECT_EQ(empty_file_text(stl, nullptr), "");
  Primitive_set set;
  EXPECT_EQ(empty_file_text(stl, &set), "");
  set.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  set.points = {0};
  EXPECT_EQ(empty_file_text(stl, &set), "stl holds triangles, and there is 1 point: the file is empty");
  set.segments = {{0, 1}, {1, 2}};
  EXPECT_EQ(empty_file_text(stl, &set), "stl holds triangles, and there is 1 point and 2 segments: the file is empty");
  EXPECT_EQ(empty_file_text(woff, &set), "woff holds balls, and there is 1 point and 2 segments: the file is empty");
  EXPECT_EQ(empty_file_text(*formats.find_layer_writer("ply"), &set), "");
  set.triangles = {{0, 1, 2}};
  EXPECT_EQ(empty_file_text(stl, &set), "");
}

TEST(Spatial_stl, LayersHaveTheirFacesAlone) {
  const std::string text = written("stl", medial_axis());
  EXPECT_THAT(text, StartsWith("mesecina some-layer, 1 elements left out"));
  const auto mesh = read_back("stl", medial_axis()).inputs.get(mesh_input);
  ASSERT_NE(mesh, nullptr);
  const std::vector<std::array<Point_3, 3>> expected{
      {{{1, 0, 0}, {2, 0.5, 0}, {1, 1, 0}}}, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}, {{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}};
  EXPECT_EQ(corners_of(*mesh), expected);
  // The normal of the first one comes before its corners.
  float z = 0;
  std::memcpy(&z, text.data() + 84 + 8, sizeof z);
  EXPECT_EQ(z, 1);
  EXPECT_EQ(written("stl", two_balls()).size(), 84u);
}

TEST(Spatial_stl, RefusesWhatSinglePrecisionDoesNotHold) {
  Triangle_mesh_3 mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1e39, 0}};
  mesh.triangles = {{0, 1, 2}};
  std::ostringstream stream;
  EXPECT_THROW(write_stl_mesh(stream, Inputs().with(mesh_input, mesh)), std::invalid_argument);
}

TEST(Spatial_formats, EmptyFilesAreRefusedByEveryReader) {
  const Temporary_folder folder(spatial_formats());
  for (const Reader& reader : spatial_formats().readers)
    for (const std::string& extension : reader.extensions)
      EXPECT_EQ(folder.error("a." + extension, ""),
                "a." + extension + ": expected data, found an empty file; write it again");
}

}  // namespace
}  // namespace mesecina

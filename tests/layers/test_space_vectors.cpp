// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/space_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>

#include "example_scene.h"
#include "layers/picture_formats.h"
#include "layers/projection_3.h"
#include "layers/space_pictures.h"
#include "layers/space_shapes.h"

namespace mesecina::test {
namespace {

constexpr int side = 200;

View_3 view_of(Camera_3::Projection projection) {
  View_3 view;
  view.camera.position = {1.5, 2, 6};
  view.camera.projection = projection;
  view.camera.height = 5;
  return view;
}

/// Triangles that cross each other, each a layer of its own with a colour that tells its number.
Scene crossing_triangles(int count, unsigned seed) {
  Scene scene;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  for (int i = 0; i < count; ++i) {
    Primitive_set set;
    set.dimension = 3;
    for (int k = 0; k < 3; ++k) set.vertices.push_back({coordinate(random), coordinate(random), coordinate(random)});
    set.triangles = {{0, 1, 2}};
    scene.layers.push_back(layer_of(std::move(set)));
    scene.layers.back().style.filled = true;
  }
  return scene;
}

/// The distance at which a line of sight meets the triangle; none, or too near to its edge to tell, for nullopt.
std::optional<double> hit(const Primitive_set& set, const Point_3& from, const Point_3& along, bool& is_near_edge) {
  const Point_3 a = set.vertices[0];
  const Point_3 ab = set.vertices[1] - a;
  const Point_3 ac = set.vertices[2] - a;
  const Point_3 normal = cross(ab, ac);
  const double determinant = -dot(along, normal);
  const Point_3 offset = from - a;
  const Point_3 turned = cross(offset, along);
  const double u = dot(ac, turned) / determinant;
  const double v = -dot(ab, turned) / determinant;
  const double inside = std::min({u, v, 1 - u - v});
  constexpr double margin = 0.02;
  if (std::abs(inside) < margin) is_near_edge = true;
  if (inside < 0) return std::nullopt;
  return dot(offset, normal) / determinant;
}

bool contains(const Space_shape& shape, const Point_2& p) {
  bool is_inside = false;
  for (std::size_t i = 0, j = shape.points.size() - 1; i < shape.points.size(); j = i++) {
    const Point_2& a = shape.points[i];
    const Point_2& b = shape.points[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) is_inside = !is_inside;
  }
  return is_inside;
}

class Space_vectors : public testing::TestWithParam<Camera_3::Projection> {};

TEST_P(Space_vectors, WhatIsPaintedLastIsWhatIsNearest) {
  const View_3 view = view_of(GetParam());
  int tested = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Scene scene = crossing_triangles(12, seed);
    const std::vector<Space_shape> shapes = space_shapes(scene, view, side, side);
    EXPECT_GT(shapes.size(), scene.layers.size()) << "those that cross are split";
    Box box;
    for (const Scene_layer& layer : scene.layers) box.add(layer.primitives->bounding_box());
    const Projection_3 projection(view.camera, box, {side, side});
    for (int row = 3; row < side; row += 4) {
      for (int column = 3; column < side; column += 4) {
        const Point_3 from = projection.place_at(column, row, 0);
        const Point_3 along = projection.place_at(column, row, 1) - from;
        std::optional<std::size_t> nearest;
        double least = 1e300;
        double second = 1e300;
        bool is_near_edge = false;
        for (std::size_t i = 0; i < scene.layers.size(); ++i) {
          const auto way = hit(*scene.layers[i].primitives, from, along, is_near_edge);
          if (!way) continue;
          second = std::min(second, std::max(*way, least));
          if (*way < least) nearest = i;
          least = std::min(least, *way);
        }
        if (is_near_edge || second - least < 0.005) continue;
        ++tested;
        std::optional<std::size_t> painted;
        for (const Space_shape& shape : shapes)
          if (contains(shape, {column + 0.5, row + 0.5})) painted = shape.layer;
        ASSERT_EQ(painted, nearest) << "seed " << seed << ", row " << row << ", column " << column;
      }
    }
  }
  EXPECT_GT(tested, 2000);
}

INSTANTIATE_TEST_SUITE_P(Projections, Space_vectors,
                         testing::Values(Camera_3::Projection::perspective, Camera_3::Projection::orthographic));

Scene balls_behind_a_square() {
  Primitive_set square;
  square.dimension = 3;
  square.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  Primitive_set balls;
  balls.dimension = 3;
  balls.vertices = {{0, 0, 1.5}, {0.1, 0, -1.5}};
  balls.balls = {{0, 0.5}, {1, 0.5}};
  Scene scene;
  scene.layers = {layer_of(std::move(square)), layer_of(std::move(balls))};
  scene.layers[0].id = "mesh";
  scene.layers[0].label = "Mesh <1>";
  scene.layers[1].id = "balls";
  scene.layers[1].label = "Balls";
  for (Scene_layer& layer : scene.layers) layer.style.filled = true;
  return scene;
}

TEST(Space_svg, GroupsBearTheNamesOfTheirLayersInTheOrderOfSpace) {
  std::ostringstream out;
  write_space_svg(out, balls_behind_a_square(), view_of(Camera_3::Projection::orthographic), side, side);
  const std::string text = out.str();
  const std::size_t far_ball = text.find("id=\"layer-balls\"");
  const std::size_t mesh = text.find("id=\"layer-mesh\"");
  const std::size_t near_ball = text.find("id=\"layer-balls-2\"");
  ASSERT_NE(near_ball, std::string::npos) << text;
  EXPECT_LT(far_ball, mesh);
  EXPECT_LT(mesh, near_ball);
  EXPECT_NE(text.find("inkscape:label=\"Mesh &lt;1&gt;\""), std::string::npos);
  // Both have one colour, so one shading.
  EXPECT_EQ(text.find("<radialGradient"), text.rfind("<radialGradient"));
  EXPECT_NE(text.find("<circle cx=\""), std::string::npos);
}

TEST(Space_svg, CirclesHaveTheSizeOfTheirBalls) {
  const std::vector<Space_shape> shapes =
      space_shapes(balls_behind_a_square(), view_of(Camera_3::Projection::orthographic), side, side);
  int balls = 0;
  for (const Space_shape& shape : shapes) {
    if (shape.kind != Space_shape::Kind::ball) continue;
    ++balls;
    EXPECT_NEAR(shape.radius, 0.5 * side / 5, 1e-9);
  }
  EXPECT_EQ(balls, 2);
}

TEST(Space_svg, APlaneTakesAwayWhatIsBehindIt) {
  View_3 view = view_of(Camera_3::Projection::orthographic);
  view.cutting_plane = Cutting_plane_3{{0.5, 0, 0}, {1, 0, 0}, {}};
  Scene scene = balls_behind_a_square();
  const auto rightmost = [&] {
    double greatest = 0;
    for (const Space_shape& shape : space_shapes(scene, view, side, side))
      if (shape.kind == Space_shape::Kind::area)
        for (const Point_2& p : shape.points) greatest = std::max(greatest, p.x);
    return greatest;
  };
  const double cut = rightmost();
  scene.layers[0].style.sliced = false;
  EXPECT_GT(rightmost(), cut + 10);
}

TEST(Space_svg, TooManyElementsAreRefusedWithTheirNumber) {
  Primitive_set set;
  set.dimension = 3;
  const int count = static_cast<int>(most_space_shapes) + 1;
  for (int i = 0; i < count; ++i) {
    set.vertices.push_back({0.01 * i, 0, 0});
    set.balls.push_back({i, 0.01});
  }
  Formats formats;
  add_space_picture_formats(formats);
  const auto file = std::filesystem::temp_directory_path() / "mesecina_many_balls.svg";
  try {
    formats.find_picture_writer("svg")->write_3(file, scene_of(layer_of(std::move(set))), {}, side, side);
    FAIL() << "not refused";
  } catch (const File_error& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(std::to_string(count)), std::string::npos) << text;
    EXPECT_NE(text.find("choose png"), std::string::npos) << text;
  }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(Space_pdf, OnePageWithoutADate) {
  const Picture_application application;
  const Scene scene = balls_behind_a_square();
  const View_3 view = view_of(Camera_3::Projection::perspective);
  const std::string bytes = space_pdf_bytes(scene, view, side, side);
  EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
  EXPECT_EQ(bytes.find("/CreationDate"), std::string::npos);
  EXPECT_EQ(space_pdf_bytes(scene, view, side, side), bytes);
}

}  // namespace
}  // namespace mesecina::test

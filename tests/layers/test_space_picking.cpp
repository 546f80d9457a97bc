// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <tuple>

#include "example_scene.h"
#include "space_fixture.h"

namespace mesecina::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Ray_hit {
  std::size_t layer = 0;
  std::size_t element = 0;
  double way = infinity;
  double second_way = infinity;  ///< of the next thing behind, to know where the order is too near to call
};

/// Rays through pixels, written from the definition of a camera.
class Ray_caster {
 public:
  Ray_caster(const Scene& scene, const Camera_3& camera, int width, int height)
      : scene_(scene), camera_(camera), axes_(camera.axes()), width_(width), height_(height) {}

  Ray_hit cast(double column, double row) const {
    const double unit = camera_.height_at_target() / height_;
    const Point_3 across = ((column - width_ / 2.0) * unit) * axes_.right + ((height_ / 2.0 - row) * unit) * axes_.up;
    const bool is_perspective = camera_.projection == Camera_3::Projection::perspective;
    const Point_3 from = is_perspective ? camera_.position : camera_.position + across;
    Point_3 along = is_perspective ? camera_.target + across - camera_.position : -1.0 * axes_.back;
    along = (1 / std::sqrt(dot(along, along))) * along;
    Ray_hit hit;
    for (std::size_t layer = 0; layer < scene_.layers.size(); ++layer) {
      const Primitive_set& set = *scene_.layers[layer].primitives;
      for (std::size_t i = 0; i < set.triangles.size(); ++i) add(hit, layer, i, triangle(set, i, from, along));
      for (std::size_t i = 0; i < set.balls.size(); ++i)
        add(hit, layer, set.triangles.size() + i, ball(set, i, from, along));
    }
    return hit;
  }

 private:
  static void add(Ray_hit& hit, std::size_t layer, std::size_t element, double way) {
    if (way < hit.way) {
      hit = {layer, element, way, hit.way};
    } else {
      hit.second_way = std::min(hit.second_way, way);
    }
  }
  static double triangle(const Primitive_set& set, std::size_t i, const Point_3& from, const Point_3& along) {
    const Point_3& a = set.vertices[set.triangles[i][0]];
    const Point_3 ab = set.vertices[set.triangles[i][1]] - a;
    const Point_3 ac = set.vertices[set.triangles[i][2]] - a;
    const Point_3 p = cross(along, ac);
    const double determinant = dot(ab, p);
    const Point_3 s = from - a;
    const double u = dot(s, p) / determinant;
    const Point_3 q = cross(s, ab);
    const double v = dot(along, q) / determinant;
    const double way = dot(ac, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && way > 0 ? way : infinity;
  }
  static double ball(const Primitive_set& set, std::size_t i, const Point_3& from, const Point_3& along) {
    const Point_3 to_center = set.vertices[set.balls[i].center] - from;
    const double middle = dot(to_center, along);
    const double square = set.balls[i].radius * set.balls[i].radius - dot(to_center, to_center) + middle * middle;
    const double way = middle - std::sqrt(std::max(0.0, square));
    return square >= 0 && way > 0 ? way : infinity;
  }

  const Scene& scene_;
  Camera_3 camera_;
  Camera_3::Axes axes_;
  int width_;
  int height_;
};

Scene random_scene(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-1, 1);
  std::uniform_real_distribution<double> radius(0.05, 0.4);
  Scene scene;
  for (int layer = 0; layer < 2; ++layer) {
    Primitive_set set;
    set.dimension = 3;
    const auto vertex = [&] {
      set.vertices.push_back({place(random), place(random), place(random)});
      return static_cast<int>(set.vertices.size()) - 1;
    };
    for (int i = 0; i < 15; ++i) {
      const int a = vertex();
      const int b = vertex();
      set.triangles.push_back({a, b, vertex()});
    }
    for (int i = 0; i < 15; ++i) set.balls.push_back({vertex(), radius(random)});
    scene.layers.push_back(layer_of(std::move(set)));
    scene.layers.back().style.filled = true;
  }
  scene.layers[1].style.opacity = 0.6;
  return scene;
}

class Space_picking : public Space_renderer, public testing::WithParamInterface<Camera_3::Projection> {};

TEST_P(Space_picking, IdsArePerPixelThoseOfCastRays) {
  constexpr int width = 211;
  constexpr int height = 160;
  int compared = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const Scene scene = random_scene(seed);
    View_3 view;
    view.camera = fit_camera(drawn_box(scene), width, height, {0.3, 0.5, 1}, {0.1, 1, 0}, GetParam());
    const Id_picture ids = renderer().ids(scene, view, plain_frame(width, height));
    const Ray_caster caster(scene, view.camera, width, height);
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const Ray_hit expected = caster.cast(column + 0.5, row + 0.5);
        bool is_clear = !(expected.second_way - expected.way < 1e-4);
        for (const auto& [x, y] : {std::pair{0.48, 0.48}, {0.52, 0.48}, {0.48, 0.52}, {0.52, 0.52}}) {
          const Ray_hit beside = caster.cast(column + x, row + y);
          if (beside.layer != expected.layer || beside.element != expected.element ||
              std::isinf(beside.way) != std::isinf(expected.way))
            is_clear = false;
        }
        if (!is_clear) continue;
        ++compared;
        const auto found = ids.find(column, row);
        ASSERT_EQ(found.has_value(), std::isfinite(expected.way)) << seed << ": " << column << ", " << row;
        if (!found) continue;
        ASSERT_EQ(found->layer, expected.layer) << seed << ": " << column << ", " << row;
        ASSERT_EQ(found->element, expected.element) << seed << ": " << column << ", " << row;
        const Camera_3::Axes axes = view.camera.axes();
        const double depth = -dot(found->place - view.camera.position, axes.back);
        EXPECT_GT(depth, 0);
        const double way =
            GetParam() == Camera_3::Projection::perspective ? distance(found->place, view.camera.position) : depth;
        ASSERT_NEAR(way, expected.way, 2e-3) << seed << ": " << column << ", " << row;
      }
    }
  }
  EXPECT_GT(compared, 3 * width * height * 9 / 10);
}

TEST_P(Space_picking, ABallIsSeenWhereItIsBeforeAPlane) {
  // The plane cuts the ball of radius 1 at z = 0.6, in a circle of radius 0.8.
  Scene scene;
  scene.layers.push_back(layer_of(square_at(0.6, 3)));
  Primitive_set ball;
  ball.dimension = 3;
  ball.vertices.push_back({});
  ball.balls.push_back({0, 1});
  scene.layers.push_back(layer_of(std::move(ball)));
  for (Scene_layer& layer : scene.layers) layer.style.filled = true;
  constexpr int side = 200;
  const View_3 view = view_along_z(GetParam(), 4);
  const Id_picture ids = renderer().ids(scene, view, plain_frame(side, side));
  const double away = GetParam() == Camera_3::Projection::perspective ? view.camera.position.z : infinity;
  // The circle is nearer than the plane z = 0 on which a pixel is 0.02 wide.
  const double pixels = 0.8 * 50 * (std::isinf(away) ? 1 : away / (away - 0.6));
  for (int column = 0; column < side; ++column) {
    const double off = std::abs(column + 0.5 - side / 2.0);
    if (std::abs(off - pixels) < 0.6) continue;
    const auto found = ids.find(column, side / 2);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->layer, off < pixels ? 1U : 0U) << column;
  }
}

TEST_P(Space_picking, FaintThingsDoNotHideWhatIsInThem) {
  // A small square behind a large one.
  Scene scene;
  scene.layers.push_back(layer_of(square_at(0.5, 1.5)));
  scene.layers.push_back(layer_of(square_at(-0.5, 0.5)));
  for (Scene_layer& layer : scene.layers) layer.style.filled = true;
  constexpr int side = 100;
  const View_3 view = view_along_z(GetParam(), 4);
  for (const auto& [front, back, is_behind] :
       {std::tuple{1.0, 1.0, false}, {0.6, 1.0, false}, {0.5, 1.0, true}, {0.2, 0.6, true}, {0.2, 0.3, false}}) {
    scene.layers[0].style.opacity = front;
    scene.layers[1].style.opacity = back;
    const Id_picture ids = renderer().ids(scene, view, plain_frame(side, side));
    const auto middle = ids.find(side / 2, side / 2);
    ASSERT_TRUE(middle);
    EXPECT_EQ(middle->layer, is_behind ? 1U : 0U) << front << ", " << back;
    EXPECT_NEAR(middle->place.z, is_behind ? -0.5 : 0.5, 1e-3) << front << ", " << back;
    const auto beside = ids.find(side / 2 + 30, side / 2);
    ASSERT_TRUE(beside);
    EXPECT_EQ(beside->layer, 0U) << front << ", " << back;
    EXPECT_NEAR(beside->place.z, 0.5, 1e-3) << front << ", " << back;
    EXPECT_FALSE(ids.find(1, 1));
  }
}

TEST_P(Space_picking, FindsWhatIsNearThePixel) {
  Primitive_set set;
  set.dimension = 3;
  set.vertices.push_back({0, 0, 0});
  set.points.push_back(0);
  Scene scene = scene_of(layer_of(std::move(set)));
  scene.layers[0].style.point_size = 3;
  constexpr int side = 101;
  const Id_picture ids = renderer().ids(scene, view_along_z(GetParam()), plain_frame(side, side));
  EXPECT_FALSE(ids.find(56, 50, 2));
  const auto found = ids.find(56, 50, 8);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->element, 0U);
  EXPECT_NEAR(found->distance, 5, 0.01);
  EXPECT_FALSE(ids.find(-1, 50));
  EXPECT_FALSE(ids.find(50, side));
}

INSTANTIATE_TEST_SUITE_P(Projections, Space_picking,
                         testing::Values(Camera_3::Projection::perspective, Camera_3::Projection::orthographic),
                         [](const auto& tested) {
                           return std::string(tested.param == Camera_3::Projection::perspective ? "perspective"
                                                                                                : "orthographic");
                         });

}  // namespace
}  // namespace mesecina::test

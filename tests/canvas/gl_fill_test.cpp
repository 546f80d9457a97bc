// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "example_scenes.h"
#include "gl_picture_fixture.h"
#include "picture_comparison.h"

namespace mesecina {
namespace {

Scene filled_scene(std::shared_ptr<const Primitive_set> set, double opacity) {
  Scene scene;
  scene.layers.push_back(make_layer("filled", std::move(set), {20, 90, 160}, opacity));
  scene.layers[0].style.filled = true;
  return scene;
}

std::shared_ptr<Primitive_set> many_disks(int count, std::shared_ptr<Primitive_set>* boundary = nullptr) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> x(0, 100);
  std::uniform_real_distribution<double> y(0, 80);
  const double size = std::sqrt(8000.0 / count);
  std::uniform_real_distribution<double> radius(0.2 * size, 0.7 * size);
  auto set = std::make_shared<Primitive_set>();
  std::vector<Disk_2> disks;
  for (int i = 0; i < count; ++i) {
    disks.push_back({{x(random), y(random)}, radius(random)});
    set->balls.push_back({add_vertex(*set, disks.back().center.x, disks.back().center.y), disks.back().radius});
  }
  if (boundary) {
    *boundary = std::make_shared<Primitive_set>();
    add_union_boundary(**boundary, disks);
  }
  return set;
}

class Gl_fill : public Gl_picture {
 protected:
  QColor color_at(const QImage& picture, double x, double y, const View_2& view = whole) const {
    const Point_2 pixel = view.to_pixel({x, y}, width, height);
    return picture.pixelColor((QPointF(pixel.x, pixel.y) * canvas_.devicePixelRatioF()).toPoint());
  }
};

TEST_F(Gl_fill, AreasBoundedByArcs) {
  for (const double opacity : {1.0, 0.5}) {
    const Scene scene = filled_scene(closed_arcs(), opacity);
    compare(scene, whole, "arcs_" + std::to_string(static_cast<int>(10 * opacity)));
    const QImage picture = drawn(scene, whole);
    const QColor inside = opacity == 1 ? QColor(20, 90, 160) : QColor(137, 172, 207);
    const auto is_inside = [&](double x, double y) {
      const QColor found = color_at(picture, x, y);
      EXPECT_TRUE(found == QColor(Qt::white) || std::abs(found.red() - inside.red()) <= 1) << x << " " << y;
      return found != QColor(Qt::white);
    };
    EXPECT_TRUE(is_inside(36, 22));
    EXPECT_FALSE(is_inside(29, 22)) << "the hole";
    EXPECT_TRUE(is_inside(22, 22)) << "the disk in the hole";
    EXPECT_TRUE(is_inside(58, 15)) << "a disk within others has no boundary";
    EXPECT_TRUE(is_inside(82, 12));
    EXPECT_TRUE(is_inside(92.5, 38)) << "first of the nested circles";
    EXPECT_FALSE(is_inside(89.5, 38));
    EXPECT_TRUE(is_inside(86, 38));
    EXPECT_FALSE(is_inside(82, 38));
    EXPECT_TRUE(is_inside(20, 72));
    EXPECT_FALSE(is_inside(20, 64)) << "circle that touches from inside";
    EXPECT_TRUE(is_inside(20, 53)) << "circle that touches from outside";
    EXPECT_TRUE(is_inside(54, 61));
    EXPECT_TRUE(is_inside(46, 57));
    EXPECT_FALSE(is_inside(75, 66)) << "an open arc";
    EXPECT_FALSE(is_inside(88, 68)) << "three arcs between two vertices";
    EXPECT_FALSE(is_inside(99, 79));
  }
}

TEST_F(Gl_fill, AreasBoundedByArcsInCloseUp) {
  const Scene scene = filled_scene(closed_arcs(), 0.6);
  for (const double scale : {40.0, 300.0, 2e4, 3e6}) {
    const std::string name = "arcs_at_" + std::to_string(static_cast<int>(scale));
    compare(scene, {{58.3, 21.4}, scale}, name + "_crossing");
    compare(scene, {{20 + 3 / scale, 60}, scale}, name + "_touching");
    compare(scene, {{96, 20}, scale}, name + "_thin");
  }
}

TEST_F(Gl_fill, LargeArcsBoundTheirArea) {
  for (const double radius : {1e4, 1e7, 1e10}) {
    auto set = std::make_shared<Primitive_set>();
    const int left = add_vertex(*set, 20, 40);
    const int right = add_vertex(*set, 80, 40);
    const double depth = std::sqrt(radius * radius - 900);
    set->arcs.push_back({{50, 40 - depth}, radius, left, right, true});
    set->arcs.push_back({{50, 40}, 30, left, right, true});
    set->arcs.push_back({{50, 40}, 20, add_vertex(*set, 70, 40), 2, false});
    const std::string name = "large_arcs_" + std::to_string(static_cast<long long>(radius));
    compare(filled_scene(set, 0.5), whole, name);
    compare(filled_scene(set, 0.5), {{75, 40}, 50}, name + "_near");
  }
}

TEST_F(Gl_fill, OnlyWhatIsStillClosedIsFilled) {
  Scene scene = filled_scene(closed_arcs(), 1);
  Scene_layer& layer = scene.layers[0];
  layer.style.value = "number";
  layer.style.color_map = "solid";
  const auto& arcs = layer.primitives->arcs;
  for (std::size_t hidden = 0; hidden < arcs.size(); hidden += 3) {
    layer.style.threshold_minimum = static_cast<double>(hidden);
    compare(scene, whole, "arcs_from_" + std::to_string(hidden));
    layer.style.threshold_minimum.reset();
    layer.cut = Cut{"number", static_cast<double>(hidden) + 0.6};
    compare(scene, whole, "arcs_cut_" + std::to_string(hidden));
    layer.cut.reset();
  }
}

TEST_F(Gl_fill, ArcsByValueAreFilledInTheColorOfTheLayer) {
  Scene scene = filled_scene(closed_arcs(), 1);
  scene.layers[0].style.value = "number";
  compare(scene, whole, "arcs_by_value");
  EXPECT_EQ(color_at(drawn(scene, whole), 36, 22), QColor(20, 90, 160));
}

TEST_F(Gl_fill, DisksOfOneColorHaveOneTone) {
  Scene scene = filled_scene(many_disks(60), 0.5);
  compare(scene, whole, "disks_united");
  const QImage picture = drawn(scene, whole);
  int even = 0;
  int other = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const int red = picture.pixelColor(x, y).red();
      even += std::abs(red - 137) <= 1;
      other += red < 136;
    }
  }
  EXPECT_GT(even, picture.width() * picture.height() / 4);
  EXPECT_EQ(other, 0);
  // Each disk has a colour of its own by a value, and shows through the others.
  auto numbered = std::make_shared<Primitive_set>(*scene.layers[0].primitives);
  numbered->values.push_back({"number", "", {}});
  for (std::size_t i = 0; i < numbered->balls.size(); ++i) numbered->values[0].data.push_back(static_cast<double>(i));
  scene.layers[0].primitives = numbered;
  scene.layers[0].style.value = "number";
  compare(scene, whole, "disks_by_value");
  scene.layers[0].style.color_map = "solid";
  scene.layers[0].style.threshold_maximum = 30;
  compare(scene, whole, "disks_united_below_a_threshold");
}

TEST_F(Gl_fill, HugeAndSmallDisksHaveOneTone) {
  auto set = std::make_shared<Primitive_set>();
  set->balls.push_back({add_vertex(*set, 50, 40 - 1e9), 1e9});
  set->balls.push_back({add_vertex(*set, 50 - 1e6, 40), 1e6});
  set->balls.push_back({add_vertex(*set, 60, 45), 12});
  const Scene scene = filled_scene(set, 0.4);
  compare(scene, whole, "huge_disks_united");
  compare(scene, {{50, 40}, 400}, "huge_disks_united_near");
}

TEST_F(Gl_fill, LayersOfUnitedDisksStillShowThroughEachOther) {
  Scene scene = filled_scene(many_disks(20), 0.5);
  scene.layers.push_back(make_layer("above", areas(), {200, 40, 0}, 0.5));
  scene.layers.back().style.filled = true;
  scene.background = {240, 230, 200};
  compare(scene, whole, "two_layers_of_disks");
}

TEST_F(Gl_fill, PanAndZoomSendNothing) {
  Scene scene = filled_scene(closed_arcs(), 0.5);
  scene.layers.push_back(make_layer("disks", many_disks(30), {0, 120, 0}, 0.5));
  scene.layers.back().style.filled = true;
  QImage last = drawn(scene, whole);
  const std::size_t before = canvas_.uploaded_bytes();
  for (int i = 1; i <= 50; ++i) {
    const QImage picture = drawn(scene, {{50 + 0.5 * i, 40}, 5.5 + 0.2 * i});
    EXPECT_NE(picture, last);
    last = picture;
  }
  EXPECT_EQ(canvas_.uploaded_bytes(), before);
}

TEST_F(Gl_fill, ManyArcs) {
  std::shared_ptr<Primitive_set> boundary;
  const auto disks = many_disks(80000, &boundary);
  EXPECT_GT(boundary->arcs.size(), 100000U);
  Scene scene = filled_scene(boundary, 1);
  const View_2 near{{50, 40}, 60};
  // The area that arcs bound is that of the disks.
  scene.layers[0].style.line_width = 0.2;
  EXPECT_TRUE(same_picture(drawn(scene, near), drawn(filled_scene(disks, 1), near), "many_arcs_near", 60, 0.002));
  compare(scene, near, "many_arcs");
}

}  // namespace
}  // namespace mesecina

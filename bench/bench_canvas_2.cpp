// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the canvas of the plane: pictures painted per second, for kinds of scenes, by each way of drawing.
#include <QApplication>
#include <QElapsedTimer>
#include <QSurfaceFormat>
#include <cmath>
#include <ctime>
#include <iostream>
#include <numbers>
#include <random>
#include <stdexcept>

#include "bench/table.h"
#include "layers/canvas_2.h"

namespace {

using namespace mesecina;

constexpr double side = 1000;

std::vector<Point_3> scattered(std::size_t count) {
  std::mt19937_64 random(7);
  const auto number = [&] { return side * static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Point_3> points;
  for (std::size_t i = 0; i < count; ++i) points.push_back({number(), number() / 2, 0});
  return points;
}

std::shared_ptr<const Primitive_set> points(std::size_t count) {
  auto set = std::make_shared<Primitive_set>();
  set->vertices = scattered(count);
  for (std::size_t i = 0; i < count; ++i) set->points.push_back(static_cast<int>(i));
  return set;
}

std::shared_ptr<const Primitive_set> segments(std::size_t count, double length) {
  auto set = std::make_shared<Primitive_set>();
  for (const Point_3& p : scattered(count)) {
    const double angle = p.x;
    const int first = static_cast<int>(set->vertices.size());
    set->vertices.push_back(p);
    set->vertices.push_back({p.x + length * std::cos(angle), p.y + length * std::sin(angle), 0});
    set->segments.push_back({first, first + 1});
  }
  return set;
}

std::shared_ptr<const Primitive_set> disks(std::size_t count, double radius) {
  auto set = std::make_shared<Primitive_set>();
  set->vertices = scattered(count);
  for (std::size_t i = 0; i < count; ++i) set->balls.push_back({static_cast<int>(i), radius});
  return set;
}

std::shared_ptr<const Primitive_set> triangles(std::size_t count, double size) {
  auto set = std::make_shared<Primitive_set>();
  for (const Point_3& p : scattered(count)) {
    const int first = static_cast<int>(set->vertices.size());
    set->vertices.push_back(p);
    set->vertices.push_back({p.x + size, p.y, 0});
    set->vertices.push_back({p.x, p.y + size, 0});
    set->triangles.push_back({first, first + 1, first + 2});
  }
  return set;
}

struct Example {
  const char* name;
  std::shared_ptr<const Primitive_set> set;
  bool is_filled;
  double opacity;
};

void bench(Table& table, Canvas_2::Backend backend, const Example& example) {
  Canvas_2 canvas(backend);
  canvas.resize(1366, 768);
  canvas.show();
  Scene scene;
  Scene_layer layer{"layer", "Layer", example.set, {}, {}};
  layer.style.visible = true;
  layer.style.filled = example.is_filled;
  layer.style.opacity = example.opacity;
  scene.layers.push_back(layer);
  canvas.fit({{0, 0, 0}, {side, side / 2, 0}});
  const auto draw = [&] {
    canvas.set_scene(scene);
    canvas.grab_picture();
  };
  draw();
  const std::clock_t start = std::clock();
  int pictures = 0;
  const double time = seconds([&] {
    QElapsedTimer timer;
    timer.start();
    constexpr int least_milliseconds = 500;
    while (timer.elapsed() < least_milliseconds) {
      draw();
      ++pictures;
    }
  });
  const double cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  const std::string what = std::string(example.name) + " [" + canvas.backend_name().left(20).toStdString() + "]";
  table.row(what, pictures / time, "per s");
  table.row(what + " processor time of a picture", cpu / pictures, "s");
}

}  // namespace

int main(int argc, char** argv) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  QApplication application(argc, argv);
  const Example examples[] = {
      {"2000 points", points(2000), false, 1},
      {"100 000 points", points(100000), false, 1},
      {"2000 long segments", segments(2000, 200), false, 1},
      {"20 000 segments", segments(20000, 20), false, 1},
      {"100 000 segments", segments(100000, 5), false, 1},
      {"2000 circles", disks(2000, 20), false, 1},
      {"2000 disks", disks(2000, 20), true, 1},
      {"2000 disks, translucent", disks(2000, 20), true, 0.5},
      {"2000 large disks", disks(2000, 150), true, 1},
      {"20 000 disks", disks(20000, 4), true, 1},
      {"20 000 triangles", triangles(20000, 8), true, 1},
      {"20 000 triangles, translucent", triangles(20000, 8), true, 0.5},
      {"100 000 triangles", triangles(100000, 4), true, 1},
  };
  Table table;
  for (const Example& example : examples)
    for (const Canvas_2::Backend backend : {Canvas_2::Backend::opengl, Canvas_2::Backend::painter})
      bench(table, backend, example);
  return 0;
}

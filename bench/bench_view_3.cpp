// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of pictures of space: uploads, frames, bytes per frame, and updates per second while the scale is moved. Rows
// name the OpenGL they were measured with. Without a mesh balls and triangles are those of a tube along a closed curve.
//
//   mesecina_bench_view_3                  the tube: 140 000 balls and a million triangles
//   mesecina_bench_view_3 MESH DELTA       the balls and the surface of a mesh
//   mesecina_bench_view_3 --scale MESH N   updates per second of the scale axis of about N balls, and what they cost
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numbers>
#include <random>
#include <string>
#include <thread>

#include "bench/table.h"
#include "core/formats/format.h"
#include "core/graph.h"
#include "geometries/modules_3.h"
#include "geometries/samples_3/module.h"
#include "layers/egl_context.h"
#include "layers/gl_objects.h"
#include "layers/gl_renderer_3.h"

namespace {

using namespace mesecina;

constexpr int width = 800;
constexpr int height = 600;

/// A closed curve, and frames along it.
Point_3 on_curve(double t) {
  return {2 * std::cos(t) + 0.5 * std::cos(3 * t), 2 * std::sin(t) - 0.5 * std::sin(3 * t), 0.6 * std::sin(2 * t)};
}

double radius_of_tube(double t) { return 0.45 + 0.12 * std::sin(5 * t); }

/// The point of the tube's surface at angle `around`, `share` of the way from the curve.
Point_3 in_tube(double t, double around, double share) {
  constexpr double step = 1e-4;
  const Point_3 ahead = on_curve(t + step) - on_curve(t - step);
  const Point_3 along = (1 / std::sqrt(dot(ahead, ahead))) * ahead;
  Point_3 side = cross(along, {0, 0, 1});
  side = (1 / std::sqrt(dot(side, side))) * side;
  const double reach = share * radius_of_tube(t);
  return on_curve(t) + (reach * std::cos(around)) * side + (reach * std::sin(around)) * cross(along, side);
}

/// Balls that touch the tube from within, as the medial balls of dense samples do; each with a value.
Primitive_set tube_balls(int count) {
  Primitive_set set;
  set.dimension = 3;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi);
  std::uniform_real_distribution<double> share(0, 0.15);
  Values radius{"radius", "units of the input", {}};
  for (int i = 0; i < count; ++i) {
    const double t = turn(random);
    const double from_axis = share(random);
    set.vertices.push_back(in_tube(t, turn(random), from_axis));
    set.balls.push_back({i, (1 - from_axis) * radius_of_tube(t)});
    radius.data.push_back(set.balls.back().radius);
  }
  set.values.push_back(std::move(radius));
  return set;
}

Primitive_set tube_triangles(int along, int around) {
  Primitive_set set;
  set.dimension = 3;
  for (int i = 0; i < along; ++i)
    for (int j = 0; j < around; ++j)
      set.vertices.push_back(in_tube(2 * std::numbers::pi * i / along, 2 * std::numbers::pi * j / around, 1.0));
  const auto vertex = [&](int i, int j) { return i % along * around + j % around; };
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < around; ++j) {
      set.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      set.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  }
  return set;
}

Scene_layer layer_of(Primitive_set set, const Color& color) {
  Scene_layer layer{"layer", "Layer", std::make_shared<const Primitive_set>(std::move(set)), {}, {}};
  layer.style.visible = true;
  layer.style.filled = true;
  layer.style.color = color;
  return layer;
}

Scene scene_of_mesh(const std::string& file, double delta) {
  Graph graph(make_registry_3());
  graph.set_inputs(read_file(spatial_formats(), file).inputs);
  graph.set_settings(Settings().with("delta", delta));
  Progress progress({}, {}, static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  Scene scene;
  for (const char* id : {"solid", "balls"}) {
    const auto outcome = graph.layer(id, progress);
    if (!outcome) throw std::runtime_error(outcome.reason);
    scene.layers.push_back(layer_of(*outcome.value, {120, 150, 200}));
  }
  return scene;
}

/// Draws without a window.
class Painter {
 public:
  Painter() { context_.make_current(); }

  /// Until the picture is there.
  double seconds_of(const Scene& scene, const View_3& view, Frame_3 frame) {
    const Gl_target target(frame.width, frame.height);
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glViewport(0, 0, frame.width, frame.height);
    const double time = seconds([&] {
      if (!renderer_) renderer_ = std::make_unique<Gl_renderer_3>();
      renderer_->draw(scene, {}, view, frame);
      glFinish();
    });
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return time;
  }

  Gl_renderer_3& renderer() { return *renderer_; }

 private:
  Egl_context context_;
  std::unique_ptr<Gl_renderer_3> renderer_;
};

View_3 view_from(const Scene& scene, double angle) {
  View_3 view;
  view.camera = fit_camera(drawn_box(scene), width, height, {std::sin(angle), 0.4, std::cos(angle)}, {0, 1, 0},
                           Camera_3::Projection::perspective);
  return view;
}

Frame_3 frame_of(int samples, int part = 1) {
  Frame_3 frame{width / part, height / part};
  frame.samples = samples;
  return frame;
}

/// The mean of some directions.
double frame_seconds(Painter& painter, const Scene& scene, const Frame_3& frame) {
  constexpr int frames = 3;
  double sum = 0;
  for (int i = 0; i < frames; ++i) sum += painter.seconds_of(scene, view_from(scene, 1.3 * i), frame);
  return sum / frames;
}

void bench_frames(Table& table, Scene scene) {
  Painter painter;
  Scene nothing;
  painter.seconds_of(nothing, view_from(nothing, 0), frame_of(1));
  const std::string by = " [" + painter.renderer().description() + "]";
  const Primitive_set& faces = *scene.layers[0].primitives;
  const Primitive_set& balls = *scene.layers[1].primitives;
  const std::string name = std::to_string(balls.balls.size()) + " balls";
  const std::string other = std::to_string(faces.triangles.size()) + " triangles";
  std::printf("pictures of space%s\n", by.c_str());

  const Frame_3 small = frame_of(1, 16);
  const double first = painter.seconds_of(scene, view_from(scene, 0), small);
  const double later = painter.seconds_of(scene, view_from(scene, 0), small);
  table.row(name + " and " + other + ": first small picture, with upload", first, "s", 1);
  table.row(name + " and " + other + ": the same again", later, "s");

  const auto with = [&](bool has_faces, bool has_balls, double opacity) {
    Scene shown = scene;
    shown.layers[0].style.visible = has_faces;
    shown.layers[1].style.visible = has_balls;
    shown.layers[1].style.opacity = opacity;
    return shown;
  };
  table.row(name + ": frame", frame_seconds(painter, with(false, true, 1), frame_of(1)), "s");
  for (const int coarseness : {2, 4, 8}) {
    Frame_3 coarse = frame_of(1);
    coarse.coarseness = coarseness;
    table.row(name + ": frame while it moves, coarseness " + std::to_string(coarseness),
              frame_seconds(painter, with(false, true, 1), coarse), "s");
  }
  table.row(other + ": frame", frame_seconds(painter, with(true, false, 1), frame_of(1)), "s");
  table.row(name + " and " + other + ": frame", frame_seconds(painter, with(true, true, 1), frame_of(1)), "s");
  Frame_3 moving = frame_of(1);
  moving.most_translucent_layers = 4;
  moving.coarseness = 8;
  table.row(name + ", translucent: frame while it moves, coarseness 8",
            frame_seconds(painter, with(false, true, 0.5), moving), "s");

  constexpr int orbit = 100;
  const Frame_3 tiny = frame_of(1, 8);
  const std::size_t bytes = painter.renderer().uploaded_bytes();
  for (int i = 0; i < orbit; ++i) painter.seconds_of(scene, view_from(scene, 0.06 * i), tiny);
  table.row("bytes uploaded in 100 frames of orbiting",
            static_cast<double>(painter.renderer().uploaded_bytes() - bytes), "bytes");

  Scene sliding = with(true, true, 1);
  Style& style = sliding.layers[1].style;
  if (balls.find_values("radius")) style.value = "radius";
  style.threshold_minimum = 0;
  painter.seconds_of(sliding, view_from(scene, 0), tiny);
  const std::size_t before = painter.renderer().uploaded_bytes();
  const double greatest = std::ranges::max(balls.balls, {}, &Ball::radius).radius;
  double sum = 0;
  for (int i = 0; i < orbit; ++i) {
    style.threshold_minimum = greatest * i / orbit;
    sum += painter.seconds_of(sliding, view_from(scene, 0), tiny);
  }
  table.row("bytes uploaded in 100 steps of a threshold",
            static_cast<double>(painter.renderer().uploaded_bytes() - before), "bytes");
  table.row("a step of a threshold, picture of " + std::to_string(tiny.width) + " x " + std::to_string(tiny.height),
            sum / orbit, "s");
}

/// As a window moves the slider: after each answer the next scale, in the same graph.
void bench_scale(Table& table, const std::string& file, double count) {
  const int threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  Graph graph(make_registry_3());
  graph.set_inputs(read_file(spatial_formats(), file).inputs);
  Progress progress({}, {}, threads);
  // Their number goes with 1 / delta^2 but for jumps, so the nearest of some steps between two bounds is taken.
  double delta = 0.01;
  std::size_t balls = 0;
  double least = 1e-3;
  double most = 0.1;
  constexpr int steps_of_search = 12;
  for (int i = 0; i < steps_of_search; ++i) {
    const double tried = std::sqrt(least * most);
    graph.set_settings(Settings().with("delta", tried));
    const auto found = graph.structure(balls_3_key, progress);
    if (!found) throw std::runtime_error(found.reason);
    const auto size = static_cast<double>(found.value->size());
    (size > count ? least : most) = tried;
    if (i > 0 && std::abs(std::log(size / count)) >= std::abs(std::log(static_cast<double>(balls) / count))) continue;
    balls = found.value->size();
    delta = tried;
  }
  const auto axis_at = [&](double scale) {
    graph.set_settings(Settings().with("delta", delta).with("scale", scale));
    const auto outcome = graph.layer("scale-axis", progress);
    if (!outcome) throw std::runtime_error(outcome.reason);
  };
  axis_at(1.1);
  graph.clear_stages();
  constexpr int steps = 5;
  std::map<std::string, double> stages;
  double sum = 0;
  for (int i = 1; i <= steps; ++i) {
    const double scale = 1.1 + 0.02 * i;
    sum += seconds([&] { axis_at(scale); });
  }
  for (const Graph::Stage& stage : graph.stages()) stages[stage.id] += stage.seconds / steps;
  table.row(std::to_string(balls) + " balls: updates of the scale axis [" + std::to_string(threads) + " threads]",
            steps / sum, "per s", 2, false);
  for (const auto& [id, time] : stages)
    if (time > 0.001) table.row("    of an update, " + id, time, "s");
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  Table table;
  try {
    if (arguments.empty()) {
      Scene scene;
      scene.layers = {layer_of(tube_triangles(1000, 500), {220, 200, 170}),
                      layer_of(tube_balls(140'000), {120, 150, 200})};
      bench_frames(table, std::move(scene));
    } else if (arguments.size() == 2) {
      bench_frames(table, scene_of_mesh(arguments[0], std::stod(arguments[1])));
    } else if (arguments.size() == 3 && arguments[0] == "--scale") {
      bench_scale(table, arguments[1], std::stod(arguments[2]));
    } else {
      std::cerr << "usage: mesecina_bench_view_3 [MESH DELTA | --scale MESH COUNT]" << std::endl;
      return 2;
    }
  } catch (const std::exception& error) {
    std::cerr << error.what() << std::endl;
    return 2;
  }
  return table.all_met() ? 0 : 1;
}

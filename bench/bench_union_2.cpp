// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the planar structures from disks. The baseline of the medial axis is what cannot be avoided: CGAL's
// regular triangulation of the disks and its Delaunay triangulation of the vertices of their union.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <thread>

#include "bench/curves.h"
#include "bench/table.h"
#include "core/formats/format.h"
#include "core/graph.h"
#include "geometries/balls_2/balls_2.h"
#include "geometries/crust_2/one_step_crust.h"
#include "geometries/labels_2/labels_2.h"
#include "geometries/modules_2.h"
#include "geometries/samples_2/samples_2.h"
#include "geometries/union_2/union_medial_axis_2.h"

namespace {

using namespace mesecina;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Times {
  double regular_baseline = 1e300;
  double delaunay_baseline = 1e300;
  double medial_axis = 1e300;
  double baseline() const { return regular_baseline + delaunay_baseline; }
};

std::shared_ptr<const Balls_2> inner_voronoi_balls(const std::vector<Point_2>& samples, Progress& progress) {
  const Delaunay_2 triangulation = delaunay(samples, progress);
  const Voronoi_2 diagram = voronoi(triangulation, progress);
  const Labels_2 labels = flood_labels(triangulation, one_step_crust(triangulation, progress), progress);
  return std::make_shared<const Balls_2>(circumscribed_balls(triangulation, diagram, labels.is_inner, progress).balls);
}

Times measure_medial_axis(const std::vector<Point_2>& samples, int threads, int repetitions) {
  Progress progress({}, {}, threads);
  const std::shared_ptr<const Balls_2> balls = inner_voronoi_balls(samples, progress);
  std::vector<Kernel::Weighted_point_2> weighted;
  for (std::size_t b = 0; b < balls->size(); ++b)
    weighted.emplace_back(Kernel::Point_2(balls->centers[b].x, balls->centers[b].y), balls->radii[b] * balls->radii[b]);
  std::vector<Kernel::Point_2> vertices;
  for (const Point_2& p : union_boundary(balls, 0, progress).vertices) vertices.emplace_back(p.x, p.y);
  Times best;
  for (int i = 0; i < repetitions; ++i) {
    best.regular_baseline =
        std::min(best.regular_baseline,
                 seconds([&] { const CGAL::Regular_triangulation_2<Kernel> of(weighted.begin(), weighted.end()); }));
    best.delaunay_baseline =
        std::min(best.delaunay_baseline,
                 seconds([&] { const CGAL::Delaunay_triangulation_2<Kernel> of(vertices.begin(), vertices.end()); }));
    std::map<std::string, double> stages;
    best.medial_axis = std::min(
        best.medial_axis, seconds([&] {
          std::shared_ptr<const Regular_2> regular;
          std::shared_ptr<const Dual_2> dual;
          std::shared_ptr<const Union_boundary_2> boundary;
          Union_voronoi_2 diagram;
          stages["1 regular triangulation"] =
              seconds([&] { regular = std::make_shared<const Regular_2>(regular_triangulation(balls, progress)); });
          stages["2 dual complex"] =
              seconds([&] { dual = std::make_shared<const Dual_2>(dual_complex(regular, 0, progress)); });
          stages["3 boundary"] =
              seconds([&] { boundary = std::make_shared<const Union_boundary_2>(union_boundary(dual, progress)); });
          stages["4 Voronoi diagram of the vertices"] = seconds([&] { diagram = union_voronoi(boundary, progress); });
          stages["5 medial axis"] = seconds([&] { union_medial_axis(diagram, false, progress); });
        }));
    if (std::getenv("MESECINA_BENCH_STAGES") && i + 1 == repetitions)
      for (const auto& [name, time] : stages) std::printf("    %-40s %8.3f s\n", name.c_str(), time);
  }
  return best;
}

void bench_medial_axis(Table& table, const std::string& name, std::vector<Point_2> (*curve)(std::size_t), int threads) {
  const Times small = measure_medial_axis(curve(100'000), threads, 5);
  const Times large = measure_medial_axis(curve(1'000'000), threads, 2);
  const std::string on = ", " + name + " [" + std::to_string(threads) + (threads == 1 ? " thread]" : " threads]");
  table.row("10^5 Voronoi disks: medial axis of union / CGAL" + on, small.medial_axis / small.baseline(), "x", 3);
  table.row("10^6 Voronoi disks: medial axis of union / CGAL" + on, large.medial_axis / large.baseline(), "x");
  table.row("10^5 to 10^6: growth exponent of medial axis" + on, std::log10(large.medial_axis / small.medial_axis), "",
            1.15);
  table.row("10^5 to 10^6: growth exponent of CGAL's" + on, std::log10(large.baseline() / small.baseline()), "");
}

/// The example sampled to about `count` points.
Inputs sampled_example(const std::string& file, std::size_t count) {
  const Inputs inputs = read_file(planar_formats(), std::filesystem::path(MESECINA_EXAMPLES) / file).inputs;
  const auto outline = inputs.get(outline_input);
  double least = 0;
  double most = diagonal(*outline);
  for (int i = 0; i < 40; ++i) {
    const double middle = (least + most) / 2;
    (sample_outline(*outline, middle).size() > count ? least : most) = middle;
  }
  return Inputs().with(points_input, sample_outline(*outline, most));
}

void print_stages(const Graph& graph, int repetitions) {
  if (!std::getenv("MESECINA_BENCH_STAGES")) return;
  std::map<std::string, double> stages;
  for (const Graph::Stage& stage : graph.stages()) stages[stage.id] += stage.seconds;
  for (const auto& [id, time] : stages) std::printf("    %-40s %8.3f ms\n", id.c_str(), 1000 * time / repetitions);
}

void bench_scale(Table& table, const std::string& file, std::size_t count, double goal, int threads) {
  Graph graph(make_registry_2());
  graph.set_inputs(sampled_example(file, count));
  const auto evaluate = [&](double scale) {
    Progress progress({}, {}, threads);
    graph.set_settings(Settings().with("scale", scale));
    for (const char* layer : {"grown-union", "scale-axis-shape", "scale-axis"})
      if (!graph.layer(layer, progress)) std::abort();
  };
  evaluate(1.1);
  graph.clear_stages();
  constexpr int moves = 20;
  const double total = seconds([&] {
    for (int i = 1; i <= moves; ++i) evaluate(1.1 + 0.02 * i);
  });
  print_stages(graph, moves);
  table.row("drag scale 1.1 to 1.5, " + file + ", " + std::to_string(graph.inputs().get(points_input)->size()) +
                " samples: axis, shapes",
            moves / total, "per s", goal, false);
}

void bench_disk(Table& table, std::size_t count, double goal, int threads) {
  Graph graph(make_registry_2());
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  const double spacing = 1 / std::sqrt(static_cast<double>(count));
  std::vector<Disk_2> disks;
  for (std::size_t i = 0; i < count; ++i)
    disks.push_back({{unit(random), unit(random)}, spacing * (0.2 + 0.8 * unit(random))});
  const auto evaluate = [&] {
    Progress progress({}, {}, threads);
    graph.set_inputs(Inputs().with(disks_input, disks));
    for (const char* layer : {"disks", "power-diagram", "dual-faces", "dual-singular-edges", "union-boundary"})
      if (!graph.layer(layer, progress)) std::abort();
  };
  evaluate();
  graph.clear_stages();
  constexpr int moves = 30;
  const Point_2 start = disks[count / 3].center;
  const double total = seconds([&] {
    for (int i = 1; i <= moves; ++i) {
      disks[count / 3].center = {start.x + spacing * std::sin(i), start.y + spacing * std::cos(i)};
      evaluate();
    }
  });
  print_stages(graph, moves);
  table.row("drag 1 of " + std::to_string(count) + " disks: power diagram, dual, boundary", moves / total, "per s",
            goal, false);
}

}  // namespace

int main() {
  Table table;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  bench_medial_axis(table, "smooth", smooth_curve, 1);
  bench_medial_axis(table, "rippled", rippled_curve, 1);
  bench_scale(table, "giraffe.wkt", 1184, 30, cores);
  bench_scale(table, "italy.wkt", 20'000, 4, cores);
  bench_disk(table, 10'000, 20, cores);
  return table.all_met() ? 0 : 1;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the planar engine. Every time is the least of several runs, and every figure but rates and the star is
// a ratio to a baseline measured in the same run: absolute times say more about the machine than about the program.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <thread>

#include "bench/curves.h"
#include "bench/table.h"
#include "core/graph.h"
#include "geometries/crust_2/one_step_crust.h"
#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/filtration/filtration.h"
#include "geometries/labels_2/labels_2.h"
#include "geometries/medial_axis_2/medial_axis_2.h"
#include "geometries/medial_filtrations_2/ball_scale_2.h"
#include "geometries/modules_2.h"

namespace {

using namespace mesecina;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Times {
  double baseline = 1e300;  ///< CGAL's own insertion
  double delaunay = 1e300;
  double rest = 1e300;   ///< crust, labels, medial axis, lambda, angle
  double scale = 1e300;  ///< scale importance and topology-preserving pass
};

Times measure(std::size_t count, int threads, int repetitions) {
  const std::vector<Point_2> points = smooth_curve(count);
  std::vector<Kernel::Point_2> cgal_points;
  for (const Point_2& p : points) cgal_points.emplace_back(p.x, p.y);
  Progress progress({}, {}, threads);
  Times best;
  for (int i = 0; i < repetitions; ++i) {
    best.baseline =
        std::min(best.baseline, seconds([&] {
                   const CGAL::Delaunay_triangulation_2<Kernel> triangulation(cgal_points.begin(), cgal_points.end());
                 }));
    Delaunay_2 triangulation;
    best.delaunay = std::min(best.delaunay, seconds([&] { triangulation = delaunay(points, progress); }));
    Medial_axis_2 axis;
    best.rest = std::min(best.rest, seconds([&] {
                           const Voronoi_2 diagram = voronoi(triangulation, progress);
                           const Crust_2 crust = one_step_crust(triangulation, progress);
                           const Labels_2 labels = flood_labels(triangulation, crust, progress);
                           axis = medial_axis(triangulation, diagram, labels, progress);
                           lambda_of_edges(triangulation, axis, progress);
                           angle_of_edges(triangulation, axis, progress);
                         }));
    best.scale = std::min(best.scale, seconds([&] {
                            const Ball_scale_2 importance = ball_scale(triangulation, axis, progress);
                            std::vector<double> values;
                            for (const auto& [a, b] : axis.edges)
                              values.push_back(std::min(importance.values[a], importance.values[b]));
                            topology_preserving(axis.centers.size(), axis.edges, values, axis.contacts, progress);
                          }));
  }
  return best;
}

void bench_pipeline(Table& table, int threads) {
  const Times small = measure(100'000, threads, 5);
  const Times large = measure(1'000'000, threads, 3);
  const std::string on = " [" + std::to_string(threads) + (threads == 1 ? " thread]" : " threads]");
  table.row("10^6 samples: Delaunay ... angle / CGAL insertion" + on, (large.delaunay + large.rest) / large.baseline,
            "x", 1.8);
  table.row("10^6 samples: scale filtration / CGAL insertion" + on, large.scale / large.baseline, "x", 3);
  table.row("10^5 to 10^6: growth exponent of Delaunay ... angle" + on,
            std::log10((large.delaunay + large.rest) / (small.delaunay + small.rest)), "");
  table.row("10^5 to 10^6: growth exponent of the scale filtration" + on, std::log10(large.scale / small.scale), "",
            1.15);
}

void bench_drag(Table& table, std::size_t count, double goal, int threads) {
  Graph graph(make_registry_2());
  std::vector<Point_2> points = smooth_curve(count);
  const auto evaluate = [&] {
    Progress progress({}, {}, threads);
    graph.set_inputs(graph.inputs().with(points_input, points));
    for (const char* layer : {"points", "voronoi", "one-step-crust", "medial-axis", "scale-medial-axis"})
      if (!graph.layer(layer, progress)) std::abort();
  };
  const auto stage_seconds = [&](const std::string& id) {
    double sum = 0;
    for (const Graph::Stage& stage : graph.stages())
      if (stage.id == id) sum += stage.seconds;
    return sum;
  };
  evaluate();
  const double full_delaunay = stage_seconds("delaunay-triangulation-2");
  graph.clear_stages();
  constexpr int moves = 40;
  const Point_2 start = points[count / 3];
  const double step = 1.0 / static_cast<double>(count);
  const double total = seconds([&] {
    for (int i = 1; i <= moves; ++i) {
      points[count / 3] = {start.x + step * std::sin(i), start.y + step * std::cos(i)};
      evaluate();
    }
  });
  const std::string name = "drag 1 of " + std::to_string(count) + " samples, five layers: ";
  table.row(name + "updates", moves / total, "per s", goal, false);
  table.row(name + "Delaunay, update / full", stage_seconds("delaunay-triangulation-2") / moves / full_delaunay, "x",
            0.1);
  if (std::getenv("MESECINA_BENCH_STAGES")) {
    std::map<std::string, double> stages;
    for (const Graph::Stage& stage : graph.stages()) stages[stage.id] += stage.seconds;
    for (const auto& [id, time] : stages) std::printf("    %-40s %8.3f ms\n", id.c_str(), 1000 * time / moves);
  }
}

void bench_star(Table& table, int threads) {
  const Outline_2 star = noisy_star(10'000, 1);
  double best = 1e300;
  for (int i = 0; i < 5; ++i) {
    best = std::min(best, seconds([&] {
                      Graph graph(make_registry_2());
                      graph.set_inputs(Inputs().with(outline_input, star));
                      Progress progress({}, {}, threads);
                      if (!graph.layer("medial-axis", progress) || !graph.layer("scale-medial-axis", progress))
                        std::abort();
                    }));
  }
  table.row("star of 10^4 segments: outline to medial axis and scale filtration", best, "s", 0.15);
}

/// In a process of its own, so that the peak is that of this case.
void bench_memory(Table& table) {
  constexpr std::size_t count = 1'000'000;
  {
    Graph graph(make_registry_2());
    graph.set_inputs(Inputs().with(points_input, smooth_curve(count)));
    Progress progress({}, {}, 1);
    for (const char* layer : {"one-step-crust", "lambda-medial-axis", "angle-medial-axis"})
      if (!graph.layer(layer, progress)) std::abort();
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  table.row("10^6 samples, crust, lambda and angle layers: peak memory per sample",
            static_cast<double>(usage.ru_maxrss) * 1024 / count, "bytes", 1200);
}

}  // namespace

int main(int argc, char** argv) {
  Table table;
  if (argc > 1 && std::string(argv[1]) == "--memory") {
    bench_memory(table);
  } else {
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    bench_pipeline(table, 1);
    if (cores > 1) bench_pipeline(table, cores);
    bench_drag(table, 10'000, 60, cores);
    bench_drag(table, 100'000, 10, cores);
    bench_star(table, cores);
  }
  return table.all_met() ? 0 : 1;
}

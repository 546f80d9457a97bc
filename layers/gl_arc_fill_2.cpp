// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_arc_fill_2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "layers/arc_loops.h"

namespace mesecina {
namespace {

constexpr double tolerance = 0.1;  // pixels
constexpr int most_corners = 2048;
/// Runs of segments differ by this factor in their bend, so by 2 in their number of corners.
constexpr double bend_factor = 4;

class Triangle_writer {
 public:
  Triangle_writer(const Point_2& origin, std::vector<float>& data) : origin_(origin), data_(data) {}

  /// Triangles that cover the points inside the ring an odd number of times. Halving the ring again and again keeps
  /// them short, other than a fan.
  void add_ring(std::span<const Point_2> ring) {
    if (ring.size() < 3) return;
    std::vector<std::pair<std::size_t, std::size_t>> chains{{0, ring.size()}};
    while (!chains.empty()) {
      const auto [first, last] = chains.back();
      chains.pop_back();
      if (last - first < 2) continue;
      const std::size_t middle = (first + last) / 2;
      if (last - first < ring.size()) {
        for (const std::size_t i : {first, middle, last}) place(ring[i % ring.size()]);
      }
      chains.emplace_back(first, middle);
      chains.emplace_back(middle, last);
    }
  }

 private:
  void place(const Point_2& p) {
    data_.push_back(static_cast<float>(p.x - origin_.x));
    data_.push_back(static_cast<float>(p.y - origin_.y));
  }

  Point_2 origin_;
  std::vector<float>& data_;
};

double bend_of(const Pixel_arc& arc) { return arc.radius * arc.sweep * arc.sweep; }

void add_segments(std::vector<Pixel_arc>& arcs, Arc_fill& fill) {
  std::erase_if(arcs, [](const Pixel_arc& arc) { return bend_of(arc) == 0; });
  std::sort(arcs.begin(), arcs.end(), [](const Pixel_arc& a, const Pixel_arc& b) { return bend_of(a) > bend_of(b); });
  fill.segments.reserve(arcs.size() * static_cast<std::size_t>(Arc_fill::segment_size));
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Pixel_arc& arc = arcs[i];
    const double bend = bend_of(arc);
    if (fill.runs.empty() || bend * bend_factor < fill.runs.back().bend) fill.runs.push_back({i, 0, bend});
    ++fill.runs.back().count;
    for (const Point_2& p : {arc.from, arc.to, arc.center}) {
      fill.segments.push_back(static_cast<float>(p.x - fill.origin.x));
      fill.segments.push_back(static_cast<float>(p.y - fill.origin.y));
    }
    for (const double number : {arc.radius, arc.start, arc.sweep}) fill.segments.push_back(static_cast<float>(number));
  }
}

}  // namespace

Arc_fill whole_arc_fill(const Primitive_set& set, const std::vector<bool>& drawn, const Point_2& origin) {
  Arc_fill fill;
  fill.origin = origin;
  Triangle_writer triangles(origin, fill.triangles);
  std::vector<Pixel_arc> arcs;
  std::vector<Point_2> ring;
  const Arc_loops loops = closed_loops(set, drawn);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    ring.clear();
    for (const Arc_step& step : loops.loop(i)) {
      arcs.push_back(planar_arc(set, step));
      ring.push_back(arcs.back().to);
    }
    triangles.add_ring(ring);
  }
  add_segments(arcs, fill);
  return fill;
}

Arc_fill cut_out_arc_fill(const Primitive_set& set, const std::vector<bool>& drawn, const Window_2& window) {
  Arc_fill fill;
  fill.origin = window.center;
  Triangle_writer triangles(window.center, fill.triangles);
  const Pixel_box box =
      Pixel_box{window.center.x, window.center.y, window.center.x, window.center.y}.grown(window.half_side);
  std::vector<Point_2> ring;
  const Arc_loops loops = closed_loops(set, drawn);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    Box around;
    for (const Arc_step& step : loops.loop(i))
      around.add(bounding_box(set, set.arcs[static_cast<std::size_t>(step.arc)]));
    if (!box.meets({around.lower.x, around.lower.y, around.upper.x, around.upper.y})) continue;
    ring.clear();
    for (const Arc_step& step : loops.loop(i))
      append_polyline(planar_arc(set, step), box, tolerance / window.largest_scale, ring);
    triangles.add_ring(clip_ring(ring, box));
  }
  return fill;
}

int corners_of_segment(const Segment_run& run, double scale) {
  // A chord over the angle a leaves its circle by r a^2 / 8.
  const double chords = std::ceil(std::sqrt(run.bend * scale / (8 * tolerance)));
  return 1 + static_cast<int>(std::clamp(chords, 1.0, double{most_corners}));
}

}  // namespace mesecina

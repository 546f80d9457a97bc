// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <string>
#include <utility>

#include "core/graph.h"
#include "geometries/evolutions_2/evolutions.h"
#include "geometries/evolutions_2/lloyd_2.h"

namespace mesecina {

namespace {

/// Whether no point goes farther than rounding takes it.
bool are_same(const std::vector<Point_2>& before, const std::vector<Point_2>& after, double diagonal) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (distance(before[i], after[i]) > rounding * diagonal) return false;
  return true;
}

std::string why_no_points(const Evolution_state& state) {
  const auto points = state.inputs.get(points_input);
  return points && !points->empty() ? "" : "there are no points to move: draw, generate or open some";
}

Evolution_state move_to_centroids(Context& context, const Evolution_state& before, std::uint64_t step) {
  const auto points = before.inputs.get(points_input);
  Evolution_state after = before;
  std::vector<Point_2> moved;
  double diagonal = 0;
  if (const auto outline = before.inputs.get(outline_input); outline && !outline->rings.empty()) {
    diagonal = bounding_box(Inputs().with(outline_input, outline)).diagonal();
    moved = cell_centroids(*points, *outline, context.progress());
  } else {
    auto box = step > 1 ? before.inputs.get(lloyd_domain_input) : nullptr;
    if (!box) {
      box = std::make_shared<const Box>(bounding_box(Inputs().with(points_input, points)));
      after.inputs = after.inputs.with(lloyd_domain_input, box);
    }
    if (box->lower.x >= box->upper.x || box->lower.y >= box->upper.y)
      throw Unavailable(
          "the bounding box of the points has no area: add points that are not on one horizontal or vertical line, or "
          "an outline that they may move in");
    diagonal = box->diagonal();
    moved = cell_centroids(*points, *box, context.progress());
  }
  if (are_same(*points, moved, diagonal)) return before;
  after.inputs = after.inputs.with(points_input, std::move(moved));
  return after;
}

}  // namespace

Evolution_spec lloyd_2() {
  Evolution_spec evolution;
  evolution.id = "lloyd";
  evolution.label = "Points to centroids (Lloyd)";
  evolution.help =
      "Each step moves every point to the centroid of its Voronoi cell, cut to the inside of the outline or, where "
      "there is none, to the bounding box that the points had at the first step. Points spread evenly; cells become "
      "alike. [S. Lloyd: Least squares quantization in PCM, 1982; Q. Du, V. Faber, M. Gunzburger: Centroidal Voronoi "
      "tessellations, 1999]";
  evolution.needs = {"points", why_no_points};
  evolution.step = move_to_centroids;
  return evolution;
}

}  // namespace mesecina

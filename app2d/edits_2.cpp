// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/edits_2.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "core/formats/number.h"

namespace mesecina {

namespace {

void for_each_handle(const Inputs& inputs, const Reach_2& reach, auto visit_point, auto visit_vertex) {
  if (const auto points = inputs.get(points_input); points && reach.points) {
    for (std::size_t i = 0; i < points->size(); ++i) visit_point(i, (*points)[i]);
  }
  if (const auto outline = inputs.get(outline_input); outline && reach.vertices) {
    for (std::size_t r = 0; r < outline->rings.size(); ++r)
      for (std::size_t v = 0; v < outline->rings[r].size(); ++v) visit_vertex(Vertex_2{r, v}, outline->rings[r][v]);
  }
}

Inputs with_rings(const Inputs& inputs, Outline_2 outline) {
  if (outline.rings.empty()) return inputs.with(outline_input, std::shared_ptr<const Outline_2>());
  return inputs.with(outline_input, std::move(outline));
}

/// Calls change(position) for each selected one and returns the inputs with what became of them.
template <class Change>
Inputs changed(const Inputs& inputs, const Selection_2& selection, Change change) {
  Inputs result = inputs;
  if (const auto points = inputs.get(points_input); points && !selection.points.empty()) {
    std::vector<Point_2> copy = *points;
    for (const std::size_t i : selection.points)
      if (i < copy.size()) change(copy[i]);
    result = result.with(points_input, std::move(copy));
  }
  if (const auto outline = inputs.get(outline_input); outline && !selection.vertices.empty()) {
    Outline_2 copy = *outline;
    for (const Vertex_2& at : selection.vertices)
      if (at.ring < copy.rings.size() && at.vertex < copy.rings[at.ring].size()) change(copy.rings[at.ring][at.vertex]);
    result = result.with(outline_input, std::move(copy));
  }
  return result;
}

constexpr std::size_t fewest_ring_vertices = 3;

}  // namespace

Selection_2 nearest(const Inputs& inputs, const Reach_2& reach, const Point_2& position, double radius) {
  double best = radius * radius;
  Selection_2 found;
  for_each_handle(
      inputs, reach,
      [&](std::size_t i, const Point_2& p) {
        const double d = squared_distance(p, position);
        if (d < best || (found.is_empty() && d <= best)) {
          best = d;
          found = {{i}, {}};
        }
      },
      [&](const Vertex_2& at, const Point_2& p) {
        const double d = squared_distance(p, position);
        if (d < best || (found.is_empty() && d <= best)) {
          best = d;
          found = {{}, {at}};
        }
      });
  return found;
}

Selection_2 all_of(const Inputs& inputs, const Reach_2& reach) {
  Selection_2 all;
  for_each_handle(
      inputs, reach, [&](std::size_t i, const Point_2&) { all.points.push_back(i); },
      [&](const Vertex_2& at, const Point_2&) { all.vertices.push_back(at); });
  return all;
}

Selection_2 inside(const Inputs& inputs, const Reach_2& reach, const Box& box) {
  const auto is_inside = [&](const Point_2& p) {
    return p.x >= box.lower.x && p.x <= box.upper.x && p.y >= box.lower.y && p.y <= box.upper.y;
  };
  Selection_2 found;
  for_each_handle(
      inputs, reach,
      [&](std::size_t i, const Point_2& p) {
        if (is_inside(p)) found.points.push_back(i);
      },
      [&](const Vertex_2& at, const Point_2& p) {
        if (is_inside(p)) found.vertices.push_back(at);
      });
  return found;
}

Selection_2 toggled(const Selection_2& first, const Selection_2& second) {
  Selection_2 result;
  std::ranges::set_symmetric_difference(first.points, second.points, std::back_inserter(result.points));
  std::ranges::set_symmetric_difference(first.vertices, second.vertices, std::back_inserter(result.vertices));
  return result;
}

Selection_2 united(const Selection_2& first, const Selection_2& second) {
  Selection_2 result;
  std::ranges::set_union(first.points, second.points, std::back_inserter(result.points));
  std::ranges::set_union(first.vertices, second.vertices, std::back_inserter(result.vertices));
  return result;
}

bool contains(const Selection_2& selection, const Selection_2& part) {
  return std::ranges::includes(selection.points, part.points) &&
         std::ranges::includes(selection.vertices, part.vertices);
}

Selection_2 restricted(const Selection_2& selection, const Inputs& inputs) {
  const auto points = inputs.get(points_input);
  const auto outline = inputs.get(outline_input);
  Selection_2 result = selection;
  std::erase_if(result.points, [&](std::size_t i) { return !points || i >= points->size(); });
  std::erase_if(result.vertices, [&](const Vertex_2& at) {
    return !outline || at.ring >= outline->rings.size() || at.vertex >= outline->rings[at.ring].size();
  });
  return result;
}

std::vector<Point_2> positions(const Inputs& inputs, const Selection_2& selection) {
  const Selection_2 known = restricted(selection, inputs);
  std::vector<Point_2> result;
  result.reserve(known.size());
  if (const auto points = inputs.get(points_input))
    for (const std::size_t i : known.points) result.push_back((*points)[i]);
  if (const auto outline = inputs.get(outline_input))
    for (const Vertex_2& at : known.vertices) result.push_back(outline->rings[at.ring][at.vertex]);
  return result;
}

Inputs moved(const Inputs& inputs, const Selection_2& selection, double dx, double dy) {
  return changed(inputs, selection, [&](Point_2& p) { p = {p.x + dx, p.y + dy}; });
}

Inputs placed(const Inputs& inputs, const Selection_2& selection, const Point_2& position) {
  Selection_2 one;
  if (!selection.points.empty()) {
    one.points = {selection.points.front()};
  } else if (!selection.vertices.empty()) {
    one.vertices = {selection.vertices.front()};
  }
  return changed(inputs, one, [&](Point_2& p) { p = position; });
}

Inputs without(const Inputs& inputs, const Selection_2& selection) {
  Inputs result = inputs;
  if (const auto points = inputs.get(points_input); points && !selection.points.empty()) {
    std::vector<Point_2> kept;
    kept.reserve(points->size());
    auto next = selection.points.begin();
    for (std::size_t i = 0; i < points->size(); ++i) {
      if (next != selection.points.end() && *next == i) {
        ++next;
      } else {
        kept.push_back((*points)[i]);
      }
    }
    result = kept.empty() ? result.with(points_input, std::shared_ptr<const std::vector<Point_2>>())
                          : result.with(points_input, std::move(kept));
  }
  if (const auto outline = inputs.get(outline_input); outline && !selection.vertices.empty()) {
    Outline_2 kept;
    auto next = selection.vertices.begin();
    for (std::size_t r = 0; r < outline->rings.size(); ++r) {
      Ring_2 ring;
      for (std::size_t v = 0; v < outline->rings[r].size(); ++v) {
        if (next != selection.vertices.end() && *next == Vertex_2{r, v}) {
          ++next;
        } else {
          ring.push_back(outline->rings[r][v]);
        }
      }
      if (ring.size() >= fewest_ring_vertices) kept.rings.push_back(std::move(ring));
    }
    result = with_rings(result, std::move(kept));
  }
  return result;
}

Inputs with_points(const Inputs& inputs, const std::vector<Point_2>& points) {
  if (points.empty()) return inputs;
  const auto old = inputs.get(points_input);
  std::vector<Point_2> all;
  all.reserve((old ? old->size() : 0) + points.size());
  if (old) all = *old;
  all.insert(all.end(), points.begin(), points.end());
  return inputs.with(points_input, std::move(all));
}

Inputs with_ring(const Inputs& inputs, Ring_2 ring) {
  if (ring.size() < fewest_ring_vertices) return inputs;
  const auto old = inputs.get(outline_input);
  Outline_2 outline = old ? *old : Outline_2();
  outline.rings.push_back(std::move(ring));
  return inputs.with(outline_input, std::move(outline));
}

Inputs appended(const Inputs& inputs, const Inputs& more) {
  Inputs result = inputs;
  if (const auto points = more.get(points_input)) result = with_points(result, *points);
  if (const auto disks = more.get(disks_input)) {
    const auto old = result.get(disks_input);
    std::vector<Disk_2> all = old ? *old : std::vector<Disk_2>();
    all.insert(all.end(), disks->begin(), disks->end());
    result = result.with(disks_input, std::move(all));
  }
  if (const auto outline = more.get(outline_input)) {
    const auto old = result.get(outline_input);
    Outline_2 all = old ? *old : Outline_2();
    all.rings.insert(all.rings.end(), outline->rings.begin(), outline->rings.end());
    result = result.with(outline_input, std::move(all));
  }
  if (const auto image = more.get(image_input)) result = result.with(image_input, image);
  return result;
}

std::pair<Inputs, Selection_2> duplicated(const Inputs& inputs, const Selection_2& selection, double dx, double dy) {
  const Selection_2 known = restricted(selection, inputs);
  Inputs result = inputs;
  Selection_2 copies;
  if (const auto points = inputs.get(points_input)) {
    std::vector<Point_2> added;
    for (const std::size_t i : known.points) {
      copies.points.push_back(points->size() + added.size());
      added.push_back({(*points)[i].x + dx, (*points)[i].y + dy});
    }
    result = with_points(result, added);
  }
  if (const auto outline = inputs.get(outline_input)) {
    std::size_t rings = outline->rings.size();
    for (std::size_t r = 0; r < outline->rings.size(); ++r) {
      const auto count = std::ranges::count(known.vertices, r, &Vertex_2::ring);
      if (static_cast<std::size_t>(count) != outline->rings[r].size() || count == 0) continue;
      Ring_2 ring = outline->rings[r];
      for (std::size_t v = 0; v < ring.size(); ++v) {
        ring[v] = {ring[v].x + dx, ring[v].y + dy};
        copies.vertices.push_back({rings, v});
      }
      result = with_ring(result, std::move(ring));
      ++rings;
    }
  }
  return {std::move(result), std::move(copies)};
}

std::string to_table(const std::vector<Point_2>& points) {
  std::string text;
  for (const Point_2& p : points) {
    append_number(text, p.x);
    text += ' ';
    append_number(text, p.y);
    text += '\n';
  }
  return text;
}

}  // namespace mesecina

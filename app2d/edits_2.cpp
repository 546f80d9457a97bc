// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/edits_2.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string_view>

#include "core/formats/number.h"
#include "core/input_elements.h"

namespace mesecina {

namespace {

/// What can be taken hold of, by its position; disks by their center.
void for_each_handle(const Inputs& inputs, const Reach_2& reach, auto visit_point, auto visit_vertex, auto visit_disk) {
  if (const auto points = inputs.get(points_input); points && reach.points) {
    for (std::size_t i = 0; i < points->size(); ++i) visit_point(i, (*points)[i]);
  }
  if (const auto outline = inputs.get(outline_input); outline && reach.vertices) {
    for (std::size_t r = 0; r < outline->rings.size(); ++r)
      for (std::size_t v = 0; v < outline->rings[r].size(); ++v) visit_vertex(Vertex_2{r, v}, outline->rings[r][v]);
  }
  if (const auto disks = inputs.get(disks_input); disks && reach.disks) {
    for (std::size_t i = 0; i < disks->size(); ++i) visit_disk(i, (*disks)[i].center);
  }
}

Inputs with_rings(const Inputs& inputs, Outline_2 outline) {
  if (outline.rings.empty()) return inputs.with(outline_input, std::shared_ptr<const Outline_2>());
  return inputs.with(outline_input, std::move(outline));
}

/// Calls change(position) for each selected one and returns the inputs with what became of them.
template <class Change>
Inputs changed(const Inputs& inputs, const Selection_2& selection, Change change) {
  Inputs result = changed_elements(inputs, points_input, selection.points, change);
  if (const auto outline = inputs.get(outline_input); outline && !selection.vertices.empty()) {
    Outline_2 copy = *outline;
    for (const Vertex_2& at : selection.vertices)
      if (at.ring < copy.rings.size() && at.vertex < copy.rings[at.ring].size()) change(copy.rings[at.ring][at.vertex]);
    result = result.with(outline_input, std::move(copy));
  }
  return changed_elements(result, disks_input, selection.disks, [&](Disk_2& disk) { change(disk.center); });
}

/// The disk whose boundary is nearest within `radius`; empty if there is none.
Selection_2 nearest_boundary(const Inputs& inputs, const Point_2& position, double radius) {
  Selection_2 found;
  const auto disks = inputs.get(disks_input);
  if (!disks) return found;
  double best = radius;
  for (std::size_t i = 0; i < disks->size(); ++i) {
    const Disk_2& disk = (*disks)[i];
    const double d = std::abs(distance(disk.center, position) - disk.radius);
    if (d < best || (found.is_empty() && d <= best)) {
      best = d;
      found.disks = {i};
    }
  }
  return found;
}

constexpr std::string_view point_columns = "x y";
constexpr std::string_view disk_columns = "x y radius";
constexpr std::size_t fewest_ring_vertices = 3;

}  // namespace

Selection_2 nearest(const Inputs& inputs, const Reach_2& reach, const Point_2& position, double radius) {
  double best = radius * radius;
  Selection_2 found;
  const auto take = [&](const Point_2& p, const auto& make_selection) {
    const double d = squared_distance(p, position);
    if (d < best || (found.is_empty() && d <= best)) {
      best = d;
      found = make_selection();
    }
  };
  for_each_handle(
      inputs, reach, [&](std::size_t i, const Point_2& p) { take(p, [i] {
                                                              return Selection_2{{i}, {}, {}};
                                                            }); },
      [&](const Vertex_2& at, const Point_2& p) { take(p, [at] {
                                                    return Selection_2{{}, {at}, {}};
                                                  }); },
      [&](std::size_t i, const Point_2& p) { take(p, [i] {
                                               return Selection_2{{}, {}, {i}};
                                             }); });
  return found.is_empty() && reach.disks ? nearest_boundary(inputs, position, radius) : found;
}

Selection_2 all_of(const Inputs& inputs, const Reach_2& reach) {
  Selection_2 all;
  for_each_handle(
      inputs, reach, [&](std::size_t i, const Point_2&) { all.points.push_back(i); },
      [&](const Vertex_2& at, const Point_2&) { all.vertices.push_back(at); },
      [&](std::size_t i, const Point_2&) { all.disks.push_back(i); });
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
      },
      [&](std::size_t i, const Point_2& p) {
        if (is_inside(p)) found.disks.push_back(i);
      });
  return found;
}

Selection_2 toggled(const Selection_2& first, const Selection_2& second) {
  Selection_2 result;
  std::ranges::set_symmetric_difference(first.points, second.points, std::back_inserter(result.points));
  std::ranges::set_symmetric_difference(first.vertices, second.vertices, std::back_inserter(result.vertices));
  std::ranges::set_symmetric_difference(first.disks, second.disks, std::back_inserter(result.disks));
  return result;
}

Selection_2 united(const Selection_2& first, const Selection_2& second) {
  Selection_2 result;
  std::ranges::set_union(first.points, second.points, std::back_inserter(result.points));
  std::ranges::set_union(first.vertices, second.vertices, std::back_inserter(result.vertices));
  std::ranges::set_union(first.disks, second.disks, std::back_inserter(result.disks));
  return result;
}

bool contains(const Selection_2& selection, const Selection_2& part) {
  return std::ranges::includes(selection.points, part.points) &&
         std::ranges::includes(selection.vertices, part.vertices) && std::ranges::includes(selection.disks, part.disks);
}

Selection_2 restricted(const Selection_2& selection, const Inputs& inputs) {
  const auto points = inputs.get(points_input);
  const auto outline = inputs.get(outline_input);
  const auto disks = inputs.get(disks_input);
  Selection_2 result = selection;
  std::erase_if(result.points, [&](std::size_t i) { return !points || i >= points->size(); });
  std::erase_if(result.vertices, [&](const Vertex_2& at) {
    return !outline || at.ring >= outline->rings.size() || at.vertex >= outline->rings[at.ring].size();
  });
  std::erase_if(result.disks, [&](std::size_t i) { return !disks || i >= disks->size(); });
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
  if (const auto disks = inputs.get(disks_input))
    for (const std::size_t i : known.disks) result.push_back((*disks)[i].center);
  return result;
}

std::vector<Disk_2> selected_disks(const Inputs& inputs, const Selection_2& selection) {
  const Selection_2 known = restricted(selection, inputs);
  std::vector<Disk_2> result;
  result.reserve(known.disks.size());
  if (const auto disks = inputs.get(disks_input))
    for (const std::size_t i : known.disks) result.push_back((*disks)[i]);
  return result;
}

Inputs moved(const Inputs& inputs, const Selection_2& selection, double dx, double dy) {
  return changed(inputs, selection, [&](Point_2& p) { p = {p.x + dx, p.y + dy}; });
}

Inputs resized(const Inputs& inputs, const Selection_2& selection, double factor) {
  return changed_elements(inputs, disks_input, selection.disks, [factor](Disk_2& disk) {
    const double radius = disk.radius * factor;
    if (radius > 0 && std::isfinite(radius)) disk.radius = radius;
  });
}

Inputs with_disk(const Inputs& inputs, std::size_t index, const Disk_2& disk) {
  return changed_elements(inputs, disks_input, {index}, [&disk](Disk_2& changed_disk) { changed_disk = disk; });
}

Inputs placed(const Inputs& inputs, const Selection_2& selection, const Point_2& position) {
  Selection_2 one;
  if (!selection.points.empty()) {
    one.points = {selection.points.front()};
  } else if (!selection.vertices.empty()) {
    one.vertices = {selection.vertices.front()};
  } else if (!selection.disks.empty()) {
    one.disks = {selection.disks.front()};
  }
  return changed(inputs, one, [&](Point_2& p) { p = position; });
}

Inputs without(const Inputs& inputs, const Selection_2& selection) {
  Inputs result = without_elements(inputs, points_input, selection.points);
  result = without_elements(result, disks_input, selection.disks);
  if (const auto outline = inputs.get(outline_input); outline && !selection.vertices.empty()) {
    Outline_2 rest;
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
      if (ring.size() >= fewest_ring_vertices) rest.rings.push_back(std::move(ring));
    }
    result = with_rings(result, std::move(rest));
  }
  return result;
}

Inputs with_points(const Inputs& inputs, const std::vector<Point_2>& points) {
  return with_elements(inputs, points_input, points);
}

Inputs with_disks(const Inputs& inputs, const std::vector<Disk_2>& disks) {
  return with_elements(inputs, disks_input, disks);
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
  if (const auto disks = more.get(disks_input)) result = with_disks(result, *disks);
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
  if (const auto disks = inputs.get(disks_input)) {
    std::vector<Disk_2> added;
    for (const std::size_t i : known.disks) {
      copies.disks.push_back(disks->size() + added.size());
      const Disk_2& disk = (*disks)[i];
      added.push_back({{disk.center.x + dx, disk.center.y + dy}, disk.radius});
    }
    result = with_disks(result, added);
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

std::string to_table(const std::vector<Point_2>& points, const std::vector<Disk_2>& disks) {
  std::string text;
  const bool has_both = !points.empty() && !disks.empty();
  if (has_both) (text += point_columns) += '\n';
  for (const Point_2& p : points) {
    append_number(text, p.x);
    text += ' ';
    append_number(text, p.y);
    text += '\n';
  }
  if (has_both) (text += disk_columns) += '\n';
  for (const Disk_2& disk : disks) {
    append_number(text, disk.center.x);
    text += ' ';
    append_number(text, disk.center.y);
    text += ' ';
    append_number(text, disk.radius);
    text += '\n';
  }
  return text;
}

std::vector<std::string> table_parts(const std::string& text) {
  std::vector<std::string> parts(1);
  std::size_t lines = 0;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line); ++lines) {
    if (line.ends_with('\r')) line.pop_back();
    if (lines > 0 && (line == point_columns || line == disk_columns)) parts.emplace_back(lines, '\n');
    (parts.back() += line) += '\n';
  }
  return parts;
}

}  // namespace mesecina

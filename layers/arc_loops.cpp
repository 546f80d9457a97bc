// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/arc_loops.h"

#include <cmath>
#include <numbers>
#include <numeric>

namespace mesecina {
namespace {

bool is_sound(const Primitive_set& set, const Arc& arc) {
  const Point_3& p = set.vertices[arc.from];
  const Point_3& q = set.vertices[arc.to];
  return arc.radius > 0 && std::isfinite(arc.radius) && std::isfinite(arc.center.x) && std::isfinite(arc.center.y) &&
         std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(q.x) && std::isfinite(q.y);
}

/// The arcs as edges of a graph, from which edges are taken away. Whole circles are not in it.
class Arc_graph {
 public:
  Arc_graph(const Primitive_set& set, const std::vector<bool>& drawn);

  void remove_what_hangs();
  void remove_odd_components();
  bool has(int arc) const { return present_[static_cast<std::size_t>(arc)]; }
  bool is_circle(int arc) const { return circles_[static_cast<std::size_t>(arc)]; }
  /// Takes the arcs of a closed walk away, from the start of `first` on, and adds them to the steps.
  void take_walk(int first, std::vector<Arc_step>& steps);

 private:
  const Arc& arc(int i) const { return set_.arcs[static_cast<std::size_t>(i)]; }
  int& degree(int vertex) { return degrees_[static_cast<std::size_t>(vertex)]; }
  void remove(int i) {
    present_[static_cast<std::size_t>(i)] = false;
    --degree(arc(i).from);
    --degree(arc(i).to);
  }
  /// An arc that is there at the vertex, which must have one.
  int any_at(int vertex);

  const Primitive_set& set_;
  std::vector<bool> present_;
  std::vector<bool> circles_;
  std::vector<int> degrees_;
  std::vector<int> next_;      ///< per vertex the first place in `incident_` not known to be of a removed arc
  std::vector<int> incident_;  ///< arcs at vertex 0, then those at vertex 1, ...
};

Arc_graph::Arc_graph(const Primitive_set& set, const std::vector<bool>& drawn)
    : set_(set),
      present_(set.arcs.size(), false),
      circles_(set.arcs.size(), false),
      degrees_(set.vertices.size(), 0),
      next_(set.vertices.size() + 1, 0) {
  const std::size_t first = set.points.size() + set.segments.size() + set.rays.size();
  for (std::size_t i = 0; i < set.arcs.size(); ++i) {
    const Arc& each = set.arcs[i];
    if ((!drawn.empty() && !drawn[first + i]) || !is_sound(set, each)) continue;
    if (each.from == each.to) {
      circles_[i] = true;
      continue;
    }
    present_[i] = true;
    ++degree(each.from);
    ++degree(each.to);
  }
  std::partial_sum(degrees_.begin(), degrees_.end(), next_.begin() + 1);
  incident_.resize(static_cast<std::size_t>(next_.back()));
  std::vector<int> place(next_.begin(), next_.end() - 1);
  for (std::size_t i = 0; i < set.arcs.size(); ++i) {
    if (!present_[i]) continue;
    for (const int vertex : {set.arcs[i].from, set.arcs[i].to})
      incident_[static_cast<std::size_t>(place[static_cast<std::size_t>(vertex)]++)] = static_cast<int>(i);
  }
}

int Arc_graph::any_at(int vertex) {
  int& place = next_[static_cast<std::size_t>(vertex)];
  while (!has(incident_[static_cast<std::size_t>(place)])) ++place;
  return incident_[static_cast<std::size_t>(place)];
}

void Arc_graph::remove_what_hangs() {
  for (std::size_t v = 0; v < degrees_.size(); ++v) {
    int vertex = static_cast<int>(v);
    while (degree(vertex) == 1) {
      const int last = any_at(vertex);
      const int other = arc(last).from == vertex ? arc(last).to : arc(last).from;
      remove(last);
      vertex = other;
    }
  }
}

void Arc_graph::remove_odd_components() {
  std::vector<int> parent(degrees_.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root_of = [&](int vertex) {
    std::size_t v = static_cast<std::size_t>(vertex);
    while (parent[v] != static_cast<int>(v)) {
      parent[v] = parent[static_cast<std::size_t>(parent[v])];
      v = static_cast<std::size_t>(parent[v]);
    }
    return v;
  };
  const int count = static_cast<int>(present_.size());
  for (int i = 0; i < count; ++i)
    if (has(i)) parent[root_of(arc(i).from)] = static_cast<int>(root_of(arc(i).to));
  std::vector<bool> is_odd(degrees_.size(), false);
  for (std::size_t v = 0; v < degrees_.size(); ++v)
    if (degrees_[v] % 2 != 0) is_odd[root_of(static_cast<int>(v))] = true;
  for (int i = 0; i < count; ++i)
    if (has(i) && is_odd[root_of(arc(i).from)]) remove(i);
}

void Arc_graph::take_walk(int first, std::vector<Arc_step>& steps) {
  const int start = arc(first).from;
  int vertex = start;
  int next = first;
  while (true) {
    const bool is_backward = arc(next).from != vertex;
    steps.push_back({next, is_backward});
    vertex = is_backward ? arc(next).from : arc(next).to;
    remove(next);
    if (vertex == start) return;
    next = any_at(vertex);
  }
}

}  // namespace

Arc_loops closed_loops(const Primitive_set& set, const std::vector<bool>& drawn) {
  Arc_graph graph(set, drawn);
  graph.remove_what_hangs();
  graph.remove_odd_components();
  Arc_loops loops;
  loops.steps.reserve(set.arcs.size());
  for (int i = 0; i < static_cast<int>(set.arcs.size()); ++i) {
    if (graph.is_circle(i)) {
      loops.steps.push_back({i, false});
    } else if (graph.has(i)) {
      graph.take_walk(i, loops.steps);
    } else {
      continue;
    }
    loops.ends.push_back(loops.steps.size());
  }
  return loops;
}

Pixel_arc planar_arc(const Primitive_set& set, const Arc_step& step) {
  const Arc& arc = set.arcs[static_cast<std::size_t>(step.arc)];
  const auto at = [&](int vertex) { return Point_2{set.vertices[vertex].x, set.vertices[vertex].y}; };
  const bool grows = arc.counterclockwise != step.is_backward;
  const Point_2 from = at(step.is_backward ? arc.to : arc.from);
  const Point_2 to = at(step.is_backward ? arc.from : arc.to);
  Pixel_arc result = arc_between(arc.center, arc.radius, from, to, !grows);
  if (arc.from == arc.to) result.sweep = (grows ? 2 : -2) * std::numbers::pi;
  return result;
}

}  // namespace mesecina

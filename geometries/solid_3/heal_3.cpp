// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/heal_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/utility.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "geometries/solid_3/box_tree_3.h"

namespace mesecina {

namespace {

double area_of(const Triangle_mesh_3& mesh, const std::array<int, 3>& t) {
  const Point_3 normal = cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
  return std::sqrt(dot(normal, normal)) / 2;
}

double area_of(const Triangle_mesh_3& mesh) {
  return std::accumulate(mesh.triangles.begin(), mesh.triangles.end(), 0.0,
                         [&](double sum, const std::array<int, 3>& t) { return sum + area_of(mesh, t); });
}

std::vector<int> open_half_edges(const Mesh_edges_3& edges) {
  std::vector<int> result;
  for (const std::vector<int>& edge : edges.irregular)
    if (edge.size() % 2 == 1) result.insert(result.end(), edge.begin(), edge.end());
  std::ranges::sort(result);
  return result;
}

std::vector<int> ends_of(const Triangle_mesh_3& mesh, const std::vector<int>& half_edges) {
  std::vector<int> result;
  for (const int h : half_edges) {
    result.push_back(half_edge_source(mesh, h));
    result.push_back(half_edge_target(mesh, h));
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Box widened(Box box, double by) {
  const Point_3 step{by, by, by};
  return {box.lower - step, box.upper + step};
}

/// Cleans what was changed, and keeps the counts.
void clean_again(Clean_mesh_3& clean) {
  Clean_mesh_3 next = clean_mesh(clean.mesh);
  clean.mesh = std::move(next.mesh);
  clean.edges = std::move(next.edges);
  clean.flat_triangles += next.flat_triangles;
  clean.duplicate_triangles += next.duplicate_triangles;
}

void join_near_ends(Clean_mesh_3& clean, double tolerance, Stitched_3& result, Progress& progress) {
  Triangle_mesh_3& mesh = clean.mesh;
  const std::vector<int> ends = ends_of(mesh, open_half_edges(clean.edges));
  std::vector<Box> boxes;
  boxes.reserve(ends.size());
  for (const int v : ends) boxes.push_back({mesh.vertices[v], mesh.vertices[v]});
  const Box_tree_3 tree(boxes, progress);
  std::vector<int> joined(mesh.vertices.size());
  std::iota(joined.begin(), joined.end(), 0);
  bool is_changed = false;
  for (const int v : ends) {
    if (joined[v] != v) continue;
    const Box near = widened({mesh.vertices[v], mesh.vertices[v]}, tolerance);
    tree.visit([&](const Box& box) { return do_meet(box, near); },
               [&](int i) {
                 const int w = ends[tree.order()[i]];
                 if (w <= v || joined[w] != w) return true;
                 const double apart = distance(mesh.vertices[v], mesh.vertices[w]);
                 if (apart > tolerance) return true;
                 joined[w] = v;
                 is_changed = true;
                 ++result.joined_vertices;
                 result.farthest = std::max(result.farthest, apart);
                 return true;
               });
  }
  if (!is_changed) return;
  for (std::array<int, 3>& t : mesh.triangles)
    for (int& v : t) v = joined[v];
  std::erase_if(mesh.triangles,
                [](const std::array<int, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  clean_again(clean);
}

/// A triangle and, per edge from corner k to corner k + 1, the vertices at which it is split, in order.
struct Split_triangle {
  std::array<int, 3> corners{};
  std::array<std::vector<int>, 3> on_edge;
};

void add_parts(const Split_triangle& whole, std::vector<std::array<int, 3>>& parts) {
  std::size_t k = 0;
  while (k < 3 && whole.on_edge[k].empty()) ++k;
  if (k == 3) {
    parts.push_back(whole.corners);
    return;
  }
  const std::vector<int>& on_edge = whole.on_edge[k];
  const std::size_t middle = on_edge.size() / 2;
  const int from = whole.corners[k];
  const int to = whole.corners[(k + 1) % 3];
  const int across = whole.corners[(k + 2) % 3];
  const auto at = [&](std::size_t i) { return on_edge.begin() + static_cast<std::ptrdiff_t>(i); };
  add_parts({{from, on_edge[middle], across}, {std::vector<int>(at(0), at(middle)), {}, whole.on_edge[(k + 2) % 3]}},
            parts);
  add_parts({{on_edge[middle], to, across},
             {std::vector<int>(at(middle + 1), on_edge.end()), whole.on_edge[(k + 1) % 3], {}}},
            parts);
}

void split_at_ends(Clean_mesh_3& clean, double tolerance, Stitched_3& result, Progress& progress) {
  Triangle_mesh_3& mesh = clean.mesh;
  const std::vector<int> open = open_half_edges(clean.edges);
  const std::vector<int> ends = ends_of(mesh, open);
  std::vector<Box> boxes;
  boxes.reserve(ends.size());
  for (const int v : ends) boxes.push_back({mesh.vertices[v], mesh.vertices[v]});
  const Box_tree_3 tree(boxes, progress);
  std::map<int, Split_triangle> splits;
  for (const int h : open) {
    const Point_3& p = mesh.vertices[half_edge_source(mesh, h)];
    const Point_3 along = mesh.vertices[half_edge_target(mesh, h)] - p;
    Box near;
    near.add(p);
    near.add(p + along);
    near = widened(near, tolerance);
    std::vector<std::pair<double, int>> between;
    tree.visit([&](const Box& box) { return do_meet(box, near); },
               [&](int i) {
                 const int v = ends[tree.order()[i]];
                 if (std::ranges::find(mesh.triangles[h / 3], v) != mesh.triangles[h / 3].end()) return true;
                 const double where = dot(along, mesh.vertices[v] - p) / dot(along, along);
                 if (!(where > 0 && where < 1)) return true;
                 const double apart = distance(mesh.vertices[v], p + where * along);
                 if (apart > tolerance) return true;
                 between.emplace_back(where, v);
                 result.farthest = std::max(result.farthest, apart);
                 return true;
               });
    if (between.empty()) continue;
    std::ranges::sort(between);
    Split_triangle& split = splits[h / 3];
    split.corners = mesh.triangles[h / 3];
    for (const auto& [where, v] : between) split.on_edge[h % 3].push_back(v);
    ++result.split_edges;
  }
  if (splits.empty()) return;
  std::vector<std::array<int, 3>> parts;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    if (const auto split = splits.find(t); split != splits.end()) {
      add_parts(split->second, parts);
    } else {
      parts.push_back(mesh.triangles[t]);
    }
  }
  mesh.triangles = std::move(parts);
  std::erase_if(mesh.triangles,
                [](const std::array<int, 3>& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  clean_again(clean);
}

/// Sets of triangles joined by edges of two.
std::vector<int> find_patches(const Mesh_edges_3& edges) {
  std::vector<int> patch(edges.twin.size() / 3, -1);
  std::vector<int> stack;
  int count = 0;
  for (int seed = 0; seed < static_cast<int>(patch.size()); ++seed) {
    if (patch[seed] >= 0) continue;
    patch[seed] = count;
    stack.push_back(seed);
    while (!stack.empty()) {
      const int t = stack.back();
      stack.pop_back();
      for (int h = 3 * t; h < 3 * t + 3; ++h) {
        if (edges.twin[h] < 0 || patch[edges.twin[h] / 3] >= 0) continue;
        patch[edges.twin[h] / 3] = count;
        stack.push_back(edges.twin[h] / 3);
      }
    }
    ++count;
  }
  return patch;
}

/// The boundaries of holes, against the direction of their triangles; no vertex twice in one. Empty where the open
/// edges do not form such curves.
std::vector<std::vector<int>> find_holes(const Clean_mesh_3& clean) {
  const Mesh_edges_3& edges = clean.edges;
  const auto next_in_triangle = [](int h) { return 3 * (h / 3) + (h + 1) % 3; };
  std::vector<int> open;
  for (const std::vector<int>& edge : edges.irregular) {
    if (edge.size() % 2 == 0) continue;
    if (edge.size() > 1) return {};
    open.push_back(edge[0]);
  }
  std::ranges::sort(open);
  std::vector<std::uint8_t> is_walked(edges.twin.size(), 0);
  std::vector<std::vector<int>> result;
  for (const int start : open) {
    if (is_walked[start]) continue;
    std::vector<int> curve;
    for (int h = start; !is_walked[h];) {
      is_walked[h] = 1;
      const int v = half_edge_source(clean.mesh, h);
      if (const auto seen = std::ranges::find(curve, v); seen != curve.end()) {
        result.emplace_back(seen, curve.end());
        curve.erase(seen, curve.end());
      }
      curve.push_back(v);
      // Around the end of the edge, through the triangles, to the open edge that leaves it.
      int g = next_in_triangle(h);
      while (edges.twin[g] >= 0) {
        if (half_edge_source(clean.mesh, g) != half_edge_target(clean.mesh, edges.twin[g])) return {};
        g = next_in_triangle(edges.twin[g]);
      }
      if (!std::ranges::binary_search(open, g)) return {};
      h = g;
    }
    result.push_back(std::move(curve));
  }
  for (std::vector<int>& curve : result) std::ranges::reverse(curve);
  return result;
}

}  // namespace

Stitched_3 stitch(Clean_mesh_3& clean, double tolerance, Progress& progress) {
  Stitched_3 result;
  // Splitting may leave triangles without area, whose removal opens edges with vertices on them.
  constexpr int rounds = 4;
  for (int round = 0; round < rounds && clean.edges.is_open(); ++round) {
    const int changes = result.joined_vertices + result.split_edges;
    join_near_ends(clean, tolerance, result, progress);
    if (clean.edges.is_open()) split_at_ends(clean, tolerance, result, progress);
    if (changes == result.joined_vertices + result.split_edges) break;
  }
  return result;
}

Removed_patches_3 remove_fins(Clean_mesh_3& clean, double largest) {
  Removed_patches_3 result;
  Triangle_mesh_3& mesh = clean.mesh;
  const std::vector<int> patch = find_patches(clean.edges);
  const int count = patch.empty() ? 0 : 1 + std::ranges::max(patch);
  std::vector<double> area(count, 0);
  double total = 0;
  for (std::size_t t = 0; t < patch.size(); ++t) {
    area[patch[t]] += area_of(mesh, mesh.triangles[t]);
    total += area_of(mesh, mesh.triangles[t]);
  }
  std::vector<std::vector<int>> boundary(count);  // irregular edges, as often as the patch is there
  std::vector<std::size_t> degree;
  for (const std::vector<int>& edge : clean.edges.irregular) {
    for (const int h : edge) boundary[patch[h / 3]].push_back(static_cast<int>(degree.size()));
    degree.push_back(edge.size());
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](int a, int b) { return area[a] != area[b] ? area[a] < area[b] : a < b; });
  std::vector<std::uint8_t> is_removed(count, 0);
  for (const int p : order) {
    const std::vector<int>& edges = boundary[p];
    const bool is_fin = area[p] <= largest * total &&
                        std::ranges::all_of(edges, [&](int e) { return degree[e] % 2 == 1; }) &&
                        std::ranges::any_of(edges, [&](int e) { return degree[e] >= 3; });
    if (!is_fin) continue;
    is_removed[p] = 1;
    for (const int e : edges) --degree[e];
    ++result.patches;
    result.area += area[p];
  }
  if (result.patches == 0) return result;
  std::vector<std::array<int, 3>> kept;
  for (std::size_t t = 0; t < patch.size(); ++t)
    if (!is_removed[patch[t]]) kept.push_back(mesh.triangles[t]);
  result.triangles = static_cast<int>(patch.size() - kept.size());
  mesh.triangles = std::move(kept);
  clean_again(clean);
  return result;
}

Filled_holes_3 fill_holes(Clean_mesh_3& clean, Progress& progress) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  constexpr std::size_t longest_boundary = 1000;
  Filled_holes_3 result;
  std::vector<std::array<int, 3>> added;
  for (const std::vector<int>& hole : find_holes(clean)) {
    if (hole.size() < 3 || hole.size() > longest_boundary) return {};
    progress.check();
    std::vector<Kernel::Point_3> points;
    double length = 0;
    for (std::size_t i = 0; i < hole.size(); ++i) {
      const Point_3& p = clean.mesh.vertices[hole[i]];
      points.emplace_back(p.x, p.y, p.z);
      length += distance(p, clean.mesh.vertices[hole[(i + 1) % hole.size()]]);
    }
    std::vector<CGAL::Triple<int, int, int>> patch;
    CGAL::Polygon_mesh_processing::triangulate_hole_polyline(points, std::back_inserter(patch));
    if (patch.size() + 2 != hole.size()) return {};
    for (const auto& corners : patch) {
      // In the order of the boundary they have its direction.
      std::array<int, 3> t{corners.first, corners.second, corners.third};
      std::ranges::sort(t);
      added.push_back({hole[t[0]], hole[t[1]], hole[t[2]]});
    }
    ++result.holes;
    result.longest = std::max(result.longest, length);
  }
  if (added.empty()) return {};
  const double before = area_of(clean.mesh);
  result.triangles = static_cast<int>(added.size());
  for (const std::array<int, 3>& t : added) result.area += area_of(clean.mesh, t) / before;
  Clean_mesh_3 filled = clean;
  filled.mesh.triangles.insert(filled.mesh.triangles.end(), added.begin(), added.end());
  clean_again(filled);
  if (filled.edges.is_open()) return {};
  clean = std::move(filled);
  result.is_done = true;
  return result;
}

}  // namespace mesecina

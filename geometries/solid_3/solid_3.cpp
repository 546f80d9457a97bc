// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/solid_3/solid_3.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/outcome.h"
#include "geometries/parallel.h"
#include "geometries/solid_3/clean_mesh_3.h"
#include "geometries/solid_3/crossing_boundary_3.h"
#include "geometries/solid_3/heal_3.h"
#include "geometries/solid_3/nesting_3.h"
#include "geometries/solid_3/self_crossings_3.h"
#include "geometries/solid_3/surface_locator_3.h"
#include "geometries/solid_3/wrap_3.h"

namespace mesecina {

namespace {

/// How many vertices there are when a surface that touches itself in points is taken apart there: one per fan of
/// triangles. Every edge has two triangles, oriented alike.
std::int64_t count_fans(const Mesh_edges_3& edges) {
  std::vector<std::uint8_t> is_seen(edges.twin.size(), 0);
  std::int64_t result = 0;
  for (int h = 0; h < static_cast<int>(edges.twin.size()); ++h) {
    if (is_seen[h]) continue;
    ++result;
    // Around its source: across the half-edge that arrives there in the same triangle is the next one that leaves it.
    for (int g = h; !is_seen[g]; g = edges.twin[3 * (g / 3) + (g + 2) % 3]) is_seen[g] = 1;
  }
  return result;
}

/// Of the solid, from its surface: the boundary of a solid has twice its Euler characteristic.
Topology topology_of(std::int64_t vertices, const Triangle_mesh_3& surface, const std::vector<int>& depth) {
  const auto triangles = static_cast<std::int64_t>(surface.triangles.size());
  Topology result;
  result.euler = (vertices - triangles / 2) / 2;
  result.betti[0] = std::ranges::count_if(depth, [](int d) { return d % 2 == 0; });
  result.betti[2] = std::ranges::count_if(depth, [](int d) { return d % 2 == 1; });
  result.betti[1] = result.betti[0] + result.betti[2] - result.euler;
  return result;
}

/// The surface on its way to being that of a solid.
struct Work {
  Triangle_mesh_3 mesh;
  Mesh_edges_3 edges;
  Mesh_components_3 parts;
  std::shared_ptr<const Surface_locator_3> locator;
  std::vector<std::array<int, 2>> crossings;
  bool has_too_many_crossings = false;
  std::vector<std::string> treatments;
  std::vector<std::string> remarks;
};

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// "0.0012": three digits, in the C locale.
std::string short_number(double x) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 3);
  return {text.data(), end.ptr};
}

double diagonal_of(const Triangle_mesh_3& mesh) {
  Box box;
  for (const Point_3& p : mesh.vertices) box.add(p);
  return box.diagonal();
}

void turn(std::array<int, 3>& triangle) { std::swap(triangle[1], triangle[2]); }

void remark_on_cleaning(const Clean_mesh_3& clean, std::vector<std::string>& remarks) {
  if (clean.joined_vertices > 0)
    remarks.push_back(counted(clean.joined_vertices, "vertex was", "vertices were") +
                      " joined with another one at the same place.");
  if (clean.endless_triangles > 0)
    remarks.push_back(counted(clean.endless_triangles, "triangle was", "triangles were") +
                      " left out: not all coordinates are finite numbers.");
  if (clean.flat_triangles > 0)
    remarks.push_back(counted(clean.flat_triangles, "triangle", "triangles") + " without area left out.");
  if (clean.duplicate_triangles > 0)
    remarks.push_back(counted(clean.duplicate_triangles, "triangle", "triangles") +
                      " with the corners of another one left out.");
}

/// Finds all that can be said of a mesh without open edges, and orients what can be oriented.
void examine(Work& work, Progress& progress) {
  work.parts = orient_components(work.mesh, work.edges);
  if (work.parts.turned_triangles > 0) {
    for (std::size_t t = 0; t < work.mesh.triangles.size(); ++t)
      if (work.parts.flipped[t]) turn(work.mesh.triangles[t]);
    work.edges = find_edges(work.mesh);
  }
  work.locator = std::make_shared<Surface_locator_3>(work.mesh, progress);
  // More than this are no accidents, and cost more than a wrap.
  const std::size_t limit = 20000 + work.mesh.triangles.size() / 4;
  work.crossings = find_self_crossings(work.mesh, *work.locator, limit, progress);
  work.has_too_many_crossings = work.crossings.size() >= limit;
}

bool is_clean(const Work& work) {
  return work.edges.irregular.empty() && work.crossings.empty() && std::ranges::count(work.parts.is_oriented, 0) == 0;
}

/// Times six, relative to some point near it.
std::vector<double> signed_volumes(const Work& work) {
  std::vector<double> result(work.parts.count, 0);
  const Point_3 origin = midpoint(work.locator->tree().box().lower, work.locator->tree().box().upper);
  for (std::size_t t = 0; t < work.mesh.triangles.size(); ++t) {
    const auto& [u, v, w] = work.mesh.triangles[t];
    result[work.parts.component[t]] +=
        dot(work.mesh.vertices[u] - origin, cross(work.mesh.vertices[v] - origin, work.mesh.vertices[w] - origin));
  }
  return result;
}

/// The boundary of the union of components that cross each other, and of the inside of those that cross themselves.
/// False where that takes too long or nothing is inside.
bool resolve_crossings(Work& work, Progress& progress) {
  const int count = work.parts.count;
  Disjoint_sets groups(count);
  std::vector<std::uint8_t> is_tangled(count, 0);
  for (const auto& [s, t] : work.crossings) {
    groups.join(work.parts.component[s], work.parts.component[t]);
    is_tangled[work.parts.component[s]] = is_tangled[work.parts.component[t]] = 1;
  }
  for (const std::vector<int>& edge : work.edges.irregular) is_tangled[work.parts.component[edge[0] / 3]] = 1;
  for (int c = 0; c < count; ++c)
    if (!work.parts.is_oriented[c]) is_tangled[c] = 1;

  Crossing_clusters_3 clusters;
  clusters.rule.assign(count, Inside_rule::as_it_is);
  int disoriented = 0;
  for (int c = 0; c < count; ++c) {
    if (!is_tangled[c]) continue;
    Inside_rule& rule = clusters.rule[groups.find(c)];
    if (!work.parts.is_oriented[c]) {
      rule = Inside_rule::odd;
      ++disoriented;
    } else if (rule == Inside_rule::as_it_is) {
      rule = Inside_rule::positive;
    }
  }
  const std::vector<double> volumes = signed_volumes(work);
  int turned = 0;
  for (int c = 0; c < count; ++c)
    if (is_tangled[c] && work.parts.is_oriented[c] && volumes[c] < 0) ++turned;
  clusters.cluster.reserve(work.mesh.triangles.size());
  for (std::size_t t = 0; t < work.mesh.triangles.size(); ++t) {
    const int c = work.parts.component[t];
    clusters.cluster.push_back(groups.find(c));
    if (turned > 0 && is_tangled[c] && work.parts.is_oriented[c] && volumes[c] < 0) turn(work.mesh.triangles[t]);
  }
  if (turned > 0) work.locator = std::make_shared<Surface_locator_3>(work.mesh, progress);
  clusters.crossings = std::move(work.crossings);
  work.crossings.clear();

  const auto tangled = static_cast<std::size_t>(std::ranges::count(is_tangled, 1));
  work.remarks.push_back(
      counted(clusters.crossings.size(), "pair of triangles crosses", "pairs of triangles cross") + " and " +
      counted(work.edges.irregular.size(), "edge has", "edges have") + " more than two triangles, in " +
      counted(tangled, "component", "components") + ": the solid is the union of what is inside of them" +
      (disoriented > 0 ? " (where no orientation is possible: what is inside an odd number of times)" : "") +
      ", cut exactly along the crossings.");
  if (turned > 0) work.remarks.push_back(counted(turned, "component", "components") + " of these turned inside out.");

  std::optional<Triangle_mesh_3> boundary = crossing_boundary(work.mesh, clusters, *work.locator, progress);
  if (!boundary || boundary->triangles.empty()) return false;
  work.mesh = *std::move(boundary);
  work.edges = find_edges(work.mesh);
  work.parts = orient_components(work.mesh, work.edges);
  work.locator = std::make_shared<Surface_locator_3>(work.mesh, progress);
  work.treatments.emplace_back("united");
  return true;
}

void wrap_it(Work& work, Progress& progress) {
  const double diagonal = diagonal_of(work.mesh);
  const double alpha = diagonal / 100;
  const double offset = diagonal / 1000;
  work.mesh = wrap(work.mesh, alpha, offset, progress);
  work.edges = find_edges(work.mesh);
  work.parts = orient_components(work.mesh, work.edges);
  work.locator = std::make_shared<Surface_locator_3>(work.mesh, progress);
  work.crossings.clear();
  work.treatments = {"wrapped"};
  work.remarks.push_back("Wrapped at a distance of about " + short_number(offset) +
                         " (0.001 of the diagonal); holes narrower than " + short_number(2 * alpha) +
                         " (0.02 of the diagonal) are closed, and so are cavities.");
}

/// Closes open edges in the mildest way that leaves none; false: there is no such way, and nothing was done.
bool close_surface(Work& work, Progress& progress) {
  Clean_mesh_3 clean;
  clean.mesh = work.mesh;
  clean.edges = work.edges;
  std::vector<std::string> treatments;
  std::vector<std::string> remarks;
  const double tolerance = 1e-6 * diagonal_of(work.mesh);
  if (const Stitched_3 stitched = stitch(clean, tolerance, progress);
      stitched.joined_vertices + stitched.split_edges > 0) {
    treatments.emplace_back("stitched");
    remarks.push_back("Open edges stitched: " + counted(stitched.joined_vertices, "vertex", "vertices") +
                      " joined with near ones, " + counted(stitched.split_edges, "edge", "edges") +
                      " split at vertices on them, at most " + short_number(stitched.farthest) + " away.");
  }
  constexpr double largest_fins = 0.01;
  if (const Removed_patches_3 removed = remove_fins(clean, largest_fins); removed.patches > 0) {
    treatments.emplace_back("trimmed");
    remarks.push_back(counted(removed.triangles, "triangle", "triangles") +
                      " left out that were only attached to the surface.");
  }
  if (clean.edges.is_open()) {
    const Mesh_components_3 parts = orient_components(clean.mesh, clean.edges);
    if (parts.turned_triangles > 0) {
      for (std::size_t t = 0; t < clean.mesh.triangles.size(); ++t)
        if (parts.flipped[t]) turn(clean.mesh.triangles[t]);
      clean.edges = find_edges(clean.mesh);
      treatments.emplace_back("oriented");
      remarks.push_back(counted(parts.turned_triangles, "triangle", "triangles") + " turned around.");
    }
    // What needs more is no surface with holes but a sheet.
    constexpr double largest_area = 0.25;
    const Filled_holes_3 filled = fill_holes(clean, progress);
    if (!filled.is_done || filled.area > largest_area) return false;
    treatments.emplace_back("filled");
    remarks.push_back(counted(filled.holes, "hole", "holes") + " filled by " +
                      counted(filled.triangles, "triangle", "triangles") + " (" + short_number(100 * filled.area) +
                      " % of the area, the longest boundary is " + short_number(filled.longest) + " long).");
  }
  work.mesh = std::move(clean.mesh);
  work.edges = std::move(clean.edges);
  work.treatments.insert(work.treatments.end(), treatments.begin(), treatments.end());
  work.remarks.insert(work.remarks.end(), remarks.begin(), remarks.end());
  return true;
}

/// Turns components so that what an odd number of others surround is a cavity.
Solid_3 finish(Work work, Progress& progress) {
  const Nesting_3 nesting = find_nesting(*work.locator, work.parts.component, work.parts.count, progress);
  std::vector<std::uint8_t> is_turned(work.parts.count, 0);
  for (int c = 0; c < work.parts.count; ++c) is_turned[c] = nesting.is_inward[c] != (nesting.depth[c] % 2 == 1) ? 1 : 0;
  const auto turned = static_cast<std::size_t>(std::ranges::count(is_turned, 1));
  if (turned > 0) {
    for (std::size_t t = 0; t < work.mesh.triangles.size(); ++t)
      if (is_turned[work.parts.component[t]]) turn(work.mesh.triangles[t]);
    work.locator = std::make_shared<Surface_locator_3>(work.mesh, progress);
    work.edges = find_edges(work.mesh);
    work.remarks.push_back(counted(turned, "component", "components") + " turned inside out.");
    if (work.treatments.empty()) work.treatments.emplace_back("oriented");
  }
  const auto cavities =
      static_cast<std::size_t>(std::ranges::count_if(nesting.depth, [](int depth) { return depth % 2 == 1; }));
  if (cavities > 0)
    work.remarks.push_back(counted(cavities, "component is a cavity: an odd number of others is around it.",
                                   "components are cavities: an odd number of others is around each."));
  Solid_3 solid;
  if (work.edges.irregular.empty()) {
    const std::int64_t fans = count_fans(work.edges);
    const std::int64_t touching = fans - static_cast<std::int64_t>(work.mesh.vertices.size());
    solid.topology = topology_of(fans, work.mesh, nesting.depth);
    if (touching > 0)
      work.remarks.push_back("The surface touches itself " + counted(touching, "time", "times") +
                             " in a vertex; its topology is that of a surface that does not.");
  } else {
    work.remarks.push_back("The surface touches itself along " + counted(work.edges.irregular.size(), "edge", "edges") +
                           ", so its topology is not said.");
  }
  solid.components = work.parts.count;
  solid.surface = std::move(work.mesh);
  for (const std::string& treatment : work.treatments)
    solid.treatment += (solid.treatment.empty() ? "" : ", ") + treatment;
  if (work.treatments.empty()) solid.treatment = "none";
  solid.remarks = std::move(work.remarks);
  solid.locator = std::move(work.locator);
  return solid;
}

}  // namespace

Solid_3 make_solid(const std::shared_ptr<const Triangle_mesh_3>& mesh, Repair repair, Progress& progress) {
  progress.begin_stage("Solid");
  Clean_mesh_3 clean = clean_mesh(*mesh);
  if (clean.mesh.triangles.empty()) {
    throw Unavailable("Of " + counted(mesh->triangles.size(), "triangle", "triangles") +
                      " none has an area, so nothing is enclosed; give a mesh with a surface.");
  }
  Work work;
  remark_on_cleaning(clean, work.remarks);
  work.mesh = std::move(clean.mesh);
  work.edges = std::move(clean.edges);
  if (repair == Repair::wrap) {
    wrap_it(work, progress);
    return finish(std::move(work), progress);
  }
  if (work.edges.is_open()) {
    const auto open =
        std::ranges::count_if(work.edges.irregular, [](const auto& edge) { return edge.size() % 2 == 1; });
    if (repair == Repair::off) {
      throw Unavailable(counted(open, "edge has", "edges have") +
                        " a triangle on one side only; with repair automatic the surface is closed.");
    }
    if (!close_surface(work, progress)) {
      wrap_it(work, progress);
      return finish(std::move(work), progress);
    }
  }
  examine(work, progress);
  if (work.parts.turned_triangles > 0) {
    if (repair == Repair::off) {
      throw Unavailable(counted(work.parts.turned_triangles, "triangle is", "triangles are") +
                        " oriented against most of the surface; with repair automatic they are turned around.");
    }
    work.remarks.push_back(counted(work.parts.turned_triangles, "triangle", "triangles") + " turned around.");
    work.treatments.emplace_back("oriented");
  }
  if (!is_clean(work)) {
    if (repair == Repair::off) {
      throw Unavailable("The surface crosses or touches itself (" + counted(work.crossings.size(), "pair", "pairs") +
                        " of triangles, " + counted(work.edges.irregular.size(), "edge", "edges") +
                        " with more than two triangles); with repair automatic it is made clean.");
    }
    if (work.has_too_many_crossings) {
      wrap_it(work, progress);
    } else {
      Work resolved = work;
      if (resolve_crossings(resolved, progress)) {
        work = std::move(resolved);
      } else {
        wrap_it(work, progress);
      }
    }
  }
  return finish(std::move(work), progress);
}

std::vector<std::uint8_t> are_inside(const Solid_3& solid, std::span<const Point_3> points, Progress& progress) {
  std::vector<std::uint8_t> result(points.size());
  parallel_for(points.size(), progress, [&](std::size_t i) { result[i] = solid.locator->contains(points[i]) ? 1 : 0; });
  return result;
}

std::vector<double> distances_to_surface(const Solid_3& solid, std::span<const Point_3> points, Progress& progress) {
  std::vector<double> result(points.size());
  parallel_for(points.size(), progress,
               [&](std::size_t i) { result[i] = std::sqrt(solid.locator->squared_distance(points[i])); });
  return result;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/power_crust_2/power_crust_2.h"

#include <algorithm>
#include <cmath>

#include "geometries/pole_labelling.h"
#include "geometries/power_crust_2/unit_vector.h"

namespace mesecina {

namespace {

/// The edges of the regular triangulation, each once.
template <class Function>
void for_each_edge(const Regular_2& regular, const Function& function) {
  for (int t = 0; t < static_cast<int>(regular.triangles.size()); ++t)
    for (int i = 0; i < 3; ++i)
      if (regular.edge_is_listed(t, i)) function(t, i);
}

/// Per disk its neighbours in the regular triangulation, in the order of their numbers.
struct Neighbors {
  std::vector<int> offsets;
  std::vector<int> disks;
  std::span<const int> of(int disk) const {
    return std::span(disks).subspan(offsets[disk], offsets[disk + 1] - offsets[disk]);
  }
};

Neighbors find_neighbors(const Regular_2& regular) {
  Neighbors result;
  result.offsets.assign(regular.balls->size() + 1, 0);
  for_each_edge(regular, [&](int t, int i) {
    for (const int end : regular.edge(t, i)) ++result.offsets[end + 1];
  });
  for (std::size_t d = 1; d < result.offsets.size(); ++d) result.offsets[d] += result.offsets[d - 1];
  result.disks.resize(result.offsets.back());
  std::vector<int> next(result.offsets.begin(), result.offsets.end() - 1);
  for_each_edge(regular, [&](int t, int i) {
    const auto [a, b] = regular.edge(t, i);
    result.disks[next[a]++] = b;
    result.disks[next[b]++] = a;
  });
  for (std::size_t d = 0; d + 1 < result.offsets.size(); ++d)
    std::sort(result.disks.begin() + result.offsets[d], result.disks.begin() + result.offsets[d + 1]);
  return result;
}

/// Of the angle between the directions from `at` to p and q.
double cosine(const Point_2& at, const Point_2& p, const Point_2& q) {
  const Point_2 to_p = unit_vector(at, p);
  const Point_2 to_q = unit_vector(at, q);
  return to_p.x * to_q.x + to_p.y * to_q.y;
}

void find_labels(const Poles_2& poles, const Regular_2& regular, Polar_balls_2& result, const Progress& progress) {
  const Neighbors neighbors = find_neighbors(regular);
  const Balls_2& balls = *poles.balls;
  Pole_labelling labelling(poles.size());
  for (int p = static_cast<int>(poles.finite_count()); p < static_cast<int>(poles.size()); ++p) labelling.add_outer(p);
  labelling.run(result.is_inner, result.confidence, progress, [&](int pole, const auto& offer) {
    for (const int s : poles.samples_of(pole)) {
      const int other = poles.opposite(pole, s);
      if (other >= 0 && !labelling.is_labelled(other))
        offer(other, false, -cosine((*balls.samples)[s], balls.centers[pole], balls.centers[other]));
    }
    for (const int other : neighbors.of(pole)) {
      if (labelling.is_labelled(other)) continue;
      if (const double depth = intersection_cosine(balls, pole, other); depth > 0) offer(other, true, depth);
    }
  });
}

}  // namespace

int shared_sample(const Balls_2& balls, std::span<const int> disks) {
  const auto contact_count = [&](int disk) { return balls.contacts_of(disk).size(); };
  const int least = *std::ranges::min_element(disks, {}, contact_count);
  for (const int sample : balls.contacts_of(least))
    if (std::ranges::all_of(disks, [&](int d) { return std::ranges::binary_search(balls.contacts_of(d), sample); }))
      return sample;
  return -1;
}

double intersection_cosine(const Balls_2& balls, int a, int b) {
  if (balls.radii[a] < balls.radii[b]) std::swap(a, b);
  const int shared = shared_sample(balls, std::array{a, b});
  const Point_2& p = (*balls.samples)[shared >= 0 ? shared : balls.contacts_of(a).front()];
  const Point_2& q = (*balls.samples)[shared >= 0 ? shared : balls.contacts_of(b).front()];
  const Point_2 to_a = unit_vector(p, balls.centers[a]);
  const Point_2 to_b = unit_vector(q, balls.centers[b]);
  const Point_2 offset{p.x - q.x, p.y - q.y};
  const auto dot = [](const Point_2& v, const Point_2& w) { return v.x * w.x + v.y * w.y; };
  // (ra^2 + rb^2 - d^2) / (2 ra rb), but without the differences of large numbers when a is very large.
  return dot(to_a, to_b) + dot(offset, to_b) / balls.radii[a] -
         (dot(offset, offset) / (2 * balls.radii[a]) + dot(offset, to_a)) / balls.radii[b];
}

std::vector<std::uint8_t> Polar_balls_2::inner_triangles(std::size_t triangle_count) const {
  std::vector<std::uint8_t> result(triangle_count, 0);
  for (std::size_t p = 0; p < poles->finite_count(); ++p)
    if (is_inner[p] != 0) result[poles->triangles[p]] = 1;
  return result;
}

Polar_balls_2 label_poles(std::shared_ptr<const Poles_2> poles, std::shared_ptr<const Regular_2> regular,
                          Progress& progress) {
  progress.check();
  Polar_balls_2 result;
  result.is_inner.assign(poles->size(), 0);
  result.confidence.assign(poles->size(), 0);
  find_labels(*poles, *regular, result, progress);
  result.unlabelled_count = static_cast<std::size_t>(std::ranges::count(result.confidence, 0.0));
  for (int s = 0; s < static_cast<int>(poles->first.size()); ++s) {
    const int first = poles->first[s];
    const int second = poles->second[s];
    if (first < 0 || second < 0 || result.confidence[first] == 0 || result.confidence[second] == 0) continue;
    if (result.is_inner[first] == result.is_inner[second]) result.contradictions.push_back(s);
  }
  result.poles = std::move(poles);
  result.regular = std::move(regular);
  return result;
}

std::vector<Regular_edge> power_edges(const Polar_balls_2& polar, const Polar_diagram_2& diagram) {
  std::vector<Regular_edge> edges;
  std::vector<Regular_edge> rays;
  for_each_edge(*polar.regular, [&](int t, int i) {
    const int u = polar.regular->neighbors[t][i];
    if (u < 0) {
      rays.push_back({t, i});
    } else if (diagram.vertex_of_triangle[t] != diagram.vertex_of_triangle[u]) {
      edges.push_back({t, i});
    }
  });
  edges.insert(edges.end(), rays.begin(), rays.end());
  return edges;
}

std::vector<Regular_edge> power_crust(const Polar_balls_2& polar, const Polar_diagram_2& diagram) {
  std::vector<Regular_edge> edges = power_edges(polar, diagram);
  std::erase_if(edges, [&](const Regular_edge& edge) {
    const auto [a, b] = polar.regular->edge(edge.triangle, edge.corner);
    return polar.is_inner[a] == polar.is_inner[b];
  });
  return edges;
}

Power_shape_2 power_shape(const Polar_balls_2& polar) {
  Power_shape_2 shape;
  const Regular_2& regular = *polar.regular;
  std::vector<std::uint8_t> is_used(polar.is_inner.size(), 0);
  for_each_edge(regular, [&](int t, int i) {
    const auto [a, b] = regular.edge(t, i);
    if (polar.is_inner[a] == 0 || polar.is_inner[b] == 0) return;
    shape.edges.push_back({a, b});
    is_used[a] = is_used[b] = 1;
  });
  for (const auto& triangle : regular.triangles)
    if (std::ranges::all_of(triangle, [&](int pole) { return polar.is_inner[pole] != 0; }))
      shape.triangles.push_back(triangle);
  for (std::size_t p = 0; p < polar.is_inner.size(); ++p)
    if (polar.is_inner[p] != 0 && regular.is_hidden[p] == 0 && is_used[p] == 0)
      shape.isolated.push_back(static_cast<int>(p));
  return shape;
}

}  // namespace mesecina

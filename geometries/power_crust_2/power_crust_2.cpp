// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/power_crust_2/power_crust_2.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

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

Point_2 unit_vector(const Point_2& from, const Point_2& to) {
  const double length = distance(from, to);
  return {(to.x - from.x) / length, (to.y - from.y) / length};
}

/// Of the angle between the directions from `at` to p and q.
double cosine(const Point_2& at, const Point_2& p, const Point_2& q) {
  const Point_2 to_p = unit_vector(at, p);
  const Point_2 to_q = unit_vector(at, q);
  return to_p.x * to_q.x + to_p.y * to_q.y;
}

/// A spread of labels from pole to pole, the surest first.
class Labelling {
 public:
  Labelling(const Poles_2& poles, const Regular_2& regular)
      : poles_(poles), neighbors_(find_neighbors(regular)), evidence_(poles.size()), is_labelled_(poles.size(), 0) {}

  void run(Polar_balls_2& result, const Progress& progress) {
    for (int p = static_cast<int>(poles_.finite_count()); p < static_cast<int>(poles_.size()); ++p)
      add_evidence(p, false, 1);
    for (std::size_t step = 0; !queue_.empty(); ++step) {
      if (step % 4096 == 0) progress.check();
      const Entry next = queue_.top();
      queue_.pop();
      if (is_labelled_[next.pole] != 0 || next.priority != evidence_[next.pole].priority()) continue;
      is_labelled_[next.pole] = 1;
      const Evidence& evidence = evidence_[next.pole];
      const bool is_inner = evidence.inner > evidence.outer;
      result.is_inner[next.pole] = is_inner ? 1 : 0;
      result.confidence[next.pole] = std::max(evidence.inner, evidence.outer);
      spread(next.pole, is_inner, result.confidence[next.pole]);
    }
  }

 private:
  struct Evidence {
    double inner = 0;
    double outer = 0;
    /// Those with evidence for one side only come first.
    double priority() const { return inner > 0 && outer > 0 ? std::abs(inner - outer) - 1 : std::max(inner, outer); }
  };
  struct Entry {
    double priority = 0;
    int pole = 0;
    bool operator<(const Entry& other) const {
      return priority != other.priority ? priority < other.priority : pole > other.pole;
    }
  };

  void add_evidence(int pole, bool is_inner, double weight) {
    double& side = is_inner ? evidence_[pole].inner : evidence_[pole].outer;
    if (weight <= side) return;
    side = weight;
    queue_.push({evidence_[pole].priority(), pole});
  }

  void spread(int pole, bool is_inner, double confidence) {
    // Long chains must not end by underflow.
    const auto weakened = [confidence](double factor) {
      return std::max(confidence * std::min(factor, 1.0), std::numeric_limits<double>::min());
    };
    const Balls_2& balls = *poles_.balls;
    for (const int s : poles_.samples_of(pole)) {
      const int other = poles_.opposite(pole, s);
      if (other < 0 || is_labelled_[other] != 0) continue;
      const double opposition = -cosine((*balls.samples)[s], balls.centers[pole], balls.centers[other]);
      add_evidence(other, !is_inner, weakened(opposition));
    }
    for (const int other : neighbors_.of(pole)) {
      if (is_labelled_[other] != 0) continue;
      if (const double depth = intersection_cosine(balls, pole, other); depth > 0)
        add_evidence(other, is_inner, weakened(depth));
    }
  }

  const Poles_2& poles_;
  Neighbors neighbors_;
  std::vector<Evidence> evidence_;
  std::vector<std::uint8_t> is_labelled_;
  std::priority_queue<Entry> queue_;
};

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
  Labelling(*poles, *regular).run(result, progress);
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

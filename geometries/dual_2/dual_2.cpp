// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/dual_2/dual_2.h"

#include "core/disjoint_sets.h"
#include "geometries/regular_2/power_predicates.h"

namespace mesecina {

namespace {

/// Which faces belong to the complex because their own smallest orthogonal circle is small enough and empty.
class Classifier {
 public:
  Classifier(Dual_2& dual, const Power_predicates& predicates) : dual_(dual), predicates_(predicates) {}

  void classify_triangles(const Progress& progress) {
    const Regular_2& regular = *dual_.regular;
    const std::size_t count = regular.triangles.size();
    dual_.has_triangle.resize(count);
    dual_.is_flat.resize(count);
    for (std::size_t t = 0; t < count; ++t) {
      if (t % 4096 == 0) progress.check();
      const auto& [a, b, c] = regular.triangles[t];
      const CGAL::Sign sign = predicates_.size_sign(a, b, c, dual_.alpha);
      dual_.has_triangle[t] = sign != CGAL::POSITIVE;
      dual_.is_flat[t] = sign == CGAL::ZERO;
    }
  }

  void classify_edges(const Progress& progress) {
    const Regular_2& regular = *dual_.regular;
    for (int t = 0; t < static_cast<int>(regular.triangles.size()); ++t) {
      if (t % 4096 == 0) progress.check();
      for (int i = 0; i < 3; ++i) {
        if (!regular.edge_is_listed(t, i)) continue;
        const auto [a, b] = regular.edge(t, i);
        add_edge(a, b, t, regular.neighbors[t][i], i);
      }
    }
    for (std::size_t i = 1; i < regular.line.size(); ++i) add_edge(regular.line[i - 1], regular.line[i], -1, -1, 0);
  }

  void classify_vertices(const Progress& progress) {
    const Regular_2& regular = *dual_.regular;
    auto& vertices = dual_.vertices;
    vertices.assign(regular.balls->size(), Dual_kind::outside);
    // Interior unless a triangle outside or the hull is beside it.
    std::vector<std::uint8_t> has_triangle(vertices.size(), 0);
    std::vector<std::uint8_t> is_on_boundary(vertices.size(), 0);
    std::vector<std::uint8_t> is_in_conflict(vertices.size(), 0);
    for (std::size_t t = 0; t < regular.triangles.size(); ++t) {
      if (t % 4096 == 0) progress.check();
      for (int i = 0; i < 3; ++i) {
        const int ball = regular.triangles[t][i];
        (dual_.has_triangle[t] != 0 ? has_triangle : is_on_boundary)[ball] = 1;
        if (regular.neighbors[t][i] < 0)
          for (const int end : regular.edge(static_cast<int>(t), i)) is_on_boundary[end] = 1;
      }
    }
    for (const Dual_edge& edge : dual_.edges)
      for (const int end : {edge.a, edge.b})
        vertices[end] = has_triangle[end] == 0 || is_on_boundary[end] != 0 ? Dual_kind::regular : Dual_kind::interior;
    // What is on no edge is in the complex if its own point is nearest to its own disk.
    const auto look_at = [&](int ball, int neighbor) {
      if (vertices[ball] == Dual_kind::outside && is_in_conflict[ball] == 0 &&
          predicates_.conflict_sign(ball, neighbor) == CGAL::NEGATIVE)
        is_in_conflict[ball] = 1;
    };
    for (const auto& triangle : regular.triangles) {
      for (int i = 0; i < 3; ++i) {
        look_at(triangle[i], triangle[(i + 1) % 3]);
        look_at(triangle[i], triangle[(i + 2) % 3]);
      }
    }
    for (std::size_t i = 1; i < regular.line.size(); ++i) {
      look_at(regular.line[i - 1], regular.line[i]);
      look_at(regular.line[i], regular.line[i - 1]);
    }
    for (std::size_t b = 0; b < vertices.size(); ++b)
      if (vertices[b] == Dual_kind::outside && regular.is_hidden[b] == 0 && is_in_conflict[b] == 0 &&
          predicates_.size_sign(static_cast<int>(b), dual_.alpha) != CGAL::POSITIVE)
        vertices[b] = Dual_kind::singular;
  }

 private:
  void add_edge(int a, int b, int left, int right, int corner) {
    const Regular_2& regular = *dual_.regular;
    const int triangles =
        (left >= 0 && dual_.has_triangle[left] != 0 ? 1 : 0) + (right >= 0 && dual_.has_triangle[right] != 0 ? 1 : 0);
    Dual_kind kind = Dual_kind::singular;
    if (triangles == 2) {
      kind = Dual_kind::interior;
    } else if (triangles == 1) {
      kind = Dual_kind::regular;
    } else {
      if (predicates_.size_sign(a, b, dual_.alpha) == CGAL::POSITIVE) return;
      if (left >= 0 && predicates_.conflict_sign(a, b, regular.triangles[left][corner]) == CGAL::NEGATIVE) return;
      if (right >= 0 && predicates_.conflict_sign(
                            a, b, regular.triangles[right][regular.mirror_corner(left, corner)]) == CGAL::NEGATIVE)
        return;
    }
    dual_.edges.push_back({a, b, left, right, kind});
  }

  Dual_2& dual_;
  const Power_predicates& predicates_;
};

}  // namespace

Dual_2 dual_complex(std::shared_ptr<const Regular_2> regular, double alpha, Progress& progress) {
  Dual_2 dual;
  dual.regular = std::move(regular);
  dual.alpha = alpha;
  const Power_predicates predicates(*dual.regular->balls, progress);
  const Power_predicates::Upward_rounding rounding;
  Classifier classifier(dual, predicates);
  classifier.classify_triangles(progress);
  classifier.classify_edges(progress);
  classifier.classify_vertices(progress);
  return dual;
}

Topology topology(const Dual_2& dual) {
  const auto& vertices = dual.vertices;
  Disjoint_sets parts(vertices.size());
  Topology result;
  for (const Dual_kind kind : vertices) result.euler += kind != Dual_kind::outside ? 1 : 0;
  result.betti[0] = result.euler;
  for (const Dual_edge& edge : dual.edges)
    if (parts.join(edge.a, edge.b)) --result.betti[0];
  result.euler -= static_cast<std::int64_t>(dual.edges.size());
  for (const std::uint8_t has : dual.has_triangle) result.euler += has;
  result.betti[1] = result.betti[0] - result.euler;
  return result;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union_3/alpha_complex_3.h"

#include <CGAL/Epeck_d.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace mesecina::test {

namespace {

using Any_kernel = CGAL::Epeck_d<CGAL::Dimension_tag<3>>;
using Any_complex = Gudhi::alpha_complex::Alpha_complex<Any_kernel, true>;
using Space_complex = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::EXACT, true>;
using Simplex_tree = Gudhi::Simplex_tree<>;
using Cohomology =
    Gudhi::persistent_cohomology::Persistent_cohomology<Simplex_tree, Gudhi::persistent_cohomology::Field_Zp>;
using Position = std::array<double, 3>;

/// GUDHI leaves out copies of a point, and says of no vertex which ball it was.
class Names {
 public:
  explicit Names(const std::vector<Ball_3>& balls) {
    for (int i = 0; i < static_cast<int>(balls.size()); ++i) {
      const Point_3& c = balls[i].center;
      const auto [it, is_new] = name_of_.try_emplace({c.x, c.y, c.z}, i);
      if (!is_new && balls[i].radius > balls[it->second].radius) it->second = i;
    }
  }
  int operator()(const Position& position) const { return name_of_.at(position); }

 private:
  std::map<Position, int> name_of_;
};

/// `name_of`: the ball of a vertex of the tree.
template <class Name_of_vertex>
Alpha_complex alpha_complex_of(Simplex_tree& tree, const Name_of_vertex& name_of) {
  Alpha_complex result;
  for (const auto& handle : tree.complex_simplex_range()) {
    std::vector<int> balls;
    for (const auto vertex : tree.simplex_vertex_range(handle)) balls.push_back(name_of(vertex));
    result.values.emplace(simplex_of(balls), tree.filtration(handle));
  }
  tree.prune_above_filtration(0);
  // The second argument: also the Betti number of the highest dimension.
  Cohomology cohomology(tree, true);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology();
  const std::vector<int> betti = cohomology.betti_numbers();
  for (std::size_t i = 0; i < betti.size(); ++i) {
    if (i < result.topology.betti.size()) {
      result.topology.betti[i] = betti[i];
    } else if (betti[i] != 0) {
      throw std::logic_error("a complex in space has a Betti number above the second one");
    }
  }
  result.topology.euler = result.topology.betti[0] - result.topology.betti[1] + result.topology.betti[2];
  return result;
}

}  // namespace

Simplex_3 simplex_of(std::span<const int> balls) {
  Simplex_3 result{-1, -1, -1, -1};
  for (std::size_t i = 0; i < balls.size(); ++i) result.at(i) = balls[i];
  std::ranges::sort(result);
  return result;
}

bool may_underflow(const std::vector<Ball_3>& balls) {
  const auto is_tiny = [](double value) { return value != 0 && std::abs(value) < 1e-100; };
  return std::ranges::any_of(balls, [&](const Ball_3& b) {
    return is_tiny(b.center.x) || is_tiny(b.center.y) || is_tiny(b.center.z) || is_tiny(b.radius);
  });
}

Alpha_complex alpha_complex(const std::vector<Ball_3>& balls) {
  std::vector<Any_kernel::Weighted_point_d> points;
  points.reserve(balls.size());
  for (const Ball_3& b : balls)
    points.emplace_back(Any_kernel::Point_d(b.center.x, b.center.y, b.center.z), Any_kernel::FT(b.radius * b.radius));
  Any_complex complex(points);
  Simplex_tree tree;
  constexpr bool is_exact = true;
  if (!complex.create_complex(tree, std::numeric_limits<double>::infinity(), is_exact))
    throw std::invalid_argument("GUDHI makes no complex");
  const Names names(balls);
  return alpha_complex_of(tree, [&](int vertex) {
    const auto& point = complex.get_point(vertex).point();
    return names({CGAL::to_double(point[0]), CGAL::to_double(point[1]), CGAL::to_double(point[2])});
  });
}

Alpha_complex alpha_complex_of_space(const std::vector<Ball_3>& balls) {
  std::vector<Space_complex::Weighted_point_3> points;
  points.reserve(balls.size());
  for (const Ball_3& b : balls)
    points.emplace_back(Space_complex::Bare_point_3(b.center.x, b.center.y, b.center.z), b.radius * b.radius);
  Space_complex complex(points);
  Simplex_tree tree;
  if (!complex.create_complex(tree)) throw std::invalid_argument("GUDHI's complex of space needs a tetrahedron");
  const Names names(balls);
  return alpha_complex_of(tree, [&](int vertex) {
    const auto& point = complex.get_point(vertex);
    return names({CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())});
  });
}

}  // namespace mesecina::test

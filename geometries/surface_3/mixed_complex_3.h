// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <compare>
#include <vector>

#include "core/progress.h"
#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// The mixed complex of balls: for each simplex of their regular triangulation the sum of the simplex, shrunk by one
/// minus the shrink factor, and of its power face, shrunk by the factor. In each such cell the skin surface is a
/// quadric. Here it is known by what subdivides it: each face of the complex belongs to a simplex in another one, and
/// has a corner at the point of the small simplex, and that of the power face of the large one, nearest to the centers
/// of their smallest orthogonal spheres. [N. Kruithof, G. Vegter: Meshing skin surfaces with certified topology, 2007]
class Mixed_complex_3 {
 public:
  /// Numbers of simplices, of which the smallest orthogonal spheres have their centers in them (in the power face of
  /// the second one): different corners are different points, but where power faces are degenerate.
  struct Corner {
    int simplex = 0;
    int dual = 0;
    auto operator<=>(const Corner&) const = default;
  };
  /// The corner is (1 - shrink factor) * point + shrink factor * dual_point.
  struct Place {
    Point_3 point;          ///< of the simplex
    Point_3 dual_point;     ///< of the power face
    double weight = 0;      ///< of the simplex at the point: between its balls' squared radii, less where it is long
    double dual_power = 0;  ///< of the dual point to its balls
  };

  /// `shrink_factor` in (0, 1). Power cells of balls that shall be looked at must be bounded. O(n log n).
  Mixed_complex_3(const Regular_3& regular, double shrink_factor, Progress& progress);

  /// Of a finite cell of the triangulation, the face for two sets of its places, of which the second one holds the
  /// first: sums of 1, 2, 4 and 8.
  Corner corner(int cell, unsigned simplex, unsigned dual) const {
    return {anchors_[number(cell, simplex)], dual_anchors_[number(cell, dual)]};
  }
  /// Of the skin surface. Exact; not on the surface itself.
  bool is_inside(const Corner& corner) const;
  /// To about nine digits, mostly more; slow where cells are nearly flat.
  Place place(const Corner& corner) const;
  /// Shrink factor * dual_power - (1 - shrink factor) * weight: negative inside of the surface. The same to rounding.
  double value(const Place& place) const;

 private:
  /// Bounds of a number.
  struct Range {
    double lower = 0;
    double upper = 0;
  };
  int number(int cell, unsigned places) const;
  int first_triangle() const { return first_edge() + static_cast<int>(edges_.size()); }
  int first_edge() const { return static_cast<int>(regular_.balls.size()); }
  int first_cell() const { return first_triangle() + static_cast<int>(triangles_.size()); }
  int simplex_count() const { return first_cell() + static_cast<int>(regular_.cells.size()); }
  boost::container::static_vector<int, 4> balls_of(int simplex) const;
  void number_edges(Progress& progress);
  void number_triangles();
  void measure(Progress& progress);
  void find_anchors(Progress& progress);

  const Regular_3& regular_;
  double shrink_factor_;
  std::vector<double> weights_;  ///< of the balls
  std::vector<std::array<int, 2>> edges_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<std::array<int, 2>> cell_of_triangle_;  ///< and the place across from it
  std::vector<std::array<int, 6>> edges_of_cell_;
  std::vector<std::array<int, 4>> triangles_of_cell_;  ///< across from each place
  // Per simplex: balls, then edges, triangles and cells.
  std::vector<Range> powers_;  ///< squared radius of the smallest orthogonal sphere
  std::vector<int> anchors_;
  std::vector<int> dual_anchors_;
};

}  // namespace mesecina

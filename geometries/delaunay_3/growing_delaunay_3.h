// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometries/delaunay_3/delaunay_3.h"

namespace mesecina {

/// Keeps a Delaunay triangulation, so that points can be added to it later at the cost of what changes. Takes about 500
/// bytes per point besides the arrays. Not to be used any more after an exception.
class Growing_delaunay_3 {
 public:
  Growing_delaunay_3();
  Growing_delaunay_3(Growing_delaunay_3&&) noexcept;
  Growing_delaunay_3& operator=(Growing_delaunay_3&&) noexcept;
  ~Growing_delaunay_3();

  /// The triangulation of all points, those that are added last. Cells are the same as if all had been there at once;
  /// their numbers may be others: cells that stay keep theirs, but for a few where cells become fewer.
  const Delaunay_3& get() const;
  /// Adds points and returns the numbers of the cells that are new, or did not have this number before; ascending.
  /// Throws as delaunay does; the first points must make a tetrahedron. O(n log n) for the first ones, then about O(1)
  /// for each.
  std::vector<int> add(std::span<const Point_3> points, Progress& progress);
  /// Gives the arrays away; nothing can be added then.
  Delaunay_3 take() &&;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/inputs.h"
#include "core/point.h"

namespace mesecina {

/// A half-line from a vertex.
struct Ray {
  int from = 0;
  Point_3 direction;  ///< unit length
};

/// A circular arc in the plane, from vertex `from` to vertex `to` (equal for a whole circle).
struct Arc {
  Point_2 center;
  double radius = 0;
  int from = 0;
  int to = 0;
  bool counterclockwise = true;
};

/// A disk in the plane, a ball in space.
struct Ball {
  int center = 0;  ///< vertex
  double radius = 0;
};

/// One number per element of a Primitive_set, in element order. May hold +infinity ("never").
struct Values {
  std::string name;  ///< "lambda", "angle", "scale", ... stable, appears in files
  std::string unit;  ///< "", "degrees", "units of the input"
  std::vector<double> data;
};

/// Euler characteristic and Betti numbers of a complex.
struct Topology {
  std::int64_t euler = 0;
  std::array<std::int64_t, 3> betti{};
  bool operator==(const Topology&) const = default;
};

/// What a layer is made of, in any dimension: the only thing canvases, pickers and writers know.
///
/// *Elements* are the primitives in this fixed order: points, segments, rays, arcs, triangles, polygons, balls; element
/// numbers, `values[].data` and `ids` run through all of them in that order. Most layers use one kind.
struct Primitive_set {
  int dimension = 2;                         ///< 2: z of every vertex is 0
  std::vector<Point_3> vertices;             ///< shared by the primitives below
  std::vector<double> radii;                 ///< per vertex, of its medial ball, which is not drawn; empty: none
  std::vector<int> points;                   ///< vertex
  std::vector<std::array<int, 2>> segments;  ///< vertices
  std::vector<Ray> rays;
  std::vector<Arc> arcs;
  std::vector<std::array<int, 3>> triangles;  ///< vertices, counterclockwise in the plane
  std::vector<int> polygon_offsets;           ///< empty, or #polygons + 1 offsets into polygon_vertices
  /// In the plane filled all together by the even-odd rule; in space each is a planar convex face of its own.
  std::vector<int> polygon_vertices;
  std::vector<Ball> balls;
  std::vector<Values> values;
  std::vector<std::int64_t> ids;           ///< per element, what it is in the structure; empty: its own number
  std::shared_ptr<const Image> image;      ///< drawn below the primitives; null for none
  bool is_complex = false;                 ///< the primitives form a complex: Euler and Betti numbers mean something
  std::optional<Topology> known_topology;  ///< of the whole structure, where the primitives do not show all of it

  std::size_t polygon_count() const { return polygon_offsets.empty() ? 0 : polygon_offsets.size() - 1; }
  std::span<const int> polygon(std::size_t i) const {
    return std::span(polygon_vertices).subspan(polygon_offsets[i], polygon_offsets[i + 1] - polygon_offsets[i]);
  }
  std::size_t element_count() const {
    return points.size() + segments.size() + rays.size() + arcs.size() + triangles.size() + polygon_count() +
           balls.size();
  }
  bool is_empty() const { return element_count() == 0 && !image; }
  std::int64_t id(std::size_t element) const { return ids.empty() ? static_cast<std::int64_t>(element) : ids[element]; }
  /// Null when there are no values of this name.
  const Values* find_values(std::string_view name) const;
  /// Of the finite primitives, disks with their radius. O(size).
  Box bounding_box() const;
};

/// Smallest box of an arc of the set: of what is drawn of its circle. Coordinates that are no numbers do not count.
/// O(1).
Box bounding_box(const Primitive_set& set, const Arc& arc);

/// Which elements of a layer belong to it: those whose value is at least `minimum`.
/// A filtration's layer holds all elements with their values, and its limit is this cut; so that moving the limit costs
/// a canvas nothing but a number.
struct Cut {
  std::string value;
  double minimum = 0;
  bool operator==(const Cut&) const = default;
};

/// A copy with only the elements for which keep[element] is true, and only the vertices they use, in the old order.
/// O(size).
Primitive_set select(const Primitive_set& set, const std::vector<bool>& keep);
/// The elements the cut keeps; the set itself if it has no values of that name.
Primitive_set apply_cut(const Primitive_set& set, const Cut& cut);

/// Of the complex formed by the points, segments, arcs, triangles and, in space, polygons of a set (their vertices and
/// edges belong to it); `known_topology` where there is one. An arc is an edge of its own, also beside others between
/// the same vertices, and a whole circle is a loop. Polygons are cells, glued to an edge as often as they visit it.
/// nullopt for sets with other primitives, or that are no complex, and for polygons in the plane. Betti numbers are
/// over the field of two elements, so b2 also counts closed surfaces that have no orientation; in the plane b2 is 0.
/// O(n log n). In space no proven bound: a medial axis or a foam of a million faces takes about a second, a complex of
/// many faces at random among few vertices the cube of their number.
std::optional<Topology> topology(const Primitive_set& set);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/union_3/vertex_delaunay_3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <cstddef>
#include <limits>
#include <numeric>

#include "geometries/cell_arrays_3.h"
#include "geometries/parallel_insertion_3.h"
#include "geometries/spatial_order_3.h"
#include "geometries/sphere_kernel_3.h"

namespace mesecina {

namespace {

using Kernel = Sphere_kernel_3;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Data_structure = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base, CGAL::Parallel_tag>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Data_structure, CGAL::Default, Territory_locks_3>;

/// The powers of points to the balls on whose spheres they lie.
class Powers {
 public:
  Powers(const Points_on_spheres_3& input, Progress& progress) : input_(input), powers_(input.ball_numbers.size()) {
    parallel_for(input.points.size(), progress, [&](std::size_t i) {
      const Point_3& p = input_.points[i];
      for (int k = input_.ball_offsets[i]; k < input_.ball_offsets[i + 1]; ++k) {
        const auto& [c, radius] = input_.balls[input_.ball_numbers[k]];
        powers_[k] = power_by_double_doubles({p.x, p.y, p.z}, {c.x, c.y, c.z}, radius);
      }
    });
  }

  /// By the spheres on which all five points lie, if there are such.
  CGAL::Oriented_side side(const Sphere_side_3& query, const std::array<int, 5>& points) const {
    const int last = points[4];
    for (int k = input_.ball_offsets[last]; k < input_.ball_offsets[last + 1]; ++k) {
      const int ball = input_.ball_numbers[k];
      std::array<double, 5> powers{};
      powers[4] = powers_[k];
      bool have_all = true;
      for (int i = 0; i < 4 && have_all; ++i) have_all = find(points[i], ball, powers[i]);
      if (!have_all) continue;
      constexpr double relative_error = 0x1p-97;
      const double radius = input_.balls[ball].radius;
      const CGAL::Oriented_side side = query.by_powers(powers, relative_error * radius * radius);
      if (side != CGAL::ON_ORIENTED_BOUNDARY) return side;
    }
    return CGAL::ON_ORIENTED_BOUNDARY;
  }

 private:
  bool find(int point, int ball, double& power) const {
    for (int k = input_.ball_offsets[point]; k < input_.ball_offsets[point + 1]; ++k) {
      if (input_.ball_numbers[k] != ball) continue;
      power = powers_[k];
      return true;
    }
    return false;
  }

  const Points_on_spheres_3& input_;
  std::vector<double> powers_;
};

/// For Parallel_insertion_3.
class Vertex_triangulation : public Triangulation {
 public:
  Vertex_triangulation(const Points_on_spheres_3& input, const Powers& powers)
      : input_(input), powers_(powers), vertices_(input.points.size()) {
    infinite_vertex()->info() = -1;
  }

  Point place(int i) const {
    const mesecina::Point_3& p = input_.points[i];
    return {p.x, p.y, p.z};
  }
  Vertex_handle vertex(int i) const { return vertices_[i]; }
  Vertex_handle insert(int i, Locate_type type, Cell_handle cell, int at, int other, bool* could_lock_zone) {
    const Point p = place(i);
    Vertex_handle vertex;
    if (dimension() < 3) {
      vertex = Triangulation::insert(p, type, cell, at, other);
    } else {
      Nothing_hidden nothing_hidden;
      vertex = insert_in_conflict(p, type, cell, at, other, Conflict(*this, i, p), nothing_hidden, could_lock_zone);
    }
    if (vertex != Vertex_handle()) {
      vertex->info() = i;
      vertices_[i] = vertex;
    }
    return vertex;
  }

 private:
  /// As the tester of the Delaunay triangulation, quicker.
  class Conflict {
   public:
    Conflict(const Vertex_triangulation& triangulation, int point, const Point& place)
        : triangulation_(triangulation), point_(point), place_(place) {}
    bool operator()(Cell_handle cell) const {
      std::array<int, 5> points{};
      for (int i = 0; i < 4; ++i) {
        points[i] = cell->vertex(i)->info();
        if (points[i] < 0) return is_in_conflict(cell);
      }
      points[4] = point_;
      const Sphere_side_3 query(cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point(),
                                cell->vertex(3)->point(), place_);
      CGAL::Oriented_side side = query.by_coordinates();
      if (side == CGAL::ON_ORIENTED_BOUNDARY) side = triangulation_.powers_.side(query, points);
      return side == CGAL::ON_ORIENTED_BOUNDARY ? is_in_conflict(cell) : side == CGAL::ON_POSITIVE_SIDE;
    }
    bool test_initial_cell(Cell_handle) const { return true; }
    CGAL::Oriented_side compare_weight(const Point&, const Point&) const { return CGAL::ZERO; }

   private:
    bool is_in_conflict(Cell_handle cell) const {
      return triangulation_.side_of_sphere(cell, place_, true) == CGAL::ON_BOUNDED_SIDE;
    }

    const Vertex_triangulation& triangulation_;
    int point_;
    const Point& place_;
  };

  struct Nothing_hidden {
    template <class Cells>
    void process_cells_in_conflict(Cells, Cells) const {}
    void reinsert_vertices(Vertex_handle) const {}
    Vertex_handle replace_vertex(Cell_handle cell, int i, const Point&) const { return cell->vertex(i); }
    void hide_point(Cell_handle, const Point&) const {}
  };

  const Points_on_spheres_3& input_;
  const Powers& powers_;
  std::vector<Vertex_handle> vertices_;
};

}  // namespace

void vertex_delaunay(const Points_on_spheres_3& input, std::vector<std::array<int, 4>>& cells,
                     std::vector<std::array<int, 4>>& neighbors, Progress& progress) {
  const Powers powers(input, progress);
  const Memory_return memory_return;
  Vertex_triangulation triangulation(input, powers);
  Parallel_insertion_3(triangulation, input.points, progress).insert(insertion_order_along_curve(input.points.size()));
  if (triangulation.dimension() < 3) return;
  std::vector<int> places(input.points.size());
  std::iota(places.begin(), places.end(), 0);  // they are along a curve
  write_cells(triangulation, places, cells, neighbors, progress);
}

}  // namespace mesecina

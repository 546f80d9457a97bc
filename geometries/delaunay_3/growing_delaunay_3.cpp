// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometries/delaunay_3/growing_delaunay_3.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "core/outcome.h"
#include "geometries/cell_arrays_3.h"
#include "geometries/circumcenter_3.h"
#include "geometries/parallel_insertion_3.h"
#include "geometries/spatial_order_3.h"

namespace mesecina {

namespace {

struct Cell_number {
  int value = -1;  ///< of a finite cell in the arrays; -1 for infinite cells, and for those that have none yet
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_3<int, Kernel>;
using Cell_base =
    CGAL::Triangulation_cell_base_with_info_3<Cell_number, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Data_structure = CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base, CGAL::Parallel_tag>;
using Triangulation = CGAL::Delaunay_triangulation_3<Kernel, Data_structure, CGAL::Default, Territory_locks_3>;

/// Points along a curve, for Parallel_insertion_3. Vertices get the numbers that the points have elsewhere; of equal
/// points that of any.
class Numbered_triangulation : public Triangulation {
 public:
  void expect(std::span<const mesecina::Point_3> points, std::span<const int> numbers) {
    points_ = points;
    numbers_ = numbers;
    vertices_.assign(points.size(), {});
  }
  void expect_no_more() {
    points_ = {};
    numbers_ = {};
    vertices_ = {};
  }

  Point place(int i) const { return Point(points_[i].x, points_[i].y, points_[i].z); }
  Vertex_handle vertex(int i) const { return vertices_[i]; }
  Vertex_handle insert(int i, Locate_type type, Cell_handle cell, int at, int other, bool* could_lock_zone) {
    const Vertex_handle vertex = Triangulation::insert(place(i), type, cell, at, other, could_lock_zone);
    if (vertex == Vertex_handle()) return vertex;
    vertex->info() = numbers_[i];
    vertices_[i] = vertex;
    return vertex;
  }

 private:
  std::span<const mesecina::Point_3> points_;
  std::span<const int> numbers_;
  std::vector<Vertex_handle> vertices_;
};

/// Per point the first one that is equal to it.
std::vector<int> first_of_equal(const std::vector<Point_3>& points) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int i) { return std::tuple(points[i].x, points[i].y, points[i].z, i); });
  std::vector<int> site(points.size());
  int first = -1;
  for (const int i : order) {
    if (first < 0 || !(points[first] == points[i])) first = i;
    site[i] = first;
  }
  return site;
}

std::string why_flat(const Triangulation& triangulation) {
  const std::size_t count = triangulation.number_of_vertices();
  constexpr std::size_t least = 4;
  if (count < least)
    return "needs at least 4 distinct points that are not in one plane; there " +
           (count == 1 ? std::string("is 1") : "are " + std::to_string(count));
  return triangulation.dimension() < 2 ? "all points lie on one line" : "all points lie in one plane";
}

}  // namespace

class Growing_delaunay_3::Implementation {
 public:
  const Delaunay_3& result() const { return result_; }
  Delaunay_3 take() { return std::move(result_); }

  std::vector<int> add(std::span<const Point_3> points, Progress& progress) {
    progress.begin_stage("Delaunay triangulation");
    const bool is_first = result_.cells.empty();
    const std::size_t before = result_.points.size();
    result_.points.insert(result_.points.end(), points.begin(), points.end());
    insert(points, static_cast<int>(before), is_first, progress);
    if (triangulation_.dimension() < 3) throw Unavailable(why_flat(triangulation_));
    find_sites(before);
    if (is_first) return write_all(progress);
    std::vector<int> renewed = number_new();
    progress.check();
    parallel_for(renewed.size(), progress, [&](std::size_t i) {
      const Cell cell = cells_[renewed[i]];
      write(cell, renewed[i], order_of(cell));
    });
    return renewed;
  }

 private:
  using Cell = Triangulation::Cell_handle;
  using Vertex = Triangulation::Vertex_handle;

  void insert(std::span<const Point_3> points, int first, bool is_first, Progress& progress) {
    std::vector<std::size_t> sorted(points.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    sort_along_hilbert_curve(points, sorted, progress);
    places_.resize(result_.points.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) places_[first + sorted[i]] = first + static_cast<int>(i);
    const std::vector<int> order = insertion_order_along_curve(points.size());
    if (is_first) {
      std::vector<Point_3> along_curve;
      std::vector<int> numbers;
      along_curve.reserve(points.size());
      numbers.reserve(points.size());
      for (const std::size_t i : sorted) {
        along_curve.push_back(points[i]);
        numbers.push_back(first + static_cast<int>(i));
      }
      triangulation_.expect(along_curve, numbers);
      Parallel_insertion_3(triangulation_, along_curve, progress).insert(order);
      triangulation_.expect_no_more();
      return;
    }
    std::size_t count = 0;
    for (const int i : order) {
      constexpr std::size_t often = 1024;
      if (++count % often == 0) progress.report(static_cast<double>(count) / static_cast<double>(points.size()));
      const Point_3& p = points[sorted[i]];
      if (!insert_followed({p.x, p.y, p.z})) continue;
      last_->info() = first + static_cast<int>(sorted[i]);
      new_vertices_.push_back(last_);
    }
  }

  /// Notes which cells end. False where there is a vertex already.
  bool insert_followed(const Kernel::Point_3& place) {
    Triangulation::Locate_type type{};
    int i = 0;
    int j = 0;
    const Cell start = triangulation_.locate(place, type, i, j, last_);
    if (type == Triangulation::VERTEX) {
      last_ = start->vertex(i);
      return false;
    }
    conflicts_.clear();
    border_.clear();
    triangulation_.find_conflicts(place, start, std::back_inserter(border_), std::back_inserter(conflicts_));
    for (const Cell cell : conflicts_)
      if (cell->info().value >= 0) free_.push_back(cell->info().value);
    last_ = triangulation_.insert_in_hole(place, conflicts_.begin(), conflicts_.end(), border_.front().first,
                                          border_.front().second);
    return true;
  }

  void find_sites(std::size_t before) {
    result_.site_count = triangulation_.number_of_vertices();
    if (result_.site_count == result_.points.size()) {
      result_.site.resize(result_.points.size());
      std::iota(result_.site.begin() + static_cast<std::ptrdiff_t>(before), result_.site.end(),
                static_cast<int>(before));
    } else {
      result_.site = first_of_equal(result_.points);
    }
  }

  /// By the places of its sites.
  Corner_order_3 order_of(Cell cell) const {
    std::array<int, 4> places{};
    for (int i = 0; i < 4; ++i) places[i] = places_[result_.site[cell->vertex(i)->info()]];
    return corner_order(places);
  }

  std::vector<int> write_all(Progress& progress) {
    std::vector<Cell> cells;
    cells.reserve(triangulation_.tds().number_of_cells());
    for (auto cell = triangulation_.finite_cells_begin(); cell != triangulation_.finite_cells_end(); ++cell)
      cells.push_back(cell);
    const auto place_of = [&](const Vertex& vertex) { return places_[result_.site[vertex->info()]]; };
    const Cell_numbers_3<Cell> numbers(std::move(cells), places_.size(), place_of, progress);
    cells_.resize(numbers.size());
    numbers.for_each(progress, [&](const Cell& cell, int number, const Corner_order_3&) {
      cells_[number] = cell;
      cell->info().value = number;
    });
    resize();
    progress.check();
    numbers.for_each(progress,
                     [&](const Cell& cell, int number, const Corner_order_3& order) { write(cell, number, order); });
    std::vector<int> all(cells_.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  /// The numbers of cells that ended are given to new ones, then to the last ones.
  std::vector<int> number_new() {
    std::ranges::sort(free_);
    std::size_t used = 0;
    std::vector<int> renewed;
    std::vector<Cell> star;
    for (const Vertex vertex : new_vertices_) {
      star.clear();
      triangulation_.finite_incident_cells(vertex, std::back_inserter(star));
      std::ranges::sort(star, {}, [&](Cell cell) { return order_of(cell).places; });
      for (const Cell cell : star) {
        if (cell->info().value >= 0) continue;
        if (used < free_.size()) {
          cell->info().value = free_[used++];
          cells_[cell->info().value] = cell;
        } else {
          cell->info().value = static_cast<int>(cells_.size());
          cells_.push_back(cell);
        }
        renewed.push_back(cell->info().value);
      }
    }
    std::vector<int> unused(free_.begin() + static_cast<std::ptrdiff_t>(used), free_.end());
    for (const int number : unused) cells_[number] = Cell();
    for (const int number : unused) {
      while (!cells_.empty() && cells_.back() == Cell()) cells_.pop_back();
      if (number >= static_cast<int>(cells_.size())) break;
      cells_[number] = std::exchange(cells_.back(), Cell());
      cells_[number]->info().value = number;
      renewed.push_back(number);
    }
    while (cells_.back() == Cell()) cells_.pop_back();
    std::erase_if(renewed, [&](int number) { return number >= static_cast<int>(cells_.size()); });
    std::ranges::sort(renewed);
    renewed.erase(std::unique(renewed.begin(), renewed.end()), renewed.end());
    // Cells beside these have others across now, or the same with other numbers.
    for (const int number : renewed) {
      const Cell cell = cells_[number];
      for (int i = 0; i < 4; ++i) {
        const Cell beside = cell->neighbor(i);
        const int next = beside->info().value;
        if (next < 0 || next >= std::ssize(result_.neighbors)) continue;
        const auto from = order_of(beside).from;
        result_.neighbors[next][std::ranges::find(from, beside->index(cell)) - from.begin()] = number;
      }
    }
    resize();
    free_.clear();
    new_vertices_.clear();
    return renewed;
  }

  void resize() {
    result_.cells.resize(cells_.size());
    result_.neighbors.resize(cells_.size());
    result_.circumcenters.resize(cells_.size());
    result_.circumradii.resize(cells_.size());
  }

  void write(Cell cell, int number, const Corner_order_3& order) {
    std::array<Point_3, 4> points;
    for (int i = 0; i < 4; ++i) {
      const int corner = result_.site[cell->vertex(order.from[i])->info()];
      result_.cells[number][i] = corner;
      result_.neighbors[number][i] = cell->neighbor(order.from[i])->info().value;
      points[i] = result_.points[corner];
    }
    result_.circumcenters[number] = circumcenter(points);
    result_.circumradii[number] = distance(result_.circumcenters[number], points[0]);
  }

  Numbered_triangulation triangulation_;
  Delaunay_3 result_;
  std::vector<int> places_;  ///< per point, along a curve of those that came with it
  std::vector<Cell> cells_;  ///< by number
  Vertex last_;
  std::vector<Vertex> new_vertices_;
  std::vector<int> free_;  ///< numbers of cells that ended
  std::vector<Cell> conflicts_;
  std::vector<Triangulation::Facet> border_;
};

Growing_delaunay_3::Growing_delaunay_3() : implementation_(std::make_unique<Implementation>()) {}
Growing_delaunay_3::Growing_delaunay_3(Growing_delaunay_3&&) noexcept = default;
Growing_delaunay_3& Growing_delaunay_3::operator=(Growing_delaunay_3&&) noexcept = default;
Growing_delaunay_3::~Growing_delaunay_3() = default;

const Delaunay_3& Growing_delaunay_3::get() const { return implementation_->result(); }

std::vector<int> Growing_delaunay_3::add(std::span<const Point_3> points, Progress& progress) {
  return implementation_->add(points, progress);
}

Delaunay_3 Growing_delaunay_3::take() && { return implementation_->take(); }

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "geometries/delaunay_2/delaunay_2.h"
#include "geometries/delaunay_2/dynamic.h"

namespace mesecina {

namespace {

using Dynamic = Delaunay_2::Dynamic;
using Vertex_handle = Dynamic::Vertex_handle;
using Face_handle = Dynamic::Face_handle;

constexpr std::size_t most_local_changes = 256;
/// From here on CGAL may take longer to fill the hole that a site leaves than to triangulate all points.
constexpr std::size_t large_star = 1000;

/// Single changes of a triangulation of dimension 2 that keep the arrays in step with CGAL's triangulation.
/// An operation returns false when the dimension falls below 2, or when it is cheaper to start afresh; the arrays are
/// then out of date.
class Local_editor {
 public:
  explicit Local_editor(Delaunay_2& delaunay) : delaunay_(delaunay), triangulation_(delaunay.dynamic->triangulation) {}

  bool remove_point(int point);
  void insert_point(int point, const Point_2& position);
  /// To be called once after the last operation: closes the gaps left in the arrays.
  void finish();

 private:
  bool has_duplicates() const { return delaunay_.site_count != delaunay_.points.size(); }
  void rename_site(Vertex_handle vertex, int new_site);
  void enter(Face_handle face);
  void move_triangle(int from, int to);

  Delaunay_2& delaunay_;
  Dynamic::Triangulation& triangulation_;
  std::vector<int> free_;
  Vertex_handle hint_;
};

void Local_editor::rename_site(Vertex_handle vertex, int new_site) {
  const int old_site = vertex->info().value;
  vertex->info().value = new_site;
  auto face = triangulation_.incident_faces(vertex);
  const auto done = face;
  do {
    if (const int t = face->info().value; t >= 0) delaunay_.triangles[t][face->index(vertex)] = new_site;
  } while (++face != done);
  for (int& site : delaunay_.site)
    if (site == old_site) site = new_site;
}

void Local_editor::enter(Face_handle face) {
  int& t = face->info().value;
  if (t < 0) {
    if (free_.empty()) {
      t = static_cast<int>(delaunay_.triangles.size());
      delaunay_.triangles.emplace_back();
      delaunay_.neighbors.emplace_back();
    } else {
      t = free_.back();
      free_.pop_back();
    }
  }
  for (int i = 0; i < 3; ++i) {
    delaunay_.triangles[t][i] = face->vertex(i)->info().value;
    const Face_handle other = face->neighbor(i);
    const int u = other->info().value;
    delaunay_.neighbors[t][i] = u;
    if (u >= 0) delaunay_.neighbors[u][other->index(face)] = t;
  }
}

bool Local_editor::remove_point(int point) {
  const Vertex_handle vertex = delaunay_.dynamic->vertex_of_point[point];
  delaunay_.site[point] = -1;
  if (has_duplicates()) {
    const int site = vertex->info().value;
    if (site != point) return true;
    const auto twin = std::ranges::find(delaunay_.site, site);
    if (twin != delaunay_.site.end()) {
      rename_site(vertex, static_cast<int>(twin - delaunay_.site.begin()));
      return true;
    }
  }

  std::vector<Vertex_handle> link;
  {
    auto face = triangulation_.incident_faces(vertex);
    const auto done = face;
    do {
      if (face->info().value >= 0) free_.push_back(face->info().value);
      face->info().value = -1;
      const Vertex_handle next = face->vertex(Dynamic::Triangulation::ccw(face->index(vertex)));
      if (!triangulation_.is_infinite(next)) link.push_back(next);
    } while (++face != done);
  }
  if (link.size() > large_star && 4 * link.size() > triangulation_.number_of_vertices()) return false;
  triangulation_.remove(vertex);
  --delaunay_.site_count;
  if (triangulation_.dimension() < 2) return false;
  hint_ = link.front();

  // The new faces have all their corners in the link. CGAL reuses faces of the star for them; all of these were
  // unmarked above. Marks of infinite faces stay -1.
  std::vector<Face_handle> fresh;
  for (const Vertex_handle& corner : link) {
    auto face = triangulation_.incident_faces(corner);
    const auto done = face;
    do {
      if (face->info().value < 0 && !triangulation_.is_infinite(face)) {
        fresh.push_back(face);
        face->info().value = -2;
      }
    } while (++face != done);
  }
  for (const Face_handle& face : fresh) face->info().value = -1;
  for (const Face_handle& face : fresh) enter(face);
  // Hull edges that the removal uncovered: their old neighbours were in the star.
  for (const Vertex_handle& corner : link) {
    auto face = triangulation_.incident_faces(corner);
    const auto done = face;
    do {
      const int t = face->info().value;
      if (t < 0) continue;
      for (int i = 0; i < 3; ++i)
        if (face->neighbor(i)->info().value < 0) delaunay_.neighbors[t][i] = -1;
    } while (++face != done);
  }
  return true;
}

void Local_editor::insert_point(int point, const Point_2& position) {
  const std::size_t vertices_before = triangulation_.number_of_vertices();
  const Vertex_handle vertex = triangulation_.insert(Dynamic::Kernel::Point_2(position.x, position.y),
                                                     hint_ == Vertex_handle() ? Face_handle() : hint_->face());
  hint_ = vertex;
  delaunay_.points[point] = position;
  delaunay_.dynamic->vertex_of_point[point] = vertex;
  if (triangulation_.number_of_vertices() == vertices_before) {
    delaunay_.site[point] = vertex->info().value;
    if (point < vertex->info().value) {
      delaunay_.site[point] = point;
      rename_site(vertex, point);
    }
    return;
  }
  vertex->info().value = point;
  delaunay_.site[point] = point;
  ++delaunay_.site_count;
  std::vector<Face_handle> star;
  auto face = triangulation_.incident_faces(vertex);
  const auto done = face;
  do {
    if (!triangulation_.is_infinite(face)) {
      star.push_back(face);
    } else if (int& t = face->info().value; t >= 0) {
      // The point lies on a hull edge: CGAL's flip made the finite face there the infinite one beyond it.
      free_.push_back(t);
      t = -1;
    }
  } while (++face != done);
  for (const Face_handle& f : star) enter(f);
}

void Local_editor::move_triangle(int from, int to) {
  delaunay_.triangles[to] = delaunay_.triangles[from];
  delaunay_.neighbors[to] = delaunay_.neighbors[from];
  for (int i = 0; i < 3; ++i) {
    const int u = delaunay_.neighbors[from][i];
    if (u < 0) continue;
    for (int& back : delaunay_.neighbors[u])
      if (back == from) back = to;
  }
  const auto& corners = delaunay_.triangles[to];
  Face_handle face;
  const bool found = triangulation_.is_face(delaunay_.dynamic->vertex_of_point[corners[0]],
                                            delaunay_.dynamic->vertex_of_point[corners[1]],
                                            delaunay_.dynamic->vertex_of_point[corners[2]], face);
  if (found) face->info().value = to;
}

void Local_editor::finish() {
  std::ranges::sort(free_, std::greater<>());
  for (const int hole : free_) {
    const int last = static_cast<int>(delaunay_.triangles.size()) - 1;
    if (hole != last) move_triangle(last, hole);
    delaunay_.triangles.pop_back();
    delaunay_.neighbors.pop_back();
  }
  free_.clear();
}

/// Removes the entries [first, first + removed) and puts `inserted` new ones there; sites keep their vertices.
void renumber(Delaunay_2& delaunay, std::size_t first, std::size_t removed, std::size_t inserted) {
  if (removed == inserted) return;
  const int shift = static_cast<int>(inserted) - static_cast<int>(removed);
  const int moved_from = static_cast<int>(first + removed);
  const auto rename = [&](int& index) {
    if (index >= moved_from) index += shift;
  };
  for (auto& triangle : delaunay.triangles)
    for (int& corner : triangle) rename(corner);
  for (int& site : delaunay.site) rename(site);
  for (const auto& vertex : delaunay.dynamic->triangulation.finite_vertex_handles()) rename(vertex->info().value);
  const auto resize = [&](auto& vector) {
    const auto begin = vector.begin() + static_cast<std::ptrdiff_t>(first);
    if (inserted > removed) {
      vector.insert(begin + static_cast<std::ptrdiff_t>(removed), inserted - removed, {});
    } else {
      vector.erase(begin + static_cast<std::ptrdiff_t>(inserted), begin + static_cast<std::ptrdiff_t>(removed));
    }
  };
  resize(delaunay.points);
  resize(delaunay.site);
  resize(delaunay.dynamic->vertex_of_point);
}

}  // namespace

bool update(Delaunay_2& triangulation, std::span<const Point_2> points, Progress& progress) {
  const auto start_afresh = [&] {
    triangulation = delaunay(points, progress);
    return false;
  };
  if (!triangulation.dynamic || triangulation.dimension < 2) return start_afresh();

  const std::vector<Point_2>& old = triangulation.points;
  const std::size_t common = std::min(old.size(), points.size());
  std::vector<int> removed;
  std::vector<int> inserted;
  std::size_t first = 0;
  if (old.size() == points.size()) {
    for (std::size_t i = 0; i < common && removed.size() <= most_local_changes; ++i)
      if (old[i] != points[i]) removed.push_back(static_cast<int>(i));
    inserted = removed;
  } else {
    while (first < common && old[first] == points[first]) ++first;
    std::size_t last = 0;
    while (last < common - first && old[old.size() - 1 - last] == points[points.size() - 1 - last]) ++last;
    if (std::max(old.size(), points.size()) - first - last > most_local_changes) return start_afresh();
    for (std::size_t i = first; i < old.size() - last; ++i) removed.push_back(static_cast<int>(i));
    for (std::size_t i = first; i < points.size() - last; ++i) inserted.push_back(static_cast<int>(i));
  }
  if (removed.size() > most_local_changes || 10 * (removed.size() + inserted.size()) > points.size())
    return start_afresh();

  Local_editor editor(triangulation);
  for (const int point : removed) {
    progress.check();
    if (!editor.remove_point(point)) return start_afresh();
  }
  if (old.size() != points.size()) renumber(triangulation, first, removed.size(), inserted.size());
  for (const int point : inserted) triangulation.site[point] = -1;
  for (const int point : inserted) {
    progress.check();
    editor.insert_point(point, points[point]);
  }
  editor.finish();
  return true;
}

}  // namespace mesecina

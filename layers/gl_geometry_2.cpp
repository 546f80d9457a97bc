// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_geometry_2.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace mesecina {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

struct Circle_arc {
  Point_2 center;
  double radius = 0;
  Point_2 start;  ///< counterclockwise from here ...
  Point_2 end;    ///< ... to here
  bool whole = false;
};

Point_2 planar(const Primitive_set& set, int vertex) { return {set.vertices[vertex].x, set.vertices[vertex].y}; }

std::size_t first_element(const Primitive_set& set, Part part) {
  std::size_t first = 0;
  if (part == Part::points) return first;
  first += set.points.size();
  if (part == Part::segments) return first;
  first += set.segments.size();
  if (part == Part::rays) return first;
  first += set.rays.size();
  if (part == Part::arcs) return first;
  first += set.arcs.size();
  if (part == Part::triangles || part == Part::triangle_edges) return first;
  first += set.triangles.size();
  if (part == Part::polygons || part == Part::polygon_edges) return first;
  return first + set.polygon_count();
}

template <class Visit>
void visit_segments(const Primitive_set& set, Part part, Visit visit) {
  std::size_t element = first_element(set, part);
  if (part == Part::segments) {
    for (const auto& s : set.segments) visit(element++, planar(set, s[0]), planar(set, s[1]));
  } else if (part == Part::triangle_edges) {
    for (const auto& t : set.triangles) {
      for (int i = 0; i < 3; ++i) visit(element, planar(set, t[i]), planar(set, t[(i + 1) % 3]));
      ++element;
    }
  } else {
    for (std::size_t i = 0; i < set.polygon_count(); ++i, ++element) {
      const auto ring = set.polygon(i);
      for (std::size_t j = 0; j < ring.size(); ++j)
        visit(element, planar(set, ring[j]), planar(set, ring[(j + 1) % ring.size()]));
    }
  }
}

template <class Visit>
void visit_circles(const Primitive_set& set, Part part, Visit visit) {
  std::size_t element = first_element(set, part);
  if (part == Part::balls) {
    for (const Ball& ball : set.balls)
      visit(element++, Circle_arc{planar(set, ball.center), ball.radius, {}, {}, true});
    return;
  }
  for (const Arc& arc : set.arcs) {
    Circle_arc circle{arc.center, arc.radius, planar(set, arc.from), planar(set, arc.to), arc.from == arc.to};
    if (!arc.counterclockwise) std::swap(circle.start, circle.end);
    visit(element++, circle);
  }
}

/// Triangles and polygons as rings of points; `ring` is reused.
template <class Visit>
void visit_rings(const Primitive_set& set, Part part, Visit visit) {
  std::size_t element = first_element(set, part);
  std::vector<Point_2> ring;
  if (part == Part::triangles) {
    for (const auto& t : set.triangles) {
      ring = {planar(set, t[0]), planar(set, t[1]), planar(set, t[2])};
      visit(element++, ring);
    }
    return;
  }
  for (std::size_t i = 0; i < set.polygon_count(); ++i) {
    ring.clear();
    for (int v : set.polygon(i)) ring.push_back(planar(set, v));
    visit(element++, ring);
  }
}

class Writer {
 public:
  explicit Writer(const Point_2& origin) { result_.origin = origin; }

  void point(std::size_t element, const Point_2& p) {
    add(element);
    place(p);
  }
  void segment(std::size_t element, const Point_2& p, const Point_2& q) {
    add(element);
    place(p);
    place(q);
  }
  void ray(std::size_t element, const Point_2& from, const Point_3& direction) {
    add(element);
    place(from);
    number(direction.x);
    number(direction.y);
  }
  void fan(std::size_t element, const std::vector<Point_2>& ring) {
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      add(element);
      place(ring[0]);
      place(ring[i]);
      place(ring[i + 1]);
    }
  }
  void circle(std::size_t element, const Circle_arc& circle) {
    add(element);
    place(circle.center);
    number(circle.radius);
    double start = 0;
    double covered = full_turn;
    if (!circle.whole) {
      start = std::atan2(circle.start.y - circle.center.y, circle.start.x - circle.center.x);
      covered = std::atan2(circle.end.y - circle.center.y, circle.end.x - circle.center.x) - start;
      if (covered < 0) covered += full_turn;
    }
    number(start);
    number(covered);
  }
  void far_circle(std::size_t element, const Circle_arc& circle) {
    add(element);
    const double x = circle.center.x - result_.origin.x;
    const double y = circle.center.y - result_.origin.y;
    const double r = circle.radius;
    number(x / r);
    number(y / r);
    number(std::hypot(x, y) - r);
    number(1 / r);
    place(circle.start);
    place(circle.end);
    number((circle.center.y - circle.start.y) / r);
    number((circle.start.x - circle.center.x) / r);
    number((circle.center.y - circle.end.y) / r);
    number((circle.end.x - circle.center.x) / r);
    number(circle.whole ? 1 : 0);
  }

  Instances take() { return std::move(result_); }

 private:
  void add(std::size_t element) { result_.elements.push_back(static_cast<std::uint32_t>(element)); }
  void number(double x) { result_.data.push_back(static_cast<float>(x)); }
  void place(const Point_2& p) {
    number(p.x - result_.origin.x);
    number(p.y - result_.origin.y);
  }

  Instances result_;
};

bool contains(const Window_2& window, const Point_2& p) {
  return std::abs(p.x - window.center.x) <= window.half_side && std::abs(p.y - window.center.y) <= window.half_side;
}

/// Cuts p + t d, t in [0, t_end], at the window; false if nothing of it is left.
bool cut_line(const Window_2& window, const Point_2& p, const Point_2& d, double t_end, Point_2& from, Point_2& to) {
  double t0 = 0;
  double t1 = t_end;
  const auto cut = [&](double start, double step, double middle) {
    const double low = middle - window.half_side - start;
    const double high = middle + window.half_side - start;
    if (step == 0) return low <= 0 && high >= 0;
    const double a = low / step;
    const double b = high / step;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
    return t0 <= t1;
  };
  if (!cut(p.x, d.x, window.center.x) || !cut(p.y, d.y, window.center.y)) return false;
  from = {p.x + t0 * d.x, p.y + t0 * d.y};
  to = {p.x + t1 * d.x, p.y + t1 * d.y};
  return std::isfinite(from.x + from.y + to.x + to.y);
}

/// Sutherland-Hodgman: the part of the ring on the inner side of one border of the window.
/// `inside(p)` is positive inside and linear in p.
template <class Inside>
void cut_ring(std::vector<Point_2>& ring, std::vector<Point_2>& scratch, Inside inside) {
  scratch.clear();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point_2& p = ring[i];
    const Point_2& q = ring[(i + 1) % ring.size()];
    const double at_p = inside(p);
    const double at_q = inside(q);
    if (at_p >= 0) scratch.push_back(p);
    if ((at_p >= 0) != (at_q >= 0)) {
      const double t = at_p / (at_p - at_q);
      scratch.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  ring.swap(scratch);
}

void cut_ring(std::vector<Point_2>& ring, std::vector<Point_2>& scratch, const Window_2& window) {
  bool all_inside = true;
  for (const Point_2& p : ring) all_inside = all_inside && contains(window, p);
  if (all_inside) return;
  const double r = window.half_side;
  const Point_2 c = window.center;
  cut_ring(ring, scratch, [&](const Point_2& p) { return p.x - c.x + r; });
  cut_ring(ring, scratch, [&](const Point_2& p) { return r - (p.x - c.x); });
  cut_ring(ring, scratch, [&](const Point_2& p) { return p.y - c.y + r; });
  cut_ring(ring, scratch, [&](const Point_2& p) { return r - (p.y - c.y); });
}

bool is_circle_part(Part part) { return part == Part::arcs || part == Part::balls; }
bool is_ring_part(Part part) { return part == Part::triangles || part == Part::polygons; }

}  // namespace

int floats_per_instance(Part part) {
  if (part == Part::points) return 2;
  if (is_circle_part(part)) return 5;
  return is_ring_part(part) ? 6 : 4;
}

bool has_part(const Primitive_set& set, Part part) {
  switch (part) {
    case Part::points:
      return !set.points.empty();
    case Part::segments:
      return !set.segments.empty();
    case Part::rays:
      return !set.rays.empty();
    case Part::arcs:
      return !set.arcs.empty();
    case Part::triangles:
    case Part::triangle_edges:
      return !set.triangles.empty();
    case Part::polygons:
    case Part::polygon_edges:
      return set.polygon_count() > 0;
    case Part::balls:
      return !set.balls.empty();
  }
  return false;
}

double farthest_reach(const Primitive_set& set, Part part, const Point_2& origin) {
  double reach = 0;
  const auto add = [&](const Point_2& p, double radius) {
    const double here = std::max(std::abs(p.x - origin.x), std::abs(p.y - origin.y)) + std::abs(radius);
    reach = std::isfinite(here) ? std::max(reach, here) : std::numeric_limits<double>::infinity();
  };
  if (part == Part::points) {
    for (int v : set.points) add(planar(set, v), 0);
  } else if (part == Part::rays) {
    for (const Ray& ray : set.rays) add(planar(set, ray.from), 0);
  } else if (is_circle_part(part)) {
    visit_circles(set, part, [&](std::size_t, const Circle_arc& circle) { add(circle.center, circle.radius); });
  } else if (is_ring_part(part)) {
    visit_rings(set, part, [&](std::size_t, const std::vector<Point_2>& ring) {
      for (const Point_2& p : ring) add(p, 0);
    });
  } else {
    visit_segments(set, part, [&](std::size_t, const Point_2& p, const Point_2&) { add(p, 0); });
    if (part == Part::segments)
      for (const auto& s : set.segments) add(planar(set, s[1]), 0);
  }
  return reach;
}

Instances whole_part(const Primitive_set& set, Part part, const Point_2& origin) {
  Writer writer(origin);
  if (part == Part::points) {
    std::size_t element = first_element(set, part);
    for (int v : set.points) writer.point(element++, planar(set, v));
  } else if (part == Part::rays) {
    std::size_t element = first_element(set, part);
    for (const Ray& ray : set.rays) writer.ray(element++, planar(set, ray.from), ray.direction);
  } else if (is_circle_part(part)) {
    visit_circles(set, part, [&](std::size_t element, const Circle_arc& circle) { writer.circle(element, circle); });
  } else if (is_ring_part(part)) {
    visit_rings(set, part, [&](std::size_t element, const std::vector<Point_2>& ring) { writer.fan(element, ring); });
  } else {
    visit_segments(set, part,
                   [&](std::size_t element, const Point_2& p, const Point_2& q) { writer.segment(element, p, q); });
  }
  return writer.take();
}

Cut_out cut_out_part(const Primitive_set& set, Part part, const Window_2& window) {
  Writer near(window.center);
  Writer far(window.center);
  Point_2 from;
  Point_2 to;
  if (part == Part::points) {
    std::size_t element = first_element(set, part);
    for (int v : set.points) {
      if (contains(window, planar(set, v))) near.point(element, planar(set, v));
      ++element;
    }
  } else if (part == Part::rays) {
    std::size_t element = first_element(set, part);
    for (const Ray& ray : set.rays) {
      const Point_2 direction{ray.direction.x, ray.direction.y};
      if (cut_line(window, planar(set, ray.from), direction, std::numeric_limits<double>::infinity(), from, to))
        near.segment(element, from, to);
      ++element;
    }
  } else if (is_circle_part(part)) {
    const double reach = window.half_side * std::numbers::sqrt2;
    visit_circles(set, part, [&](std::size_t element, const Circle_arc& circle) {
      const double away = distance(circle.center, window.center) - circle.radius;
      if (!(away <= reach) || (part == Part::arcs && away < -reach)) return;
      if (circle.radius * window.largest_scale > largest_near_radius)
        far.far_circle(element, circle);
      else
        near.circle(element, circle);
    });
  } else if (is_ring_part(part)) {
    std::vector<Point_2> cut;
    std::vector<Point_2> scratch;
    visit_rings(set, part, [&](std::size_t element, const std::vector<Point_2>& ring) {
      cut = ring;
      cut_ring(cut, scratch, window);
      near.fan(element, cut);
    });
  } else {
    visit_segments(set, part, [&](std::size_t element, const Point_2& p, const Point_2& q) {
      if (contains(window, p) && contains(window, q))
        near.segment(element, p, q);
      else if (cut_line(window, p, {q.x - p.x, q.y - p.y}, 1, from, to))
        near.segment(element, from, to);
    });
  }
  return {near.take(), far.take()};
}

}  // namespace mesecina

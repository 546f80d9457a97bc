// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>

#include "geometries/power_crust_2/circle_center.h"
#include "geometries/power_crust_2/power_crust_2.h"

namespace mesecina {

namespace {

using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Exact_rational;

constexpr double allowed_error = 1e-9;

/// Three points of a circle, far apart if it has many.
struct Circle {
  Point_2 p;
  Point_2 q;
  Point_2 r;
};

Circle circle_of(const Balls_2& balls, int disk) {
  const auto contacts = balls.contacts_of(disk);
  const auto at = [&](std::size_t third) { return (*balls.samples)[contacts[third * contacts.size() / 3]]; };
  return {at(0), at(1), at(2)};
}

/// Center seen from an origin, and the power distance of that origin.
template <class Number>
struct Disk {
  Vector<Number> center;
  Number power;
};

template <class Number>
Disk<Number> disk_seen_from(const Point_2& origin, const Circle& circle) {
  const auto offset = offset_of_center<Number>(circle.p, circle.q, circle.r);
  const Vector<Number> to_center{offset.vector.x / offset.factor, offset.vector.y / offset.factor};
  const auto to_circle = difference<Number>(circle.p, origin);
  return {{to_circle.x + to_center.x, to_circle.y + to_center.y},
          dot(to_circle, to_circle) + 2 * dot(to_circle, to_center)};
}

/// The point of equal power distance to the disks, seen from a point on the circle of the first.
template <class Number>
Vector<Number> power_vertex(const std::array<Circle, 3>& circles) {
  const Point_2& origin = circles[0].p;
  const Disk<Number> a = disk_seen_from<Number>(origin, circles[0]);
  const Disk<Number> b = disk_seen_from<Number>(origin, circles[1]);
  const Disk<Number> c = disk_seen_from<Number>(origin, circles[2]);
  const Vector<Number> to_b{b.center.x - a.center.x, b.center.y - a.center.y};
  const Vector<Number> to_c{c.center.x - a.center.x, c.center.y - a.center.y};
  const Number b2 = b.power - a.power;
  const Number c2 = c.power - a.power;
  const Number twice_cross = 2 * (to_b.x * to_c.y - to_b.y * to_c.x);
  return {(to_c.y * b2 - to_b.y * c2) / twice_cross, (to_b.x * c2 - to_c.x * b2) / twice_cross};
}

/// Wants upward rounding.
Point_2 rounded_power_vertex(const std::array<Circle, 3>& circles, double error) {
  const Point_2& origin = circles[0].p;
  const auto rough = power_vertex<Interval>(circles);
  const auto is_sure = [error](const Interval& x) { return x.sup() - x.inf() <= error; };
  if (is_sure(rough.x) && is_sure(rough.y))
    return {origin.x + (rough.x.inf() + rough.x.sup()) / 2, origin.y + (rough.y.inf() + rough.y.sup()) / 2};
  const auto sure = power_vertex<Rational>(circles);
  return {CGAL::to_double(Rational(origin.x) + sure.x), CGAL::to_double(Rational(origin.y) + sure.y)};
}

}  // namespace

Polar_diagram_2 polar_power_diagram(const Polar_balls_2& polar, Progress& progress) {
  const Regular_2& regular = *polar.regular;
  const Balls_2& balls = *regular.balls;
  Box box;
  for (std::size_t s = 0; s < polar.poles->first.size(); ++s) box.add((*balls.samples)[s]);
  const double error = allowed_error * box.diagonal();
  Polar_diagram_2 diagram;
  std::vector<int> vertex_of_sample(balls.samples->size(), -1);
  diagram.vertex_of_triangle.reserve(regular.triangles.size());
  const CGAL::Protect_FPU_rounding<true> upward_rounding;
  for (std::size_t t = 0; t < regular.triangles.size(); ++t) {
    if (t % 1024 == 0) progress.check();
    auto disks = regular.triangles[t];
    const int sample = shared_sample(balls, disks);
    const int vertex = static_cast<int>(diagram.vertices.size());
    if (sample >= 0 && vertex_of_sample[sample] >= 0) {
      diagram.vertex_of_triangle.push_back(vertex_of_sample[sample]);
      continue;
    }
    diagram.vertex_of_triangle.push_back(vertex);
    if (sample >= 0) {
      vertex_of_sample[sample] = vertex;
      diagram.vertices.push_back((*balls.samples)[sample]);
      continue;
    }
    // The smallest disk first, and always in the same order.
    std::ranges::sort(disks, [&](int a, int b) {
      return balls.radii[a] != balls.radii[b] ? balls.radii[a] < balls.radii[b] : a < b;
    });
    diagram.vertices.push_back(rounded_power_vertex(
        {circle_of(balls, disks[0]), circle_of(balls, disks[1]), circle_of(balls, disks[2])}, error));
  }
  return diagram;
}

}  // namespace mesecina

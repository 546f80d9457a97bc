// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/picker_2.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>

#include "layers/box_tree.h"
#include "layers/scene_shapes.h"

namespace mesecina {
namespace {

constexpr double far = std::numeric_limits<double>::infinity();

double distance_to_segment(const Point_2& p, const Point_2& a, const Point_2& b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double squared_length = dx * dx + dy * dy;
  double t = squared_length > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / squared_length : 0;
  t = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - (a.x + t * dx), p.y - (a.y + t * dy));
}

double distance_to_ray(const Point_2& p, const Point_2& from, const Point_2& direction) {
  const double t = (p.x - from.x) * direction.x + (p.y - from.y) * direction.y;
  if (t <= 0) return distance(p, from);
  return std::abs((p.x - from.x) * direction.y - (p.y - from.y) * direction.x);
}

/// True when p is inside by the even-odd rule.
bool is_inside(const Point_2& p, std::span<const Point_2> ring) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if ((ring[i].y > p.y) == (ring[j].y > p.y)) continue;
    if (p.x < ring[i].x + (p.y - ring[i].y) / (ring[j].y - ring[i].y) * (ring[j].x - ring[i].x)) inside = !inside;
  }
  return inside;
}

double distance_to_ring(const Point_2& p, std::span<const Point_2> ring) {
  double nearest = far;
  for (std::size_t i = 0; i < ring.size(); ++i)
    nearest = std::min(nearest, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  return nearest;
}

/// What is better to pick has the smaller rank.
enum class Rank { point, curve, area };

struct Candidate {
  std::size_t element = 0;
  Rank rank = Rank::area;
  double distance = far;  ///< from its middle line, or from the inside, in pixels
};

bool is_better(const Candidate& a, const Candidate& b) {
  return std::tuple(a.rank, a.distance) < std::tuple(b.rank, b.distance) ||
         (a.rank == b.rank && a.distance == b.distance && a.element > b.element);
}

}  // namespace

/// Boxes of one Primitive_set in the plane (as they are, y up).
struct Picker_2::Index {
  explicit Index(const std::shared_ptr<const Primitive_set>& primitives);

  struct Query {
    Point_2 position;      ///< in the plane
    double scale = 1;      ///< pixels per unit
    double tolerance = 0;  ///< pixels
    const Style* style = nullptr;
  };
  /// Follows the layer's cut and thresholds; O(elements) only when they have changed.
  void update_drawn(const Scene_layer& layer);
  std::optional<Candidate> best(const Query& query) const;
  /// Pixels by which the drawn element is wider than what Candidate::distance is measured from.
  static double half_width(const Style& style, Rank rank);

  std::weak_ptr<const Primitive_set> primitives;

 private:
  struct Filter {
    std::optional<Cut> cut;
    std::string value;
    std::optional<double> minimum;
    std::optional<double> maximum;
    bool operator==(const Filter&) const = default;
  };

  Point_2 vertex(int i) const {
    const Point_3& p = set_->vertices[static_cast<std::size_t>(i)];
    return {p.x, p.y};
  }
  bool is_drawn(std::size_t element) const { return drawn_.empty() || drawn_[element]; }
  Ring_2 ring(std::size_t polygon) const;
  Candidate measure(std::size_t element, const Query& query) const;
  double distance_to_arc(const Arc& arc, const Point_2& p) const;

  const Primitive_set* set_;
  Box_tree tree_;
  std::size_t first_segment_;
  std::size_t first_ray_;
  std::size_t first_arc_;
  std::size_t first_triangle_;
  std::size_t first_polygon_;
  std::size_t first_ball_;
  Filter filter_;
  std::vector<bool> drawn_;
};

Picker_2::Index::Index(const std::shared_ptr<const Primitive_set>& given) : primitives(given), set_(given.get()) {
  const Primitive_set& set = *set_;
  first_segment_ = set.points.size();
  first_ray_ = first_segment_ + set.segments.size();
  first_arc_ = first_ray_ + set.rays.size();
  first_triangle_ = first_arc_ + set.arcs.size();
  first_polygon_ = first_triangle_ + set.triangles.size();
  first_ball_ = first_polygon_ + set.polygon_count();
  const auto around = [](const Point_2& center, double radius) {
    return Pixel_box{center.x, center.y, center.x, center.y}.grown(radius);
  };
  std::vector<Pixel_box> boxes;
  boxes.reserve(set.element_count());
  for (const int point : set.points) boxes.push_back(around(vertex(point), 0));
  for (const auto& [a, b] : set.segments) boxes.push_back(box_of(std::array{vertex(a), vertex(b)}));
  // Rays are unbounded and few: they are all measured.
  boxes.resize(first_arc_, {far, far, far, far});
  for (const Arc& arc : set.arcs) {
    const Box box = bounding_box(set, arc);
    boxes.push_back({box.lower.x, box.lower.y, box.upper.x, box.upper.y});
  }
  for (const auto& [a, b, c] : set.triangles) boxes.push_back(box_of(std::array{vertex(a), vertex(b), vertex(c)}));
  for (std::size_t i = 0; i < set.polygon_count(); ++i) {
    const Ring_2 corners = ring(i);
    boxes.push_back(corners.empty() ? Pixel_box{far, far, far, far} : box_of(corners));
  }
  for (const Ball& ball : set.balls) boxes.push_back(around(vertex(ball.center), ball.radius));
  tree_ = Box_tree(boxes);
}

void Picker_2::Index::update_drawn(const Scene_layer& layer) {
  Filter filter{layer.cut, {}, layer.style.threshold_minimum, layer.style.threshold_maximum};
  if (filter.minimum || filter.maximum) filter.value = layer.style.value;
  if (filter == filter_) return;
  drawn_ = drawn_elements(layer);
  filter_ = std::move(filter);
}

double Picker_2::Index::half_width(const Style& style, Rank rank) {
  if (rank == Rank::point) return style.point_size / 2;
  return rank == Rank::curve ? style.line_width / 2 : 0;
}

Ring_2 Picker_2::Index::ring(std::size_t polygon) const {
  Ring_2 corners;
  for (const int v : set_->polygon(polygon)) corners.push_back(vertex(v));
  return corners;
}

double Picker_2::Index::distance_to_arc(const Arc& arc, const Point_2& p) const {
  const double to_circle = std::abs(distance(p, arc.center) - arc.radius);
  if (arc.from == arc.to) return to_circle;
  const Point_2 from = vertex(arc.counterclockwise ? arc.from : arc.to);
  const Point_2 to = vertex(arc.counterclockwise ? arc.to : arc.from);
  const auto angle_from_start = [&](const Point_2& q) {
    const double angle =
        std::atan2(q.y - arc.center.y, q.x - arc.center.x) - std::atan2(from.y - arc.center.y, from.x - arc.center.x);
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  };
  if (angle_from_start(p) <= angle_from_start(to)) return to_circle;
  return std::min(distance(p, from), distance(p, to));
}

Candidate Picker_2::Index::measure(std::size_t element, const Query& query) const {
  const Point_2& p = query.position;
  const bool filled = query.style->filled;
  const auto found = [&](Rank rank, double units) { return Candidate{element, rank, units * query.scale}; };
  if (element < first_segment_) return found(Rank::point, distance(p, vertex(set_->points[element])));
  if (element < first_ray_) {
    const auto& [a, b] = set_->segments[element - first_segment_];
    return found(Rank::curve, distance_to_segment(p, vertex(a), vertex(b)));
  }
  if (element < first_arc_) {
    const Ray& ray = set_->rays[element - first_ray_];
    return found(Rank::curve, distance_to_ray(p, vertex(ray.from), {ray.direction.x, ray.direction.y}));
  }
  if (element < first_triangle_) return found(Rank::curve, distance_to_arc(set_->arcs[element - first_arc_], p));
  if (element < first_polygon_) {
    const auto& [a, b, c] = set_->triangles[element - first_triangle_];
    const std::array corners{vertex(a), vertex(b), vertex(c)};
    if (!filled) return found(Rank::curve, distance_to_ring(p, corners));
    return found(Rank::area, is_inside(p, corners) ? 0 : distance_to_ring(p, corners));
  }
  if (element < first_ball_) {
    const Ring_2 corners = ring(element - first_polygon_);
    return found(filled ? Rank::area : Rank::curve, distance_to_ring(p, corners));
  }
  const Ball& ball = set_->balls[element - first_ball_];
  const double outside = distance(p, vertex(ball.center)) - ball.radius;
  if (filled) return found(Rank::area, std::max(0.0, outside));
  return found(Rank::curve, std::abs(outside));
}

std::optional<Candidate> Picker_2::Index::best(const Query& query) const {
  const Style& style = *query.style;
  std::optional<Candidate> result;
  const auto offer = [&](const Candidate& candidate) {
    if (candidate.distance > query.tolerance + half_width(style, candidate.rank)) return;
    if (!result || is_better(candidate, *result)) result = candidate;
  };
  const double widest = query.tolerance + std::max(style.point_size, style.line_width) / 2;
  const double radius = widest / query.scale;
  const Pixel_box around{query.position.x - radius, query.position.y - radius, query.position.x + radius,
                         query.position.y + radius};
  // Polygons are filled together: those around the position decide in common whether it is inside.
  std::size_t polygons_around = 0;
  std::optional<std::pair<double, std::size_t>> innermost;
  tree_.query(around, [&](std::size_t element) {
    if (!is_drawn(element)) return;
    offer(measure(element, query));
    if (!style.filled || element < first_polygon_ || element >= first_ball_) return;
    const Ring_2 corners = ring(element - first_polygon_);
    if (!is_inside(query.position, corners)) return;
    ++polygons_around;
    const Pixel_box box = box_of(corners);
    const std::pair size((box.right - box.left) * (box.bottom - box.top), element);
    if (!innermost || size < *innermost) innermost = size;
  });
  if (polygons_around % 2 == 1) offer({innermost->second, Rank::area, 0});
  for (std::size_t element = first_ray_; element < first_arc_; ++element)
    if (is_drawn(element)) offer(measure(element, query));
  return result;
}

Picker_2::Picker_2() = default;
Picker_2::~Picker_2() = default;

std::optional<Picker_2::Hit> Picker_2::pick(const Scene& scene, const View_2& view, double width, double height,
                                            const Point_2& pixel, double tolerance) {
  std::erase_if(indices_, [](const auto& entry) { return entry.second->primitives.expired(); });
  std::optional<Candidate> best;
  std::optional<Hit> hit;
  for (std::size_t i = 0; i < scene.layers.size(); ++i) {
    const Scene_layer& layer = scene.layers[i];
    if (!is_shown(layer)) continue;
    std::shared_ptr<Index>& index = indices_[layer.primitives.get()];
    if (!index) index = std::make_shared<Index>(layer.primitives);
    index->update_drawn(layer);
    const auto candidate = index->best({view.to_plane(pixel, width, height), view.scale, tolerance, &layer.style});
    if (!candidate) continue;
    if (best && std::tuple(best->rank, best->distance) < std::tuple(candidate->rank, candidate->distance)) continue;
    best = candidate;
    hit = Hit{i, candidate->element,
              std::max(0.0, candidate->distance - Index::half_width(layer.style, candidate->rank))};
  }
  return hit;
}

}  // namespace mesecina

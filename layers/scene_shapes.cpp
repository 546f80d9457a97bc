// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/scene_shapes.h"

#include <algorithm>
#include <cmath>

#include "layers/arc_loops.h"

namespace mesecina {
namespace {

class Layer_sender {
 public:
  Layer_sender(const Scene_layer& layer, const Layer_colors& colors, const Page& page, Shape_sink& sink)
      : set_(*layer.primitives), style_(layer.style), colors_(colors), page_(page), sink_(sink) {
    drawn_ = drawn_elements(layer);
    const Pixel_box paper{0, 0, page.width, page.height};
    shown_ = paper.grown(2 + std::max(style_.line_width, style_.point_size));
    reached_ = paper.grown(page.reach);
    vertices_.reserve(set_.vertices.size());
    for (const Point_3& vertex : set_.vertices)
      vertices_.push_back(page.view.to_pixel({vertex.x, vertex.y}, page.width, page.height));
    first_segment_ = set_.points.size();
    first_ray_ = first_segment_ + set_.segments.size();
    first_arc_ = first_ray_ + set_.rays.size();
    first_triangle_ = first_arc_ + set_.arcs.size();
    first_polygon_ = first_triangle_ + set_.triangles.size();
    first_ball_ = first_polygon_ + set_.polygon_count();
  }

  void send() {
    if (set_.image) send_image(*set_.image);
    send_balls();
    send_polygons();
    send_triangles();
    send_arc_region();
    send_arcs();
    send_rays();
    send_segments();
    send_points();
  }

 private:
  const Point_2& vertex(int i) const { return vertices_[static_cast<std::size_t>(i)]; }
  bool is_drawn(std::size_t element) const { return drawn_.empty() || drawn_[element]; }

  void send_image(const Image& image) {
    if (image.width <= 0 || image.height <= 0) return;
    const Point_2 corner = page_.view.to_pixel(image.lower_left, page_.width, page_.height);
    const double pixel = image.pixel_size * page_.view.scale;
    const Pixel_box place{corner.x, corner.y - pixel * image.height, corner.x + pixel * image.width, corner.y};
    if (shown_.meets(place)) sink_.image(image, place);
  }

  void send_balls() {
    // Translucent disks of one colour are one area: overlaps are no darker than the rest.
    const bool are_united = style_.filled && style_.opacity < 1 && colors_.is_uniform();
    Pixel_region united;
    for (std::size_t i = 0; i < set_.balls.size(); ++i) {
      const std::size_t element = first_ball_ + i;
      if (!is_drawn(element)) continue;
      const Point_2& center = vertex(set_.balls[i].center);
      const double radius = set_.balls[i].radius * page_.view.scale;
      const Pixel_box box = Pixel_box{center.x, center.y, center.x, center.y}.grown(radius);
      if (!(radius > 0) || !std::isfinite(radius) || !shown_.meets(box)) continue;
      if (are_united) {
        if (radius <= page_.reach) {
          united.arcs.push_back(whole_circle(center, radius));
          united.end_loop();
        } else {
          united.rings.add(clip_disk(center, radius, shown_));
        }
      } else if (radius <= page_.reach) {
        if (style_.filled) {
          sink_.disk(center, radius, colors_(element));
        } else {
          sink_.circle(center, radius, colors_(element));
        }
      } else if (style_.filled) {
        rings_.clear();
        rings_.add(clip_disk(center, radius, shown_));
        if (!rings_.is_empty()) sink_.area(rings_, true, colors_(element));
      } else {
        for (const Pixel_arc& piece : clip_arc(whole_circle(center, radius), shown_))
          sink_.arc(piece, colors_(element));
      }
    }
    if (!united.is_empty()) sink_.region(united, false, style_.color);
  }

  /// False when nothing of the ring is on the page.
  bool add_ring(std::span<const Point_2> ring) {
    if (ring.size() < 3) return false;
    const Pixel_box box = box_of(ring);
    if (!shown_.meets(box)) return false;
    if (reached_.contains(box)) {
      rings_.add(ring);
    } else {
      rings_.add(clip_ring(ring, reached_));
    }
    return true;
  }

  void send_outline(std::span<const Point_2> ring, Color color) {
    if (ring.size() < 2) return;
    const Pixel_box box = box_of(ring);
    if (!shown_.meets(box)) return;
    if (reached_.contains(box)) {
      sink_.outline(ring, color);
    } else {
      for (std::size_t i = 0; i < ring.size(); ++i) send_segment(ring[i], ring[(i + 1) % ring.size()], color);
    }
  }

  void flush_area(bool odd_even, Color color) {
    if (!rings_.is_empty()) sink_.area(rings_, odd_even, color);
    rings_.clear();
  }

  void send_polygons() {
    rings_.clear();
    Color color;
    std::vector<Point_2> ring;
    for (std::size_t i = 0; i < set_.polygon_count(); ++i) {
      const std::size_t element = first_polygon_ + i;
      if (!is_drawn(element)) continue;
      ring.clear();
      for (const int v : set_.polygon(i)) ring.push_back(vertex(v));
      const Color own = colors_(element);
      if (!style_.filled) {
        send_outline(ring, own);
        continue;
      }
      if (own != color) flush_area(true, color);
      color = own;
      add_ring(ring);
    }
    flush_area(true, color);
  }

  void send_triangles() {
    rings_.clear();
    Color color;
    for (std::size_t i = 0; i < set_.triangles.size(); ++i) {
      const std::size_t element = first_triangle_ + i;
      if (!is_drawn(element)) continue;
      const auto& [a, b, c] = set_.triangles[i];
      std::array<Point_2, 3> ring{vertex(a), vertex(b), vertex(c)};
      const Color own = colors_(element);
      if (!style_.filled) {
        send_outline(ring, own);
        continue;
      }
      // One orientation, so that overlapping triangles add up whatever their own is.
      if ((ring[1].x - ring[0].x) * (ring[2].y - ring[0].y) < (ring[1].y - ring[0].y) * (ring[2].x - ring[0].x))
        std::swap(ring[1], ring[2]);
      if (own != color) flush_area(false, color);
      color = own;
      add_ring(ring);
    }
    flush_area(false, color);
  }

  Point_2 to_page(const Point_2& p) const { return page_.view.to_pixel(p, page_.width, page_.height); }

  Pixel_box to_page(const Box& box) const {
    const Point_2 lower = to_page(Point_2{box.lower.x, box.lower.y});
    const Point_2 upper = to_page(Point_2{box.upper.x, box.upper.y});
    return {lower.x, upper.y, upper.x, lower.y};
  }

  Pixel_arc to_page(const Pixel_arc& planar) const {
    return {to_page(planar.center), planar.radius * page_.view.scale,
            -planar.start,          -planar.sweep,
            to_page(planar.from),   to_page(planar.to)};
  }

  void send_arc_region() {
    if (!style_.filled || set_.arcs.empty()) return;
    constexpr double tolerance = 0.01;
    Pixel_region region;
    std::vector<Point_2> ring;
    const Arc_loops loops = closed_loops(set_, drawn_);
    for (std::size_t i = 0; i < loops.size(); ++i) {
      Box box;
      double largest_radius = 0;
      for (const Arc_step& step : loops.loop(i)) {
        const Arc& arc = set_.arcs[static_cast<std::size_t>(step.arc)];
        box.add(bounding_box(set_, arc));
        largest_radius = std::max(largest_radius, arc.radius * page_.view.scale);
      }
      const Pixel_box place = to_page(box);
      if (!shown_.meets(place)) continue;
      const bool is_whole = largest_radius <= page_.reach && reached_.contains(place);
      ring.clear();
      for (const Arc_step& step : loops.loop(i)) {
        const Pixel_arc arc = to_page(planar_arc(set_, step));
        if (is_whole) {
          region.arcs.push_back(arc);
        } else {
          append_polyline(arc, shown_, tolerance, ring);
        }
      }
      if (is_whole) {
        region.end_loop();
      } else {
        region.rings.add(clip_ring(ring, reached_));
      }
    }
    if (!region.is_empty()) sink_.region(region, true, style_.color);
  }

  void send_arcs() {
    for (std::size_t i = 0; i < set_.arcs.size(); ++i) {
      const std::size_t element = first_arc_ + i;
      if (!is_drawn(element)) continue;
      const Arc& arc = set_.arcs[i];
      const Point_2 center = to_page(arc.center);
      const double radius = arc.radius * page_.view.scale;
      if (!(radius > 0) || !std::isfinite(radius) || !shown_.meets(to_page(bounding_box(set_, arc)))) continue;
      const bool whole = arc.from == arc.to;
      const Color color = colors_(element);
      if (whole && radius <= page_.reach) {
        sink_.circle(center, radius, color);
        continue;
      }
      const Pixel_arc shape = whole
                                  ? whole_circle(center, radius)
                                  : arc_between(center, radius, vertex(arc.from), vertex(arc.to), arc.counterclockwise);
      if (radius <= page_.reach) {
        sink_.arc(shape, color);
      } else {
        for (const Pixel_arc& piece : clip_arc(shape, shown_)) sink_.arc(piece, color);
      }
    }
  }

  void send_segment(const Point_2& from, const Point_2& to, Color color) {
    const std::array ends{from, to};
    const Pixel_box box = box_of(ends);
    if (!shown_.meets(box)) return;
    if (reached_.contains(box)) {
      sink_.segment(from, to, color);
    } else if (const auto part = clip_segment(from, to, reached_)) {
      sink_.segment((*part)[0], (*part)[1], color);
    }
  }

  void send_rays() {
    for (std::size_t i = 0; i < set_.rays.size(); ++i) {
      if (!is_drawn(first_ray_ + i)) continue;
      const Ray& ray = set_.rays[i];
      if (const auto part = clip_ray(vertex(ray.from), {ray.direction.x, -ray.direction.y}, shown_))
        sink_.segment((*part)[0], (*part)[1], colors_(first_ray_ + i));
    }
  }

  void send_segments() {
    for (std::size_t i = 0; i < set_.segments.size(); ++i)
      if (is_drawn(first_segment_ + i))
        send_segment(vertex(set_.segments[i][0]), vertex(set_.segments[i][1]), colors_(first_segment_ + i));
  }

  void send_points() {
    for (std::size_t i = 0; i < set_.points.size(); ++i)
      if (is_drawn(i) && shown_.contains(vertex(set_.points[i]))) sink_.dot(vertex(set_.points[i]), colors_(i));
  }

  const Primitive_set& set_;
  const Style& style_;
  const Layer_colors& colors_;
  const Page& page_;
  Shape_sink& sink_;
  std::vector<bool> drawn_;
  Pixel_box shown_;
  Pixel_box reached_;
  std::vector<Point_2> vertices_;
  Pixel_rings rings_;
  std::size_t first_segment_ = 0;
  std::size_t first_ray_ = 0;
  std::size_t first_arc_ = 0;
  std::size_t first_triangle_ = 0;
  std::size_t first_polygon_ = 0;
  std::size_t first_ball_ = 0;
};

}  // namespace

bool is_shown(const Scene_layer& layer) {
  return layer.style.visible && layer.style.opacity > 0 && layer.primitives && !layer.primitives->is_empty();
}

void send_scene(const Scene& scene, const Page& page, Shape_sink& sink) {
  for (const Scene_layer& layer : scene.layers) {
    if (!is_shown(layer)) continue;
    const Layer_colors colors(layer);
    sink.begin_layer(layer, colors);
    Layer_sender(layer, colors, page, sink).send();
    sink.end_layer();
  }
}

}  // namespace mesecina

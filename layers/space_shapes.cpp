// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/space_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "layers/color_map.h"
#include "layers/gl_geometry_3.h"
#include "layers/gl_renderer_3.h"
#include "layers/projection_3.h"
#include "layers/scene_shapes.h"

namespace mesecina {

namespace {

constexpr double shade_of_edges = 0.45;
constexpr double width_of_edges = 0.6;
/// Of the diagonal of what is drawn: nearer to a plane is on it.
constexpr double thickness_of_planes = 1e-6;

Point_3 unit(const Point_3& p) {
  const double length = std::sqrt(dot(p, p));
  return length > 0 ? (1 / length) * p : Point_3{};
}

/// A face, a segment, a point or a ball in eye coordinates.
struct Piece {
  Space_shape::Kind kind = Space_shape::Kind::area;
  std::size_t layer = 0;
  std::vector<Point_3> places;
  double radius = 0;
  double line_width = 0;
  Color color;
};

/// Where `offset` is not negative is the front.
struct Plane {
  Point_3 normal;
  double constant = 0;
  double offset(const Point_3& p) const { return dot(normal, p) + constant; }
};

/// By Newell's method: of any polygon.
Plane plane_of(std::span<const Point_3> places) {
  Point_3 normal;
  Point_3 middle;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Point_3& p = places[i];
    const Point_3& q = places[(i + 1) % places.size()];
    normal = normal + cross(p - places[0], q - places[0]);
    middle = middle + p;
  }
  normal = unit(normal);
  return {normal, -dot(normal, middle) / static_cast<double>(places.size())};
}

/// The part of a piece with several places on one side, those on the plane included.
Piece part_of(const Piece& piece, const Plane& plane, double sign) {
  Piece part = piece;
  part.places.clear();
  const std::size_t count = piece.places.size();
  const bool is_closed = piece.kind == Space_shape::Kind::area;
  for (std::size_t i = 0; i < count; ++i) {
    const Point_3& here = piece.places[i];
    const double offset = sign * plane.offset(here);
    if (offset >= 0) part.places.push_back(here);
    if (!is_closed && i + 1 == count) break;
    const Point_3& next = piece.places[(i + 1) % count];
    const double other = sign * plane.offset(next);
    if ((offset > 0 && other < 0) || (offset < 0 && other > 0))
      part.places.push_back(here + (offset / (offset - other)) * (next - here));
  }
  return part;
}

bool is_nothing(const Piece& piece) {
  const std::size_t least = piece.kind == Space_shape::Kind::area ? 3 : piece.kind == Space_shape::Kind::line ? 2 : 1;
  return piece.places.size() < least;
}

/// Keeps what is before the plane.
void clip(std::vector<Piece>& pieces, const Plane& plane) {
  for (Piece& piece : pieces) piece = part_of(piece, plane, 1);
  std::erase_if(pieces, is_nothing);
}

class Collector {
 public:
  Collector(const View_3& view, const Projection_3& projection, double reach_of_rays)
      : view_(view), projection_(projection), reach_of_rays_(reach_of_rays) {}

  void add(const Scene_layer& layer, std::size_t number) {
    const Primitive_set& set = *layer.primitives;
    const Style& style = layer.style;
    layer_ = number;
    edges_.clear();
    const Layer_colors colors(layer);
    const std::vector<bool> drawn = drawn_elements(layer);
    const auto is_drawn = [&](std::size_t element) { return drawn.empty() || drawn[element]; };
    const std::size_t before = pieces_.size();
    std::size_t element = set.points.size() + set.segments.size() + set.rays.size() + set.arcs.size();
    const auto add_face = [&](std::span<const int> corners) {
      if (is_drawn(element) && corners.size() > 2) add_corners(set, corners, style, colors(element));
      ++element;
    };
    for (const auto& triangle : set.triangles) add_face(triangle);
    for (std::size_t i = 0; i < set.polygon_count(); ++i) add_face(set.polygon(i));
    for (const Ball& ball : set.balls) {
      if (is_drawn(element))
        pieces_.push_back({Space_shape::Kind::ball,
                           layer_,
                           {eye(set, ball.center)},
                           ball.radius,
                           style.filled ? 0 : style.line_width,
                           colors(element)});
      ++element;
    }
    for_pieces(set, Part_3::segments, is_drawn, [&](std::span<const std::int32_t> piece) {
      add_line(eye(set, piece[0]), eye(set, piece[1]), style.line_width, colors(static_cast<std::size_t>(piece[3])));
    });
    for (const Part_3 part : {Part_3::points, Part_3::bounding_points}) {
      if (part == Part_3::bounding_points && !style.vertices) continue;
      for_pieces(set, part, is_drawn, [&](std::span<const std::int32_t> piece) {
        pieces_.push_back(
            {Space_shape::Kind::dot, layer_, {eye(set, piece[0])}, 0, 0, colors(static_cast<std::size_t>(piece[3]))});
      });
    }
    if (style.sliced && view_.cutting_plane) slice(before);
  }

  std::vector<Piece> take() { return std::move(pieces_); }

 private:
  Point_3 eye(const Primitive_set& set, int place) const {
    const auto index = static_cast<std::size_t>(place);
    if (index < set.vertices.size()) return projection_.to_eye(set.vertices[index]);
    const Ray& ray = set.rays[index - set.vertices.size()];
    return projection_.to_eye(set.vertices[static_cast<std::size_t>(ray.from)] + reach_of_rays_ * ray.direction);
  }

  void add_line(const Point_3& from, const Point_3& to, double line_width, const Color& color) {
    pieces_.push_back({Space_shape::Kind::line, layer_, {from, to}, 0, line_width, color});
  }

  void add_corners(const Primitive_set& set, std::span<const int> corners, const Style& style, const Color& color) {
    std::vector<Point_3> places;
    Point_3 middle;
    for (const int corner : corners) {
      places.push_back(eye(set, corner));
      middle = middle + places.back();
    }
    if (style.edges || !style.filled) {
      const double shade = style.filled ? shade_of_edges : 1;
      const auto shaded = [&](std::uint8_t component) { return static_cast<std::uint8_t>(shade * component); };
      const Color dark{shaded(color.red), shaded(color.green), shaded(color.blue)};
      for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t next = (i + 1) % places.size();
        if (edges_.insert(std::minmax(corners[i], corners[next])).second)
          add_line(places[i], places[next], style.line_width * (style.filled ? width_of_edges : 1), dark);
      }
    }
    if (!style.filled) return;
    const Point_3 to_viewer = projection_.is_perspective() ? unit(Point_3{} - middle) : Point_3{0, 0, 1};
    const Color seen = lit_color(color, plane_of(places).normal, to_viewer);
    pieces_.push_back({Space_shape::Kind::area, layer_, std::move(places), 0, 0, seen});
  }

  template <class Is_drawn, class Visit>
  static void for_pieces(const Primitive_set& set, Part_3 part, const Is_drawn& is_drawn, const Visit& visit) {
    const std::vector<std::int32_t> pieces = pieces_3(set, part);
    for (std::size_t i = 0; i + 3 < pieces.size(); i += 4)
      if (is_drawn(static_cast<std::size_t>(pieces[i + 3]))) visit(std::span(pieces).subspan(i, 4));
  }

  void slice(std::size_t first) {
    std::vector<Piece> cut(std::make_move_iterator(pieces_.begin() + static_cast<std::ptrdiff_t>(first)),
                           std::make_move_iterator(pieces_.end()));
    pieces_.resize(first);
    const Cutting_plane_3& plane = *view_.cutting_plane;
    const Point_3 normal = unit(projection_.direction_to_eye(plane.normal));
    const double offset = dot(normal, projection_.to_eye(plane.point));
    const double half = plane.thickness.value_or(0) / 2;
    clip(cut, {Point_3{} - normal, offset + half});
    if (plane.thickness) clip(cut, {normal, half - offset});
    std::ranges::move(cut, std::back_inserter(pieces_));
  }

  const View_3& view_;
  const Projection_3& projection_;
  double reach_of_rays_ = 1;
  std::size_t layer_ = 0;
  std::set<std::pair<int, int>> edges_;  ///< of the faces of this layer so far
  std::vector<Piece> pieces_;
};

/// Puts pieces into an order in which none hides a later one, by planes through faces: what is behind a plane, seen
/// from the viewer, comes before what is on it, and that before the rest.
class Painters_order {
 public:
  Painters_order(bool is_perspective, double tolerance) : is_perspective_(is_perspective), tolerance_(tolerance) {}

  std::vector<Piece> sort(std::vector<Piece> pieces) {
    waiting_.push_back({std::move(pieces), false});
    while (!waiting_.empty()) {
      Heap heap = std::move(waiting_.back());
      waiting_.pop_back();
      if (heap.is_in_order) {
        std::ranges::move(heap.pieces, std::back_inserter(sorted_));
      } else {
        divide(std::move(heap.pieces));
      }
    }
    return std::move(sorted_);
  }

 private:
  struct Heap {
    std::vector<Piece> pieces;
    bool is_in_order = false;
  };
  enum class Side { on, front, back, both };

  Side side_of(const Piece& piece, const Plane& plane) const {
    bool is_front = false;
    bool is_back = false;
    for (const Point_3& place : piece.places) {
      const double offset = plane.offset(place);
      is_front = is_front || offset > tolerance_;
      is_back = is_back || offset < -tolerance_;
    }
    return is_front && is_back ? Side::both : is_front ? Side::front : is_back ? Side::back : Side::on;
  }

  /// Of some faces at random that which splits and separates best, judged by some pieces.
  std::size_t choose(const std::vector<Piece>& pieces, const std::vector<std::size_t>& faces) {
    constexpr int candidates = 6;
    constexpr std::size_t judges = 40;
    std::size_t best = faces[0];
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < candidates; ++i) {
      const std::size_t candidate = faces[random_() % faces.size()];
      const Plane plane = plane_of(pieces[candidate].places);
      int balance = 0;
      int splits = 0;
      for (std::size_t j = 0; j < std::min(judges, pieces.size()); ++j) {
        const Side side = side_of(pieces[random_() % pieces.size()], plane);
        balance += side == Side::front ? 1 : side == Side::back ? -1 : 0;
        splits += side == Side::both;
      }
      const double price = std::abs(balance) + 4.0 * splits;
      if (price >= least) continue;
      least = price;
      best = candidate;
    }
    return best;
  }

  double distance(const Piece& piece) const {
    Point_3 middle;
    for (const Point_3& place : piece.places) middle = middle + place;
    middle = (1.0 / static_cast<double>(piece.places.size())) * middle;
    return is_perspective_ ? std::sqrt(dot(middle, middle)) : -middle.z;
  }

  void divide(std::vector<Piece> pieces) {
    std::vector<std::size_t> faces;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i].kind == Space_shape::Kind::area) faces.push_back(i);
    if (faces.empty()) {
      std::vector<std::pair<double, std::size_t>> order;
      for (std::size_t i = 0; i < pieces.size(); ++i) order.emplace_back(-distance(pieces[i]), i);
      std::ranges::sort(order);
      for (const auto& [key, index] : order) sorted_.push_back(std::move(pieces[index]));
      return;
    }
    const Plane plane = plane_of(pieces[choose(pieces, faces)].places);
    std::vector<Piece> front;
    std::vector<Piece> back;
    std::vector<Piece> on;
    for (Piece& piece : pieces) {
      switch (side_of(piece, plane)) {
        case Side::front:
          front.push_back(std::move(piece));
          break;
        case Side::back:
          back.push_back(std::move(piece));
          break;
        case Side::on:
          on.push_back(std::move(piece));
          break;
        case Side::both:
          for (const double sign : {1.0, -1.0}) {
            Piece part = part_of(piece, plane, sign);
            if (!is_nothing(part)) (sign > 0 ? front : back).push_back(std::move(part));
          }
          break;
      }
    }
    // Of what is in one place later layers are seen, and above faces lines, above lines points.
    std::ranges::stable_sort(on, {}, [](const Piece& piece) { return std::pair(piece.layer, piece.kind); });
    const bool is_viewer_in_front = is_perspective_ ? plane.constant >= 0 : plane.normal.z >= 0;
    if (!is_viewer_in_front) std::swap(front, back);
    // The last is taken first.
    waiting_.push_back({std::move(front), false});
    waiting_.push_back({std::move(on), true});
    waiting_.push_back({std::move(back), false});
  }

  bool is_perspective_ = true;
  double tolerance_ = 0;
  std::minstd_rand random_;
  std::vector<Heap> waiting_;
  std::vector<Piece> sorted_;
};

}  // namespace

Color lit_color(const Color& color, const Point_3& normal, const Point_3& to_viewer) {
  // As in surface_3.frag.
  const Point_3 main_light = unit({-0.35, 0.45, 0.82});
  const Point_3 second_light = unit({0.7, -0.15, 0.55});
  Point_3 facing = dot(normal, normal) > 0 ? unit(normal) : to_viewer;
  if (dot(facing, to_viewer) < 0) facing = Point_3{} - facing;
  const double sky = 0.5 + 0.5 * facing.y;
  const double bright = 0.36 + 0.08 * sky + 0.60 * std::max(dot(facing, main_light), 0.0) +
                        0.16 * std::max(dot(facing, second_light), 0.0);
  const double gloss = std::pow(std::max(dot(facing, unit(main_light + to_viewer)), 0.0), 48);
  const auto lit = [&](std::uint8_t component) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(component * bright + 25.5 * gloss, 0.0, 255.0)));
  };
  return {lit(color.red), lit(color.green), lit(color.blue)};
}

std::vector<Space_shape> space_shapes(const Scene& scene, const View_3& view, int width, int height) {
  const Box box = drawn_box(scene);
  const Frame_3 frame{width, height};
  const Projection_3 projection(view.camera, box, frame);
  const double diagonal = box.diagonal() > 0 ? box.diagonal() : 1;
  constexpr double reach_of_rays = 16;
  Collector collector(view, projection, reach_of_rays * diagonal);
  for (std::size_t i = 0; i < scene.layers.size(); ++i)
    if (is_shown(scene.layers[i]) && scene.layers[i].style.opacity > 0) collector.add(scene.layers[i], i);
  std::vector<Piece> pieces = collector.take();
  const double nearest = projection.is_perspective() ? projection.near() : -1e300;
  if (projection.is_perspective()) clip(pieces, {{0, 0, -1}, -nearest});
  if (pieces.size() > most_space_shapes)
    throw std::invalid_argument("expected at most " + std::to_string(most_space_shapes) +
                                " faces, lines, points and balls in a picture of vectors, found " +
                                std::to_string(pieces.size()) +
                                "; choose png, or draw less of it (fewer layers, a larger delta by --set)");
  pieces = Painters_order(projection.is_perspective(), thickness_of_planes * diagonal).sort(std::move(pieces));

  std::vector<Space_shape> shapes;
  shapes.reserve(pieces.size());
  const double pixel = projection.pixel_size();
  const auto scale_at = [&](const Point_3& p) { return 1 / (pixel * (projection.is_perspective() ? -p.z : 1)); };
  for (Piece& piece : pieces) {
    Space_shape shape{piece.kind, piece.layer, {}, 0, piece.line_width, piece.color};
    for (const Point_3& p : piece.places) {
      const double scale = scale_at(p);
      shape.points.push_back({width / 2.0 + scale * p.x, height / 2.0 - scale * p.y});
    }
    if (piece.kind == Space_shape::Kind::ball) shape.radius = piece.radius * scale_at(piece.places[0]);
    const auto off_page = [&](const auto& coordinate, double limit, double margin) {
      return std::ranges::all_of(shape.points, [&](const Point_2& p) { return coordinate(p) < -margin; }) ||
             std::ranges::all_of(shape.points, [&](const Point_2& p) { return coordinate(p) > limit + margin; });
    };
    const double margin = shape.radius + 10;
    if (off_page([](const Point_2& p) { return p.x; }, width, margin) ||
        off_page([](const Point_2& p) { return p.y; }, height, margin))
      continue;
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace mesecina

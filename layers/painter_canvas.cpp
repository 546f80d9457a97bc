// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/painter_canvas.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPaintEngine>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "layers/color_bars.h"
#include "layers/scene_shapes.h"

namespace mesecina {
namespace {

/// Lines gathered before they are painted in one call.
constexpr std::size_t batch_size = 4096;
/// From this size on the pixels of an image are painted one by one, since Qt cannot place images of 1e5 pixels exactly.
constexpr double separate_pixel = 100;
constexpr double widest_flat_line = 2;
/// Regions with as many arcs are painted tile by tile.
constexpr std::size_t many_arcs = 1000;
constexpr double smallest_tile = 64;
constexpr double most_tiles_in_a_row = 12;
/// Closes the hairlines that antialiasing leaves between neighbouring areas of different colour.
constexpr double seam_width = 0.6;

QColor to_qt(Color color, double opacity = 1) {
  QColor result(color.red, color.green, color.blue);
  result.setAlphaF(static_cast<float>(opacity));
  return result;
}

QPointF to_qt(const Point_2& p) { return {p.x, p.y}; }

QRectF to_qt(const Pixel_box& box) { return {box.left, box.top, box.right - box.left, box.bottom - box.top}; }

class Painter_sink : public Shape_sink {
 public:
  Painter_sink(QPainter& painter, const Pixel_box& paper) : painter_(painter), paper_(paper) {}

  void begin_layer(const Scene_layer& layer, const Layer_colors& colors) override {
    style_ = &layer.style;
    uniform_ = colors.is_uniform();
    has_pen_ = false;
    has_brush_ = false;
  }
  void end_layer() override { flush(); }

  void image(const Image& image, const Pixel_box& place) override {
    const double pixel = (place.right - place.left) / image.width;
    const auto visible = [pixel](double low, double high, double from, double to, int count) {
      const int first = static_cast<int>(std::clamp(std::floor((from - low) / pixel), 0.0, double(count)));
      const int last = static_cast<int>(std::clamp(std::ceil((std::min(to, high) - low) / pixel), 0.0, double(count)));
      return std::pair(first, last);
    };
    const auto [left, right] = visible(place.left, place.right, paper_.left, paper_.right, image.width);
    const auto [top, bottom] = visible(place.top, place.bottom, paper_.top, paper_.bottom, image.height);
    if (left >= right || top >= bottom) return;
    if (pixel >= separate_pixel) {
      paint_pixels(image, place, pixel, left, right, top, bottom);
      return;
    }
    const QImage whole(image.rgba.data(), image.width, image.height, qsizetype{4} * image.width,
                       QImage::Format_RGBA8888);
    const QRectF target(place.left + left * pixel, place.top + top * pixel, (right - left) * pixel,
                        (bottom - top) * pixel);
    painter_.save();
    painter_.setOpacity(style_->opacity);
    // Enlarged pixels show as squares.
    painter_.setRenderHint(QPainter::SmoothPixmapTransform, pixel < 1);
    if (pixel < 0.5) {
      const QImage part = whole.copy(left, top, right - left, bottom - top);
      const QSize size(std::max(1, int(std::lround(target.width()))), std::max(1, int(std::lround(target.height()))));
      painter_.drawImage(target, part.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
    } else {
      painter_.drawImage(target, whole, QRectF(left, top, right - left, bottom - top));
    }
    painter_.restore();
  }

  void area(const Pixel_rings& rings, bool odd_even, Color color) override {
    flush();
    QPainterPath path;
    path.setFillRule(odd_even ? Qt::OddEvenFill : Qt::WindingFill);
    append_rings(path, rings);
    const bool neighbours_differ = !uniform_;
    const bool opaque = style_->opacity >= 1;
    set_brush(color);
    if (neighbours_differ && opaque) {
      painter_.setPen(QPen(to_qt(color), seam_width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
      has_pen_ = false;
    }
    painter_.setRenderHint(QPainter::Antialiasing, !neighbours_differ || opaque);
    painter_.drawPath(path);
    painter_.setRenderHint(QPainter::Antialiasing, true);
  }

  void region(const Pixel_region& region, bool odd_even, Color color) override {
    flush();
    set_brush(color);
    const Qt::FillRule rule = odd_even ? Qt::OddEvenFill : Qt::WindingFill;
    if (painter_.paintEngine()->type() == QPaintEngine::Raster && region.arcs.size() >= many_arcs) {
      paint_in_tiles(region, rule);
    } else {
      paint_part(region, {}, paper_, rule);
    }
  }

  void disk(const Point_2& center, double radius, Color color) override {
    flush();
    set_brush(color);
    painter_.drawEllipse(to_qt(center), radius, radius);
  }

  void dot(const Point_2& center, Color color) override {
    flush();
    set_brush(color);
    painter_.drawEllipse(to_qt(center), style_->point_size / 2, style_->point_size / 2);
  }

  void circle(const Point_2& center, double radius, Color color) override { arc(whole_circle(center, radius), color); }

  void outline(std::span<const Point_2> ring, Color color) override {
    flush();
    set_pen(color);
    QPolygonF polygon;
    polygon.reserve(static_cast<qsizetype>(ring.size()));
    for (const Point_2& p : ring) polygon.append(to_qt(p));
    painter_.drawPolygon(polygon);
  }

  void arc(const Pixel_arc& arc, Color color) override {
    flush();
    set_pen(color);
    QPainterPath path(to_qt(arc.from));
    append_arc(path, arc);
    if (arc.is_whole_circle()) path.closeSubpath();
    painter_.drawPath(path);
  }

  void segment(const Point_2& from, const Point_2& to, Color color) override {
    if (!lines_.empty() && (color != pen_color_ || lines_.size() >= static_cast<qsizetype>(batch_size))) flush();
    if (lines_.empty()) set_pen(color);
    lines_.append(QLineF(to_qt(from), to_qt(to)));
  }

 private:
  static void append_rings(QPainterPath& path, const Pixel_rings& rings) {
    for (std::size_t i = 0; i < rings.size(); ++i) {
      const auto ring = rings.ring(i);
      path.moveTo(to_qt(ring[0]));
      for (const Point_2& p : ring.subspan(1)) path.lineTo(to_qt(p));
      path.closeSubpath();
    }
  }

  static void append_arc(QPainterPath& path, const Pixel_arc& arc) {
    for (const Bezier& curve : to_beziers(arc))
      path.cubicTo(to_qt(curve.control_1), to_qt(curve.control_2), to_qt(curve.to));
  }

  /// A path that has the same inside as the region within the tile. `boxes`, of the arcs, may be empty for all in full.
  void paint_part(const Pixel_region& region, std::span<const Pixel_box> boxes, const Pixel_box& tile,
                  Qt::FillRule rule) {
    QPainterPath path;
    path.setFillRule(rule);
    append_rings(path, region.rings);
    std::size_t first = 0;
    for (std::size_t i = 0; i < region.loop_count(); first += region.loop(i).size(), ++i) {
      const auto loop = region.loop(i);
      int common_sides = boxes.empty() ? 0 : -1;
      for (std::size_t k = 0; k < loop.size() && common_sides != 0; ++k)
        common_sides &= sides_of(tile, boxes[first + k]);
      if (common_sides != 0) continue;
      path.moveTo(to_qt(loop[0].from));
      // Arcs that follow each other on one side of the tile become one line there.
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const int sides = boxes.empty() ? 0 : sides_of(tile, boxes[first + k]);
        const bool goes_on = (common_sides & sides) != 0;
        if (common_sides != 0 && !goes_on) path.lineTo(to_qt(loop[k].from));
        common_sides = goes_on ? common_sides & sides : sides;
        if (sides == 0) append_arc(path, loop[k]);
      }
      path.closeSubpath();
    }
    painter_.drawPath(path);
  }

  /// Qt's time for a row of pixels grows with the square of what crosses it.
  void paint_in_tiles(const Pixel_region& region, Qt::FillRule rule) {
    std::vector<Pixel_box> boxes;
    boxes.reserve(region.arcs.size());
    for (const Pixel_arc& arc : region.arcs)
      boxes.push_back(Pixel_box{arc.center.x, arc.center.y, arc.center.x, arc.center.y}.grown(arc.radius + 1));
    const double width = paper_.right - paper_.left;
    const double height = paper_.bottom - paper_.top;
    const double side = std::max(smallest_tile, std::ceil(std::max(width, height) / most_tiles_in_a_row));
    for (double top = paper_.top; top < paper_.bottom; top += side) {
      for (double left = paper_.left; left < paper_.right; left += side) {
        const Pixel_box tile{left, top, left + side, top + side};
        painter_.save();
        painter_.setClipRect(to_qt(tile), Qt::IntersectClip);
        paint_part(region, boxes, tile, rule);
        painter_.restore();
      }
    }
  }

  /// One bit for each side of the tile beyond which the whole box lies.
  static int sides_of(const Pixel_box& tile, const Pixel_box& box) {
    return (box.right < tile.left ? 1 : 0) | (box.left > tile.right ? 2 : 0) | (box.bottom < tile.top ? 4 : 0) |
           (box.top > tile.bottom ? 8 : 0);
  }

  void paint_pixels(const Image& image, const Pixel_box& place, double pixel, int left, int right, int top,
                    int bottom) {
    painter_.save();
    painter_.setRenderHint(QPainter::Antialiasing, false);
    const Pixel_box around = paper_.grown(1);
    for (int row = top; row < bottom; ++row) {
      for (int column = left; column < right; ++column) {
        const std::uint8_t* rgba =
            image.rgba.data() + 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                     static_cast<std::size_t>(column));
        const Pixel_box box{std::max(around.left, place.left + column * pixel),
                            std::max(around.top, place.top + row * pixel),
                            std::min(around.right, place.left + (column + 1) * pixel),
                            std::min(around.bottom, place.top + (row + 1) * pixel)};
        painter_.fillRect(to_qt(box), to_qt({rgba[0], rgba[1], rgba[2]}, style_->opacity * rgba[3] / 255));
      }
    }
    painter_.restore();
  }

  void flush() {
    if (lines_.empty()) return;
    painter_.drawLines(lines_);
    lines_.clear();
  }

  void set_pen(Color color) {
    if (has_pen_ && color == pen_color_) return;
    // Round ends join the pieces of a curve. Translucent ones would show as dots there, and Qt takes ten times as long
    // for them, so thin lines do without.
    const bool has_round_ends = style_->opacity >= 1 && style_->line_width > widest_flat_line;
    const Qt::PenCapStyle cap = has_round_ends ? Qt::RoundCap : Qt::FlatCap;
    painter_.setPen(QPen(to_qt(color, style_->opacity), style_->line_width, Qt::SolidLine, cap, Qt::RoundJoin));
    painter_.setBrush(Qt::NoBrush);
    pen_color_ = color;
    has_pen_ = true;
    has_brush_ = false;
  }

  void set_brush(Color color) {
    if (has_brush_ && color == brush_color_) return;
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(to_qt(color, style_->opacity));
    brush_color_ = color;
    has_brush_ = true;
    has_pen_ = false;
  }

  QPainter& painter_;
  Pixel_box paper_;
  const Style* style_ = nullptr;
  bool uniform_ = true;
  QList<QLineF> lines_;
  Color pen_color_;
  Color brush_color_;
  bool has_pen_ = false;
  bool has_brush_ = false;
};

void paint_strip(QPainter& painter, const Color_bar& bar) {
  const QRectF strip = to_qt(bar.strip);
  const auto hard_edge = std::adjacent_find(bar.stops.begin(), bar.stops.end(),
                                            [](const auto& a, const auto& b) { return a.position == b.position; });
  if (hard_edge == bar.stops.end()) {
    QLinearGradient gradient(strip.topLeft(), strip.topRight());
    for (const Color_bar::Stop& stop : bar.stops) gradient.setColorAt(stop.position, to_qt(stop.color));
    painter.fillRect(strip, gradient);
    return;
  }
  for (std::size_t i = 0; i + 1 < bar.stops.size(); i += 2) {
    const double left = strip.left() + bar.stops[i].position * strip.width();
    const double right = strip.left() + bar.stops[i + 1].position * strip.width();
    painter.fillRect(QRectF(left, strip.top(), right - left, strip.height()), to_qt(bar.stops[i].color));
  }
}

}  // namespace

void paint_scene(QPainter& painter, const Scene& scene, const View_2& view, double width, double height) {
  painter.save();
  const QRectF paper(0, 0, width, height);
  painter.setClipRect(paper, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing, true);
  if (!scene.transparent_background) painter.fillRect(paper, to_qt(scene.background));
  Painter_sink sink(painter, {0, 0, width, height});
  send_scene(scene, {view, width, height}, sink);
  painter.restore();
}

void paint_color_bars(QPainter& painter, const Scene& scene, double width, double height) {
  const std::vector<Color_bar> bars = color_bars(scene, width, height);
  if (bars.empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, true);
  QFont font{QString::fromLatin1(Color_bar_look::font)};
  font.setPixelSize(static_cast<int>(Color_bar_look::text_size));
  font.setHintingPreference(QFont::PreferNoHinting);
  painter.setFont(font);
  const QFontMetricsF metrics(font);
  const QColor ink = to_qt(ink_on(scene.background));
  for (const Color_bar& bar : bars) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(to_qt(scene.background, Color_bar_look::plate_opacity));
    painter.drawRoundedRect(to_qt(bar.plate), 3, 3);
    paint_strip(painter, bar);
    painter.setPen(QPen(ink, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(to_qt(bar.strip));
    painter.drawText(to_qt(bar.title_anchor), QString::fromStdString(bar.title));
    for (const Color_bar::Tick& tick : bar.ticks) {
      const double x = bar.strip.left + tick.position * (bar.strip.right - bar.strip.left);
      painter.drawLine(QPointF(x, bar.strip.bottom), QPointF(x, bar.strip.bottom + Color_bar_look::tick_length));
      const QString text = QString::fromStdString(tick.text);
      painter.drawText(QPointF(x - metrics.horizontalAdvance(text) / 2, bar.tick_base), text);
    }
  }
  painter.restore();
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/space_vectors.h"

#include <QPainter>
#include <QRadialGradient>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <set>

#include "layers/painter_canvas.h"
#include "layers/pdf_writer.h"
#include "layers/space_shapes.h"
#include "layers/svg_text.h"

namespace mesecina {

namespace {

/// As in svg_writer.cpp and painter_canvas.cpp: closes the hairlines between neighbouring areas.
constexpr double seam_width = 0.6;
/// Where the light falls on a ball straight on, in radii from its center, y down; and where least of it does.
constexpr Point_2 lit_place{-0.35, -0.45};
constexpr Point_2 dark_place{0.6, 0.8};
constexpr std::array ball_stops{0.0, 0.25, 0.5, 0.75, 0.9, 1.0};

/// Thousandths of pixels: all digits would make files three times as large.
double rounded(double coordinate) { return std::round(coordinate * 1000) / 1000; }

/// On the way from the lit to the dark place.
Color ball_color(const Color& color, double way) {
  const double x = lit_place.x + way * (dark_place.x - lit_place.x);
  const double y = lit_place.y + way * (dark_place.y - lit_place.y);
  return lit_color(color, {x, -y, std::sqrt(std::max(0.0, 1 - x * x - y * y))}, {0, 0, 1});
}

class Svg_shapes {
 public:
  Svg_shapes(std::string& text, const Scene& scene) : text_(text), scene_(scene) {}

  void write(const std::vector<Space_shape>& shapes) {
    write_gradients(shapes);
    const Space_shape* last = nullptr;
    for (const Space_shape& shape : shapes) {
      if (!last || last->layer != shape.layer) {
        if (last) text_ += "</g>\n";
        begin_layer(scene_.layers[shape.layer]);
      }
      write(shape);
      last = &shape;
    }
    if (last) text_ += "</g>\n";
  }

 private:
  void write_gradients(const std::vector<Space_shape>& shapes) {
    std::set<std::string> colors;
    for (const Space_shape& shape : shapes) {
      if (shape.kind != Space_shape::Kind::ball || shape.line_width > 0) continue;
      const std::string name = gradient_of(shape);
      if (!colors.insert(name).second) continue;
      text_ += "<radialGradient";
      append_attribute(text_, "id", name);
      append_attribute(text_, "fx", 0.5 + lit_place.x / 2);
      append_attribute(text_, "fy", 0.5 + lit_place.y / 2);
      text_ += ">";
      for (const double stop : ball_stops) {
        text_ += "<stop";
        append_attribute(text_, "offset", stop);
        append_attribute(text_, "stop-color", svg_hex(ball_color(shape.color, stop)));
        text_ += "/>";
      }
      text_ += "</radialGradient>\n";
    }
  }

  static std::string gradient_of(const Space_shape& shape) { return "ball-" + svg_hex(shape.color).substr(1); }

  void begin_layer(const Scene_layer& layer) {
    text_ += "<g";
    append_attribute(text_, "id", unique_svg_id(layer.id, ids_));
    append_attribute(text_, "data-layer", svg_escaped(layer.id));
    append_attribute(text_, "inkscape:groupmode", "layer");
    append_attribute(text_, "inkscape:label", svg_escaped(layer.label.empty() ? layer.id : layer.label));
    append_attribute(text_, "clip-path", "url(#page)");
    append_attribute(text_, "stroke-linecap", "round");
    append_attribute(text_, "stroke-linejoin", "round");
    if (layer.style.opacity < 1) {
      append_attribute(text_, "fill-opacity", layer.style.opacity);
      append_attribute(text_, "stroke-opacity", layer.style.opacity);
    }
    text_ += ">\n";
  }

  void write(const Space_shape& shape) {
    const Style& style = scene_.layers[shape.layer].style;
    const std::string color = svg_hex(shape.color);
    switch (shape.kind) {
      case Space_shape::Kind::area:
      case Space_shape::Kind::line: {
        const bool is_area = shape.kind == Space_shape::Kind::area;
        std::string path;
        for (std::size_t i = 0; i < shape.points.size(); ++i)
          append_point(path, i == 0 ? 'M' : 'L', {rounded(shape.points[i].x), rounded(shape.points[i].y)});
        text_ += "<path";
        append_attribute(text_, "fill", is_area ? color : "none");
        if (!is_area || style.opacity >= 1) {
          append_attribute(text_, "stroke", color);
          append_attribute(text_, "stroke-width", is_area ? seam_width : shape.line_width);
        }
        append_attribute(text_, "d", is_area ? path + 'Z' : path);
        text_ += "/>\n";
        break;
      }
      case Space_shape::Kind::dot:
        write_circle(shape.points[0], style.point_size / 2);
        append_attribute(text_, "fill", color);
        text_ += "/>\n";
        break;
      case Space_shape::Kind::ball:
        write_circle(shape.points[0], shape.radius);
        if (shape.line_width > 0) {
          append_attribute(text_, "fill", "none");
          append_attribute(text_, "stroke", color);
          append_attribute(text_, "stroke-width", shape.line_width);
        } else {
          append_attribute(text_, "fill", "url(#" + gradient_of(shape) + ")");
        }
        text_ += "/>\n";
        break;
    }
  }

  void write_circle(const Point_2& center, double radius) {
    text_ += "<circle";
    append_attribute(text_, "cx", rounded(center.x));
    append_attribute(text_, "cy", rounded(center.y));
    append_attribute(text_, "r", rounded(radius));
  }

  std::string& text_;
  const Scene& scene_;
  std::set<std::string> ids_;
};

QColor to_qt(const Color& color, double opacity) {
  QColor result(color.red, color.green, color.blue);
  result.setAlphaF(static_cast<float>(opacity));
  return result;
}

void paint(QPainter& painter, const Space_shape& shape, const Style& style) {
  const QColor color = to_qt(shape.color, style.opacity);
  QPolygonF polygon;
  for (const Point_2& p : shape.points) polygon.append(QPointF(p.x, p.y));
  const auto pen = [&](double width) { return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin); };
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  switch (shape.kind) {
    case Space_shape::Kind::area:
      if (style.opacity >= 1) painter.setPen(pen(seam_width));
      painter.drawPolygon(polygon);
      break;
    case Space_shape::Kind::line:
      painter.setPen(pen(shape.line_width));
      painter.drawLine(polygon[0], polygon[1]);
      break;
    case Space_shape::Kind::dot:
      painter.drawEllipse(polygon[0], style.point_size / 2, style.point_size / 2);
      break;
    case Space_shape::Kind::ball:
      if (shape.line_width > 0) {
        painter.setPen(pen(shape.line_width));
        painter.setBrush(Qt::NoBrush);
      } else {
        QRadialGradient gradient(polygon[0], shape.radius,
                                 polygon[0] + shape.radius * QPointF(lit_place.x, lit_place.y));
        for (const double stop : ball_stops)
          gradient.setColorAt(stop, to_qt(ball_color(shape.color, stop), style.opacity));
        painter.setBrush(gradient);
      }
      painter.drawEllipse(polygon[0], shape.radius, shape.radius);
      break;
  }
}

}  // namespace

void write_space_svg(std::ostream& out, const Scene& scene, const View_3& view, int width, int height) {
  const std::vector<Space_shape> shapes = space_shapes(scene, view, width, height);
  std::string text = svg_head(scene, width, height);
  Svg_shapes(text, scene).write(shapes);
  append_color_bars(text, scene, width, height);
  out << text << "</svg>\n";
}

std::string space_pdf_bytes(const Scene& scene, const View_3& view, int width, int height) {
  const std::vector<Space_shape> shapes = space_shapes(scene, view, width, height);
  return pdf_page(width, height, [&](QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(0, 0, width, height);
    const Color& ground = scene.background;
    if (!scene.transparent_background) painter.fillRect(0, 0, width, height, to_qt(ground, 1));
    for (const Space_shape& shape : shapes) paint(painter, shape, scene.layers[shape.layer].style);
    paint_color_bars(painter, scene, width, height);
  });
}

}  // namespace mesecina

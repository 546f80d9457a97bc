// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/panel_paint.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <cmath>
#include <numbers>
#include <utility>

#include "layers/color_map.h"

namespace mesecina {

namespace {

class Painted_icon_engine : public QIconEngine {
 public:
  explicit Painted_icon_engine(std::function<void(QPainter&, const QRectF&, const QColor&)> paint_glyph)
      : paint_glyph_(std::move(paint_glyph)) {}

  void paint(QPainter* painter, const QRect& rectangle, QIcon::Mode mode, QIcon::State) override {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paint_glyph_(*painter, rectangle, QGuiApplication::palette().color(group, QPalette::ButtonText));
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap result(size);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return result;
  }
  QIconEngine* clone() const override { return new Painted_icon_engine(paint_glyph_); }

 private:
  std::function<void(QPainter&, const QRectF&, const QColor&)> paint_glyph_;
};

bool is_dark(const QPalette& palette) { return palette.color(QPalette::Base).lightnessF() < 0.5; }

QPen round_pen(const QColor& color, double width) {
  return QPen(color, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
}

}  // namespace

QColor to_qcolor(const Color& color) { return QColor(color.red, color.green, color.blue); }

Color from_qcolor(const QColor& color) {
  return {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
          static_cast<std::uint8_t>(color.blue())};
}

QColor mix(const QColor& first, const QColor& second, double fraction) {
  const auto part = [&](double a, double b) { return static_cast<float>(a + (b - a) * fraction); };
  return QColor::fromRgbF(part(first.redF(), second.redF()), part(first.greenF(), second.greenF()),
                          part(first.blueF(), second.blueF()), part(first.alphaF(), second.alphaF()));
}

QColor subdued_text(const QPalette& palette) {
  return mix(palette.color(QPalette::Active, QPalette::Text), palette.color(QPalette::Active, QPalette::Base), 0.42);
}

QColor failure_color(const QPalette& palette) {
  return is_dark(palette) ? QColor::fromHsl(2, 200, 160) : QColor::fromHsl(2, 190, 100);
}

QColor warning_color(const QPalette& palette) {
  return is_dark(palette) ? QColor::fromHsl(38, 220, 140) : QColor::fromHsl(34, 240, 96);
}

void paint_eye(QPainter& painter, const QRectF& square, const QColor& color, bool is_open) {
  const double side = std::min(square.width(), square.height());
  const QPointF center = square.center();
  const double half_width = side * 0.46;
  const double height = side * 0.62;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(round_pen(color, side * 0.085));
  painter.setBrush(Qt::NoBrush);
  const QPointF left = center - QPointF(half_width, 0);
  const QPointF right = center + QPointF(half_width, 0);
  QPainterPath lids(left);
  if (is_open) {
    lids.quadTo(center - QPointF(0, height), right);
    lids.quadTo(center + QPointF(0, height), left);
    painter.drawPath(lids);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawEllipse(center, side * 0.145, side * 0.145);
  } else {
    lids.quadTo(center + QPointF(0, height), right);
    painter.drawPath(lids);
    for (const double angle : {-0.62, 0.0, 0.62}) {
      const QPointF direction(std::sin(angle), std::cos(angle));
      const QPointF from = center + QPointF(direction.x() * side * 0.33, side * (angle == 0 ? 0.31 : 0.25));
      painter.drawLine(from, from + direction * side * 0.13);
    }
  }
  painter.restore();
}

void paint_arrow(QPainter& painter, const QRectF& square, const QColor& color, bool is_expanded) {
  const double side = std::min(square.width(), square.height());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(square.center());
  if (is_expanded) painter.rotate(90);
  painter.setPen(round_pen(color, side * 0.11));
  const QPointF points[] = {{-side * 0.11, -side * 0.22}, {side * 0.12, 0}, {-side * 0.11, side * 0.22}};
  painter.drawPolyline(points, 3);
  painter.restore();
}

void paint_more(QPainter& painter, const QRectF& square, const QColor& color) {
  constexpr double radius = 0.08;
  constexpr double apart = 0.28;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  for (const int step : {-1, 0, 1})
    painter.drawEllipse(square.center() + QPointF(step * apart * square.width(), 0), radius * square.width(),
                        radius * square.width());
  painter.restore();
}

void paint_spinner(QPainter& painter, const QRectF& square, const QColor& color, int phase) {
  constexpr int dots = 8;
  const double side = std::min(square.width(), square.height());
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  for (int dot = 0; dot < dots; ++dot) {
    const double angle = 2 * std::numbers::pi * dot / dots;
    const int age = ((phase - dot) % dots + dots) % dots;
    QColor faded = color;
    faded.setAlphaF(static_cast<float>(1.0 - 0.11 * age));
    painter.setBrush(faded);
    painter.drawEllipse(square.center() + QPointF(std::sin(angle), -std::cos(angle)) * side * 0.34, side * 0.09,
                        side * 0.09);
  }
  painter.restore();
}

void paint_clock(QPainter& painter, const QRectF& square, const QColor& color) {
  const double side = std::min(square.width(), square.height());
  const QPointF center = square.center();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(round_pen(color, side * 0.09));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(center, side * 0.38, side * 0.38);
  painter.drawLine(center, center - QPointF(0, side * 0.22));
  painter.drawLine(center, center + QPointF(side * 0.16, side * 0.06));
  painter.restore();
}

void paint_failure(QPainter& painter, const QRectF& square, const QColor& color, const QColor& mark) {
  const double side = std::min(square.width(), square.height());
  const QPointF center = square.center();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawEllipse(center, side * 0.44, side * 0.44);
  painter.setPen(round_pen(mark, side * 0.11));
  const double arm = side * 0.15;
  painter.drawLine(center - QPointF(arm, arm), center + QPointF(arm, arm));
  painter.drawLine(center + QPointF(-arm, arm), center + QPointF(arm, -arm));
  painter.restore();
}

void paint_warning(QPainter& painter, const QRectF& square, const QColor& color, const QColor& mark) {
  const double side = std::min(square.width(), square.height());
  const QPointF center = square.center();
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(round_pen(color, side * 0.12));
  painter.setBrush(color);
  const QPointF corners[] = {center + QPointF(0, -side * 0.36), center + QPointF(side * 0.39, side * 0.33),
                             center + QPointF(-side * 0.39, side * 0.33)};
  painter.drawPolygon(corners, 3);
  painter.setPen(round_pen(mark, side * 0.1));
  painter.drawLine(center - QPointF(0, side * 0.14), center + QPointF(0, side * 0.08));
  painter.drawPoint(center + QPointF(0, side * 0.25));
  painter.restore();
}

void paint_gradient(QPainter& painter, const QRectF& rectangle, const std::string& color_map, bool is_reversed) {
  const Color_map* map = find_color_map(color_map);
  if (!map) return;
  constexpr int stops = 24;
  QLinearGradient gradient(rectangle.topLeft(), rectangle.topRight());
  for (int i = 0; i <= stops; ++i) {
    const double t = static_cast<double>(i) / stops;
    gradient.setColorAt(t, to_qcolor(map->lookup(is_reversed ? 1 - t : t)));
  }
  painter.fillRect(rectangle, gradient);
}

void paint_swatch(QPainter& painter, const QRectF& rectangle, const Style& style, const QPalette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double radius = rectangle.height() * 0.2;
  QPainterPath outline;
  outline.addRoundedRect(rectangle, radius, radius);
  painter.save();
  painter.setClipPath(outline);
  if (style.value.empty() || !find_color_map(style.color_map)) {
    painter.fillRect(rectangle, to_qcolor(style.color));
  } else {
    paint_gradient(painter, rectangle, style.color_map, style.color_map_reversed);
  }
  painter.restore();
  painter.setPen(QPen(mix(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.6), 1));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(outline);
  painter.restore();
}

void paint_plate(QPainter& painter, const QRectF& rectangle, const QPalette& palette) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(palette.color(QPalette::Mid));
  painter.setBrush(palette.color(QPalette::Window));
  painter.drawRect(rectangle.adjusted(0.5, 0.5, -0.5, -0.5));
}

QIcon painted_icon(std::function<void(QPainter&, const QRectF&, const QColor&)> paint) {
  return QIcon(new Painted_icon_engine(std::move(paint)));
}

QIcon color_map_icon(const std::string& color_map, bool is_reversed) {
  return painted_icon([color_map, is_reversed](QPainter& painter, const QRectF& rectangle, const QColor&) {
    paint_gradient(painter, rectangle, color_map, is_reversed);
  });
}

QString grouped_count(std::size_t count) {
  QString text = QString::number(count);
  for (auto position = text.size() - 3; position > 0; position -= 3) text.insert(position, QChar(0x202f));
  return text;
}

QString short_number(double value, int digits) {
  if (std::isinf(value)) return value > 0 ? QStringLiteral("∞") : QStringLiteral("-∞");
  return QLocale::c().toString(value, 'g', digits);
}

}  // namespace mesecina

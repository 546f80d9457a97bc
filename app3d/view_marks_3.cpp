// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/view_marks_3.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "layers/color_bars.h"

namespace mesecina {

namespace {

QColor to_qt(Color color) { return {color.red, color.green, color.blue}; }

constexpr std::array axis_colors{Color{214, 60, 60}, Color{60, 150, 50}, Color{50, 110, 220}};
constexpr std::array axis_letters{"X", "Y", "Z"};

}  // namespace

Axis_gizmo::Axis_gizmo(const Camera_3& camera, const QPointF& middle) : middle_(middle), ends_() {
  const Camera_3::Axes axes = camera.axes();
  constexpr std::array directions{Point_3{1, 0, 0}, Point_3{0, 1, 0}, Point_3{0, 0, 1}};
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    End& end = ends_[i];
    end.axis = i % 3;
    end.is_positive = i < 3;
    end.direction = (end.is_positive ? 1.0 : -1.0) * directions[end.axis];
    end.place = middle + radius * QPointF(dot(end.direction, axes.right), -dot(end.direction, axes.up));
    end.height = dot(end.direction, axes.back);
  }
  std::ranges::stable_sort(ends_, {}, &End::height);
}

std::optional<Point_3> Axis_gizmo::direction_at(const QPointF& pixel) const {
  for (auto end = ends_.rbegin(); end != ends_.rend(); ++end) {
    const QPointF off = pixel - end->place;
    if (std::hypot(off.x(), off.y()) <= end_radius) return end->direction;
  }
  return std::nullopt;
}

void Axis_gizmo::paint(QPainter& painter, Color ground, const std::optional<Point_3>& hovered) const {
  painter.save();
  QFont font = painter.font();
  font.setBold(true);
  constexpr double letter_height = 1.2 * end_radius;
  font.setPixelSize(static_cast<int>(letter_height));
  painter.setFont(font);
  for (const End& end : ends_) {
    const QColor color = to_qt(axis_colors[end.axis]);
    const bool is_hovered = hovered == end.direction;
    constexpr double thin = 1.5;
    constexpr double thick = 2.5;
    if (end.is_positive) {
      painter.setPen(QPen(color, thick, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(middle_, end.place);
    }
    painter.setPen(QPen(is_hovered ? to_qt(ink_on(ground)) : color, thin));
    painter.setBrush(end.is_positive || is_hovered ? color : to_qt(ground));
    const double button = end.is_positive ? end_radius : 0.75 * end_radius;
    painter.drawEllipse(end.place, button, button);
    if (!end.is_positive) continue;
    painter.setPen(Qt::white);
    const QRectF box(end.place - QPointF(end_radius, end_radius), QSizeF(2 * end_radius, 2 * end_radius));
    painter.drawText(box, Qt::AlignCenter, QLatin1String(axis_letters[end.axis]));
  }
  painter.restore();
}

Scale_bar scale_bar(double unit, double most_pixels) {
  const double longest = most_pixels / unit;
  const double power = std::pow(10, std::floor(std::log10(longest)));
  double length = power;
  for (const double factor : {2.0, 5.0, 10.0})
    if (factor * power <= longest) length = factor * power;
  return {length, length * unit};
}

void paint_scale_bar(QPainter& painter, const Scale_bar& bar, bool is_exact, const QPointF& corner, Color ground) {
  painter.save();
  constexpr double wide = 1.5;
  constexpr double tick = 5;
  painter.setPen(QPen(to_qt(ink_on(ground)), wide));
  const QPointF end = corner + QPointF(bar.pixels, 0);
  painter.drawPolyline(QPolygonF{corner - QPointF(0, tick), corner, end, end - QPointF(0, tick)});
  constexpr int digits = 6;
  const QString length = QString::number(bar.length, 'g', digits);
  const QString text =
      is_exact ? length : QCoreApplication::translate("mesecina::Scale_bar", "%1 at the pivot").arg(length);
  const QFontMetricsF metrics(painter.font());
  const double left = std::max(0.0, (bar.pixels - metrics.horizontalAdvance(text)) / 2);
  painter.drawText(corner + QPointF(left, -tick - metrics.descent()), text);
  painter.restore();
}

}  // namespace mesecina

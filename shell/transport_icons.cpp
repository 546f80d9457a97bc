// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/transport_icons.h"

#include <QPainter>
#include <QPolygonF>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {

void paint_triangle(QPainter& painter, double from, double to) {
  painter.drawPolygon(QPolygonF({{from, 3.5}, {to, 8}, {from, 12.5}}));
}

void paint_bar(QPainter& painter, double left) { painter.drawRect(QRectF(left, 3.2, 2, 9.6)); }

void paint_sliders(QPainter& painter, const QColor& color) {
  struct Slider {
    double y;
    double knob;
  };
  painter.setPen(QPen(color, 1.4, Qt::SolidLine, Qt::RoundCap));
  for (const Slider& slider : {Slider{4, 10.5}, Slider{8, 5.5}, Slider{12, 9}}) {
    painter.drawLine(QPointF(2.5, slider.y), QPointF(13.5, slider.y));
    painter.drawEllipse(QPointF(slider.knob, slider.y), 1.3, 1.3);
  }
}

/// Paints in a square of 16 x 16 units. What goes backward is the mirror image of what goes forward.
void paint_icon(QPainter& painter, const QColor& color, Transport_icon icon) {
  painter.setPen(QPen(color, 0.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(color);
  switch (icon) {
    case Transport_icon::play:
    case Transport_icon::play_backward:
      paint_triangle(painter, 4.5, 12.5);
      break;
    case Transport_icon::forward:
    case Transport_icon::back:
      paint_bar(painter, 3.6);
      paint_triangle(painter, 7.4, 13.4);
      break;
    case Transport_icon::last:
    case Transport_icon::first:
      paint_triangle(painter, 3.2, 9.6);
      paint_bar(painter, 10.8);
      break;
    case Transport_icon::pause:
      paint_bar(painter, 4.4);
      paint_bar(painter, 9.6);
      break;
    case Transport_icon::more:
      painter.setPen(QPen(color, 1.8, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(QPointF(8, 3.5), QPointF(8, 12.5));
      painter.drawLine(QPointF(3.5, 8), QPointF(12.5, 8));
      break;
    case Transport_icon::settings:
      paint_sliders(painter, color);
      break;
  }
}

bool is_backward(Transport_icon icon) {
  return icon == Transport_icon::first || icon == Transport_icon::back || icon == Transport_icon::play_backward;
}

}  // namespace

QIcon transport_icon(Transport_icon icon) {
  return painted_icon([icon](QPainter& painter, const QRectF& square, const QColor& color) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(square.topLeft());
    constexpr double units = 16;
    painter.scale(square.width() / units, square.height() / units);
    if (is_backward(icon)) {
      painter.translate(units, 0);
      painter.scale(-1, 1);
    }
    paint_icon(painter, color, icon);
    painter.restore();
  });
}

}  // namespace mesecina

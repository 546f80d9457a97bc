// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/tool_icons.h"

#include <QPainter>
#include <QPainterPath>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {

/// Paints in a square of 16 x 16 units.
void paint_icon(QPainter& painter, const QColor& color, Tool_icon icon) {
  painter.setPen(QPen(color, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  const auto dot = [&](double x, double y, double radius) {
    painter.setBrush(color);
    painter.drawEllipse(QPointF(x, y), radius, radius);
    painter.setBrush(Qt::NoBrush);
  };
  const auto curved_arrow = [&] {
    QPainterPath path(QPointF(3, 6.5));
    path.lineTo(10, 6.5);
    path.arcTo(QRectF(6.5, 6.5, 7, 7), 90, -180);
    path.lineTo(6, 13.5);
    painter.drawPath(path);
    painter.drawPolyline(QPolygonF({{6.2, 3.3}, {3, 6.5}, {6.2, 9.7}}));
  };
  switch (icon) {
    case Tool_icon::select:
      painter.setBrush(color);
      painter.drawPolygon(QPolygonF({{4, 2}, {4, 12.5}, {6.8, 10}, {8.6, 14}, {10.4, 13.2}, {8.6, 9.3}, {12.2, 9}}));
      break;
    case Tool_icon::insert:
      dot(6, 10, 2.2);
      painter.drawLine(QPointF(11.5, 2), QPointF(11.5, 8));
      painter.drawLine(QPointF(8.5, 5), QPointF(14.5, 5));
      break;
    case Tool_icon::spray:
      dot(3.5, 12, 1.2);
      dot(6.5, 9, 1.2);
      dot(9.5, 6.7, 1.2);
      dot(12.6, 4, 1.2);
      break;
    case Tool_icon::outline:
      painter.drawPolygon(QPolygonF({{3, 12}, {4.5, 4}, {11, 2.8}, {13.2, 9}, {8.3, 13.3}}));
      for (const QPointF& p : {QPointF(3, 12), QPointF(4.5, 4), QPointF(11, 2.8), QPointF(13.2, 9), QPointF(8.3, 13.3)})
        dot(p.x(), p.y(), 0.9);
      break;
    case Tool_icon::disk:
      painter.drawEllipse(QPointF(8, 8), 5.8, 5.8);
      painter.drawLine(QPointF(8, 8), QPointF(12.1, 3.9));
      dot(8, 8, 1.2);
      break;
    case Tool_icon::turn:
      painter.drawArc(QRectF(2.5, 5, 11, 6), 20 * 16, 320 * 16);
      painter.drawArc(QRectF(5, 2.5, 6, 11), 110 * 16, 320 * 16);
      painter.drawPolyline(QPolygonF({{10.8, 5.2}, {13.2, 6.9}, {13.8, 4}}));
      break;
    case Tool_icon::pan:
      painter.drawLine(QPointF(8, 1.8), QPointF(8, 14.2));
      painter.drawLine(QPointF(1.8, 8), QPointF(14.2, 8));
      painter.drawPolyline(QPolygonF({{6, 3.8}, {8, 1.8}, {10, 3.8}}));
      painter.drawPolyline(QPolygonF({{6, 12.2}, {8, 14.2}, {10, 12.2}}));
      painter.drawPolyline(QPolygonF({{3.8, 6}, {1.8, 8}, {3.8, 10}}));
      painter.drawPolyline(QPolygonF({{12.2, 6}, {14.2, 8}, {12.2, 10}}));
      break;
    case Tool_icon::redo:
      painter.translate(16, 0);
      painter.scale(-1, 1);
      curved_arrow();
      break;
    case Tool_icon::undo:
      curved_arrow();
      break;
    case Tool_icon::fit:
      painter.drawPolyline(QPolygonF({{2.5, 5.5}, {2.5, 2.5}, {5.5, 2.5}}));
      painter.drawPolyline(QPolygonF({{10.5, 2.5}, {13.5, 2.5}, {13.5, 5.5}}));
      painter.drawPolyline(QPolygonF({{13.5, 10.5}, {13.5, 13.5}, {10.5, 13.5}}));
      painter.drawPolyline(QPolygonF({{5.5, 13.5}, {2.5, 13.5}, {2.5, 10.5}}));
      dot(8, 8, 1.8);
      break;
  }
}

}  // namespace

QIcon tool_icon(Tool_icon icon) {
  return painted_icon([icon](QPainter& painter, const QRectF& square, const QColor& color) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(square.topLeft());
    constexpr double units = 16;
    painter.scale(square.width() / units, square.height() / units);
    paint_icon(painter, color, icon);
    painter.restore();
  });
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/automatic_dot.h"

#include <QPainter>
#include <algorithm>

#include "layers/panel_paint.h"

namespace mesecina {

Automatic_dot::Automatic_dot(QWidget* parent) : QToolButton(parent) {
  setAutoRaise(true);
  setCursor(Qt::ArrowCursor);
  setFocusPolicy(Qt::TabFocus);
  setAccessibleName(tr("Automatic"));
  const int side = fontMetrics().height();
  setIconSize(QSize(side * 3 / 4, side * 3 / 4));
  setFixedSize(side, side * 5 / 4);
  show_chosen(false);
}

void Automatic_dot::show_chosen(bool is_chosen) {
  setIcon(painted_icon([is_chosen](QPainter& painter, const QRectF& square, const QColor& color) {
    const double side = std::min(square.width(), square.height());
    painter.setPen(is_chosen ? QPen(Qt::NoPen) : QPen(color, side * 0.09));
    painter.setBrush(is_chosen ? QBrush(color) : QBrush(Qt::NoBrush));
    painter.drawEllipse(square.center(), side * 0.24, side * 0.24);
  }));
  setEnabled(is_chosen);
  setToolTip(is_chosen ? tr("Make it automatic again") : tr("Is automatic"));
}

}  // namespace mesecina

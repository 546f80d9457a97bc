// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/step_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>

namespace mesecina {

Step_slider::Step_slider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

void Step_slider::set_marked_range(int begin, int end) {
  if (begin == begin_ && end == end_) return;
  begin_ = begin;
  end_ = end;
  update();
}

QRect Step_slider::groove() const {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect whole = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderGroove, this);
  const int handle = style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this).width();
  return whole.adjusted(handle / 2, 0, -handle / 2, 0);
}

void Step_slider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) {
    const QRect ways = groove();
    setValue(QStyle::sliderValueFromPosition(minimum(), maximum(), qRound(event->position().x()) - ways.left(),
                                             ways.width()));
  }
  // The handle is under the mouse now, so that one can go on dragging.
  QSlider::mousePressEvent(event);
}

void Step_slider::paintEvent(QPaintEvent* event) {
  if (begin_ < end_) {
    const QRect ways = groove();
    const auto place = [&](int value) {
      return ways.left() + QStyle::sliderPositionFromValue(minimum(), maximum(), value, ways.width());
    };
    QColor color = palette().color(QPalette::Highlight);
    constexpr double faint = 0.35;
    color.setAlphaF(faint);
    QPainter painter(this);
    painter.fillRect(QRect(QPoint(place(begin_), 1), QPoint(place(end_), height() - 2)), color);
  }
  QSlider::paintEvent(event);
}

}  // namespace mesecina

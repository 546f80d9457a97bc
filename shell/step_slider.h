// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>

namespace mesecina {

/// A slider over steps: a click on it goes there, and a range may be marked on it.
class Step_slider : public QSlider {
  Q_OBJECT
 public:
  explicit Step_slider(QWidget* parent = nullptr);

  /// Marks nothing where `begin` is not less than `end`.
  void set_marked_range(int begin, int end);

 protected:
  void mousePressEvent(QMouseEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Where the middle of the handle may be, in pixels.
  QRect groove() const;

  int begin_ = 0;
  int end_ = 0;
};

}  // namespace mesecina

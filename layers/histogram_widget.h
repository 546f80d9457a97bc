// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>

#include "layers/color_map.h"
#include "layers/histogram.h"

class QToolButton;

namespace mesecina {

/// Histogram of one of a layer's values, coloured like the layer, with handles for what is shown of it.
class Histogram_widget : public QWidget {
  Q_OBJECT
 public:
  struct Content {
    Scene_layer layer;  ///< its style's thresholds are the handles
    std::string value;  ///< name of the values shown; bars have the map's colours if it is `style.value`
    QString caption;    ///< what the values are called
    Value_range range;  ///< of the colour map
    bool has_handles = true;
    /// Instead of the thresholds there is one handle: the number of the layer's cut, between these bounds.
    bool is_cut = false;
    double cut_lowest = 0;
    double cut_highest = 0;
  };
  enum class Handle { minimum, maximum };

  explicit Histogram_widget(QWidget* parent = nullptr);

  void set_content(const Content& content);
  /// Nothing but this text.
  void set_empty(const QString& reason);
  /// The bins; those of the Primitive_set and value that are shown are computed once.
  const Histogram& histogram() const;
  /// Where a handle stands, in pixels of the widget; that of an absent threshold is beyond all values.
  double handle_x(Handle handle) const;
  /// Where a value is.
  double x_of(double value) const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// Values are rounded to what a pixel can tell apart. nullopt: no limit, or the default of the cut.
  void handle_moved(mesecina::Histogram_widget::Handle handle, const std::optional<double>& value);
  void reset_requested();  ///< of both thresholds
  /// What follows is another change.
  void gesture_started();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool focusNextPrevChild(bool is_next) override;
  bool event(QEvent* event) override;

 private:
  struct Geometry;
  struct Bar;
  Geometry geometry() const;
  std::vector<Bar> bars(const Geometry& geometry) const;
  bool has_bins() const;
  std::optional<double> limit(Handle handle) const;
  std::optional<double> limit_at(Handle handle, double x) const;
  Handle nearest_handle(double x) const;
  void move_handle(Handle handle, double x);
  void describe_to_assistants();
  void paint_bars(QPainter& painter, const Geometry& geometry) const;
  void paint_side(QPainter& painter, const QRectF& zone, const QString& label, std::size_t count, bool is_shown) const;
  void paint_axis(QPainter& painter, const Geometry& geometry) const;
  void paint_handles(QPainter& painter, const Geometry& geometry) const;
  QString tool_tip(const QPointF& position) const;

  Content content_;
  QString empty_text_;
  QToolButton* logarithmic_button_;
  mutable Histogram histogram_;
  mutable std::shared_ptr<const Primitive_set> binned_primitives_;
  mutable std::string binned_value_;
  Handle focused_ = Handle::minimum;
  bool is_dragging_ = false;
  bool is_undecided_ = false;
  double pressed_x_ = 0;
  double grip_offset_ = 0;
};

}  // namespace mesecina

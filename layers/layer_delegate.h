// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace mesecina {

/// Draws a row of the layer list (eye, swatch, label with a second line for a failure, badges, count) and tells its
/// parts apart. All sizes follow the font.
class Layer_delegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  enum class Part { none, eye, swatch, arrow, state, warning, label };
  using QStyledItemDelegate::QStyledItemDelegate;

  /// The part of the row with this rectangle that is at `position`.
  Part part_at(const QModelIndex& index, const QRect& row, const QFont& font, const QPoint& position) const;
  /// Where a part is; empty if the row has none.
  QRect part_rectangle(const QModelIndex& index, const QRect& row, const QFont& font, Part part) const;
  /// Moves the sign of running computations on by a step.
  void advance() { ++phase_; }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  /// Badges explain themselves, the rest of the row shows the model's tool tip.
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;

 private:
  void paint_stage(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paint_layer(QPainter& painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;

  int phase_ = 0;
};

}  // namespace mesecina

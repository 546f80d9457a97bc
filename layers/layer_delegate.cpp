// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/layer_delegate.h"

#include <QAbstractItemView>
#include <QApplication>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "layers/layer_model.h"
#include "layers/panel_paint.h"

namespace mesecina {

namespace {

using State = Layer_status::State;

QFont scaled(const QFont& font, double factor) {
  QFont result = font;
  if (font.pointSizeF() > 0) {
    result.setPointSizeF(font.pointSizeF() * factor);
  } else {
    result.setPixelSize(static_cast<int>(std::lround(font.pixelSize() * factor)));
  }
  return result;
}

QFont small_font(const QFont& font) { return scaled(font, 0.88); }

QFont heading_font(const QFont& font) {
  QFont result = scaled(font, 0.95);
  result.setBold(true);
  result.setCapitalization(QFont::SmallCaps);
  result.setLetterSpacing(QFont::PercentageSpacing, 104);
  return result;
}

int row_height(const QFont& font) { return static_cast<int>(std::lround(QFontMetricsF(font).height() * 1.55)); }

/// Where the parts of a row are; empty rectangles for parts it has not.
struct Row_layout {
  QRectF eye, swatch, text, reason, state, warning, count;
};

Row_layout lay_out(const QModelIndex& index, const QRect& rectangle, const QFont& font) {
  const QRectF row = rectangle;
  const double em = QFontMetricsF(font).height();
  const double gap = std::round(em * 0.4);
  const double line = std::min<double>(row_height(font), row.height());
  const double middle = row.top() + line / 2;
  const auto centered = [&](double left, double width, double height) {
    return QRectF(left, std::round(middle - height / 2), std::round(width), std::round(height));
  };
  Row_layout result;
  result.eye = centered(row.left() + gap, em * 1.05, em * 1.05);
  result.swatch = centered(result.eye.right() + gap, em * 1.25, em * 0.8);
  double right = row.right() - gap;
  if (const QString count = index.data(Layer_model::count_role).toString(); !count.isEmpty()) {
    const double width = QFontMetricsF(small_font(font)).horizontalAdvance(count) + 1;
    result.count = QRectF(right - width, row.top(), width, line);
    right -= width + gap;
  }
  const auto add_badge = [&](QRectF& badge) {
    badge = centered(std::round(right - em), em, em);
    right = badge.left() - gap / 2;
  };
  const bool is_stage = index.data(Layer_model::is_stage_role).toBool();
  if (!is_stage) {
    const auto state = static_cast<State>(index.data(Layer_model::state_role).toInt());
    const bool is_alarming = state == State::failed && !index.data(Layer_model::is_input_missing_role).toBool();
    if (state == State::computing || state == State::stale || is_alarming) add_badge(result.state);
    if (!index.data(Layer_model::warnings_role).toStringList().isEmpty()) add_badge(result.warning);
  }
  const double left = result.swatch.right() + gap;
  result.text = QRectF(left, row.top(), std::max(0.0, right - gap / 2 - left), line);
  if (row.height() > line) {
    result.reason = QRectF(left, row.top() + line - em * 0.3, row.right() - gap - left, row.height() - line + em * 0.1);
  }
  return result;
}

void draw_elided(QPainter& painter, const QRectF& rectangle, const QString& text, const QFont& font,
                 const QColor& color) {
  painter.setFont(font);
  painter.setPen(color);
  const QFontMetricsF metrics(font);
  painter.drawText(rectangle, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(text, Qt::ElideRight, rectangle.width()));
}

bool is_selected(const QStyleOptionViewItem& option) { return (option.state & QStyle::State_Selected) != 0; }

QPalette::ColorGroup group(const QStyleOptionViewItem& option) {
  return (option.state & QStyle::State_Active) != 0 ? QPalette::Active : QPalette::Inactive;
}

QColor background(const QStyleOptionViewItem& option) {
  return option.palette.color(group(option), is_selected(option) ? QPalette::Highlight : QPalette::Base);
}

QColor foreground(const QStyleOptionViewItem& option) {
  return option.palette.color(group(option), is_selected(option) ? QPalette::HighlightedText : QPalette::Text);
}

}  // namespace

Layer_delegate::Part Layer_delegate::part_at(const QModelIndex& index, const QRect& row, const QFont& font,
                                             const QPoint& position) const {
  if (!index.isValid() || !row.contains(position)) return Part::none;
  const Row_layout parts = lay_out(index, row, font);
  const double x = position.x();
  const bool is_first_line = position.y() < row.top() + row_height(font);
  // A target is as large as the row allows: the gaps beside a glyph belong to it.
  const double half_gap = (parts.swatch.left() - parts.eye.right()) / 2;
  if (is_first_line && x < parts.eye.right() + half_gap) return Part::eye;
  if (is_first_line && x < parts.swatch.right() + half_gap) {
    return index.data(Layer_model::is_stage_role).toBool() ? Part::arrow : Part::swatch;
  }
  if (parts.state.contains(position)) return Part::state;
  if (parts.warning.contains(position)) return Part::warning;
  return Part::label;
}

QRect Layer_delegate::part_rectangle(const QModelIndex& index, const QRect& row, const QFont& font, Part part) const {
  const Row_layout parts = lay_out(index, row, font);
  switch (part) {
    case Part::eye:
      return parts.eye.toRect();
    case Part::swatch:
    case Part::arrow:
      return parts.swatch.toRect();
    case Part::state:
      return parts.state.toRect();
    case Part::warning:
      return parts.warning.toRect();
    case Part::label:
      return parts.text.toRect();
    case Part::none:
      break;
  }
  return {};
}

void Layer_delegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  painter->save();
  QStyleOptionViewItem row = option;
  row.showDecorationSelected = true;
  if (row.widget) row.widget->style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &row, painter, row.widget);
  if (index.data(Layer_model::is_stage_role).toBool()) {
    paint_stage(*painter, option, index);
  } else {
    paint_layer(*painter, option, index);
  }
  if ((option.state & QStyle::State_HasFocus) != 0 && (option.state & QStyle::State_KeyboardFocusChange) != 0) {
    QStyleOptionFocusRect focus;
    focus.QStyleOption::operator=(option);
    focus.backgroundColor = background(option);
    QApplication::style()->drawPrimitive(QStyle::PE_FrameFocusRect, &focus, painter, option.widget);
  }
  painter->restore();
}

void Layer_delegate::paint_stage(QPainter& painter, const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const {
  const Row_layout parts = lay_out(index, option.rect, option.font);
  const QColor color = foreground(option);
  const QColor subdued = mix(color, background(option), 0.45);
  const auto visibility = static_cast<Qt::CheckState>(index.data(Qt::CheckStateRole).toInt());
  paint_eye(painter, parts.eye, visibility == Qt::Checked ? color : subdued, visibility != Qt::Unchecked);
  const bool is_expanded = (option.state & QStyle::State_Open) != 0;
  paint_arrow(painter, parts.swatch, subdued, is_expanded);
  QString heading = index.data().toString();
  if (index.data(Layer_model::is_interleaved_role).toBool()) heading += QStringLiteral(" ⇅");
  draw_elided(painter, parts.text, heading, heading_font(option.font), color);
  painter.setFont(small_font(option.font));
  painter.setPen(subdued);
  painter.drawText(parts.count, Qt::AlignRight | Qt::AlignVCenter, index.data(Layer_model::count_role).toString());
}

void Layer_delegate::paint_layer(QPainter& painter, const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const {
  const Row_layout parts = lay_out(index, option.rect, option.font);
  const QColor base = background(option);
  const QColor color = foreground(option);
  const QColor subdued = mix(color, base, is_selected(option) ? 0.3 : 0.45);
  const bool is_visible = index.data(Qt::CheckStateRole).toInt() == Qt::Checked;
  const auto state = static_cast<State>(index.data(Layer_model::state_role).toInt());

  paint_eye(painter, parts.eye, is_visible ? color : mix(color, base, 0.6), is_visible);
  const QRectF swatch = parts.swatch.adjusted(0.5, 0.5, -0.5, -0.5);
  if (!is_visible) painter.fillRect(swatch.adjusted(1, 1, -1, -1), option.palette.color(QPalette::Base));
  painter.setOpacity(is_visible ? 1 : 0.45);
  paint_swatch(painter, swatch, index.data(Layer_model::style_role).value<Style>(), option.palette);
  painter.setOpacity(1);

  const bool is_dimmed = state == State::not_computed || state == State::failed;
  draw_elided(painter, parts.text, index.data().toString(), option.font, is_dimmed ? subdued : color);
  const QColor failure = is_selected(option) ? color : failure_color(option.palette);
  const QColor warning = is_selected(option) ? color : warning_color(option.palette);
  const bool is_quiet = index.data(Layer_model::is_input_missing_role).toBool();
  if (!parts.reason.isEmpty()) {
    draw_elided(painter, parts.reason, index.data(Layer_model::reason_role).toString(), small_font(option.font),
                is_quiet ? subdued : failure);
  }
  if (state == State::computing) paint_spinner(painter, parts.state, color, phase_);
  if (state == State::stale) paint_clock(painter, parts.state, subdued);
  if (state == State::failed && !is_quiet) paint_failure(painter, parts.state, failure, base);
  if (!parts.warning.isEmpty()) paint_warning(painter, parts.warning, warning, base);
  painter.setFont(small_font(option.font));
  painter.setPen(subdued);
  painter.drawText(parts.count, Qt::AlignRight | Qt::AlignVCenter, index.data(Layer_model::count_role).toString());
}

QSize Layer_delegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  int height = row_height(option.font);
  if (!index.data(Layer_model::reason_role).toString().isEmpty()) {
    height += static_cast<int>(std::lround(QFontMetricsF(small_font(option.font)).height()));
  } else if (index.data(Layer_model::is_stage_role).toBool()) {
    height += static_cast<int>(std::lround(QFontMetricsF(option.font).height() * 0.15));
  }
  return {1, height};
}

bool Layer_delegate::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                               const QModelIndex& index) {
  if (event->type() != QEvent::ToolTip) return QStyledItemDelegate::helpEvent(event, view, option, index);
  const Part part = part_at(index, option.rect, option.font, event->pos());
  QString text;
  if (part == Part::warning) {
    text = index.data(Layer_model::warnings_role).toStringList().join(QLatin1Char('\n'));
  } else if (part == Part::state) {
    const auto state = static_cast<State>(index.data(Layer_model::state_role).toInt());
    text = state == State::failed  ? index.data(Layer_model::reason_role).toString()
           : state == State::stale ? tr("Shows an earlier result")
                                   : tr("Is being computed");
  } else if (part == Part::eye) {
    text = tr("Show or hide; with Alt: this one only");
  }
  if (text.isEmpty()) return QStyledItemDelegate::helpEvent(event, view, option, index);
  QToolTip::showText(event->globalPos(), text, view);
  return true;
}

}  // namespace mesecina

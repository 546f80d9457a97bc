// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/histogram_widget.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QToolTip>
#include <algorithm>
#include <cmath>
#include <limits>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {

constexpr double narrowest_bar = 3;     // logical pixels
constexpr double key_step = 1.0 / 200;  // of the axis

QFont font_of_numbers(const QFont& font) {
  QFont result = font;
  if (font.pointSizeF() > 0) {
    result.setPointSizeF(font.pointSizeF() * 0.85);
  } else {
    result.setPixelSize(static_cast<int>(std::lround(font.pixelSize() * 0.85)));
  }
  return result;
}

/// The number with the fewest digits that is as near to `value` as `resolution`.
double rounded(double value, double resolution) {
  if (!(resolution > 0) || !std::isfinite(resolution)) return value;
  const double exponent = std::floor(std::log10(resolution));
  const double scale = std::pow(10, std::abs(exponent));
  return exponent < 0 ? std::round(value * scale) / scale : std::round(value / scale) * scale;
}

}  // namespace

/// Where things are; the zones beside the plot are empty when nothing belongs there.
struct Histogram_widget::Geometry {
  QRectF header, labels, plot, below, infinite;
  double axis_top = 0;
};

/// Neighbouring bins drawn as one.
struct Histogram_widget::Bar {
  double from = 0;  ///< places on the axis, in [0, 1]
  double to = 0;
  std::size_t count = 0;
};

Histogram_widget::Histogram_widget(QWidget* parent) : QWidget(parent), logarithmic_button_(new QToolButton(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Histogram"));
  logarithmic_button_->setText(tr("log"));
  logarithmic_button_->setCheckable(true);
  logarithmic_button_->setAutoRaise(true);
  logarithmic_button_->setToolTip(tr("Heights grow with the logarithm of the counts"));
  logarithmic_button_->setAccessibleName(tr("Logarithmic counts"));
  logarithmic_button_->setFont(font_of_numbers(font()));
  connect(logarithmic_button_, &QToolButton::toggled, this, qOverload<>(&QWidget::update));
  set_empty({});
}

void Histogram_widget::set_content(const Content& content) {
  content_ = content;
  empty_text_.clear();
  if (content.is_cut) focused_ = Handle::minimum;
  const bool is_plot = content.layer.primitives && content.layer.primitives->find_values(content.value);
  logarithmic_button_->setVisible(is_plot);
  describe_to_assistants();
  update();
}

void Histogram_widget::set_empty(const QString& reason) {
  content_ = {};
  empty_text_ = reason;
  is_dragging_ = false;
  logarithmic_button_->hide();
  setAccessibleDescription(reason);
  update();
}

const Histogram& Histogram_widget::histogram() const {
  const auto& primitives = content_.layer.primitives;
  const std::string& name = content_.value;
  if (binned_primitives_ != primitives || binned_value_ != name) {
    const Values* values = primitives ? primitives->find_values(name) : nullptr;
    histogram_ = values ? compute_histogram(values->data) : Histogram();
    binned_primitives_ = primitives;
    binned_value_ = name;
  }
  return histogram_;
}

bool Histogram_widget::has_bins() const { return empty_text_.isEmpty() && !histogram().bins.empty(); }

Histogram_widget::Geometry Histogram_widget::geometry() const {
  const double em = QFontMetricsF(font()).height();
  const QFontMetricsF small(font_of_numbers(font()));
  const double line = std::ceil(small.height());
  Geometry result;
  const QRectF inner = QRectF(rect()).adjusted(em * 0.45, 0, -em * 0.45, 0);
  result.header = QRectF(inner.left(), 0, inner.width(), std::max<double>(line, logarithmic_button_->height()));
  result.labels = QRectF(inner.left(), result.header.bottom(), inner.width(), line);
  result.axis_top = height() - line - em * 0.3;
  result.plot = QRectF(QPointF(inner.left(), result.labels.bottom()), QPointF(inner.right(), result.axis_top));
  const auto side_width = [&](std::size_t count) {
    return std::ceil(std::max(em * 1.3, small.horizontalAdvance(grouped_count(count)) + em * 0.3));
  };
  const Histogram& shown = histogram();
  if (shown.below > 0) {
    result.below = result.plot;
    result.below.setWidth(side_width(shown.below));
    result.plot.setLeft(result.below.right() + em * 0.3);
  }
  if (shown.infinite > 0) {
    result.infinite = result.plot;
    result.infinite.setLeft(result.plot.right() - side_width(shown.infinite));
    result.plot.setRight(result.infinite.left() - em * 0.3);
  }
  return result;
}

std::vector<Histogram_widget::Bar> Histogram_widget::bars(const Geometry& geometry) const {
  const std::vector<std::size_t>& bins = histogram().bins;
  const double bin_width = geometry.plot.width() / static_cast<double>(bins.size());
  const auto group = static_cast<std::size_t>(std::max(1.0, std::ceil(narrowest_bar / std::max(bin_width, 0.01))));
  std::vector<Bar> result;
  for (std::size_t first = 0; first < bins.size(); first += group) {
    const std::size_t last = std::min(first + group, bins.size());
    Bar bar{static_cast<double>(first) / static_cast<double>(bins.size()),
            static_cast<double>(last) / static_cast<double>(bins.size()), 0};
    for (std::size_t bin = first; bin < last; ++bin) bar.count += bins[bin];
    result.push_back(bar);
  }
  return result;
}

std::optional<double> Histogram_widget::limit(Handle handle) const {
  if (content_.is_cut) {
    if (handle == Handle::maximum || !content_.layer.cut) return std::nullopt;
    return content_.layer.cut->minimum;
  }
  return handle == Handle::minimum ? content_.layer.style.threshold_minimum : content_.layer.style.threshold_maximum;
}

double Histogram_widget::x_of(double value) const {
  const Geometry parts = geometry();
  const Histogram& shown = histogram();
  if (std::isinf(value) && value > 0 && !parts.infinite.isEmpty()) return parts.infinite.center().x();
  if (value < shown.lower && !parts.below.isEmpty()) return parts.below.center().x();
  return parts.plot.left() + shown.position(value) * parts.plot.width();
}

double Histogram_widget::handle_x(Handle handle) const {
  const Geometry parts = geometry();
  const std::optional<double> value = limit(handle);
  if (handle == Handle::minimum) {
    const double end = parts.below.isEmpty() ? parts.plot.left() : parts.below.left();
    if (!value) return end;
    return *value <= std::min(histogram().minimum, histogram().lower) ? end : x_of(*value);
  }
  if (!value) return parts.infinite.isEmpty() ? parts.plot.right() : parts.infinite.right();
  return x_of(*value);
}

std::optional<double> Histogram_widget::limit_at(Handle handle, double x) const {
  const Geometry parts = geometry();
  const Histogram& shown = histogram();
  const double place = (x - parts.plot.left()) / std::max(parts.plot.width(), 1.0);
  const double lowest = content_.is_cut ? std::max(content_.cut_lowest, std::min(shown.minimum, shown.lower)) : 0;
  if (handle == Handle::minimum) {
    const bool is_before_all = parts.below.isEmpty() ? place <= 0 : x < parts.below.center().x();
    if (is_before_all) return content_.is_cut ? std::optional(lowest) : std::nullopt;
  } else {
    const bool is_past_all = parts.infinite.isEmpty() ? place >= 1 : x > parts.infinite.center().x();
    if (is_past_all) return std::nullopt;
  }
  const double half_pixel = 0.5 / std::max(parts.plot.width(), 1.0);
  double value = place <= 0 ? shown.lower : place >= 1 ? shown.maximum : shown.value(place);
  if (place > 0 && place < 1) {
    value = rounded(value, shown.value(place + half_pixel) - shown.value(place - half_pixel));
  }
  if (content_.is_cut) return std::clamp(value, content_.cut_lowest, content_.cut_highest);
  const std::optional<double> other = limit(handle == Handle::minimum ? Handle::maximum : Handle::minimum);
  if (!other) return value;
  return handle == Handle::minimum ? std::min(value, *other) : std::max(value, *other);
}

Histogram_widget::Handle Histogram_widget::nearest_handle(double x) const {
  if (content_.is_cut) return Handle::minimum;
  const double to_minimum = std::abs(x - handle_x(Handle::minimum));
  const double to_maximum = std::abs(x - handle_x(Handle::maximum));
  return to_minimum < to_maximum ? Handle::minimum : Handle::maximum;
}

void Histogram_widget::move_handle(Handle handle, double x) {
  const std::optional<double> value = limit_at(handle, x);
  if (value == limit(handle)) return;
  Q_EMIT handle_moved(handle, value);
}

void Histogram_widget::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !content_.has_handles || !has_bins()) {
    event->ignore();
    return;
  }
  const double x = event->position().x();
  focused_ = nearest_handle(x);
  const double offset = handle_x(focused_) - x;
  grip_offset_ = std::abs(offset) < QFontMetricsF(font()).height() * 0.5 ? offset : 0;
  // Of two handles in one place the direction of the drag tells which is meant.
  is_undecided_ = !content_.is_cut && std::abs(handle_x(Handle::minimum) - handle_x(Handle::maximum)) < 1;
  pressed_x_ = x;
  is_dragging_ = true;
  Q_EMIT gesture_started();
  update();
}

void Histogram_widget::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (is_dragging_) {
    if (is_undecided_ && x != pressed_x_) focused_ = x < pressed_x_ ? Handle::minimum : Handle::maximum;
    is_undecided_ = is_undecided_ && x == pressed_x_;
    move_handle(focused_, x + grip_offset_);
    return;
  }
  const bool is_near = content_.has_handles && has_bins() &&
                       std::abs(handle_x(nearest_handle(x)) - x) < QFontMetricsF(font()).height() * 0.5;
  setCursor(is_near ? Qt::SplitHCursor : Qt::ArrowCursor);
}

void Histogram_widget::mouseReleaseEvent(QMouseEvent*) { is_dragging_ = false; }

void Histogram_widget::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !content_.has_handles || !has_bins()) return;
  is_dragging_ = false;
  const double x = event->position().x();
  const Handle nearest = nearest_handle(x);
  const bool is_on_handle = std::abs(handle_x(nearest) - x) < QFontMetricsF(font()).height() * 0.5;
  Q_EMIT gesture_started();
  if (is_on_handle || content_.is_cut) {
    Q_EMIT handle_moved(nearest, std::nullopt);
  } else {
    Q_EMIT reset_requested();
  }
}

void Histogram_widget::keyPressEvent(QKeyEvent* event) {
  if (!content_.has_handles || !has_bins()) {
    QWidget::keyPressEvent(event);
    return;
  }
  const double width = geometry().plot.width();
  const double step = width * key_step * (event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1);
  const double x = std::clamp(handle_x(focused_), geometry().plot.left(), geometry().plot.right());
  switch (event->key()) {
    case Qt::Key_Left:
      move_handle(focused_, handle_x(focused_) > x ? x : x - step);
      break;
    case Qt::Key_Right:
      move_handle(focused_, handle_x(focused_) < x ? x : x + step);
      break;
    case Qt::Key_Home:
      move_handle(focused_, 0);
      break;
    case Qt::Key_End:
      move_handle(focused_, this->width());
      break;
    case Qt::Key_Delete:
    case Qt::Key_Backspace:
      Q_EMIT gesture_started();
      Q_EMIT handle_moved(focused_, std::nullopt);
      break;
    default:
      QWidget::keyPressEvent(event);
  }
}

bool Histogram_widget::focusNextPrevChild(bool is_next) {
  const bool has_two = content_.has_handles && !content_.is_cut && has_bins();
  const Handle wanted = is_next ? Handle::maximum : Handle::minimum;
  if (hasFocus() && has_two && focused_ != wanted) {
    focused_ = wanted;
    Q_EMIT gesture_started();
    update();
    return true;
  }
  return QWidget::focusNextPrevChild(is_next);
}

bool Histogram_widget::event(QEvent* event) {
  if (event->type() == QEvent::FocusIn) Q_EMIT gesture_started();
  if (event->type() == QEvent::FontChange) logarithmic_button_->setFont(font_of_numbers(font()));
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), tool_tip(help->pos()), this);
    return true;
  }
  return QWidget::event(event);
}

void Histogram_widget::resizeEvent(QResizeEvent*) {
  logarithmic_button_->adjustSize();
  logarithmic_button_->move(width() - logarithmic_button_->width(), 0);
}

void Histogram_widget::describe_to_assistants() {
  const auto text = [&](Handle handle) {
    const std::optional<double> value = limit(handle);
    return value ? short_number(*value) : tr("none");
  };
  setAccessibleDescription(content_.is_cut
                               ? tr("Limit %1").arg(text(Handle::minimum))
                               : tr("Minimum %1, maximum %2").arg(text(Handle::minimum), text(Handle::maximum)));
}

QString Histogram_widget::tool_tip(const QPointF& position) const {
  if (!has_bins()) return empty_text_;
  const Geometry parts = geometry();
  const Histogram& shown = histogram();
  if (parts.infinite.contains(position)) return tr("%1 elements: +∞ (never)").arg(grouped_count(shown.infinite));
  if (parts.below.contains(position)) {
    return tr("%1 elements below %2").arg(grouped_count(shown.below), short_number(shown.lower));
  }
  const double place = (position.x() - parts.plot.left()) / parts.plot.width();
  for (const Bar& bar : bars(parts)) {
    if (place < bar.from || place >= bar.to) continue;
    return tr("%1 elements from %2 to %3")
        .arg(grouped_count(bar.count), short_number(shown.value(bar.from)), short_number(shown.value(bar.to)));
  }
  return content_.has_handles ? tr("Drag the handles; double click takes them away") : QString();
}

void Histogram_widget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int em = fontMetrics().height();
  if (!has_bins()) {
    QString text = empty_text_;
    if (text.isEmpty() && histogram().infinite > 0) text = tr("All values are +∞ (never)");
    if (text.isEmpty()) text = tr("No element has a finite value");
    painter.setPen(subdued_text(palette()));
    painter.drawText(rect().adjusted(em, em / 2, -em, -em / 2), Qt::AlignCenter | Qt::TextWordWrap, text);
    return;
  }
  const Geometry parts = geometry();
  const Histogram& shown = histogram();
  painter.setFont(font_of_numbers(font()));
  painter.setPen(subdued_text(palette()));
  const QFontMetricsF metrics(painter.font());
  const QString header = tr("%1, %2 elements").arg(content_.caption, grouped_count(shown.total()));
  painter.drawText(parts.header, Qt::AlignLeft | Qt::AlignVCenter,
                   metrics.elidedText(header, Qt::ElideRight, logarithmic_button_->x() - parts.header.left()));
  paint_bars(painter, parts);
  paint_axis(painter, parts);
  if (content_.has_handles) paint_handles(painter, parts);
}

void Histogram_widget::paint_bars(QPainter& painter, const Geometry& parts) const {
  const Histogram& shown = histogram();
  const std::vector<Bar> drawn = bars(parts);
  std::size_t highest = 1;
  for (const Bar& bar : drawn) highest = std::max(highest, bar.count);
  const bool is_logarithmic = logarithmic_button_->isChecked();
  const auto height_of = [&](std::size_t count) {
    if (count == 0) return 0.0;
    const double part = is_logarithmic
                            ? std::log1p(static_cast<double>(count)) / std::log1p(static_cast<double>(highest))
                            : static_cast<double>(count) / static_cast<double>(highest);
    return std::max(1.0, std::min(part, 1.0) * parts.plot.height() * 0.94);
  };
  Values centers;
  const Style& style = content_.layer.style;
  const bool is_colored_by_value = style.value == content_.value;
  for (const Bar& bar : drawn) centers.data.push_back(shown.value((bar.from + bar.to) / 2));
  const double from = limit(Handle::minimum).value_or(-std::numeric_limits<double>::infinity());
  const double to = limit(Handle::maximum).value_or(std::numeric_limits<double>::infinity());
  const QColor base = palette().color(QPalette::Window);
  const QColor hidden = mix(palette().color(QPalette::WindowText), base, 0.8);

  // Edges lie on whole device pixels, so that neighbours neither blur nor overlap.
  const double ratio = devicePixelRatioF();
  const auto snapped = [&](double x) { return std::round(x * ratio) / ratio; };
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(Qt::NoPen);
  const double gap = drawn.size() < 40 ? 1 : 0;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i].count == 0) continue;
    const double left = snapped(parts.plot.left() + drawn[i].from * parts.plot.width());
    const double right = snapped(parts.plot.left() + drawn[i].to * parts.plot.width()) - gap;
    const double top = snapped(parts.axis_top - height_of(drawn[i].count));
    const bool is_shown = centers.data[i] >= from && centers.data[i] <= to;
    const QRectF bar(QPointF(left, top), QPointF(std::max(right, left + 1 / ratio), parts.axis_top));
    const Color color = color_of(style, is_colored_by_value ? &centers : nullptr, content_.range, i);
    painter.fillRect(bar, is_shown ? to_qcolor(color) : hidden);
    if (is_shown) {
      // A dark end of a map on a dark window, or a light one on a light window, still shows where it ends.
      const QColor cap = mix(to_qcolor(color), palette().color(QPalette::WindowText), 0.45);
      painter.fillRect(QRectF(bar.topLeft(), QSizeF(bar.width(), 1)), cap);
    }
  }
  painter.restore();
  if (!parts.below.isEmpty()) {
    const QString label = shown.minimum == 0 ? QStringLiteral("0") : QStringLiteral("…");
    paint_side(painter, parts.below, label, shown.below, from <= shown.minimum);
  }
  if (!parts.infinite.isEmpty()) {
    paint_side(painter, parts.infinite, QStringLiteral("∞"), shown.infinite, std::isinf(to));
  }
}

/// A count beside the axis: a bar of fixed height, for it has no place on the scale of the others.
void Histogram_widget::paint_side(QPainter& painter, const QRectF& zone, const QString& label, std::size_t count,
                                  bool is_shown) const {
  const QFontMetricsF metrics(painter.font());
  const QColor text = subdued_text(palette());
  const double height = zone.height() * 0.5;
  const double width = std::min(zone.width(), metrics.height());
  const QRectF bar(zone.center().x() - width / 2, zone.bottom() - height, width, height);
  painter.fillRect(bar, QBrush(is_shown ? text : mix(text, palette().color(QPalette::Window), 0.6), Qt::BDiagPattern));
  painter.setPen(text);
  painter.drawText(QRectF(zone.left() - 2, bar.top() - metrics.height(), zone.width() + 4, metrics.height()),
                   Qt::AlignCenter, grouped_count(count));
  painter.drawText(QRectF(zone.left() - 2, zone.bottom() + 1, zone.width() + 4, metrics.height()), Qt::AlignCenter,
                   label);
}

void Histogram_widget::paint_axis(QPainter& painter, const Geometry& parts) const {
  const Histogram& shown = histogram();
  const QFontMetricsF metrics(painter.font());
  const QColor text = subdued_text(palette());
  painter.fillRect(QRectF(parts.plot.left(), parts.axis_top, parts.plot.width(), 1), mix(text, Qt::transparent, 0.5));
  const double top = parts.axis_top + 1;
  const bool is_by_integer = shown.lower < shown.minimum;
  const QString first = short_number(is_by_integer ? shown.minimum : shown.lower);
  const QString last = short_number(shown.maximum);
  painter.setPen(text);
  if (shown.minimum == shown.maximum) {
    painter.drawText(QRectF(parts.plot.left(), top, parts.plot.width(), metrics.height()), Qt::AlignCenter, last);
    return;
  }
  const QRectF line(parts.plot.left(), top, parts.plot.width(), metrics.height());
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, first);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, last);
  if (shown.is_logarithmic) {
    const QString note = tr("log scale");
    const double used = metrics.horizontalAdvance(first) + metrics.horizontalAdvance(last);
    if (used + metrics.horizontalAdvance(note) + 2 * metrics.height() < line.width()) {
      painter.drawText(line, Qt::AlignCenter, note);
    }
  }
}

void Histogram_widget::paint_handles(QPainter& painter, const Geometry& parts) const {
  const QFontMetricsF metrics(painter.font());
  const double em = QFontMetricsF(font()).height();
  QRectF taken;
  for (const Handle handle : {Handle::minimum, Handle::maximum}) {
    if (content_.is_cut && handle == Handle::maximum) continue;
    const std::optional<double> value = limit(handle);
    const double x = std::round(handle_x(handle));
    const bool is_focused = hasFocus() && handle == focused_;
    QColor color = palette().color(is_focused ? QPalette::Highlight : QPalette::WindowText);
    if (!value && !is_focused) color = mix(color, palette().color(QPalette::Window), 0.45);
    painter.setPen(QPen(color, is_focused ? 2 : 1));
    painter.drawLine(QPointF(x, parts.plot.top()), QPointF(x, parts.axis_top));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const double half = em * 0.22;
    const double top = parts.plot.top();
    const QPointF grip[] = {
        {x, top + half * 2.2}, {x + half, top + half}, {x + half, top}, {x - half, top}, {x - half, top + half}};
    painter.drawPolygon(grip, 5);
    if (!value) continue;
    const QString text = short_number(*value);
    const double width = metrics.horizontalAdvance(text);
    double left =
        std::clamp(x - width / 2, parts.labels.left(), std::max(parts.labels.left(), parts.labels.right() - width));
    if (left < taken.right() + metrics.averageCharWidth()) left = taken.right() + metrics.averageCharWidth();
    taken = QRectF(left, parts.labels.top(), width, parts.labels.height());
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(taken.adjusted(0, 0, 2, 0), Qt::AlignLeft | Qt::AlignVCenter, text);
  }
}

QSize Histogram_widget::sizeHint() const {
  const int em = fontMetrics().height();
  return {em * 14, em * 8};
}

QSize Histogram_widget::minimumSizeHint() const { return {fontMetrics().height() * 8, fontMetrics().height() * 8}; }

}  // namespace mesecina

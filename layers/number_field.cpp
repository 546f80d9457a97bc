// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/number_field.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QStyleOptionSpinBox>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/formats/number.h"
#include "layers/panel_paint.h"

namespace mesecina {

namespace {

constexpr int shown_digits = 6;

}  // namespace

Number_field::Number_field(QWidget* parent) : QAbstractSpinBox(parent) {
  setButtonSymbols(NoButtons);
  setFocusPolicy(Qt::StrongFocus);
  setLocale(QLocale::c());
  setCorrectionMode(CorrectToPreviousValue);
  connect(this, &QAbstractSpinBox::editingFinished, this, &Number_field::commit);
}

void Number_field::set_bounds(double minimum, double maximum) {
  minimum_ = minimum;
  maximum_ = maximum;
}

void Number_field::show_value(std::optional<double> value, const QString& placeholder, std::optional<double> start) {
  lineEdit()->setPlaceholderText(placeholder);
  start_ = start;
  if (hasFocus() && is_text_edited() && value == value_) return;
  value_ = value;
  const QString text = text_of(value);
  if (lineEdit()->text() != text) lineEdit()->setText(text);
  lineEdit()->setCursorPosition(0);
}

std::optional<double> Number_field::parsed(QString text) const {
  text = text.trimmed();
  if (const QString unit = suffix_.trimmed(); !unit.isEmpty() && text.endsWith(unit)) {
    text = text.chopped(unit.size()).trimmed();
  }
  const std::optional<double> number = parse_number(text.toStdString());
  if (!number || std::isnan(*number)) return std::nullopt;
  return std::clamp(*number, minimum_, maximum_);
}

QString Number_field::text_of(std::optional<double> value) const {
  if (!value) return {};
  const QString number =
      std::isinf(*value) ? QString::fromStdString(format_number(*value)) : short_number(*value, shown_digits);
  return number + suffix_;
}

bool Number_field::is_text_edited() const { return lineEdit()->text() != text_of(value_); }

void Number_field::commit() {
  if (is_text_edited()) {
    const QString text = lineEdit()->text();
    const bool is_emptied = text.trimmed().isEmpty();
    const std::optional<double> number = parsed(text);
    const std::optional<double> before = value_;
    if (number || (is_emptied && is_optional_)) value_ = number;
    lineEdit()->setText(text_of(value_));
    if (value_ != before) Q_EMIT edited(value_);
  }
  Q_EMIT finished();
}

void Number_field::stepBy(int steps) {
  const std::optional<double> from = value_ ? value_ : start_;
  if (!from || !std::isfinite(*from)) return;
  const double magnitude = std::abs(*from) / 20;
  const double step = step_ > 0 ? step_ : magnitude > 0 ? std::pow(10, std::floor(std::log10(magnitude))) : 0.01;
  // Whole multiples of the step, so that 0.1 + 0.1 + 0.1 is shown and kept as 0.3.
  const double inverse = std::round(1 / step);
  const double multiple = std::round(*from / step) + steps;
  const double next = std::clamp(step < 1 && inverse < 1e15 ? multiple / inverse : multiple * step, minimum_, maximum_);
  if (value_ == next) return;
  value_ = next;
  lineEdit()->setText(text_of(value_));
  Q_EMIT edited(value_);
}

QValidator::State Number_field::validate(QString& text, int&) const {
  text.replace(QLatin1Char(','), QLatin1Char('.'));
  return parsed(text) || (is_optional_ && text.trimmed().isEmpty()) ? QValidator::Acceptable : QValidator::Intermediate;
}

QAbstractSpinBox::StepEnabled Number_field::stepEnabled() const {
  if (isReadOnly() || !(value_ || start_)) return StepNone;
  return StepUpEnabled | StepDownEnabled;
}

void Number_field::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) {
    QAbstractSpinBox::wheelEvent(event);
  } else {
    event->ignore();
  }
}

void Number_field::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && is_text_edited()) {
    lineEdit()->setText(text_of(value_));
    selectAll();
    return;
  }
  QAbstractSpinBox::keyPressEvent(event);
}

QSize Number_field::sizeHint() const {
  ensurePolished();
  QStyleOptionSpinBox option;
  initStyleOption(&option);
  const int width = fontMetrics().horizontalAdvance(QStringLiteral("-0.00000")) + fontMetrics().height() / 2;
  const QSize content(width, lineEdit()->sizeHint().height());
  return style()->sizeFromContents(QStyle::CT_SpinBox, &option, content, this);
}

QSize Number_field::minimumSizeHint() const {
  QSize size = sizeHint();
  size.setWidth(fontMetrics().horizontalAdvance(QStringLiteral("-0.00")) + fontMetrics().height());
  return size;
}

}  // namespace mesecina

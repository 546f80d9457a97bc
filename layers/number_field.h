// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractSpinBox>
#include <limits>
#include <optional>

namespace mesecina {

/// A field for one number, or for none, which then shows a placeholder ("mixed", "auto 0.25"). Shows and reads numbers
/// in the C locale whatever the system's is; a typed decimal comma becomes a point. The wheel changes it only while it
/// has the focus.
class Number_field : public QAbstractSpinBox {
  Q_OBJECT
 public:
  explicit Number_field(QWidget* parent = nullptr);

  void set_bounds(double minimum, double maximum);
  /// Of the arrow keys and the wheel; 0: about a twentieth of the number.
  void set_step(double step) { step_ = step; }
  void set_suffix(const QString& suffix) { suffix_ = suffix; }
  /// An optional field may be emptied.
  void set_optional(bool is_optional) { is_optional_ = is_optional; }
  /// Does nothing to a text that is being edited and stands for the same number. `start` is where stepping begins when
  /// there is no value.
  void show_value(std::optional<double> value, const QString& placeholder = {}, std::optional<double> start = {});
  std::optional<double> value() const { return value_; }

  void stepBy(int steps) override;
  QValidator::State validate(QString& text, int& position) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// The user changed the number, or took it away where that is allowed.
  void edited(const std::optional<double>& value);
  /// The focus left, or a typed number was taken over: what follows is another change.
  void finished();

 protected:
  StepEnabled stepEnabled() const override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::optional<double> parsed(QString text) const;
  QString text_of(std::optional<double> value) const;
  bool is_text_edited() const;
  void commit();

  std::optional<double> value_;
  std::optional<double> start_;
  double minimum_ = -std::numeric_limits<double>::infinity();
  double maximum_ = std::numeric_limits<double>::infinity();
  double step_ = 0;
  bool is_optional_ = false;
  QString suffix_;
};

}  // namespace mesecina

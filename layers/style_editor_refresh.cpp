// SPDX-License-Identifier: GPL-3.0-or-later
// How a Style_editor shows its subjects.
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "layers/automatic_dot.h"
#include "layers/color_map.h"
#include "layers/histogram_widget.h"
#include "layers/number_field.h"
#include "layers/panel_paint.h"
#include "layers/style_editor.h"

namespace mesecina {

template <class T>
std::optional<T> Style_editor::common(T Style::*member) const {
  if (subjects_.empty()) return std::nullopt;
  const T& first = subjects_.front().layer.style.*member;
  const bool is_same = std::all_of(subjects_.begin(), subjects_.end(),
                                   [&](const Subject& subject) { return subject.layer.style.*member == first; });
  return is_same ? std::optional<T>(first) : std::nullopt;
}

/// Names of the values that every computed subject has, and those that styles ask for.
std::vector<std::string> Style_editor::offered_values() const {
  std::vector<std::string> names;
  bool is_first = true;
  for (const Subject& subject : subjects_) {
    const auto& primitives = subject.layer.primitives;
    if (!primitives || primitives->is_empty()) continue;
    if (is_first) {
      for (const Values& values : primitives->values) names.push_back(values.name);
    } else {
      std::erase_if(names, [&](const std::string& name) { return !primitives->find_values(name); });
    }
    is_first = false;
  }
  for (const Subject& subject : subjects_) {
    const std::string& name = subject.layer.style.value;
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

void Style_editor::refresh_switches() {
  for (const Switch& entry : switches_) {
    const QSignalBlocker blocker(entry.box);
    const std::optional<bool> is_on = common(entry.member);
    const bool is_mixed = !is_on && !subjects_.empty();
    entry.box->setTristate(is_mixed);
    entry.box->setCheckState(is_mixed ? Qt::PartiallyChecked : is_on.value_or(false) ? Qt::Checked : Qt::Unchecked);
  }
  const bool is_in_space = std::any_of(subjects_.begin(), subjects_.end(), [](const Subject& subject) {
    return subject.layer.primitives && subject.layer.primitives->dimension == 3;
  });
  space_row_->setVisible(is_in_space);
  space_label_->setVisible(is_in_space);
}

void Style_editor::refresh() {
  setEnabled(!subjects_.empty());
  refresh_color();
  refresh_switches();
  refresh_slider(opacity_, &Style::opacity, 100);
  refresh_slider(point_size_, &Style::point_size, 1);
  refresh_slider(line_width_, &Style::line_width, 1);
  refresh_value_choice();

  const bool is_by_value = std::any_of(subjects_.begin(), subjects_.end(),
                                       [](const Subject& subject) { return !subject.layer.style.value.empty(); });
  std::string value;
  bool has_cut = false;
  if (!subjects_.empty()) {
    const Scene_layer& layer = subjects_.front().layer;
    value = layer.style.value.empty() && layer.cut ? layer.cut->value : layer.style.value;
    has_cut = layer.cut && layer.cut->value == value;
  }
  const bool has_thresholds = std::any_of(subjects_.begin(), subjects_.end(), [](const Subject& subject) {
    return subject.layer.style.threshold_minimum || subject.layer.style.threshold_maximum;
  });
  color_map_label_->setVisible(is_by_value);
  color_map_row_->setVisible(is_by_value);
  range_.label->setVisible(is_by_value);
  range_.box->setVisible(is_by_value);
  // Where the setting is the limit, the style's own one is shown only when it has an effect.
  const bool shows_thresholds = is_by_value && (!has_cut || has_thresholds);
  threshold_.label->setVisible(shows_thresholds);
  threshold_.box->setVisible(shows_thresholds);
  refresh_cut(has_cut);
  refresh_histogram(value, has_cut);
}

void Style_editor::refresh_color() {
  const std::optional<Color> color = common(&Style::color);
  color_button_->setText(color ? to_qcolor(*color).name() : subjects_.empty() ? QString() : tr("mixed"));
  color_button_->setIcon(!color ? QIcon()
                                : painted_icon([color = *color, palette = palette()](
                                                   QPainter& painter, const QRectF& rectangle, const QColor&) {
                                    Style plain;
                                    plain.color = color;
                                    paint_swatch(painter, rectangle.adjusted(0.5, 0.5, -0.5, -0.5), plain, palette);
                                  }));
  if (color_dialog_ && !subjects_.empty()) {
    const QSignalBlocker blocker(color_dialog_);
    const QColor shown = to_qcolor(color.value_or(subjects_.front().layer.style.color));
    if (color_dialog_->currentColor().rgb() != shown.rgb()) color_dialog_->setCurrentColor(shown);
  }
}

void Style_editor::refresh_slider(const Slider_row& row, double Style::*member, double scale) {
  const QSignalBlocker blocker(row.slider);
  if (subjects_.empty()) {
    row.slider->setValue(row.slider->minimum());
    row.field->show_value(std::nullopt);
    return;
  }
  const double first = subjects_.front().layer.style.*member * scale;
  const std::optional<double> number = common(member);
  if (!row.slider->isSliderDown()) row.slider->setValue(static_cast<int>(std::lround(first / row.unit)));
  row.field->show_value(number ? std::optional(first) : std::nullopt, number ? QString() : tr("mixed"), first);
}

void Style_editor::refresh_value_choice() {
  const QSignalBlocker value_blocker(value_combo_);
  const QSignalBlocker map_blocker(color_map_combo_);
  const std::vector<std::string> names = offered_values();
  QStringList wanted{QString()};
  for (const std::string& name : names) wanted << QString::fromStdString(name);
  QStringList present;
  for (int i = 0; i < value_combo_->count(); ++i) present << value_combo_->itemData(i).toString();
  if (present != wanted) {
    value_combo_->clear();
    for (const QString& name : wanted) value_combo_->addItem(name.isEmpty() ? tr("plain") : name, name);
  }
  const std::optional<std::string> value = common(&Style::value);
  value_combo_->setPlaceholderText(subjects_.empty() ? QString() : tr("mixed"));
  value_combo_->setCurrentIndex(value ? value_combo_->findData(QString::fromStdString(*value)) : -1);

  const std::optional<std::string> map = common(&Style::color_map);
  color_map_combo_->setCurrentIndex(map ? color_map_combo_->findData(QString::fromStdString(*map)) : -1);
  const std::optional<bool> is_reversed = common(&Style::color_map_reversed);
  reversed_button_->setChecked(is_reversed.value_or(false));
}

void Style_editor::refresh_limits(const Limits_row& row, Member minimum, Member maximum,
                                  const std::optional<double>& automatic_minimum,
                                  const std::optional<double>& automatic_maximum) {
  const auto show = [&](Number_field* field, Automatic_dot* dot, Member member,
                        const std::optional<double>& automatic) {
    const bool is_chosen = std::any_of(subjects_.begin(), subjects_.end(), [&](const Subject& subject) {
      return (subject.layer.style.*member).has_value();
    });
    const std::optional<std::optional<double>> number = common(member);
    QString placeholder = automatic ? short_number(*automatic) : tr("none");
    if (!number && !subjects_.empty()) placeholder = tr("mixed");
    field->show_value(number.value_or(std::nullopt), placeholder, automatic);
    dot->show_chosen(is_chosen);
  };
  show(row.minimum, row.minimum_dot, minimum, automatic_minimum);
  show(row.maximum, row.maximum_dot, maximum, automatic_maximum);
}

void Style_editor::refresh_cut(bool has_cut) {
  cut_label_->setVisible(has_cut);
  cut_row_->setVisible(has_cut);
  if (!has_cut) return;
  const Subject& subject = subjects_.front();
  const QString label = subject.cut_label.isEmpty() ? subject.cut_setting : subject.cut_label;
  const QString text = tr("%1: elements whose value is less do not belong to the layer. This is a setting, which other "
                          "layers may use, too.")
                           .arg(label);
  cut_label_->setToolTip(text);
  cut_field_->setToolTip(text);
  cut_field_->setAccessibleName(label);
  cut_field_->set_bounds(subject.cut_lowest, subject.cut_highest);
  cut_field_->show_value(subject.layer.cut->minimum);
  cut_dot_->show_chosen(subject.layer.cut->minimum != subject.cut_default);
}

void Style_editor::refresh_histogram(const std::string& value, bool has_cut) {
  const std::optional<double> none;
  const Values* values = nullptr;
  Value_range automatic;
  if (!subjects_.empty() && subjects_.front().layer.primitives) {
    values = subjects_.front().layer.primitives->find_values(value);
  }
  if (values) {
    Scene_layer layer = subjects_.front().layer;
    layer.style.range_minimum = layer.style.range_maximum = none;
    if (layer.style.value.empty()) layer.style.value = value;
    automatic = value_range(layer);
  }
  refresh_limits(range_, &Style::range_minimum, &Style::range_maximum, values ? std::optional(automatic.minimum) : none,
                 values ? std::optional(automatic.maximum) : none);
  refresh_limits(threshold_, &Style::threshold_minimum, &Style::threshold_maximum, none, none);
  if (!values) {
    histogram_->set_empty(subjects_.empty() ? tr("Select a layer to change its look.")
                          : !subjects_.front().layer.primitives
                              ? tr("The distribution of values appears here once the layer is computed.")
                          : subjects_.front().layer.primitives->values.empty()
                              ? tr("The elements of this layer have no values.")
                              : tr("Choose a value under “Colour by” to see how it is distributed."));
    return;
  }
  const Subject& subject = subjects_.front();
  Histogram_widget::Content content;
  content.layer = subject.layer;
  content.value = value;
  content.caption = QString::fromStdString(value);
  if (!values->unit.empty()) content.caption += QStringLiteral(" [%1]").arg(QString::fromStdString(values->unit));
  if (subjects_.size() > 1) {
    content.caption = tr("%1 of %2").arg(content.caption, QString::fromStdString(subject.layer.label));
  }
  content.range = automatic;
  if (subject.layer.style.range_minimum) content.range.minimum = *subject.layer.style.range_minimum;
  if (subject.layer.style.range_maximum) content.range.maximum = *subject.layer.style.range_maximum;
  content.is_cut = has_cut;
  content.cut_lowest = subject.cut_lowest;
  content.cut_highest = subject.cut_highest;
  histogram_->set_content(content);
}

}  // namespace mesecina

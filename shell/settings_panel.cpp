// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/settings_panel.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/help_text.h"
#include "layers/number_field.h"

namespace mesecina {

namespace {

QString text_of(const std::string& text) { return QString::fromStdString(text); }

double number_of(const Setting_value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&value);
  return real ? *real : 0;
}

/// Between the positions of a slider and the numbers of a setting; the default lies about the middle.
class Slider_scale {
 public:
  static constexpr int steps = 1000;

  Slider_scale(double minimum, double maximum, double start) : minimum_(minimum) { set_maximum(maximum, start); }
  void set_maximum(double maximum, double start) {
    maximum_ = std::max(maximum, minimum_);
    const double middle = maximum_ > minimum_ ? (start - minimum_) / (maximum_ - minimum_) : 0;
    constexpr double least = 1;
    constexpr double most = 8;
    constexpr double usual = 2;
    exponent_ = middle > 0 && middle < 1 ? std::clamp(std::log(middle) / std::log(0.5), least, most) : usual;
  }
  double value(int position) const {
    if (position <= 0) return minimum_;
    if (position >= steps) return maximum_;
    const double exact = minimum_ + (maximum_ - minimum_) * std::pow(static_cast<double>(position) / steps, exponent_);
    // As many digits as the slider can tell apart.
    const double unit = std::pow(10, std::floor(std::log10((maximum_ - minimum_) * exact / (steps * maximum_))));
    return std::isfinite(unit) && unit > 0 ? std::round(exact / unit) * unit : exact;
  }
  int position(double value) const {
    if (!(maximum_ > minimum_)) return 0;
    const double part = std::clamp((value - minimum_) / (maximum_ - minimum_), 0.0, 1.0);
    return static_cast<int>(std::round(std::pow(part, 1 / exponent_) * steps));
  }

 private:
  double minimum_;
  double maximum_ = 0;
  double exponent_ = 1;
};

/// Turning the wheel over the panel scrolls the panel.
class Calm_slider : public QSlider {
 public:
  using QSlider::QSlider;

 protected:
  void wheelEvent(QWheelEvent* event) override { event->ignore(); }
};

}  // namespace

QString Settings_panel::tip_of(const Setting_spec& spec) const {
  // Rich text is broken into lines, plain text is not.
  const auto paragraph = [](const QString& text) { return QStringLiteral("<p>%1</p>").arg(text.toHtmlEscaped()); };
  const QString help = paragraph(text_of(with_labels(spec.help, *registry_)));
  return spec.unit.empty() ? help : help + paragraph(tr("Unit: %1").arg(text_of(spec.unit)));
}

Settings_panel::Settings_panel(std::shared_ptr<const Registry> registry, QWidget* parent)
    : QScrollArea(parent), registry_(std::move(registry)) {
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  const int em = fontMetrics().height();
  column->setContentsMargins(em / 2, em / 2, em / 2, em / 2);
  column->setSpacing(em / 3);
  const Module_spec* group = nullptr;
  QLabel* heading = nullptr;
  for (const Setting_spec& spec : registry_->settings()) {
    const Module_spec* module = registry_->module_of(spec.id);
    if (module != group && module) {
      heading = new QLabel(text_of(module->label), content);
      if (group) heading->setContentsMargins(0, em / 2, 0, 0);
      heading->setToolTip(text_of(with_labels(module->help, *registry_)));
      QFont bold = heading->font();
      bold.setBold(true);
      heading->setFont(bold);
      column->addWidget(heading);
    }
    group = module;
    add_row(spec, column, heading);
  }
  nothing_ = new QLabel(tr("No setting has these words."), content);
  nothing_->setForegroundRole(QPalette::PlaceholderText);
  nothing_->setWordWrap(true);
  nothing_->hide();
  column->addWidget(nothing_);
  column->addStretch(1);
  setWidget(content);
  set_settings({});
}

void Settings_panel::add_row(const Setting_spec& spec, QVBoxLayout* column, QWidget* heading) {
  Row row;
  QWidget* editor = std::holds_alternative<bool>(spec.default_value)          ? make_switch(spec, row)
                    : std::holds_alternative<std::string>(spec.default_value) ? make_text(spec, row)
                                                                              : make_number(spec, row);
  row.editor = editor;
  row.reset = new QToolButton(widget() ? widget() : this);
  row.reset->setText(QStringLiteral("●"));
  row.reset->setAutoRaise(true);
  row.reset->setAccessibleName(tr("Reset %1").arg(text_of(spec.label)));
  row.reset->setToolTip(tr("Back to the default, %1").arg(text_of(to_text(spec.default_value))));
  QSizePolicy keep = row.reset->sizePolicy();
  keep.setRetainSizeWhenHidden(true);
  row.reset->setSizePolicy(keep);
  connect(row.reset, &QToolButton::clicked, this, [this, &spec] { change(spec, spec.default_value, {}); });
  row.line = new QWidget(this);
  auto* line = new QHBoxLayout(row.line);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(fontMetrics().height() / 4);
  line->addWidget(editor, 1);
  auto* buttons = new QVBoxLayout;
  buttons->setSpacing(0);
  buttons->addWidget(row.reset);
  if (row.animate) buttons->addWidget(make_animate_button(spec, row));
  buttons->addStretch(1);
  line->addLayout(buttons);
  column->addWidget(row.line);
  row.heading = heading;
  const Module_spec* module = registry_->module_of(spec.id);
  row.words = text_of(spec.id + ' ' + spec.label + ' ' + spec.help + ' ' + spec.unit + ' ' +
                      (module ? module->label : std::string()));
  for (const std::string& tag : spec.tags) row.words += QLatin1Char(' ') + text_of(tag);
  for (const Evolution_spec& evolution : registry_->evolutions())
    if (std::ranges::count(evolution.settings, spec.id) > 0)
      row.words += text_of(' ' + evolution.id + ' ' + evolution.label);
  rows_.emplace(spec.id, std::move(row));
}

QWidget* Settings_panel::make_animate_button(const Setting_spec& spec, const Row& row) {
  auto* button = new QToolButton(row.line);
  button->setText(QStringLiteral("▶"));
  button->setAutoRaise(true);
  button->setObjectName(QStringLiteral("animate-") + text_of(spec.id));
  button->setAccessibleName(tr("Animate %1").arg(text_of(spec.label)));
  button->setToolTip(tr("Animate: let the number move, play and record it"));
  connect(button, &QToolButton::clicked, this, row.animate);
  auto* action = new QAction(tr("Animate %1…").arg(text_of(spec.label)), row.line);
  connect(action, &QAction::triggered, this, row.animate);
  auto* reset = new QAction(tr("Reset to %1").arg(text_of(to_text(spec.default_value))), row.line);
  connect(reset, &QAction::triggered, this, [this, &spec] { change(spec, spec.default_value, {}); });
  row.line->addActions({action, reset});
  row.line->setContextMenuPolicy(Qt::ActionsContextMenu);
  return button;
}

QWidget* Settings_panel::make_switch(const Setting_spec& spec, Row& row) {
  auto* box = new QCheckBox(text_of(spec.label), this);
  box->setToolTip(tip_of(spec));
  box->setAccessibleName(text_of(spec.label));
  connect(box, &QCheckBox::toggled, this, [this, &spec](bool is_on) { change(spec, is_on, {}); });
  row.show = [box](const Setting_value& value) {
    const QSignalBlocker quiet(box);
    box->setChecked(std::get<bool>(value));
  };
  return box;
}

QWidget* Settings_panel::make_text(const Setting_spec& spec, Row& row) {
  auto* holder = new QWidget(this);
  auto* layout = new QHBoxLayout(holder);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(text_of(spec.label), holder);
  label->setToolTip(tip_of(spec));
  label->setWordWrap(true);
  layout->addWidget(label, 1);
  if (spec.choices.empty()) {
    auto* line = new QLineEdit(holder);
    line->setToolTip(tip_of(spec));
    line->setAccessibleName(text_of(spec.label));
    connect(line, &QLineEdit::editingFinished, this,
            [this, &spec, line] { change(spec, line->text().toStdString(), {}); });
    row.show = [line](const Setting_value& value) { line->setText(text_of(std::get<std::string>(value))); };
    layout->addWidget(line);
    return holder;
  }
  auto* combo = new QComboBox(holder);
  for (const std::string& choice : spec.choices) combo->addItem(text_of(choice));
  combo->setToolTip(tip_of(spec));
  combo->setAccessibleName(text_of(spec.label));
  combo->setFocusPolicy(Qt::StrongFocus);
  connect(combo, &QComboBox::textActivated, this,
          [this, &spec](const QString& text) { change(spec, text.toStdString(), {}); });
  row.show = [combo](const Setting_value& value) {
    const QSignalBlocker quiet(combo);
    combo->setCurrentText(text_of(std::get<std::string>(value)));
  };
  layout->addWidget(combo);
  return holder;
}

QWidget* Settings_panel::make_number(const Setting_spec& spec, Row& row) {
  const bool is_whole = std::holds_alternative<std::int64_t>(spec.default_value);
  const double start = number_of(spec.default_value);
  const auto as_value = [is_whole](double number) -> Setting_value {
    if (is_whole) return static_cast<std::int64_t>(std::llround(number));
    return number;
  };
  auto* holder = new QWidget(this);
  auto* grid = new QGridLayout(holder);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(0);
  auto* label = new QLabel(text_of(spec.label), holder);
  auto* unit = new QLabel(text_of(spec.unit), holder);
  unit->setForegroundRole(QPalette::PlaceholderText);
  // A long text goes on in the next line rather than making the panel wider.
  for (QLabel* text : {label, unit}) text->setWordWrap(true);
  QFont small = unit->font();
  small.setPointSizeF(small.pointSizeF() * 0.9);
  unit->setFont(small);
  auto* field = new Number_field(holder);
  field->set_bounds(spec.minimum, spec.maximum);
  if (is_whole) field->set_step(1);
  field->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("0.000000")));
  field->setAccessibleName(text_of(spec.label));
  auto* slider = new Calm_slider(Qt::Horizontal, holder);
  slider->setRange(0, Slider_scale::steps);
  slider->setPageStep(Slider_scale::steps / 20);
  slider->setAccessibleName(tr("Slider of %1").arg(text_of(spec.label)));
  const QString help = tip_of(spec);
  for (QWidget* part : {static_cast<QWidget*>(label), static_cast<QWidget*>(unit), static_cast<QWidget*>(field),
                        static_cast<QWidget*>(slider)})
    part->setToolTip(help);
  grid->addWidget(label, 0, 0);
  grid->addWidget(field, 0, 1, 2, 1, Qt::AlignTop);
  if (spec.unit.empty()) {
    unit->hide();
  } else {
    grid->addWidget(unit, 1, 0);
  }
  grid->addWidget(slider, 2, 0, 1, 2);
  grid->setColumnStretch(0, 1);

  const bool is_bounded = std::isfinite(spec.minimum) && std::isfinite(spec.maximum);
  const double lower = std::isfinite(spec.minimum) ? spec.minimum : 0;
  constexpr double modest_span = 10;
  const auto scale = std::make_shared<Slider_scale>(lower, is_bounded ? spec.maximum : lower + modest_span, start);
  connect(field, &Number_field::edited, this, [this, &spec, as_value](const std::optional<double>& number) {
    if (number) change(spec, as_value(*number), QStringLiteral("setting/%1").arg(gesture_));
  });
  connect(field, &Number_field::finished, this, [this] { ++gesture_; });
  connect(slider, &QSlider::sliderPressed, this, [this] { ++gesture_; });
  connect(slider, &QSlider::sliderReleased, this, [this] { ++gesture_; });
  connect(slider, &QSlider::valueChanged, this, [this, &spec, as_value, scale](int position) {
    change(spec, as_value(scale->value(position)), QStringLiteral("setting/%1").arg(gesture_));
  });
  const auto show = [field, slider, scale](double number) {
    field->show_value(number);
    const QSignalBlocker quiet(slider);
    if (!slider->isSliderDown()) slider->setValue(scale->position(number));
  };
  row.show = [show](const Setting_value& value) { show(number_of(value)); };
  row.animate = [this, &spec, scale] {
    Q_EMIT animate_requested(text_of(spec.id), scale->value(0), scale->value(Slider_scale::steps));
  };
  row.set_slider_maximum = [this, &spec, scale, show, start](double maximum) {
    scale->set_maximum(std::min(maximum, spec.maximum), start);
    show(number_of(registry_->value(settings_, spec.id)));
  };
  return holder;
}

void Settings_panel::set_settings(const Settings& settings) {
  settings_ = settings;
  for (auto& [id, row] : rows_) {
    row.show(registry_->value(settings, id));
    row.reset->setVisible(settings.find(id) != nullptr);
  }
  if (changed_only_) apply_filter();
}

void Settings_panel::set_filter(const QString& words, bool changed_only) {
  filter_ = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  changed_only_ = changed_only;
  apply_filter();
}

bool Settings_panel::is_listed(const std::string& id, const Row& row) const {
  if (changed_only_ && settings_.find(id) == nullptr) return false;
  return std::ranges::all_of(filter_,
                             [&](const QString& word) { return row.words.contains(word, Qt::CaseInsensitive); });
}

void Settings_panel::apply_filter() {
  std::set<QWidget*> headings;
  for (const auto& [id, row] : rows_) {
    const bool is_shown = is_listed(id, row);
    row.line->setVisible(is_shown);
    if (is_shown) headings.insert(row.heading);
  }
  for (const auto& [id, row] : rows_)
    if (row.heading) row.heading->setVisible(headings.contains(row.heading));
  nothing_->setText(changed_only_ && filter_.isEmpty() ? tr("All settings have their defaults.")
                                                       : tr("No setting has these words."));
  nothing_->setVisible(headings.empty());
}

std::vector<std::string> Settings_panel::listed() const {
  std::vector<std::string> ids;
  for (const Setting_spec& spec : registry_->settings())
    if (const auto it = rows_.find(spec.id); it != rows_.end() && is_listed(spec.id, it->second))
      ids.push_back(spec.id);
  return ids;
}

void Settings_panel::set_slider_maximum(const std::string& setting, double maximum) {
  const auto it = rows_.find(setting);
  if (it != rows_.end() && it->second.set_slider_maximum) it->second.set_slider_maximum(maximum);
}

void Settings_panel::focus_setting(const std::string& setting) {
  const auto it = rows_.find(setting);
  if (it == rows_.end()) return;
  QWidget* control = it->second.editor;
  if (control->focusPolicy() == Qt::NoFocus) {
    for (QWidget* part : control->findChildren<QWidget*>()) {
      if ((part->focusPolicy() & Qt::TabFocus) == 0) continue;
      control = part;
      break;
    }
  }
  ensureWidgetVisible(it->second.editor);
  control->setFocus(Qt::ShortcutFocusReason);
}

void Settings_panel::change(const Setting_spec& spec, const Setting_value& value, const QString& merge) {
  if (value == registry_->value(settings_, spec.id)) return;
  const bool is_default = value == spec.default_value;
  const Settings after = is_default ? settings_.without(spec.id) : settings_.with(spec.id, value);
  Q_EMIT edited(after, text_of(spec.label), merge);
}

}  // namespace mesecina

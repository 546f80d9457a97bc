// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/style_editor.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QStandardItemModel>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "layers/automatic_dot.h"
#include "layers/color_map.h"
#include "layers/histogram_widget.h"
#include "layers/number_field.h"
#include "layers/panel_paint.h"

namespace mesecina {

namespace {

/// Lets the wheel scroll the panel, not change what happens to be under the mouse.
class Wheel_guard : public QObject {
 public:
  using QObject::QObject;
  bool eventFilter(QObject* watched, QEvent* event) override {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return false;
    event->ignore();
    return true;
  }
};

void guard_wheel(QWidget* widget) {
  widget->setFocusPolicy(Qt::StrongFocus);
  widget->installEventFilter(new Wheel_guard(widget));
}

QString kind_label(Color_map::Kind kind) {
  switch (kind) {
    case Color_map::Kind::sequential:
      return Style_editor::tr("Sequential");
    case Color_map::Kind::diverging:
      return Style_editor::tr("Diverging");
    case Color_map::Kind::cyclic:
      return Style_editor::tr("Cyclic");
    case Color_map::Kind::categorical:
      return Style_editor::tr("Categories");
    case Color_map::Kind::historical:
      return Style_editor::tr("Historical");
  }
  return {};
}

void fill_with_color_maps(QComboBox* combo) {
  auto* model = new QStandardItemModel(combo);
  std::optional<Color_map::Kind> kind;
  for (const Color_map& map : color_maps()) {
    if (kind != map.kind()) {
      kind = map.kind();
      auto* heading = new QStandardItem(kind_label(map.kind()));
      heading->setFlags(Qt::NoItemFlags);
      model->appendRow(heading);
    }
    auto* item = new QStandardItem(color_map_icon(map.name(), false), QString::fromStdString(map.name()));
    item->setData(QString::fromStdString(map.name()), Qt::UserRole);
    model->appendRow(item);
  }
  combo->setModel(model);
}

QHBoxLayout* tight_row(QWidget* box) {
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(box->fontMetrics().height() / 4);
  return layout;
}

}  // namespace

Style_editor::Style_editor(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  const int em = fontMetrics().height();
  grid->setContentsMargins(em / 2, em / 4, em / 2, em / 4);
  grid->setHorizontalSpacing(em / 2);
  grid->setVerticalSpacing(em / 5);
  grid->setColumnStretch(1, 1);
  build_color_row(grid);
  build_space_row(grid);
  opacity_ = build_slider_row(grid, tr("Opacity"), tr("From 0 % (transparent) to 100 %"), 0, 100, 1,
                              QStringLiteral(" %"), 100, &Style::opacity);
  point_size_ = build_slider_row(grid, tr("Point size"), tr("Diameter of points in pixels"), 0, 30, 0.5,
                                 QStringLiteral(" px"), 1, &Style::point_size);
  line_width_ = build_slider_row(grid, tr("Line width"), tr("Width of lines and outlines in pixels"), 0, 12, 0.25,
                                 QStringLiteral(" px"), 1, &Style::line_width);
  build_value_rows(grid);
  build_cut_row(grid);
  build_histogram(grid);
  grid->setRowStretch(grid->rowCount(), 1);
  refresh();
}

QLabel* Style_editor::add_row(QGridLayout* grid, const QString& label, QWidget* field, const QString& tool_tip) {
  auto* name = new QLabel(label, this);
  name->setToolTip(tool_tip);
  name->setBuddy(field);
  field->setToolTip(tool_tip);
  const int row = grid->rowCount();
  grid->addWidget(name, row, 0);
  grid->addWidget(field, row, 1);
  return name;
}

void Style_editor::build_color_row(QGridLayout* grid) {
  auto* box = new QWidget(this);
  auto* layout = tight_row(box);
  color_button_ = new QPushButton(box);
  color_button_->setAccessibleName(tr("Colour"));
  const int em = fontMetrics().height();
  color_button_->setIconSize(QSize(em * 5 / 4, em * 3 / 4));
  const QString filled_tip =
      tr("Paint the inside of disks, triangles, polygons and closed curves of arcs; else only their outline");
  QCheckBox* filled =
      build_switch(box, tr("Filled"), filled_tip, &Style::filled, tr("Filling"), QStringLiteral("filled"));
  layout->addWidget(color_button_, 1);
  layout->addSpacing(em / 2);
  layout->addWidget(filled);
  add_row(grid, tr("Colour"), box, tr("Colour of all elements that no value gives one"))->setBuddy(color_button_);
  // The row has the tool tip of the colour.
  filled->setToolTip(filled_tip);
  connect(color_button_, &QPushButton::clicked, this, &Style_editor::open_color_dialog);
}

QCheckBox* Style_editor::build_switch(QWidget* parent, const QString& label, const QString& tool_tip,
                                      bool Style::*member, const QString& step, const QString& property) {
  auto* box = new QCheckBox(label, parent);
  box->setToolTip(tool_tip);
  connect(box, &QCheckBox::clicked, this, [this, box, member, step, property] {
    box->setTristate(false);
    end_gesture();
    const bool is_on = box->isChecked();
    edit([member, is_on](Style& style) { style.*member = is_on; }, step, property);
  });
  switches_.push_back({box, member});
  return box;
}

void Style_editor::build_space_row(QGridLayout* grid) {
  space_row_ = new QWidget(this);
  auto* layout = new QGridLayout(space_row_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(build_switch(space_row_, tr("Edges"), tr("Draw the edges of filled triangles and polygons"),
                                 &Style::edges, tr("Edges"), QStringLiteral("edges")),
                    0, 0);
  layout->addWidget(build_switch(space_row_, tr("Smooth"), tr("Shade as if surfaces were smooth"), &Style::smooth,
                                 tr("Shading"), QStringLiteral("smooth")),
                    0, 1);
  layout->addWidget(build_switch(space_row_, tr("Vertices"), tr("Draw points also where other elements end"),
                                 &Style::vertices, tr("Vertices"), QStringLiteral("vertices")),
                    1, 0);
  layout->addWidget(build_switch(space_row_, tr("Sliced"), tr("The cutting plane takes parts of this layer away"),
                                 &Style::sliced, tr("Slicing"), QStringLiteral("sliced")),
                    1, 1);
  space_label_ = add_row(grid, tr("In space"), space_row_, {});
}

Style_editor::Slider_row Style_editor::build_slider_row(QGridLayout* grid, const QString& label,
                                                        const QString& tool_tip, double lowest, double highest,
                                                        double unit, const QString& suffix, double scale,
                                                        double Style::*member) {
  Slider_row row;
  row.unit = unit;
  auto* box = new QWidget(this);
  auto* layout = tight_row(box);
  row.slider = new QSlider(Qt::Horizontal, box);
  row.slider->setRange(static_cast<int>(lowest / unit), static_cast<int>(highest / unit));
  row.slider->setAccessibleName(label);
  guard_wheel(row.slider);
  row.field = new Number_field(box);
  row.field->setAccessibleName(label);
  row.field->set_suffix(suffix);
  row.field->set_step(unit);
  row.field->set_bounds(lowest, scale == 100 ? highest : highest * 10);
  row.field->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("00.00 px")) + fontMetrics().height());
  layout->addWidget(row.slider, 1);
  layout->addWidget(row.field);
  add_row(grid, label, box, tool_tip)->setBuddy(row.slider);

  const auto set_to = [this, member, scale, label](double number) {
    edit([member, value = number / scale](Style& style) { style.*member = value; }, label, label);
  };
  connect(row.slider, &QSlider::sliderPressed, this, [this] { end_gesture(); });
  connect(row.slider, &QSlider::sliderReleased, this, [this] { end_gesture(); });
  connect(row.slider, &QSlider::valueChanged, this, [set_to, unit](int steps) { set_to(steps * unit); });
  connect(row.field, &Number_field::edited, this, [set_to](const std::optional<double>& number) {
    if (number) set_to(*number);
  });
  connect(row.field, &Number_field::finished, this, [this] { end_gesture(); });
  return row;
}

void Style_editor::build_value_rows(QGridLayout* grid) {
  value_combo_ = new QComboBox(this);
  value_combo_->setAccessibleName(tr("Colour by"));
  value_combo_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  value_combo_->setMinimumContentsLength(6);
  guard_wheel(value_combo_);
  add_row(grid, tr("Colour by"), value_combo_, tr("The values that choose the colour of each element"));
  connect(value_combo_, &QComboBox::activated, this, [this](int index) {
    end_gesture();
    const std::string value = value_combo_->itemData(index).toString().toStdString();
    edit(
        [value](Style& style) {
          if (style.value == value) return;
          style.value = value;
          // Limits are numbers of the old value and mean nothing for the new one.
          style.range_minimum = style.range_maximum = style.threshold_minimum = style.threshold_maximum = {};
        },
        tr("Values shown"), QStringLiteral("value"));
  });

  color_map_row_ = new QWidget(this);
  auto* layout = tight_row(color_map_row_);
  color_map_combo_ = new QComboBox(color_map_row_);
  fill_with_color_maps(color_map_combo_);
  const int em = fontMetrics().height();
  color_map_combo_->setIconSize(QSize(em * 4, em * 3 / 4));
  color_map_combo_->setAccessibleName(tr("Colour map"));
  color_map_combo_->setPlaceholderText(tr("mixed"));
  color_map_combo_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  color_map_combo_->setMinimumContentsLength(4);
  guard_wheel(color_map_combo_);
  reversed_button_ = new QToolButton(color_map_row_);
  reversed_button_->setCheckable(true);
  reversed_button_->setText(QStringLiteral("⇄"));
  reversed_button_->setToolTip(tr("Reverse the colour map"));
  reversed_button_->setAccessibleName(tr("Reversed"));
  layout->addWidget(color_map_combo_, 1);
  layout->addWidget(reversed_button_);
  color_map_label_ =
      add_row(grid, tr("Colour map"), color_map_row_, tr("Colours from the least value to the greatest"));
  color_map_label_->setBuddy(color_map_combo_);
  connect(color_map_combo_, &QComboBox::activated, this, [this](int index) {
    end_gesture();
    const std::string map = color_map_combo_->itemData(index).toString().toStdString();
    edit([map](Style& style) { style.color_map = map; }, tr("Colour map"), QStringLiteral("map"));
  });
  connect(reversed_button_, &QToolButton::clicked, this, [this](bool is_reversed) {
    end_gesture();
    edit([is_reversed](Style& style) { style.color_map_reversed = is_reversed; }, tr("Direction of the colour map"),
         QStringLiteral("reversed"));
  });

  range_ = build_limits_row(grid, tr("Range"), tr("The values at the two ends of the colour map"),
                            &Style::range_minimum, &Style::range_maximum);
  threshold_ = build_limits_row(grid, tr("Shown"), tr("Elements with values outside of these limits are not drawn"),
                                &Style::threshold_minimum, &Style::threshold_maximum);
}

Style_editor::Limits_row Style_editor::build_limits_row(QGridLayout* grid, const QString& label,
                                                        const QString& tool_tip, Member minimum, Member maximum) {
  Limits_row row;
  row.box = new QWidget(this);
  auto* layout = tight_row(row.box);
  layout->setSpacing(0);
  const auto add_end = [&](Number_field*& field, Automatic_dot*& dot, Member member, const QString& name) {
    field = new Number_field(row.box);
    field->set_optional(true);
    field->setAccessibleName(name);
    dot = new Automatic_dot(row.box);
    layout->addWidget(field, 1);
    layout->addWidget(dot);
    connect(field, &Number_field::edited, this,
            [this, member](const std::optional<double>& value) { edit_limit(member, value); });
    connect(field, &Number_field::finished, this, [this] { end_gesture(); });
    connect(dot, &Automatic_dot::clicked, this, [this, member] {
      end_gesture();
      edit_limit(member, std::nullopt);
    });
  };
  add_end(row.minimum, row.minimum_dot, minimum, tr("%1: minimum").arg(label));
  layout->addWidget(new QLabel(QStringLiteral("–"), row.box));
  layout->addSpacing(fontMetrics().height() / 4);
  add_end(row.maximum, row.maximum_dot, maximum, tr("%1: maximum").arg(label));
  row.label = add_row(grid, label, row.box, tool_tip);
  row.label->setBuddy(row.minimum);
  row.minimum->setToolTip(tool_tip);
  row.maximum->setToolTip(tool_tip);
  return row;
}

void Style_editor::build_cut_row(QGridLayout* grid) {
  cut_row_ = new QWidget(this);
  auto* layout = tight_row(cut_row_);
  layout->setSpacing(0);
  cut_field_ = new Number_field(cut_row_);
  cut_field_->setAccessibleName(tr("Limit"));
  cut_field_->setToolTip(tr("Elements beyond it are no part of the layer"));
  cut_dot_ = new Automatic_dot(cut_row_);
  layout->addWidget(cut_field_, 1);
  layout->addWidget(cut_dot_);
  cut_label_ = add_row(grid, tr("Limit"), cut_row_, {});
  cut_label_->setBuddy(cut_field_);
  connect(cut_field_, &Number_field::edited, this, &Style_editor::edit_cut);
  connect(cut_field_, &Number_field::finished, this, [this] { end_gesture(); });
  connect(cut_dot_, &Automatic_dot::clicked, this, [this] {
    end_gesture();
    edit_cut(std::nullopt);
  });
}

void Style_editor::build_histogram(QGridLayout* grid) {
  histogram_ = new Histogram_widget(this);
  grid->addWidget(histogram_, grid->rowCount(), 0, 1, 2);
  connect(histogram_, &Histogram_widget::gesture_started, this, [this] { end_gesture(); });
  connect(histogram_, &Histogram_widget::handle_moved, this,
          [this](Histogram_widget::Handle handle, const std::optional<double>& value) {
            const bool is_minimum = handle == Histogram_widget::Handle::minimum;
            if (!cut_row_->isHidden()) {
              edit_cut(value);
            } else {
              edit_limit(is_minimum ? &Style::threshold_minimum : &Style::threshold_maximum, value);
            }
          });
  connect(histogram_, &Histogram_widget::reset_requested, this, [this] {
    edit([](Style& style) { style.threshold_minimum = style.threshold_maximum = {}; }, tr("Limits"),
         QStringLiteral("thresholds"));
  });
}

void Style_editor::set_subjects(std::vector<Subject> subjects) {
  const bool has_same_layers = std::equal(subjects.begin(), subjects.end(), subjects_.begin(), subjects_.end(),
                                          [](const Subject& a, const Subject& b) { return a.layer.id == b.layer.id; });
  if (!has_same_layers) end_gesture();
  subjects_ = std::move(subjects);
  if (subjects_.empty() && color_dialog_) color_dialog_->hide();
  if (isVisible()) {
    refresh();
  } else {
    is_outdated_ = true;
  }
}

void Style_editor::showEvent(QShowEvent* event) {
  if (std::exchange(is_outdated_, false)) refresh();
  QWidget::showEvent(event);
}

void Style_editor::hideEvent(QHideEvent* event) {
  if (color_dialog_) color_dialog_->hide();
  QWidget::hideEvent(event);
}

void Style_editor::choose_color() {
  if (subjects_.empty()) return;
  if (is_outdated_) {
    is_outdated_ = false;
    refresh();
  }
  const bool is_by_value = std::all_of(subjects_.begin(), subjects_.end(),
                                       [](const Subject& subject) { return !subject.layer.style.value.empty(); });
  if (is_by_value) {
    color_map_combo_->setFocus();
    color_map_combo_->showPopup();
  } else {
    open_color_dialog();
  }
}

void Style_editor::open_color_dialog() {
  if (!color_dialog_) {
    color_dialog_ = new QColorDialog(this);
    color_dialog_->setOptions(QColorDialog::NoButtons | QColorDialog::DontUseNativeDialog);
    connect(color_dialog_, &QColorDialog::currentColorChanged, this, [this](const QColor& chosen) {
      edit([color = from_qcolor(chosen)](Style& style) { style.color = color; }, tr("Colour"), QStringLiteral("color"));
    });
  }
  end_gesture();
  refresh_color();
  color_dialog_->show();
  color_dialog_->raise();
}

void Style_editor::focus_first() { color_button_->setFocus(Qt::TabFocusReason); }

QString Style_editor::merge_key(const QString& property) const {
  return QStringLiteral("style/%1/%2").arg(property).arg(gesture_);
}

void Style_editor::edit(const Change& change, const QString& what, const QString& property) {
  if (!subjects_.empty()) Q_EMIT edited(change, what, merge_key(property));
}

void Style_editor::edit_limit(Member member, const std::optional<double>& value) {
  const bool is_range = member == &Style::range_minimum || member == &Style::range_maximum;
  edit([member, value](Style& style) { style.*member = value; }, is_range ? tr("Range of the colours") : tr("Limits"),
       is_range ? QStringLiteral("range") : QStringLiteral("thresholds"));
}

void Style_editor::edit_cut(const std::optional<double>& value) {
  if (subjects_.empty()) return;
  const QString& setting = subjects_.front().cut_setting;
  Q_EMIT cut_edited(setting, value, QStringLiteral("setting/%1/%2").arg(setting).arg(gesture_));
}

}  // namespace mesecina

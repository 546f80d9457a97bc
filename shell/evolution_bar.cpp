// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/evolution_bar.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QEvent>
#include <QResizeEvent>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>

#include "core/help_text.h"
#include "shell/step_slider.h"
#include "shell/transport_icons.h"

namespace mesecina {

namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20;
constexpr int largest_budget = 65536;

QString text_of(const std::string& text) { return QString::fromStdString(text); }

std::size_t place_of(int value) { return static_cast<std::size_t>(std::max(0, value)); }

/// Only as large as its text of so many digits.
void fit_width(QSpinBox& field, const QString& widest) {
  const int arrows_and_frame = 2 * field.fontMetrics().height();
  field.setFixedWidth(field.fontMetrics().horizontalAdvance(widest) + arrows_and_frame);
}

}  // namespace

Evolution_bar::Evolution_bar(Evolution_control& control, Computation& computation, const Actions& actions,
                             QWidget* parent)
    : QWidget(parent), control_(control), computation_(computation) {
  setObjectName(QStringLiteral("evolution-bar"));
  const int em = fontMetrics().height();
  rows_ = new QBoxLayout(QBoxLayout::TopToBottom, this);
  rows_->setContentsMargins(em / 2, em / 4, em / 2, em / 4);
  rows_->setSpacing(em / 4);
  transport_ = make_transport(actions);
  options_ = make_options(actions);
  rows_->addWidget(transport_, 1);
  rows_->addWidget(options_);
  for (const char* id : {"evolution-play", "evolution-play-backward"}) addAction(actions[QLatin1String(id)]);
  connect(&control_, &Evolution_control::changed, this, &Evolution_bar::show_control);
  connect(&computation_, &Computation::kept_bytes_changed, this, &Evolution_bar::show_memory);
  show_control();
  show_memory();
}

QToolButton* Evolution_bar::make_button(QAction* action, QWidget* parent) const {
  auto* button = new QToolButton(parent);
  button->setDefaultAction(action);
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::TabFocus);
  button->setAccessibleName(action->text().remove(QLatin1Char('&')));
  return button;
}

QSpinBox* Evolution_bar::make_field(int minimum, int maximum, const QString& name, const QString& tip,
                                    QWidget* parent) const {
  auto* field = new QSpinBox(parent);
  field->setRange(minimum, maximum);
  field->setKeyboardTracking(false);
  field->setAccessibleName(name);
  field->setToolTip(tip);
  return field;
}

QWidget* Evolution_bar::make_transport(const Actions& actions) {
  const int em = fontMetrics().height();
  auto* part = new QWidget(this);
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(em / 4);

  evolutions_ = new QComboBox(part);
  evolutions_->setAccessibleName(tr("Evolution"));
  evolutions_->setFocusPolicy(Qt::TabFocus);
  for (const Evolution_spec& spec : control_.registry().evolutions()) {
    evolutions_->addItem(text_of(spec.label), text_of(spec.id));
  }
  if (evolutions_->count() == 0) {
    evolutions_->addItem(tr("No evolutions"));
    evolutions_->setEnabled(false);
  }
  connect(evolutions_, &QComboBox::activated, this,
          [this](int row_chosen) { control_.choose(evolutions_->itemData(row_chosen).toString().toStdString()); });
  row->addWidget(evolutions_);
  row->addWidget(make_button(actions[QStringLiteral("evolution-settings")], part));
  row->addSpacing(em / 2);
  for (const char* id : {"evolution-first", "evolution-back", "evolution-play-backward", "evolution-play",
                         "evolution-forward", "evolution-last"})
    row->addWidget(make_button(actions[QLatin1String(id)], part));

  slider_ = new Step_slider(part);
  slider_->setFocusPolicy(Qt::TabFocus);
  slider_->setAccessibleName(tr("Step that is shown"));
  slider_->setToolTip(tr("Step that is shown; drag to go through them"));
  constexpr int least_width_in_ems = 8;
  slider_->setMinimumWidth(least_width_in_ems * em);
  slider_->setMinimumHeight(em * 3 / 2);
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { control_.go_to(place_of(value)); });
  row->addWidget(slider_, 1);

  position_ =
      make_field(0, 0, tr("Number of the step"), tr("Number of the step that is shown; type one to go there"), part);
  fit_width(*position_, QStringLiteral("0000 of 0000"));
  connect(position_, &QSpinBox::valueChanged, this, [this](int value) { control_.go_to(place_of(value)); });
  row->addWidget(position_);
  return part;
}

QWidget* Evolution_bar::make_options(const Actions& actions) {
  const int em = fontMetrics().height();
  auto* part = new QWidget(this);
  auto* row = new QHBoxLayout(part);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(em / 4);

  constexpr int most_steps = 10000;
  ahead_ = make_field(1, most_steps, tr("Steps to make"), tr("How many steps are made at once"), part);
  ahead_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  fit_width(*ahead_, QStringLiteral("00000"));
  connect(ahead_, &QSpinBox::valueChanged, &control_, &Evolution_control::set_steps_ahead);
  QToolButton* make = make_button(actions[QStringLiteral("evolution-make-steps")], part);
  make->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  row->addWidget(ahead_);
  row->addWidget(make);
  row->addSpacing(em / 2);

  repeat_ = new QComboBox(part);
  repeat_->setAccessibleName(tr("What comes after the last step"));
  repeat_->setFocusPolicy(Qt::TabFocus);
  // In the order of Evolution_control::Repeat.
  for (const char* id : {"evolution-once", "evolution-wrap", "evolution-ping-pong"}) {
    QAction* action = actions[QLatin1String(id)];
    repeat_->addItem(action->text().remove(QLatin1Char('&')));
    repeat_->setItemData(repeat_->count() - 1, action->statusTip(), Qt::ToolTipRole);
    connect(repeat_, &QComboBox::activated, action, [action, row_of_it = repeat_->count() - 1](int row_chosen) {
      if (row_chosen == row_of_it) action->trigger();
    });
  }
  row->addWidget(repeat_);
  range_begin_ = make_field(0, 0, tr("First step that is repeated"), tr("First step that is repeated"), part);
  range_begin_->setPrefix(tr("from "));
  fit_width(*range_begin_, QStringLiteral("from 0000"));
  range_end_ = make_field(0, 0, tr("Last step that is repeated"), tr("Last step that is repeated"), part);
  range_end_->setPrefix(tr("to "));
  fit_width(*range_end_, QStringLiteral("to 0000"));
  for (QSpinBox* field : {range_begin_, range_end_}) {
    connect(field, &QSpinBox::valueChanged, this,
            [this] { control_.set_range(place_of(range_begin_->value()), place_of(range_end_->value())); });
    row->addWidget(field);
  }

  constexpr int fastest = 100;
  speed_ = make_field(1, fastest, tr("Speed"), tr("Steps played in a second, at most"), part);
  speed_->setSuffix(tr(" steps/s"));
  fit_width(*speed_, QStringLiteral("000 steps/s"));
  connect(speed_, &QSpinBox::valueChanged, &control_, &Evolution_control::set_steps_per_second);
  row->addWidget(speed_);
  row->addStretch(1);

  memory_ = make_field(1, largest_budget, tr("Memory for pictures of steps, in megabytes"),
                       tr("Memory that pictures of seen steps take, and may take; those not seen for longest go first"),
                       part);
  memory_->setSuffix(tr(" MB"));
  memory_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  fit_width(*memory_, QStringLiteral("0000 of 00000 MB"));
  connect(memory_, &QSpinBox::valueChanged, this, [this](int megabytes) {
    computation_.set_kept_bytes_budget(static_cast<std::size_t>(megabytes) * megabyte);
    Q_EMIT budget_edited(megabytes);
  });
  row->addWidget(memory_);
  return part;
}

void Evolution_bar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int em = fontMetrics().height();
  // The slider is worth a row of its own until it has much more than its least width beside the rest.
  const int wanted = transport_->sizeHint().width() + options_->sizeHint().width() + 12 * em;
  rows_->setDirection(event->size().width() >= wanted ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void Evolution_bar::show_fitness() {
  const auto& all = control_.registry().evolutions();
  for (int row = 0; row < static_cast<int>(all.size()); ++row) {
    const Evolution_spec& spec = all[static_cast<std::size_t>(row)];
    const QString reason = control_.why_unfit(spec.id);
    const QString help = text_of(with_labels(spec.help, control_.registry()));
    const QString why = text_of(with_labels(reason.toStdString(), control_.registry()));
    const QString tip =
        reason.isEmpty() ? help : tr("Not for the present data: %1.").arg(why) + QStringLiteral("\n\n") + help;
    const QVariant dim = reason.isEmpty() ? QVariant() : QVariant(palette().brush(QPalette::PlaceholderText));
    if (evolutions_->itemData(row, Qt::ToolTipRole).toString() != tip)
      evolutions_->setItemData(row, tip, Qt::ToolTipRole);
    if (evolutions_->itemData(row, Qt::ForegroundRole) != dim) evolutions_->setItemData(row, dim, Qt::ForegroundRole);
  }
}

void Evolution_bar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && evolutions_) show_fitness();
}

void Evolution_bar::show_control() {
  show_fitness();
  const int chosen = evolutions_->findData(text_of(control_.chosen()));
  if (chosen >= 0) {
    evolutions_->setCurrentIndex(chosen);
    evolutions_->setToolTip(evolutions_->itemData(chosen, Qt::ToolTipRole).toString());
  }
  const auto show = [](QSpinBox& field, int value) {
    const QSignalBlocker quiet(field);
    field.setValue(value);
  };
  show(*ahead_, control_.steps_ahead());
  show(*speed_, static_cast<int>(control_.steps_per_second()));
  const bool is_repeated = control_.repeat() != Evolution_control::Repeat::once;
  repeat_->setCurrentIndex(static_cast<int>(control_.repeat()));
  repeat_->setToolTip(repeat_->currentData(Qt::ToolTipRole).toString());
  range_begin_->setVisible(is_repeated);
  range_end_->setVisible(is_repeated);
  show_track();
}

void Evolution_bar::show_track() {
  const int count = static_cast<int>(control_.document().step_count());
  const int position = static_cast<int>(control_.document().position());
  const int begin = static_cast<int>(control_.range_begin());
  const int end = static_cast<int>(control_.range_end());
  const QSignalBlocker quiet[] = {QSignalBlocker(slider_), QSignalBlocker(position_), QSignalBlocker(range_begin_),
                                  QSignalBlocker(range_end_)};
  slider_->setRange(0, count);
  constexpr int pages = 10;
  slider_->setPageStep(std::max(1, count / pages));
  if (!slider_->isSliderDown()) slider_->setValue(position);
  slider_->set_marked_range(begin, control_.repeat() == Evolution_control::Repeat::once ? begin : end);
  slider_->setEnabled(count > 0);
  position_->setRange(0, count);
  position_->setSuffix(tr(" of %1").arg(count));
  position_->setValue(position);
  position_->setEnabled(count > 0);
  range_begin_->setRange(0, count);
  range_begin_->setValue(begin);
  range_end_->setRange(0, count);
  range_end_->setValue(end);
}

void Evolution_bar::show_memory() {
  const QSignalBlocker quiet(memory_);
  memory_->setPrefix(tr("%1 of ").arg((computation_.kept_bytes() + megabyte - 1) / megabyte));
  memory_->setValue(static_cast<int>(computation_.kept_bytes_budget() / megabyte));
}

}  // namespace mesecina

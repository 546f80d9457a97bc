// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/animation_popover.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <memory>
#include <stdexcept>
#include <utility>

#include "layers/number_field.h"
#include "shell/popover_fields.h"

namespace mesecina {

namespace {

QString tr(const char* text) { return QObject::tr(text); }

/// The controls, alive as long as the popover.
struct Controls {
  Sweep sweep;
  double frames_per_second = 30;
  Number_field* from = nullptr;
  Number_field* to = nullptr;
  QSpinBox* steps = nullptr;
  QComboBox* easing = nullptr;
  QCheckBox* ping_pong = nullptr;
  QCheckBox* along = nullptr;  ///< null where nothing else has moved
  std::vector<Sweep> others;
  QLabel* length = nullptr;
  QPushButton* play = nullptr;
  QPushButton* record = nullptr;

  void read() {
    sweep.from = from->value().value_or(sweep.from);
    sweep.to = to->value().value_or(sweep.to);
    sweep.steps = steps->value();
    sweep.easing = easing->currentIndex() == 1 ? Sweep::Easing::smooth : Sweep::Easing::linear;
    sweep.is_ping_pong = ping_pong->isChecked();
  }
  std::vector<Sweep> sweeps() const {
    std::vector<Sweep> all = along && along->isChecked() ? others : std::vector<Sweep>();
    all.push_back(sweep);
    return all;
  }
  void show_length() const {
    const int frames = frames_of(sweeps());
    length->setText(tr("%1 frames, %2 s at %3 per second")
                        .arg(frames)
                        .arg(rounded_to(frames / frames_per_second, 3))
                        .arg(frames_per_second));
  }
};

}  // namespace

Popover* open_animation_popover(const Registry& registry, const Sweep& start, const std::vector<Sweep>& animation,
                                double frames_per_second, Frame_player& player, QWidget* over,
                                Animation_popover_calls calls) {
  const Setting_spec* spec = registry.find_setting(start.setting);
  if (!spec) return nullptr;
  const QString label = QString::fromStdString(spec->label);
  auto* popover = new Popover(tr("Animate %1").arg(label), over);
  const auto controls = std::make_shared<Controls>();
  controls->sweep = start;
  controls->frames_per_second = frames_per_second;
  const bool is_whole = std::holds_alternative<std::int64_t>(spec->default_value);
  const auto make_end = [&](double value, const QString& name, const QString& tip) {
    auto* field = new Number_field(popover);
    field->set_bounds(spec->minimum, spec->maximum);
    if (is_whole) field->set_step(1);
    field->show_value(value);
    field->setAccessibleName(name);
    field->setToolTip(tip);
    return field;
  };
  controls->from = make_end(start.from, tr("From"), tr("%1 in the first frame").arg(label));
  controls->to = make_end(start.to, tr("To"), tr("%1 after all steps").arg(label));
  controls->steps = make_count_field(1, most_sweep_steps, start.steps, popover, tr("Steps"));
  controls->steps->setToolTip(tr("Frames on the way, both ends included; each waits until it is computed"));
  controls->easing = new QComboBox(popover);
  controls->easing->addItems({tr("Evenly"), tr("Start and end slowly")});
  controls->easing->setCurrentIndex(start.easing == Sweep::Easing::smooth ? 1 : 0);
  controls->easing->setAccessibleName(tr("Easing"));
  controls->ping_pong = new QCheckBox(tr("There and back"), popover);
  controls->ping_pong->setChecked(start.is_ping_pong);
  controls->length = new QLabel(popover);
  controls->length->setForegroundRole(QPalette::PlaceholderText);
  controls->length->setObjectName(QStringLiteral("animation-length"));
  controls->play = new QPushButton(tr("Play"), popover);
  controls->play->setObjectName(QStringLiteral("animation-play"));
  controls->play->setToolTip(tr("Play it in the window; all of it is one step of undo"));
  controls->record = new QPushButton(tr("Record…"), popover);
  controls->record->setObjectName(QStringLiteral("animation-record"));
  controls->record->setToolTip(tr("Choose file and size, then record it"));
  popover->form()->addRow(tr("From"), controls->from);
  popover->form()->addRow(tr("To"), controls->to);
  popover->form()->addRow(tr("Steps"), controls->steps);
  popover->form()->addRow(tr("Moves"), controls->easing);
  popover->form()->addRow(controls->ping_pong);
  QStringList labels;
  for (const Sweep& other : animation) {
    const Setting_spec* moved = registry.find_setting(other.setting);
    if (!moved || other.setting == start.setting) continue;
    controls->others.push_back(other);
    labels << QString::fromStdString(moved->label);
  }
  if (!controls->others.empty()) {
    controls->along = new QCheckBox(tr("Along with %1").arg(labels.join(tr(", "))), popover);
    controls->along->setObjectName(QStringLiteral("animation-along"));
    controls->along->setToolTip(
        tr("Both move in the same frames, each as it was told; the shorter one waits at its end"));
    controls->along->setChecked(controls->others.size() < animation.size());
    popover->form()->addRow(controls->along);
  }
  popover->form()->addRow(controls->length);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(controls->play);
  buttons->addWidget(controls->record);
  popover->column()->addLayout(buttons);
  popover->set_default(controls->play);

  const auto read = [controls, remember = std::move(calls.remember)] {
    controls->read();
    controls->show_length();
    if (remember) remember(controls->sweeps());
  };
  QObject::connect(controls->from, &Number_field::edited, popover, read);
  QObject::connect(controls->to, &Number_field::edited, popover, read);
  QObject::connect(controls->steps, &QSpinBox::valueChanged, popover, read);
  QObject::connect(controls->easing, &QComboBox::currentIndexChanged, popover, read);
  QObject::connect(controls->ping_pong, &QCheckBox::toggled, popover, read);
  if (controls->along) QObject::connect(controls->along, &QCheckBox::toggled, popover, read);
  const auto show_state = [controls, &player] {
    controls->play->setText(player.is_playing() ? tr("Stop (%1 of %2)").arg(player.frame() + 1).arg(player.count())
                                                : tr("Play"));
    controls->record->setEnabled(!player.is_playing());
  };
  QObject::connect(&player, &Frame_player::changed, popover, show_state);
  QObject::connect(controls->play, &QPushButton::clicked, popover, [controls, &player, play = std::move(calls.play)] {
    if (player.is_playing()) {
      player.stop();
    } else {
      play(controls->sweeps());
    }
  });
  QObject::connect(controls->record, &QPushButton::clicked, popover,
                   [controls, record = std::move(calls.record)] { record(controls->sweeps()); });
  controls->show_length();
  show_state();
  // So that the plate does not change its size while it plays.
  controls->play->setMinimumWidth(
      popover->fontMetrics().horizontalAdvance(tr("Stop (%1 of %2)").arg(99999).arg(99999)) +
      popover->fontMetrics().height());
  popover->open();
  return popover;
}

}  // namespace mesecina

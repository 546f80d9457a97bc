// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/record_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include "layers/number_field.h"
#include "shell/popover_fields.h"

namespace mesecina {

Record_panel::Record_panel(int dimension, QWidget* parent)
    : QWidget(parent),
      source_(new QComboBox(this)),
      about_(new QLabel(this)),
      turn_frames_(nullptr),
      width_(nullptr),
      height_(nullptr),
      rate_(new Number_field(this)),
      is_transparent_(new QCheckBox(tr("Transparent background"), this)),
      file_(new QLineEdit(this)),
      record_(new QPushButton(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      status_(new QLabel(this)) {
  const int em = fontMetrics().height();
  source_->addItem(tr("All that changes"), QVariant::fromValue(static_cast<int>(Source::changes)));
  source_->addItem(tr("An animated setting"), QVariant::fromValue(static_cast<int>(Source::animation)));
  source_->addItem(tr("The steps of the evolution"), QVariant::fromValue(static_cast<int>(Source::evolution)));
  if (dimension == 3) source_->addItem(tr("A turntable"), QVariant::fromValue(static_cast<int>(Source::turntable)));
  source_->setObjectName(QStringLiteral("record-source"));
  source_->setAccessibleName(tr("What is recorded"));
  source_->setToolTip(tr("What makes a frame of the film"));
  about_->setWordWrap(true);
  about_->setForegroundRole(QPalette::PlaceholderText);
  constexpr int most_frames = 100'000;
  constexpr int usual_frames = 120;
  turn_frames_ = make_count_field(2, most_frames, usual_frames, this, tr("Frames of a turn"));
  turn_frames_->setToolTip(tr("Frames of a whole turn of the camera"));
  turn_frames_->setSuffix(tr(" frames"));
  constexpr double least_rate = 0.01;
  constexpr double most_rate = 240;
  constexpr double usual_rate = 30;
  rate_->set_bounds(least_rate, most_rate);
  rate_->set_step(1);
  rate_->show_value(usual_rate);
  rate_->setAccessibleName(tr("Frames per second"));
  rate_->setToolTip(tr("Frames that are shown in a second of the film"));
  is_transparent_->setToolTip(tr("Not in MP4, which has no transparency"));
  record_->setObjectName(QStringLiteral("record-start"));
  cancel_->setObjectName(QStringLiteral("record-cancel"));
  cancel_->setToolTip(tr("Stop, and keep nothing of this film"));
  status_->setObjectName(QStringLiteral("record-status"));
  status_->setWordWrap(true);
  status_->setTextInteractionFlags(Qt::TextSelectableByMouse);

  auto* form = new QFormLayout;
  form->setHorizontalSpacing(em / 2);
  form->setVerticalSpacing(em / 3);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->addRow(tr("What"), source_);
  form->addRow(about_);
  form->addRow(tr("Turn"), turn_frames_);
  form->addRow(tr("Size"), make_size_row());
  form->addRow(tr("Per second"), rate_);
  form->addRow(is_transparent_);
  form->addRow(tr("File"), make_file_row());
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(record_, 1);
  buttons->addWidget(cancel_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(em / 2, em / 2, em / 2, em / 2);
  column->setSpacing(em / 2);
  column->addLayout(form);
  column->addLayout(buttons);
  column->addWidget(status_);
  column->addStretch(1);

  connect(source_, &QComboBox::currentIndexChanged, this, [this] {
    show_source();
    Q_EMIT edited();
  });
  for (QSpinBox* box : {turn_frames_, width_, height_})
    connect(box, &QSpinBox::valueChanged, this, [this] { Q_EMIT edited(); });
  connect(rate_, &Number_field::edited, this, [this] { Q_EMIT edited(); });
  connect(is_transparent_, &QCheckBox::toggled, this, [this] { Q_EMIT edited(); });
  connect(file_, &QLineEdit::textChanged, this, [this] { Q_EMIT edited(); });
  connect(record_, &QPushButton::clicked, this, [this] {
    if (state_.is_recording) {
      Q_EMIT stop_requested();
    } else {
      Q_EMIT record_requested();
    }
  });
  connect(cancel_, &QPushButton::clicked, this, &Record_panel::cancel_requested);
  show_source();
  show_state({});
}

QWidget* Record_panel::make_size_row() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(fontMetrics().height() / 4);
  constexpr int most_pixels = 16384;
  constexpr int usual_width = 1280;
  constexpr int usual_height = 720;
  width_ = make_count_field(1, most_pixels, usual_width, row, tr("Width in pixels"));
  height_ = make_count_field(1, most_pixels, usual_height, row, tr("Height in pixels"));
  for (QSpinBox* box : {width_, height_}) {
    box->setButtonSymbols(QSpinBox::NoButtons);
    box->setToolTip(tr("Pixels of the film; MP4 and WebM get a row or column of background more where it is odd"));
  }
  auto* as_window = new QToolButton(row);
  as_window->setText(tr("As seen"));
  as_window->setToolTip(tr("As large as the picture in the window"));
  connect(as_window, &QToolButton::clicked, this, &Record_panel::window_size_requested);
  layout->addWidget(width_, 1);
  layout->addWidget(new QLabel(QStringLiteral("×"), row));
  layout->addWidget(height_, 1);
  layout->addWidget(as_window);
  return row;
}

QWidget* Record_panel::make_file_row() {
  auto* row = new QWidget(this);
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(fontMetrics().height() / 4);
  file_->setAccessibleName(tr("File of the film"));
  file_->setPlaceholderText(tr("film.mp4"));
  file_->setToolTip(tr("MP4, WebM or GIF by its name, or numbered pictures: frame-%05d.png"));
  auto* choose = new QToolButton(row);
  choose->setText(tr("…"));
  choose->setToolTip(tr("Choose the file"));
  choose->setAccessibleName(tr("Choose the file"));
  connect(choose, &QToolButton::clicked, this, &Record_panel::file_requested);
  layout->addWidget(file_, 1);
  layout->addWidget(choose);
  return row;
}

Record_panel::Source Record_panel::source() const { return static_cast<Source>(source_->currentData().toInt()); }

void Record_panel::set_source(Source source) {
  const int index = source_->findData(static_cast<int>(source));
  if (index >= 0) source_->setCurrentIndex(index);
}

int Record_panel::turntable_frames() const { return turn_frames_->value(); }

void Record_panel::set_turntable_frames(int frames) { turn_frames_->setValue(frames); }

Film_request Record_panel::request() const {
  Film_request request;
  request.file = file_->text().trimmed().toStdString();
  request.width = width_->value();
  request.height = height_->value();
  request.frames_per_second = rate_->value().value_or(request.frames_per_second);
  request.is_transparent = is_transparent_->isChecked();
  return request;
}

void Record_panel::set_file(const QString& file) { file_->setText(file); }

void Record_panel::set_size(const QSize& size) {
  width_->setValue(size.width());
  height_->setValue(size.height());
}

void Record_panel::set_frames_per_second(double frames) { rate_->show_value(frames); }

void Record_panel::set_transparent(bool is_transparent) { is_transparent_->setChecked(is_transparent); }

void Record_panel::set_animation_text(const QString& text) {
  animation_ = text;
  show_source();
}

void Record_panel::set_evolution_steps(int steps) {
  if (evolution_steps_ == steps) return;
  evolution_steps_ = steps;
  show_source();
}

void Record_panel::show_source() {
  const Source now = source();
  bool is_ready = true;
  switch (now) {
    case Source::changes:
      about_->setText(tr("A frame after each finished change: of data, settings, looks, steps and view."));
      break;
    case Source::animation:
      is_ready = !animation_.isEmpty();
      about_->setText(is_ready ? animation_ : tr("Choose a number in the settings with its button ▶ first."));
      break;
    case Source::evolution:
      is_ready = evolution_steps_ > 0;
      about_->setText(is_ready ? tr("%1 frames, from the first place to the last.").arg(evolution_steps_ + 1)
                               : tr("Make some steps of an evolution first."));
      break;
    case Source::turntable:
      about_->setText(tr("The camera goes round once, at the elevation of the view."));
      break;
  }
  auto* form = static_cast<QFormLayout*>(layout()->itemAt(0)->layout());
  turn_frames_->setVisible(now == Source::turntable);
  form->labelForField(turn_frames_)->setVisible(now == Source::turntable);
  record_->setEnabled(state_.is_recording ? !state_.is_finishing : is_ready);
}

void Record_panel::show_state(const State& state) {
  const bool was_recording = state_.is_recording;
  state_ = state;
  record_->setText(state.is_recording ? tr("■ Stop") : tr("● Record"));
  record_->setToolTip(state.is_recording ? tr("End the film here, and keep it") : tr("Begin a film"));
  cancel_->setEnabled(state.is_recording);
  for (QWidget* part : findChildren<QWidget*>()) {
    const bool is_button = part == record_ || part == cancel_;
    const bool is_text = qobject_cast<QLabel*>(part) != nullptr;
    if (part->parentWidget() == this && !is_button && !is_text) part->setEnabled(!state.is_recording);
  }
  if (state.is_recording) {
    QString text = state.expected > 0 ? tr("Frame %1 of %2").arg(state.frames).arg(state.expected)
                                      : tr("Frame %1").arg(state.frames);
    if (state.is_finishing && state.waiting == 0) {
      text = tr("Completing the film…");
    } else if (state.waiting > 0) {
      text = tr("%1, %2 to be encoded").arg(text).arg(state.waiting);
    }
    status_->setText(text);
  } else if (was_recording) {
    status_->clear();
  }
  show_source();
}

void Record_panel::show_note(const QString& note) { status_->setText(note); }

}  // namespace mesecina

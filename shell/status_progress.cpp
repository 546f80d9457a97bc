// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/status_progress.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <chrono>
#include <cmath>

namespace mesecina {

namespace {
constexpr std::chrono::milliseconds delay_before_showing(330);
constexpr int bar_steps = 1000;
}  // namespace

Status_progress::Status_progress(QWidget* parent)
    : QWidget(parent), text_(new QLabel(this)), bar_(new QProgressBar(this)) {
  const int em = fontMetrics().height();
  auto* cancel = new QToolButton(this);
  cancel->setText(tr("Cancel"));
  cancel->setToolTip(tr("Stop this (Esc); what was shown before stays"));
  cancel->setAutoRaise(true);
  cancel->setFocusPolicy(Qt::TabFocus);
  bar_->setTextVisible(false);
  bar_->setFixedSize(em * 7, em * 2 / 3);
  bar_->setAccessibleName(tr("Progress"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(em / 3);
  row->addWidget(text_);
  row->addWidget(bar_);
  row->addWidget(cancel);
  delay_.setSingleShot(true);
  connect(&delay_, &QTimer::timeout, this, &QWidget::show);
  connect(cancel, &QToolButton::clicked, this, &Status_progress::cancel_requested);
  hide();
}

void Status_progress::begin(const QString& text) {
  report(text, -1);
  is_running_ = true;
  if (isVisible()) return;
  delay_.start(delay_before_showing);
}

void Status_progress::report(const QString& text, double fraction) {
  if (text != stage_ || !stage_time_.isValid()) {
    stage_ = text;
    stage_time_.start();
  }
  constexpr double told_from = 0.05;
  constexpr double milliseconds = 1000;
  const double seconds = static_cast<double>(stage_time_.elapsed()) / milliseconds;
  const bool is_told = seconds >= 1 && fraction >= told_from;
  text_->setText(is_told ? tr("%1, %2 s left").arg(text).arg(std::ceil(seconds * (1 - fraction) / fraction)) : text);
  bar_->setRange(0, fraction < 0 ? 0 : bar_steps);
  if (fraction >= 0) bar_->setValue(static_cast<int>(fraction * bar_steps));
}

void Status_progress::end() {
  is_running_ = false;
  delay_.stop();
  hide();
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/message_bar.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <algorithm>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {
constexpr int most_lines = 4;
}

Message_bar::Message_bar(QWidget* parent) : QFrame(parent), text_(new QLabel(this)) {
  setObjectName(QStringLiteral("message-bar"));
  setAccessibleName(tr("Messages"));
  const int em = fontMetrics().height();
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  text_->setTextFormat(Qt::PlainText);
  text_->setFocusPolicy(Qt::NoFocus);
  auto* copy = new QToolButton(this);
  copy->setText(tr("Copy"));
  copy->setToolTip(tr("Copy every message to the clipboard"));
  copy->setAutoRaise(true);
  auto* close = new QToolButton(this);
  close->setText(tr("Close"));
  close->setToolTip(tr("Close the messages (Esc)"));
  close->setAutoRaise(true);
  for (QToolButton* button : {copy, close}) button->setFocusPolicy(Qt::TabFocus);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(em * 2, em / 4, em / 2, em / 4);
  row->setSpacing(em / 4);
  row->addWidget(text_, 1);
  row->addWidget(copy, 0, Qt::AlignTop);
  row->addWidget(close, 0, Qt::AlignTop);
  connect(copy, &QToolButton::clicked, this, &Message_bar::copy_lines);
  connect(close, &QToolButton::clicked, this, &Message_bar::dismiss);
  hide();
}

void Message_bar::add(Kind kind, const QString& line) {
  kind_ = lines_.isEmpty() ? kind : std::max(kind_, kind);
  if (!lines_.contains(line)) lines_ << line;
  QStringList shown = lines_.mid(std::max<qsizetype>(0, lines_.size() - most_lines));
  if (lines_.size() > shown.size())
    shown.prepend(tr("%n earlier message(s); Copy takes all of them", nullptr, int(lines_.size() - shown.size())));
  text_->setText(shown.join(QLatin1Char('\n')));
  text_->setAccessibleName(text_->text());
  show();
  update();
  Q_EMIT added(kind, line);
}

void Message_bar::dismiss() {
  lines_.clear();
  hide();
}

void Message_bar::copy_lines() const { QGuiApplication::clipboard()->setText(lines_.join(QLatin1Char('\n'))); }

void Message_bar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor signal = kind_ == Kind::error     ? failure_color(palette())
                        : kind_ == Kind::warning ? warning_color(palette())
                                                 : palette().color(QPalette::Highlight);
  painter.fillRect(rect(), mix(palette().color(QPalette::Base), signal, 0.14));
  const int em = fontMetrics().height();
  painter.fillRect(QRectF(0, 0, em * 0.25, height()), signal);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF square(em * 0.7, em * 0.4, em * 0.9, em * 0.9);
  if (kind_ == Kind::error) {
    paint_failure(painter, square, signal, palette().color(QPalette::Base));
  } else if (kind_ == Kind::warning) {
    paint_warning(painter, square, signal, palette().color(QPalette::Base));
  } else {
    // An "i" in a disk.
    painter.setPen(Qt::NoPen);
    painter.setBrush(signal);
    painter.drawEllipse(square);
    const double stroke = square.width() * 0.14;
    const double x = square.center().x() - stroke / 2;
    const QColor ink = palette().color(QPalette::HighlightedText);
    painter.fillRect(QRectF(x, square.top() + square.height() * 0.22, stroke, stroke), ink);
    painter.fillRect(QRectF(x, square.top() + square.height() * 0.44, stroke, square.height() * 0.34), ink);
  }
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/popover.h"

#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "layers/panel_paint.h"

namespace mesecina {

Popover::Popover(const QString& title, QWidget* over)
    : QFrame(over->parentWidget()), over_(over), column_(new QVBoxLayout(this)), form_(new QFormLayout) {
  const int em = fontMetrics().height();
  setAccessibleName(title);
  setObjectName(QStringLiteral("popover"));
  // Clicks on the plate are not for what is below.
  setAttribute(Qt::WA_NoMousePropagation);
  setCursor(Qt::ArrowCursor);
  auto* heading = new QLabel(title, this);
  QFont bold = heading->font();
  bold.setBold(true);
  heading->setFont(bold);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));
  close->setAutoRaise(true);
  close->setToolTip(tr("Close (Esc)"));
  close->setAccessibleName(tr("Close"));
  connect(close, &QToolButton::clicked, this, &Popover::dismiss);
  auto* row = new QHBoxLayout;
  row->addWidget(heading, 1);
  row->addWidget(close);
  column_->setContentsMargins(em * 3 / 4, em / 3, em / 3, em / 2);
  column_->setSpacing(em / 3);
  column_->addLayout(row);
  form_->setContentsMargins(0, 0, em / 3, 0);
  form_->setHorizontalSpacing(em / 2);
  form_->setVerticalSpacing(em / 3);
  column_->addLayout(form_);
  hide();
}

void Popover::open() {
  const int em = fontMetrics().height();
  adjustSize();
  move(over_->pos() + QPoint(em / 2, em / 2));
  show();
  raise();
  if (QWidget* first = nextInFocusChain()) {
    for (QWidget* candidate = first; candidate != this; candidate = candidate->nextInFocusChain()) {
      if (!isAncestorOf(candidate) || qobject_cast<QToolButton*>(candidate)) continue;
      if ((candidate->focusPolicy() & Qt::TabFocus) == 0) continue;
      candidate->setFocus(Qt::PopupFocusReason);
      break;
    }
  }
}

void Popover::dismiss() {
  hide();
  Q_EMIT closed();
  deleteLater();
}

void Popover::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    dismiss();
  } else if (default_ && (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)) {
    default_->click();
  } else {
    QFrame::keyPressEvent(event);
  }
}

void Popover::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paint_plate(painter, rect(), palette());
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/recovery_bar.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

#include "layers/panel_paint.h"

namespace mesecina {

QString words_for(const Stored_scene& scene) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(scene.changed.time_since_epoch()).count();
  const QDateTime time = QDateTime::fromSecsSinceEpoch(seconds);
  const QString title = scene.title.empty() ? Recovery_bar::tr("Untitled") : QString::fromStdString(scene.title);
  const QString clock = time.toString(QStringLiteral("HH:mm"));
  const qint64 days = time.date().daysTo(QDate::currentDate());
  if (days == 0) return Recovery_bar::tr("%1, today %2").arg(title, clock);
  if (days == 1) return Recovery_bar::tr("%1, yesterday %2").arg(title, clock);
  return Recovery_bar::tr("%1, %2 %3").arg(title, time.date().toString(Qt::ISODate), clock);
}

Recovery_bar::Recovery_bar(QWidget* parent) : QFrame(parent), column_(new QVBoxLayout(this)) {
  setObjectName(QStringLiteral("recovery-bar"));
  setAccessibleName(tr("Scenes that can be recovered"));
  const int em = fontMetrics().height();
  column_->setContentsMargins(em * 2, em / 4, em / 2, em / 4);
  column_->setSpacing(em / 4);
  hide();
}

void Recovery_bar::offer(const std::vector<Stored_scene>& scenes) {
  for (const Stored_scene& scene : scenes) add(scene);
  setVisible(offers_ > 0);
}

void Recovery_bar::add(const Stored_scene& scene) {
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  auto* text = new QLabel(
      tr("The program ended without being closed. What there was can be recovered: %1").arg(words_for(scene)), line);
  text->setWordWrap(true);
  text->setTextFormat(Qt::PlainText);
  row->addWidget(text, 1);
  const QString folder = QString::fromStdString(scene.folder.string());
  const auto add_button = [&](const char* name, const QString& label, const QString& tip, auto signal) {
    auto* button = new QPushButton(label, line);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button, 0, Qt::AlignTop);
    connect(button, &QPushButton::clicked, this, [this, line, folder, signal] {
      line->deleteLater();
      if (--offers_ == 0) hide();
      Q_EMIT(this->*signal)(folder);
    });
  };
  add_button("recover", tr("Recover"), tr("Show this scene in place of the present one; Undo brings that back"),
             &Recovery_bar::recovery_requested);
  add_button("decline", tr("Not now"), tr("Keep it for 30 days under File ▸ Earlier scenes"), &Recovery_bar::declined);
  column_->addWidget(line);
  ++offers_;
}

void Recovery_bar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const QColor signal = warning_color(palette());
  painter.fillRect(rect(), mix(palette().color(QPalette::Base), signal, 0.14));
  const int em = fontMetrics().height();
  painter.fillRect(QRectF(0, 0, em * 0.25, height()), signal);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_warning(painter, QRectF(em * 0.7, em * 0.5, em * 0.9, em * 0.9), signal, palette().color(QPalette::Base));
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/recovery_bar.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <algorithm>
#include <limits>

#include "layers/panel_paint.h"

namespace mesecina {

namespace {

/// "1 204 points"; nothing for inputs that the user does not know.
QString words_for_count(const std::string& input, std::uint64_t count) {
  const auto number = static_cast<int>(std::min<std::uint64_t>(count, std::numeric_limits<int>::max()));
  // English has no translation that would choose between one and many.
  const auto words = [&](const QString& one, const QString& many) { return number == 1 ? one : many.arg(number); };
  if (input == points_input.id || input == cloud_input.id)
    return words(Recovery_bar::tr("1 point"), Recovery_bar::tr("%1 points"));
  if (input == disks_input.id) return words(Recovery_bar::tr("1 disk"), Recovery_bar::tr("%1 disks"));
  if (input == balls_input.id) return words(Recovery_bar::tr("1 ball"), Recovery_bar::tr("%1 balls"));
  if (input == mesh_input.id) return words(Recovery_bar::tr("1 triangle"), Recovery_bar::tr("%1 triangles"));
  if (input == outline_input.id) return words(Recovery_bar::tr("an outline"), Recovery_bar::tr("outlines of %1 rings"));
  if (input == image_input.id) return Recovery_bar::tr("a picture");
  return {};
}

QStringList folders_of(const std::vector<Stored_scene>& states) {
  QStringList folders;
  for (const Stored_scene& scene : states) folders << QString::fromStdString(scene.folder.string());
  return folders;
}

}  // namespace

QString words_for(std::chrono::system_clock::time_point moment) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(moment.time_since_epoch()).count();
  const QDateTime time = QDateTime::fromSecsSinceEpoch(seconds);
  const QString clock = time.toString(QStringLiteral("HH:mm"));
  const qint64 days = time.date().daysTo(QDate::currentDate());
  if (days == 0) return Recovery_bar::tr("today %1").arg(clock);
  if (days == 1) return Recovery_bar::tr("yesterday %1").arg(clock);
  return Recovery_bar::tr("%1 %2").arg(time.date().toString(Qt::ISODate), clock);
}

QString words_for(const Stored_scene& scene) {
  const QString title = scene.title.empty() ? Recovery_bar::tr("Untitled") : QString::fromStdString(scene.title);
  QStringList contents;
  for (const auto& [input, count] : scene.counts) contents << words_for_count(input, count);
  contents.removeAll(QString());
  if (scene.visible_layers == 1) contents << Recovery_bar::tr("1 layer");
  if (scene.visible_layers > 1) contents << Recovery_bar::tr("%1 layers").arg(scene.visible_layers);
  const QString name =
      contents.isEmpty() ? title : Recovery_bar::tr("%1 (%2)").arg(title, contents.join(QStringLiteral(", ")));
  return Recovery_bar::tr("%1, %2").arg(name, words_for(scene.changed));
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
  std::vector<std::vector<Stored_scene>> groups;
  for (const Stored_scene& scene : scenes) {
    const auto group = std::ranges::find_if(
        groups, [&](const std::vector<Stored_scene>& states) { return is_same_scene(states.front(), scene); });
    if (group == groups.end()) {
      groups.push_back({scene});
    } else {
      group->push_back(scene);
    }
  }
  for (const std::vector<Stored_scene>& states : groups) add(states);
  setVisible(offers_ > 0);
}

void Recovery_bar::add(const std::vector<Stored_scene>& states) {
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  const QString words = words_for(states.front());
  auto* text = new QLabel(
      offers_ == 0 ? tr("The program ended without being closed. What there was can be recovered: %1").arg(words)
                   : tr("And: %1").arg(words),
      line);
  text->setWordWrap(true);
  text->setTextFormat(Qt::PlainText);
  row->addWidget(text, 1);
  const QStringList folders = folders_of(states);
  const auto leave = [this, line] {
    line->deleteLater();
    if (--offers_ == 0) hide();
  };
  const auto add_button = [&](const char* name, const QString& label, const QString& tip) {
    auto* button = new QPushButton(label, line);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    row->addWidget(button, 0, Qt::AlignTop);
    return button;
  };
  const QString what_recovering_does = tr("Show this scene in place of the present one; Undo brings that back");
  if (states.size() > 1) {
    auto* older = add_button("older", tr("Older (%1)").arg(states.size() - 1),
                             tr("The scene as it was when the program ended before"));
    auto* menu = new QMenu(older);
    menu->setToolTipsVisible(true);
    for (qsizetype i = 1; i < folders.size(); ++i) {
      // An ampersand in a menu would mark a key.
      QAction* action = menu->addAction(
          words_for(states[static_cast<std::size_t>(i)]).replace(QLatin1Char('&'), QLatin1String("&&")));
      action->setToolTip(what_recovering_does);
      QStringList wanted_first = folders;
      wanted_first.move(i, 0);
      connect(action, &QAction::triggered, this, [this, leave, wanted_first] {
        leave();
        Q_EMIT recovery_requested(wanted_first);
      });
    }
    older->setMenu(menu);
  }
  connect(add_button("recover", tr("Recover"), what_recovering_does), &QPushButton::clicked, this,
          [this, leave, folders] {
            leave();
            Q_EMIT recovery_requested(folders);
          });
  connect(add_button("decline", tr("Not now"), tr("Keep it for 30 days under File ▸ Earlier scenes")),
          &QPushButton::clicked, this, [this, leave, folders] {
            leave();
            Q_EMIT declined(folders);
          });
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/layer_notes.h"

#include <QEvent>
#include <algorithm>
#include <utility>

#include "layers/color_bars.h"
#include "layers/missing_input.h"

namespace mesecina {

namespace {

constexpr const char* on_light = "#9a4a00";
constexpr const char* on_dark = "#f0a860";
/// Left free for the colour bars.
constexpr int width_beside = 290;
constexpr double least_share = 0.6;

}  // namespace

bool is_worth_a_note(const QString& reason) { return !reason.isEmpty() && !is_input_missing(reason); }

Layer_notes::Layer_notes(QWidget* canvas) : QLabel(canvas) {
  setObjectName(QStringLiteral("layer-notes"));
  setTextFormat(Qt::RichText);
  setWordWrap(true);
  // Links that took the focus would take the keys from the canvas.
  setTextInteractionFlags(Qt::LinksAccessibleByMouse);
  setFocusPolicy(Qt::NoFocus);
  connect(this, &QLabel::linkActivated, this, &Layer_notes::chosen);
  canvas->installEventFilter(this);
  hide();
}

void Layer_notes::set_notes(std::vector<Note> notes, Color background) {
  if (notes == notes_ && background == background_) return;
  notes_ = std::move(notes);
  background_ = background;
  arrange();
}

QStringList Layer_notes::lines() const {
  QStringList lines;
  const std::size_t said = notes_.size() > most_lines ? most_lines - 1 : notes_.size();
  for (std::size_t i = 0; i < said; ++i) lines << tr("%1: %2").arg(notes_[i].label, notes_[i].reason);
  if (said < notes_.size()) lines << tr("and %1 more layers").arg(notes_.size() - said);
  return lines;
}

void Layer_notes::arrange() {
  if (notes_.empty()) {
    hide();
    return;
  }
  constexpr int middle_grey = 128;
  const QString color = QLatin1String(ink_on(background_).green < middle_grey ? on_light : on_dark);
  const int margin = fontMetrics().height() / 2;
  const int whole = parentWidget()->width() - 2 * margin;
  const int widest = std::max(whole - width_beside, static_cast<int>(whole * least_share));
  QStringList shown;
  const QStringList all = lines();
  int natural = 0;
  for (const QString& line : all) natural = std::max(natural, fontMetrics().horizontalAdvance(line));
  for (qsizetype i = 0; i < all.size(); ++i)
    shown << QStringLiteral("<a href=\"%1\" style=\"color:%2; text-decoration:none\">%3</a>")
                 .arg(notes_[static_cast<std::size_t>(i)].layer, color, all[i].toHtmlEscaped());
  setText(shown.join(QStringLiteral("<br>")));
  QStringList every;
  for (const Note& note : notes_) every << tr("%1: %2").arg(note.label, note.reason);
  setToolTip(every.join(QLatin1Char('\n')));
  setAccessibleName(toolTip());
  const int used = std::min(natural + 2, widest);
  resize(used, heightForWidth(used));
  move(margin, parentWidget()->height() - height() - margin);
  show();
  raise();
}

bool Layer_notes::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) arrange();
  return QLabel::eventFilter(watched, event);
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/editor_2.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <utility>

namespace mesecina {

namespace {
/// How near the cursor has to be, in logical pixels.
constexpr double grab_radius = 8;
/// Copies lie this far beside the originals.
constexpr double copy_offset = 16;
}  // namespace

Editor_2::Editor_2(Document& document, Canvas_2& canvas, const Formats& formats, QObject* parent)
    : QObject(parent), document_(document), canvas_(canvas), formats_(formats) {
  connect(&document_, &Document::changed, this, &Editor_2::react);
}

Reach_2 Editor_2::reach() const {
  const auto is_shown = [this](std::string_view layer) {
    const Layer_entry* entry = find_entry(document_.layers(), layer);
    return !entry || entry->style.visible;
  };
  return {is_shown(points_input.id), is_shown(outline_input.id)};
}

Selection_2 Editor_2::at(const Canvas_event& event) const {
  return nearest(document_.inputs(), reach(), event.position, grab_radius / canvas_.view().scale);
}

void Editor_2::select(Selection_2 selection) {
  if (selection == selection_) return;
  selection_ = std::move(selection);
  ++gesture_;
  Q_EMIT selection_changed();
}

void Editor_2::select_all() { select(all_of(document_.inputs(), reach())); }

void Editor_2::react(const Document_change& change) {
  if (!change.inputs || is_editing_) return;
  select(restricted(selection_, document_.inputs()));
}

void Editor_2::edit(Inputs inputs, Selection_2 selection, const QString& text, const QString& merge) {
  is_editing_ = true;
  document_.edit_inputs(std::move(inputs), text, merge);
  is_editing_ = false;
  select(std::move(selection));
}

void Editor_2::add_point(const Point_2& position, const QString& merge) {
  const auto points = document_.inputs().get(points_input);
  const std::size_t index = points ? points->size() : 0;
  edit(with_points(document_.inputs(), {position}), {{index}, {}},
       merge.isEmpty() ? tr("Add a point") : tr("Spray points"), merge);
}

void Editor_2::add_ring(Ring_2 ring) {
  edit(with_ring(document_.inputs(), std::move(ring)), {}, tr("Draw an outline"));
}

void Editor_2::begin_drag() {
  ++gesture_;
  drag_start_ = document_.inputs();
}

void Editor_2::drag_by(double dx, double dy) {
  Inputs inputs = dx == 0 && dy == 0 ? drag_start_ : moved(drag_start_, selection_, dx, dy);
  edit(std::move(inputs), selection_, tr("Move %1").arg(words(selection_)), QStringLiteral("drag/%1").arg(gesture_));
}

void Editor_2::nudge(double dx, double dy) {
  if (selection_.is_empty()) return;
  edit(moved(document_.inputs(), selection_, dx, dy), selection_, tr("Nudge %1").arg(words(selection_)),
       QStringLiteral("nudge/%1").arg(gesture_));
}

void Editor_2::place(const Point_2& position, const QString& merge) {
  edit(placed(document_.inputs(), selection_, position), selection_, tr("Set coordinates"), merge);
}

void Editor_2::place_point(std::size_t index, const Point_2& position) {
  const auto points = document_.inputs().get(points_input);
  if (!points || index >= points->size() || (*points)[index] == position) return;
  const Selection_2 one{{index}, {}};
  edit(placed(document_.inputs(), one, position), selection_, tr("Set coordinates of point %1").arg(index));
}

void Editor_2::remove_selected() {
  if (selection_.is_empty()) return;
  edit(without(document_.inputs(), selection_), {}, tr("Delete %1").arg(words(selection_)));
}

void Editor_2::duplicate() {
  if (selection_.is_empty()) return;
  const double offset = copy_offset / canvas_.view().scale;
  auto [inputs, copies] = duplicated(document_.inputs(), selection_, offset, -offset);
  if (copies.is_empty()) {
    Q_EMIT failed(tr("Duplicate copies points and whole rings of an outline; select all vertices of a ring first."));
    return;
  }
  const QString text = tr("Duplicate %1").arg(words(copies));
  edit(std::move(inputs), std::move(copies), text);
}

void Editor_2::copy() {
  if (selection_.is_empty()) return;
  QGuiApplication::clipboard()->setText(QString::fromStdString(to_table(positions(document_.inputs(), selection_))));
}

void Editor_2::cut() {
  copy();
  remove_selected();
}

void Editor_2::paste() {
  const QString text = QGuiApplication::clipboard()->text();
  if (text.trimmed().isEmpty()) {
    Q_EMIT failed(tr("The clipboard holds no text to paste; expected a point per line, \"x y\"."));
    return;
  }
  paste_text(text);
}

bool Editor_2::paste_text(const QString& text) {
  // The readers of files define what a table is and what is wrong with one.
  const QTemporaryDir folder;
  const QString path = folder.filePath(tr("clipboard") + QStringLiteral(".txt"));
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly) || file.write(text.toUtf8()) < 0 || !file.flush()) {
    Q_EMIT failed(tr("Cannot paste: no room for a temporary file (%1).").arg(file.errorString()));
    return false;
  }
  try {
    const File_contents contents = read_file(formats_, path.toStdString());
    auto points = contents.inputs.get(points_input);
    std::vector<Point_2> pasted;
    if (points) pasted = *points;
    if (const auto disks = contents.inputs.get(disks_input))
      for (const Disk_2& disk : *disks) pasted.push_back(disk.center);
    const auto before = document_.inputs().get(points_input);
    Selection_2 added;
    for (std::size_t i = 0; i < pasted.size(); ++i) added.points.push_back((before ? before->size() : 0) + i);
    const QString words_of_added = words(added);
    edit(with_points(document_.inputs(), pasted), std::move(added), tr("Paste %1").arg(words_of_added));
    return true;
  } catch (const File_error& error) {
    Q_EMIT failed(tr("Cannot paste: %1").arg(QString::fromUtf8(error.what()).remove(folder.path() + QLatin1Char('/'))));
    return false;
  }
}

QString Editor_2::words(const Selection_2& selection) {
  const auto points = selection.points.size() == 1 ? tr("1 point") : tr("%1 points").arg(selection.points.size());
  const auto vertices =
      selection.vertices.size() == 1 ? tr("1 vertex") : tr("%1 vertices").arg(selection.vertices.size());
  if (selection.vertices.empty()) return points;
  if (selection.points.empty()) return vertices;
  return tr("%1 and %2").arg(points, vertices);
}

}  // namespace mesecina

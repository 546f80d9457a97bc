// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/editor_2.h"

#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace mesecina {

namespace {
/// How near the cursor has to be, in logical pixels.
constexpr double grab_radius = 8;
/// Copies lie this far beside the originals.
constexpr double copy_offset = 16;
/// Handles are at least this far from the center, so that it stays free.
constexpr double least_handle_distance = 22;
constexpr std::size_t most_disks_with_handles = 50;
constexpr double least_dragged_radius = 0.5;
/// Of the shorter side of the canvas.
constexpr double usual_radius_share = 0.06;
/// One notch of a wheel is 15 degrees and makes a disk larger by 6 percent.
constexpr double growth_per_degree = 1.004;
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
  return {is_shown(points_input.id), is_shown(outline_input.id), is_shown(disks_input.id)};
}

Selection_2 Editor_2::at(const Canvas_event& event) const {
  return nearest(document_.inputs(), reach(), event.position, grab_radius / canvas_.view().scale);
}

std::vector<Disk_handle_2> Editor_2::handles() const {
  std::vector<Disk_handle_2> handles;
  const auto disks = document_.inputs().get(disks_input);
  if (!disks || selection_.disks.size() > most_disks_with_handles || !reach().disks) return handles;
  for (const std::size_t i : selection_.disks) {
    if (i >= disks->size()) continue;
    const Point_2& center = (*disks)[i].center;
    const double least = least_handle_distance / canvas_.view().scale;
    // Beside others, handles far outside of their disk would seem to be those of another one.
    if ((*disks)[i].radius < least / 2 && selection_.disks.size() > 1) continue;
    const double far = std::max((*disks)[i].radius, least);
    handles.push_back({i, {center.x + far, center.y}, true});
    handles.push_back({i, {center.x, center.y + far}, false});
    handles.push_back({i, {center.x - far, center.y}, true});
    handles.push_back({i, {center.x, center.y - far}, false});
  }
  return handles;
}

std::optional<Disk_handle_2> Editor_2::handle_at(const Canvas_event& event) const {
  std::optional<Disk_handle_2> found;
  double best = grab_radius / canvas_.view().scale;
  for (const Disk_handle_2& handle : handles()) {
    const double d = distance(handle.position, event.position);
    if (d > best) continue;
    best = d;
    found = handle;
  }
  return found;
}

bool Editor_2::is_over_selected_disk(const Canvas_event& event) const {
  if (!reach().disks) return false;
  const double near = grab_radius / canvas_.view().scale;
  return std::ranges::any_of(selected_disks(document_.inputs(), selection_), [&](const Disk_2& disk) {
    return distance(disk.center, event.position) <= disk.radius + near;
  });
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

void Editor_2::add_disk(const Disk_2& disk, const QString& merge) {
  const auto disks = document_.inputs().get(disks_input);
  const std::size_t index = disks ? disks->size() : 0;
  edit(with_disks(document_.inputs(), {disk}), {{}, {}, {index}},
       merge.isEmpty() ? tr("Draw a disk") : tr("Spray disks"), merge);
  remember_radius();
}

double Editor_2::usual_radius() const {
  if (last_radius_) return *last_radius_;
  return usual_radius_share * std::min(canvas_.width(), canvas_.height()) / canvas_.view().scale;
}

void Editor_2::remember_radius() {
  const std::vector<Disk_2> disks = selected_disks(document_.inputs(), selection_);
  if (disks.size() == 1 && disks.front().radius > 0) last_radius_ = disks.front().radius;
}

void Editor_2::begin_drag() {
  ++gesture_;
  drag_start_ = document_.inputs();
}

void Editor_2::drag_by(double dx, double dy) {
  Inputs inputs = dx == 0 && dy == 0 ? drag_start_ : moved(drag_start_, selection_, dx, dy);
  edit(std::move(inputs), selection_, tr("Move %1").arg(words(selection_)), QStringLiteral("drag/%1").arg(gesture_));
}

void Editor_2::drag_radius(std::size_t disk, double change) {
  const auto disks = drag_start_.get(disks_input);
  if (!disks || disk >= disks->size()) return;
  const Disk_2& start = (*disks)[disk];
  Inputs inputs = drag_start_;
  if (change != 0) {
    const double radius = std::max(start.radius + change, least_dragged_radius / canvas_.view().scale);
    if (start.radius > 0) inputs = resized(inputs, selection_, radius / start.radius);
    // Free of the rounding of the factor, and also where there is none.
    inputs = with_disk(inputs, disk, {start.center, radius});
  }
  edit(std::move(inputs), selection_, tr("Resize %1").arg(words({{}, {}, selection_.disks})),
       QStringLiteral("drag/%1").arg(gesture_));
  remember_radius();
}

void Editor_2::turn_wheel(double degrees) {
  if (selection_.disks.empty()) return;
  const bool goes_on = wheel_run_.gesture == gesture_ && wheel_run_.end == document_.inputs();
  if (!goes_on) wheel_run_ = {document_.inputs(), {}, 0, gesture_};
  wheel_run_.degrees += degrees;
  Inputs inputs = wheel_run_.degrees == 0
                      ? wheel_run_.start
                      : resized(wheel_run_.start, selection_, std::pow(growth_per_degree, wheel_run_.degrees));
  edit(std::move(inputs), selection_, tr("Resize %1").arg(words({{}, {}, selection_.disks})),
       QStringLiteral("wheel/%1").arg(gesture_));
  wheel_run_.end = document_.inputs();
  remember_radius();
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

void Editor_2::change_disk(std::size_t index, const Disk_2& disk, const QString& merge) {
  const auto disks = document_.inputs().get(disks_input);
  if (!disks || index >= disks->size() || (*disks)[index] == disk) return;
  edit(with_disk(document_.inputs(), index, disk), selection_, tr("Set numbers of disk %1").arg(index), merge);
  remember_radius();
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
    Q_EMIT failed(
        tr("Duplicate copies points, disks and whole rings of an outline; select all vertices of a ring first."));
    return;
  }
  const QString text = tr("Duplicate %1").arg(words(copies));
  edit(std::move(inputs), std::move(copies), text);
}

void Editor_2::copy() {
  if (selection_.is_empty()) return;
  const Inputs& inputs = document_.inputs();
  const Selection_2 without_disks{selection_.points, selection_.vertices, {}};
  QGuiApplication::clipboard()->setText(
      QString::fromStdString(to_table(positions(inputs, without_disks), selected_disks(inputs, selection_))));
}

void Editor_2::cut() {
  copy();
  remove_selected();
}

void Editor_2::paste() {
  const QString text = QGuiApplication::clipboard()->text();
  if (text.trimmed().isEmpty()) {
    Q_EMIT failed(
        tr("The clipboard holds no text to paste; expected a point \"x y\" or a disk \"x y radius\" per line."));
    return;
  }
  paste_text(text);
}

bool Editor_2::paste_text(const QString& text) {
  // The readers of files define what a table is and what is wrong with one.
  const QTemporaryDir folder;
  const QString path = folder.filePath(tr("clipboard") + QStringLiteral(".txt"));
  try {
    Inputs pasted;
    for (const std::string& part : table_parts(text.toStdString())) {
      QFile file(path);
      if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray::fromStdString(part)) < 0 || !file.flush()) {
        Q_EMIT failed(tr("Cannot paste: no room for a temporary file (%1).").arg(file.errorString()));
        return false;
      }
      pasted = appended(pasted, read_file(formats_, path.toStdString()).inputs);
    }
    const Inputs& before = document_.inputs();
    const auto numbers_of_added = [&](auto key) {
      std::vector<std::size_t> numbers(pasted.get(key) ? pasted.get(key)->size() : 0);
      std::iota(numbers.begin(), numbers.end(), before.get(key) ? before.get(key)->size() : 0);
      return numbers;
    };
    Selection_2 added{numbers_of_added(points_input), {}, numbers_of_added(disks_input)};
    const QString words_of_added = words(added);
    edit(appended(before, pasted), std::move(added), tr("Paste %1").arg(words_of_added));
    return true;
  } catch (const File_error& error) {
    Q_EMIT failed(tr("Cannot paste: %1").arg(QString::fromUtf8(error.what()).remove(folder.path() + QLatin1Char('/'))));
    return false;
  }
}

QString Editor_2::words(const Selection_2& selection) {
  QStringList parts;
  const auto add = [&parts](std::size_t count, const QString& one, const QString& several) {
    if (count > 0) parts << (count == 1 ? one : several.arg(count));
  };
  add(selection.points.size(), tr("1 point"), tr("%1 points"));
  add(selection.vertices.size(), tr("1 vertex"), tr("%1 vertices"));
  add(selection.disks.size(), tr("1 disk"), tr("%1 disks"));
  if (parts.isEmpty()) return tr("0 points");
  const QString last = parts.takeLast();
  return parts.isEmpty() ? last : tr("%1 and %2").arg(parts.join(tr(", ")), last);
}

}  // namespace mesecina

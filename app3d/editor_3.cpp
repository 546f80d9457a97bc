// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/editor_3.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/input_elements.h"

namespace mesecina {

namespace {

/// Of the height of the picture.
constexpr double usual_radius_share = 0.06;
/// One notch of a wheel is 15 degrees and makes a ball larger by 6 percent.
constexpr double growth_per_degree = 1.004;

template <class T>
std::size_t count_of(const std::shared_ptr<const std::vector<T>>& all) {
  return all ? all->size() : 0;
}

}  // namespace

Editor_3::Editor_3(Document& document, QObject* parent) : QObject(parent), document_(document) {
  connect(&document_, &Document::changed, this, &Editor_3::react);
}

Reach_3 Editor_3::reach() const {
  const auto is_shown = [this](std::string_view layer) {
    const Layer_entry* entry = find_entry(document_.layers(), layer);
    return !entry || entry->style.visible;
  };
  return {is_shown(points_layer), is_shown(balls_layer)};
}

void Editor_3::select(Selection_3 selection) {
  if (selection == selection_) return;
  selection_ = std::move(selection);
  ++gesture_;
  Q_EMIT selection_changed();
}

void Editor_3::select_all() { select(all_of(document_.inputs(), reach())); }

void Editor_3::invert_selection() { select(toggled(selection_, all_of(document_.inputs(), reach()))); }

void Editor_3::react(const Document_change& change) {
  if (!change.inputs || is_editing_) return;
  const auto undone = std::ranges::find(removals_, document_.inputs(), &Removal::before);
  select(undone != removals_.end() ? undone->selection : restricted(selection_, document_.inputs()));
}

void Editor_3::edit(Inputs inputs, Selection_3 selection, const QString& text, const QString& merge) {
  is_editing_ = true;
  document_.edit_inputs(std::move(inputs), text, merge);
  is_editing_ = false;
  select(std::move(selection));
}

QString Editor_3::merge_key(const QString& kind) const { return QStringLiteral("%1/%2").arg(kind).arg(gesture_); }

void Editor_3::show_layer(std::string_view layer, const QString& text, const QString& merge) {
  Layer_list layers = document_.layers();
  Layer_entry* entry = find_entry(layers, layer);
  if (!entry || entry->style.visible) return;
  entry->style.visible = true;
  document_.edit_layers(std::move(layers), text, merge);
}

void Editor_3::add_point(const Point_3& place) {
  const std::size_t index = count_of(document_.inputs().get(cloud_input));
  const QString text = tr("Add a point");
  const QString merge = merge_key(QStringLiteral("add"));
  edit(with_elements(document_.inputs(), cloud_input, {place}), {{index}, {}}, text, merge);
  show_layer(points_layer, text, merge);
  ++gesture_;
}

void Editor_3::add_ball(const Ball_3& ball) {
  const std::size_t index = count_of(document_.inputs().get(balls_input));
  const QString text = tr("Add a ball");
  const QString merge = merge_key(QStringLiteral("add"));
  edit(with_elements(document_.inputs(), balls_input, {ball}), {{}, {index}}, text, merge);
  show_layer(balls_layer, text, merge);
  ++gesture_;
  remember_radius();
}

double Editor_3::usual_radius(double seen) const { return last_radius_.value_or(usual_radius_share * seen); }

void Editor_3::remember_radius() {
  const std::vector<Ball_3> balls = selected_balls(document_.inputs(), selection_);
  if (balls.size() == 1 && balls.front().radius > 0) last_radius_ = balls.front().radius;
}

void Editor_3::begin_drag() {
  ++gesture_;
  drag_start_ = document_.inputs();
}

void Editor_3::drag_by(const Point_3& shift) {
  Inputs inputs = shift == Point_3{} ? drag_start_ : moved(drag_start_, selection_, shift);
  edit(std::move(inputs), selection_, tr("Move %1").arg(words(selection_)), merge_key(QStringLiteral("drag")));
}

std::optional<Ball_3> Editor_3::dragged_ball(std::size_t ball) const {
  const auto balls = drag_start_.get(balls_input);
  return ball < count_of(balls) ? std::optional((*balls)[ball]) : std::nullopt;
}

void Editor_3::drag_radius(std::size_t ball, double radius) {
  const auto start = dragged_ball(ball);
  if (!start || !(radius > 0) || !std::isfinite(radius)) return;
  Inputs inputs = drag_start_;
  if (radius != start->radius) {
    if (start->radius > 0) inputs = resized(inputs, selection_, radius / start->radius);
    // Free of the rounding of the factor, and also where there is none.
    inputs = with_ball(inputs, ball, {start->center, radius});
  }
  edit(std::move(inputs), selection_, tr("Resize %1").arg(words({{}, selection_.balls})),
       merge_key(QStringLiteral("drag")));
  remember_radius();
}

void Editor_3::turn_wheel(double degrees) {
  if (selection_.balls.empty()) return;
  const bool goes_on = wheel_run_.gesture == gesture_ && wheel_run_.end == document_.inputs();
  if (!goes_on) wheel_run_ = {document_.inputs(), {}, 0, gesture_};
  wheel_run_.degrees += degrees;
  Inputs inputs = wheel_run_.degrees == 0
                      ? wheel_run_.start
                      : resized(wheel_run_.start, selection_, std::pow(growth_per_degree, wheel_run_.degrees));
  edit(std::move(inputs), selection_, tr("Resize %1").arg(words({{}, selection_.balls})),
       merge_key(QStringLiteral("wheel")));
  wheel_run_.end = document_.inputs();
  remember_radius();
}

void Editor_3::nudge(const Point_3& shift) {
  if (selection_.is_empty()) return;
  edit(moved(document_.inputs(), selection_, shift), selection_, tr("Nudge %1").arg(words(selection_)),
       merge_key(QStringLiteral("nudge")));
}

void Editor_3::change_point(std::size_t index, const Point_3& point, const QString& merge) {
  const auto points = document_.inputs().get(cloud_input);
  if (index >= count_of(points) || (*points)[index] == point) return;
  edit(with_point(document_.inputs(), index, point), selection_, tr("Set coordinates of point %1").arg(index), merge);
}

void Editor_3::change_ball(std::size_t index, const Ball_3& ball, const QString& merge) {
  const auto balls = document_.inputs().get(balls_input);
  if (index >= count_of(balls) || (*balls)[index] == ball) return;
  edit(with_ball(document_.inputs(), index, ball), selection_, tr("Set numbers of ball %1").arg(index), merge);
  remember_radius();
}

void Editor_3::remove_selected() {
  if (selection_.is_empty()) return;
  constexpr std::size_t most_removals = 32;
  removals_.push_front({document_.inputs(), selection_});
  if (removals_.size() > most_removals) removals_.pop_back();
  edit(without(document_.inputs(), selection_), {}, tr("Delete %1").arg(words(selection_)));
}

void Editor_3::duplicate(const Point_3& shift) {
  if (selection_.is_empty()) return;
  auto [inputs, copies] = duplicated(document_.inputs(), selection_, shift);
  const QString text = tr("Duplicate %1").arg(words(copies));
  edit(std::move(inputs), std::move(copies), text);
}

void Editor_3::transform(const Inputs& start, const Transform_3& transform, const QString& merge) {
  Transform_3 still;
  still.pivot = transform.pivot;
  edit(transform == still ? start : transformed(start, transform), selection_, tr("Transform"), merge);
}

QString Editor_3::words(const Selection_3& selection) {
  QStringList parts;
  const auto add = [&parts](std::size_t count, const QString& one, const QString& several) {
    if (count > 0) parts << (count == 1 ? one : several.arg(count));
  };
  add(selection.points.size(), tr("1 point"), tr("%1 points"));
  add(selection.balls.size(), tr("1 ball"), tr("%1 balls"));
  return parts.isEmpty() ? tr("nothing") : parts.join(tr(" and "));
}

}  // namespace mesecina

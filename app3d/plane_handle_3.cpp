// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/plane_handle_3.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "shell/theme.h"

namespace mesecina {

namespace {

Point_2 to_point(const QPointF& pixel) { return {pixel.x(), pixel.y()}; }

double distance_to_segment(const Point_2& p, const Point_2& a, const Point_2& b) {
  const double square = squared_distance(a, b);
  if (square == 0) return distance(p, a);
  const double part = std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / square, 0.0, 1.0);
  return distance(p, {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)});
}

}  // namespace

Plane_handle_3::Plane_handle_3(Viewer_3& viewer, QObject* parent) : QObject(parent), viewer_(viewer) {
  viewer_.set_handle(this);
  connect(&viewer_, &Viewer_3::view_changed, this, &Plane_handle_3::follow);
  connect(&viewer_, &Viewer_3::hovered, this, &Plane_handle_3::look_at);
}

Plane_handle_3::~Plane_handle_3() { viewer_.set_handle(nullptr); }

void Plane_handle_3::set_box(const Box& box) {
  box_ = sized(box);
  shown_.reset();
  follow();
}

Sight_3 Plane_handle_3::sight() const {
  return {viewer_.view().camera, static_cast<double>(viewer_.width()), static_cast<double>(viewer_.height())};
}

std::optional<Plane_frame_3> Plane_handle_3::frame() const {
  const auto plane = viewer_.view().cutting_plane;
  if (!plane) return std::nullopt;
  return frame_of(*plane, box_);
}

/// The sets to be drawn are made anew only for another plane, so that turning the view uploads nothing.
void Plane_handle_3::follow() {
  const auto plane = viewer_.view().cutting_plane;
  if (plane) last_ = plane;
  if (plane == shown_ && (!plane || outline_)) return;
  shown_ = plane;
  outline_ = plane ? outline_of(*frame()) : nullptr;
}

Plane_handle_3::Part Plane_handle_3::part_at(const QPointF& pixel) const {
  const auto here = frame();
  if (!here) return Part::none;
  const Sight_3 seen = sight();
  constexpr double reach_of_tip = 9;
  constexpr double reach_of_line = 5;
  const auto is_near = [&](const Point_3& a, const Point_3& b, double reach) {
    const auto from = seen.pixel(a);
    const auto to = seen.pixel(b);
    return from && to && distance_to_segment(to_point(pixel), *from, *to) <= reach;
  };
  if (is_near(here->tip(), here->tip(), reach_of_tip) || is_near(here->center, here->tip(), reach_of_line))
    return Part::arrow;
  for (const double shift : {here->half_thickness, -here->half_thickness}) {
    const auto corners = here->corners(shift);
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (is_near(corners[i], corners[(i + 1) % corners.size()], reach_of_line)) return Part::frame;
  }
  return Part::none;
}

void Plane_handle_3::look_at(const QPointF& pixel) {
  const Part part = part_at(pixel);
  if (std::exchange(hovered_, part) != part) viewer_.QOpenGLWidget::update();
}

void Plane_handle_3::set_plane(const Cutting_plane_3& plane) {
  viewer_.remember_view();
  viewer_.set_cutting_plane(plane);
}

void Plane_handle_3::toggle() {
  if (viewer_.view().cutting_plane) {
    viewer_.remember_view();
    viewer_.set_cutting_plane(std::nullopt);
  } else {
    set_plane(new_plane());
  }
}

Cutting_plane_3 Plane_handle_3::new_plane() const {
  if (last_ && distance(frame_of(*last_, box_).center, middle()) < box_.diagonal() / 2) return *last_;
  return plane_facing(viewer_.destination().camera.axes().back, box_);
}

void Plane_handle_3::align(const Point_3& normal) {
  const Cutting_plane_3 plane = viewer_.view().cutting_plane.value_or(new_plane());
  set_plane(aligned(plane, frame_of(plane, box_).center, normal));
}

void Plane_handle_3::flip() {
  const auto here = frame();
  if (here) align(-1.0 * here->normal);
}

bool Plane_handle_3::press(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
  dragged_ = part_at(event.position());
  if (dragged_ == Part::none) return false;
  hovered_ = dragged_;
  before_ = event.position();
  viewer_.remember_view();
  return true;
}

void Plane_handle_3::drag(const QMouseEvent& event) {
  const auto here = frame();
  if (!here || dragged_ == Part::none) return;
  const Cutting_plane_3 plane = *viewer_.view().cutting_plane;
  const QPointF moved = event.position() - before_;
  const Sight_3 seen = sight();
  if (dragged_ == Part::arrow) {
    const auto along = [&](const QPointF& pixel) { return seen.along(to_point(pixel), here->tip(), here->normal); };
    double step = along(event.position()) - along(before_);
    // Where the arrow points at the viewer, upwards is towards the viewer.
    constexpr double almost = 0.98;
    const double towards = dot(here->normal, seen.axes().back);
    if (std::abs(towards) > almost) step = -moved.y() * seen.pixel_size(here->center) * (towards > 0 ? 1 : -1);
    if (step != 0) viewer_.set_cutting_plane(shifted(plane, step));
  } else {
    const double way = std::hypot(moved.x(), moved.y());
    if (way == 0) return;
    // As if the scene turned under the mouse: half a turn across the picture.
    const Point_3 axis = (1 / way) * (moved.x() * seen.axes().up + moved.y() * seen.axes().right);
    const double angle = std::numbers::pi * way / std::max(1, std::min(viewer_.width(), viewer_.height()));
    viewer_.set_cutting_plane(turned(plane, here->center, axis, angle));
  }
  before_ = event.position();
}

void Plane_handle_3::release(const QMouseEvent&) { dragged_ = Part::none; }

bool Plane_handle_3::double_click(const QMouseEvent& event) { return part_at(event.position()) != Part::none; }

bool Plane_handle_3::wheel(const QWheelEvent& event) {
  const auto plane = viewer_.view().cutting_plane;
  if (!plane || event.modifiers() != Qt::ControlModifier) return false;
  constexpr double eighths_per_notch = 120;
  constexpr double pixels_per_notch = 8;
  const double size = sight().pixel_size(frame()->center);
  viewer_.remember_step();
  viewer_.set_cutting_plane(shifted(*plane, pixels_per_notch * size * event.angleDelta().y() / eighths_per_notch));
  return true;
}

std::vector<Scene_layer> Plane_handle_3::overlay() const {
  if (!viewer_.view().cutting_plane || !outline_) return {};
  Style style;
  style.visible = true;
  style.sliced = false;
  style.color = color();
  constexpr double wide = 2.5;
  constexpr double wider = 4;
  style.line_width = hovered_ == Part::frame ? wider : wide;
  return {Scene_layer{"cutting-plane", {}, outline_, {}, style}};
}

Color Plane_handle_3::color() const {
  constexpr Color violet{150, 60, 215};
  return visible_on(viewer_.scene().background, violet);
}

/// The arrow stays in sight and in reach whatever hides it.
void Plane_handle_3::paint(QPainter& painter) const {
  const auto here = frame();
  if (!here) return;
  const Sight_3 seen = sight();
  const auto from = seen.pixel(here->center);
  const auto to = seen.pixel(here->tip());
  if (!from || !to) return;
  const QPointF center(from->x, from->y);
  const QPointF tip(to->x, to->y);
  const Color ink = color();
  const Color& ground = viewer_.scene().background;
  const bool is_hovered = hovered_ == Part::arrow;
  constexpr double rim = 2;
  const double wide = is_hovered ? 4 : 2.5;
  const double knob = is_hovered ? 8 : 6.5;
  const double foot = 3;
  painter.save();
  const QColor light(ground.red, ground.green, ground.blue);
  const QColor dark(ink.red, ink.green, ink.blue);
  for (const auto& [brush, more] : {std::pair{light, rim}, std::pair{dark, 0.0}}) {
    painter.setPen(QPen(brush, wide + more, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(center, tip);
    painter.setPen(Qt::NoPen);
    painter.setBrush(brush);
    painter.drawEllipse(tip, knob + more / 2, knob + more / 2);
    painter.drawEllipse(center, foot + more / 2, foot + more / 2);
  }
  painter.restore();
}

}  // namespace mesecina

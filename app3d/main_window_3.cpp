// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/main_window_3.h"

#include <QDockWidget>
#include <QLabel>
#include <QStatusBar>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app3d/example_3.h"
#include "app3d/first_look_3.h"
#include "layers/canvas_surface.h"
#include "shell/element_facts.h"
#include "shell/panel_focus.h"

namespace mesecina {

namespace {

Document_state first_state_3(const Registry& registry, const Startup& startup) {
  constexpr int segments = 96;
  return first_state(registry, startup, Inputs().with(mesh_input, twisted_ring(segments)),
                     [&](const Inputs& inputs) { return first_look_3(registry, inputs); });
}

}  // namespace

Main_window_3::Main_window_3(const std::shared_ptr<const Registry>& registry, Formats formats, const Startup& startup)
    : Program_window(
          QStringLiteral("mesecina3d"), registry, std::move(formats), first_state_3(*registry, startup),
          [registry](const Inputs& inputs, const Layer_list& layers) { return look_at_3(*registry, inputs, layers); }) {
  seen_first_ = startup.seen_3;
  build_canvas();
  editor_ = new Editor_3(document_, this);
  files_ = new Files_3(document_, formats_, this);
  set_files(files_);
  build_docks();
  build_status_bar();
  selected_ = new QLabel(this);
  statusBar()->insertPermanentWidget(1, selected_);
  readout_ = make_plate(QStringLiteral("readout"));
  make_actions();
  make_menus();
  make_tool_bar();
  connect_common();
  connect_editing();
  if (viewer_) connect(viewer_, &Viewer_3::view_changed, &recording(), &Window_recording::note_change);
  use_tool(QStringLiteral("tool-turn"));
  show_selection();
  make_own_commands();
  restore();
  restore_camera_habits();
  start(startup, QStringLiteral("scale-axis"));
}

Main_window_3::~Main_window_3() {
  player_.reset();
  plane_.reset();
  hover_.reset();
  if (viewer_) viewer_->set_tool(nullptr);
  take_apart();
  delete editor_;
  delete files_;
}

void Main_window_3::build_canvas() {
  const Opengl_probe probe = probe_opengl();
  if (probe.reason.isEmpty()) {
    viewer_ = new Viewer_3(probe.is_software);
    canvas_ = viewer_;
    build_center(canvas_);
    hover_ = std::make_unique<Hover_3>(computation_, *viewer_);
    plane_ = std::make_unique<Plane_handle_3>(*viewer_);
    player_ = std::make_unique<Camera_player_3>(*viewer_);
    viewer_->keep_marks_above(notes_);
    connect(viewer_, &Viewer_3::view_changed, this, &Main_window_3::show_view_state);
    connect(viewer_, &Viewer_3::view_changed, this, [this] { touch_scene(); });
    connect(player_.get(), &Camera_player_3::changed, this, &Main_window_3::show_view_state);
    connect(viewer_, &Viewer_3::hovered, hover_.get(), &Hover_3::look_at);
    connect(viewer_, &Viewer_3::left, hover_.get(), &Hover_3::forget);
    connect(viewer_, &Viewer_3::view_changed, hover_.get(), &Hover_3::forget);
    connect(hover_.get(), &Hover_3::changed, this, &Main_window_3::show_hover);
    connect(viewer_, &Viewer_3::failed, this, [this](const QString& reason) {
      messages_->add(Message_bar::Kind::error, tr("Nothing can be drawn: %1").arg(reason));
    });
    return;
  }
  auto* message = new QLabel(
      tr("Space cannot be shown here: %1.\nLayers are computed and can be exported all the same.").arg(probe.reason));
  message->setAlignment(Qt::AlignCenter);
  message->setWordWrap(true);
  message->setTextFormat(Qt::PlainText);
  message->setFocusPolicy(Qt::StrongFocus);
  canvas_ = message;
  build_center(canvas_);
}

void Main_window_3::build_docks() {
  build_panels();
  bundles_->set_view_access(
      [this](Bundle& bundle) {
        if (viewer_) bundle.view_3 = viewer_->view();
      },
      [this](const Bundle& bundle) {
        if (viewer_) viewer_->go_to(*bundle.view_3);
      });
  balls_table_ = new Input_table_3(Rows_3::balls, *editor_, this);
  points_table_ = new Input_table_3(Rows_3::points, *editor_, this);
  QDockWidget* balls = add_dock(QStringLiteral("balls-dock"), tr("Balls"), balls_table_, Qt::RightDockWidgetArea);
  QDockWidget* points = add_dock(QStringLiteral("points-dock"), tr("Points"), points_table_, Qt::RightDockWidgetArea);
  tabifyDockWidget(settings_dock_, balls);
  tabifyDockWidget(balls, points);
  settings_dock_->raise();
}

void Main_window_3::showEvent(QShowEvent* event) {
  Program_window::showEvent(event);
  if (!std::exchange(is_view_chosen_, true)) show_first_view();
}

void Main_window_3::show_scene() {
  show_notes();
  if (!viewer_) return;
  hover_->check();
  Scene scene = computation_.scene(background());
  // The last pictures of data that is gone would tell a lie.
  if (document_.inputs().is_empty()) {
    for (Scene_layer& layer : scene.layers) layer.primitives = nullptr;
  }
  viewer_->set_scene(std::move(scene));
  plane_->set_box(drawn_box(viewer_->scene()));
}

void Main_window_3::show_hover() {
  viewer_->set_overlay(hover_->overlay());
  show_facts_text(with_short_numbers(hover_->text()));
  if (!hover_->hovered()) {
    coordinates_->clear();
    return;
  }
  const Point_3& place = hover_->hovered()->place;
  const double pixel = viewer_->view().camera.height_at_target() / std::max(1, viewer_->height());
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(pixel))), 0, 12);
  coordinates_->setText(QStringLiteral("%1, %2, %3")
                            .arg(place.x, 0, 'f', decimals)
                            .arg(place.y, 0, 'f', decimals)
                            .arg(place.z, 0, 'f', decimals));
}

void Main_window_3::show_title() {
  setWindowTitle(tr("%1[*] — Mesecina 3D").arg(files_->title()));
  setWindowModified(document_.is_modified());
}

QString Main_window_3::unsaved_text() const {
  return tr("The mesh, the balls or the points of %1 were changed.").arg(files_->title());
}

void Main_window_3::files_loaded() {
  show_first_view();
  seen_first_.reset();
}

void Main_window_3::show_first_view() {
  if (!viewer_ || !seen_first_) {
    fit();
    return;
  }
  viewer_->set_view(seen_first_->view);
  player_->set_key_frames(seen_first_->key_frames);
  show_view_state();
}

void Main_window_3::add_view(Session& session) const {
  if (!viewer_) return;
  session.view_3 = viewer_->destination();
  session.camera_path = player_->key_frames();
}

void Main_window_3::show_view(const Session& session) {
  if (!viewer_) return;
  player_->set_key_frames(session.camera_path);
  if (!session.view_3) {
    fit();
    return;
  }
  is_view_chosen_ = true;
  viewer_->set_view(*session.view_3);
}

View_3 Main_window_3::first_view() const {
  constexpr Point_3 direction_with_z_up{0.45, -1, 0.3};
  View_3 view = viewer_->view();
  const Box box = bounding_box(document_.inputs());
  const bool is_z_up = viewer_->up().z > 0;
  view.camera = is_z_up ? fit_camera(box, viewer_->width(), viewer_->height(), direction_with_z_up, viewer_->up(),
                                     Camera_3::Projection::perspective)
                        : fit_camera(box, viewer_->width(), viewer_->height());
  return view;
}

void Main_window_3::fit() {
  if (viewer_) viewer_->set_view(first_view());
}

void Main_window_3::finish_drawing() {
  if (viewer_) viewer_->grab_picture();
}

void Main_window_3::escape() {
  if (tool_ && tool_->cancel()) return;
  if (player_ && player_->is_playing()) {
    player_->stop();
    return;
  }
  if (popover_) {
    popover_->dismiss();
  } else if (evolution_.stop()) {
    return;
  } else if (files_->jobs().is_busy()) {
    files_->jobs().cancel();
  } else if (computation_.is_busy() && computing_->isVisible()) {
    computation_.cancel();
  } else if (leave_panel(*canvas_)) {
    return;
  } else if (!editor_->selection().is_empty()) {
    editor_->select({});
  } else {
    messages_->dismiss();
  }
}

void Main_window_3::show_places(const std::vector<Place>& places) {
  Selection_3 selection;
  const auto cloud = document_.inputs().get(cloud_input);
  const auto balls = document_.inputs().get(balls_input);
  for (const Place& place : places) {
    // They may be gone by now.
    if (place.input == cloud_input.id && cloud && place.element < cloud->size())
      selection.points.push_back(place.element);
    if (place.input == balls_input.id && balls && place.element < balls->size())
      selection.balls.push_back(place.element);
  }
  if (!selection.is_empty()) editor_->select(std::move(selection));
  if (viewer_) viewer_->fit(box_around(places, bounding_box(document_.inputs())));
}

}  // namespace mesecina

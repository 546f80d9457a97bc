// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QMenu>
#include <QStyle>
#include <stdexcept>
#include <utility>

#include "app3d/main_window_3.h"
#include "app3d/plane_popover_3.h"
#include "core/formats/format.h"
#include "shell/preferences.h"

namespace mesecina {

namespace {

constexpr double zoom_step = 1.25;
constexpr const char* program = "mesecina3d";

struct Mouse_choice {
  Mouse_preset preset;
  const char* id;
};
constexpr Mouse_choice mouse_choices[] = {{Mouse_preset::standard, "mouse-standard"},
                                          {Mouse_preset::blender, "mouse-blender"},
                                          {Mouse_preset::cad, "mouse-cad"}};

/// Switches that are remembered between runs.
constexpr const char* habits[] = {"free-turning", "z-up", "smooth-flights", "axes", "scale-bar"};

constexpr Point_3 y_up{0, 1, 0};
constexpr Point_3 z_up{0, 0, 1};

QKeySequence pad(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
  return {QKeyCombination(Qt::KeypadModifier | modifiers, key)};
}

}  // namespace

void Main_window_3::make_view_actions() {
  const QString group = tr("View");
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void(Viewer_3&)> run) {
    actions_->add(group, {QLatin1String(id), text, tip, std::move(keys)}, [this, run = std::move(run)] {
      if (viewer_) run(*viewer_);
    });
  };
  add("fit", tr("&Fit"), tr("Show all of the data"), {QKeySequence(Qt::Key_F)},
      [this](Viewer_3& viewer) { viewer.fit(bounding_box(document_.inputs())); });
  add("reset-view", tr("&Reset the view"), tr("Show all of the data from where it was seen first"),
      {QKeySequence(Qt::Key_0)}, [this](Viewer_3& viewer) { viewer.go_to(first_view()); });
  add("previous-view", tr("&Previous view"), tr("Go back to where the view was, also with its cutting plane"),
      {QKeySequence(Qt::Key_Backspace)}, [](Viewer_3& viewer) { viewer.previous_view(); });
  add("zoom-in", tr("Zoom &in"), tr("Larger; the wheel zooms about the cursor"),
      {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)},
      [](Viewer_3& viewer) { viewer.zoom(zoom_step); });
  add("zoom-out", tr("Zoom &out"), tr("Smaller; the wheel zooms about the cursor"),
      {QKeySequence(Qt::Key_Minus), QKeySequence(Qt::CTRL | Qt::Key_Minus)},
      [](Viewer_3& viewer) { viewer.zoom(1 / zoom_step); });
  add("projection", tr("Perspective or orthographi&c"), tr("Parallel lines meet far away, or stay parallel"),
      {pad(Qt::Key_5)}, [](Viewer_3& viewer) {
        viewer.set_projection(viewer.destination().camera.projection == Camera_3::Projection::perspective
                                  ? Camera_3::Projection::orthographic
                                  : Camera_3::Projection::perspective);
      });
  add("copy-view", tr("Cop&y the view"), tr("The view as the text of a view file, to be kept or sent"),
      {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_C)},
      [this](Viewer_3&) { QApplication::clipboard()->setText(QString::fromStdString(view_text())); });
  add("paste-view", tr("P&aste a view"), tr("See the scene as the copied text of a view file says"),
      {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_V)}, [this](Viewer_3&) { paste_view(); });
  make_standard_views();
  make_camera_actions();
  make_plane_actions();
  make_path_actions();
  make_layer_actions();
  make_bundle_actions();
  make_settings_actions();
  make_evolution_actions();
  make_look_actions();
}

void Main_window_3::make_standard_views() {
  struct Standard_view {
    const char* id;
    QString text;
    QString tip;
    QKeySequence key;
    Point_3 with_y_up;  ///< direction towards the viewer
    Point_3 with_z_up;
  };
  const Standard_view standard_views[] = {
      {"view-front",
       tr("&Front"),
       tr("From the front: along -z, or along y where z points upwards"),
       pad(Qt::Key_1),
       {0, 0, 1},
       {0, -1, 0}},
      {"view-back", tr("&Back"), tr("From behind"), pad(Qt::Key_1, Qt::ControlModifier), {0, 0, -1}, {0, 1, 0}},
      {"view-right", tr("&Right"), tr("Along -x"), pad(Qt::Key_3), {1, 0, 0}, {1, 0, 0}},
      {"view-left", tr("&Left"), tr("Along x"), pad(Qt::Key_3, Qt::ControlModifier), {-1, 0, 0}, {-1, 0, 0}},
      {"view-top", tr("&Top"), tr("From above"), pad(Qt::Key_7), {0, 1, 0}, {0, 0, 1}},
      {"view-bottom", tr("Botto&m"), tr("From below"), pad(Qt::Key_7, Qt::ControlModifier), {0, -1, 0}, {0, 0, -1}},
      {"view-isometric",
       tr("&Isometric"),
       tr("Along the diagonal of a cube, from the right, above and the front"),
       pad(Qt::Key_9),
       {1, 1, 1},
       {1, -1, 1}}};
  for (const Standard_view& view : standard_views) {
    actions_->add(tr("View"), {QLatin1String(view.id), view.text, view.tip, {view.key}},
                  [this, y = view.with_y_up, z = view.with_z_up] {
                    if (viewer_) viewer_->look_from(viewer_->up() == z_up ? z : y);
                  });
  }
}

void Main_window_3::make_camera_actions() {
  const QString group = tr("Camera");
  const auto add_switch = [&](const char* id, const QString& text, const QString& tip) {
    actions_->add(group, {QLatin1String(id), text, tip, {}, {}, true}, [this] { store_camera_habits(); });
  };
  add_switch("free-turning", tr("&Free turning"),
             tr("Turn the scene about any direction, like a ball under the mouse; else like a turntable"));
  add_switch("z-up", tr("&Z points upwards"), tr("The scene turns about z, and standard views show it so; else y"));
  add_switch("smooth-flights", tr("&Smooth flights"), tr("The view flies to where a key takes it; else it jumps"));
  add_switch("axes", tr("&Axes"), tr("The directions of the axes in a corner; a click on one looks along it"));
  add_switch("scale-bar", tr("Scale &bar"), tr("A line of a round length in a corner"));
  auto* presets = new QActionGroup(this);
  const auto add_preset = [&](Mouse_preset preset, const char* id, const QString& text, const QString& tip) {
    presets->addAction(actions_->add(group, {QLatin1String(id), text, tip, {}, {}, true}, [this, preset] {
      mouse_ = preset;
      store_camera_habits();
    }));
  };
  add_preset(Mouse_preset::standard, "mouse-standard", tr("&Default mouse"),
             tr("Left turns, middle or Shift with left moves"));
  add_preset(Mouse_preset::blender, "mouse-blender", tr("Mouse of &Blender"),
             tr("Middle turns, with Shift it moves, with Ctrl it zooms"));
  add_preset(Mouse_preset::cad, "mouse-cad", tr("Mouse of &CAD programs"),
             tr("Middle turns, with Ctrl it moves, with Shift it zooms"));
}

void Main_window_3::restore_camera_habits() {
  const Preferences preferences(QString::fromLatin1(program));
  mouse_ = preset_named(preferences.value(QStringLiteral("mouse")).toString());
  for (const Mouse_choice& choice : mouse_choices)
    (*actions_)[QLatin1String(choice.id)]->setChecked(choice.preset == mouse_);
  for (const char* habit : habits) {
    const QString id = QLatin1String(habit);
    const bool usual = id == QLatin1String("axes") || id == QLatin1String("scale-bar") ||
                       (id == QLatin1String("smooth-flights") &&
                        style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) > 0);
    (*actions_)[id]->setChecked(preferences.value(id, usual).toBool());
  }
  apply_camera_habits();
}

void Main_window_3::store_camera_habits() {
  Preferences preferences(QString::fromLatin1(program));
  preferences.set_value(QStringLiteral("mouse"), preset_name(mouse_));
  for (const char* habit : habits)
    preferences.set_value(QLatin1String(habit), (*actions_)[QLatin1String(habit)]->isChecked());
  apply_camera_habits();
}

void Main_window_3::apply_camera_habits() {
  if (!viewer_) return;
  const auto is_on = [this](const char* id) { return (*actions_)[QLatin1String(id)]->isChecked(); };
  constexpr int flight_milliseconds = 250;
  viewer_->set_flight_time(is_on("smooth-flights") ? flight_milliseconds : 0);
  viewer_->set_up(is_on("z-up") ? z_up : y_up);
  viewer_->set_free_turning(is_on("free-turning"));
  viewer_->set_marks(is_on("axes"), is_on("scale-bar"));
  viewer_->set_mouse_preset(mouse_);
}

void Main_window_3::make_plane_actions() {
  const QString group = tr("Cutting plane");
  const auto add = [&](const char* id, const QString& text, const QString& tip, const QKeySequence& key,
                       std::function<void(Plane_handle_3&)> run, bool is_checkable = false) {
    actions_->add(group, {QLatin1String(id), text, tip, {key}, {}, is_checkable}, [this, run = std::move(run)] {
      if (plane_) run(*plane_);
      show_view_state();
    });
  };
  add(
      "cutting-plane", tr("&Cutting plane"),
      tr("Cut the scene open; drag the arrow to move the plane, its frame to turn it"), QKeySequence(Qt::Key_C),
      [](Plane_handle_3& plane) { plane.toggle(); }, true);
  add("plane-settings", tr("&Place and thickness…"), tr("The plane by numbers, and a slab instead of half of space"),
      QKeySequence(Qt::ALT | Qt::Key_C), [this](Plane_handle_3&) { open_plane_popover(); });
  add("plane-x", tr("Across &x"), tr("Turn the cutting plane across the x axis"), QKeySequence(Qt::SHIFT | Qt::Key_X),
      [](Plane_handle_3& plane) {
        plane.align({1, 0, 0});
      });
  add("plane-y", tr("Across &y"), tr("Turn the cutting plane across the y axis"), QKeySequence(Qt::SHIFT | Qt::Key_Y),
      [](Plane_handle_3& plane) {
        plane.align({0, 1, 0});
      });
  add("plane-z", tr("Across &z"), tr("Turn the cutting plane across the z axis"), QKeySequence(Qt::SHIFT | Qt::Key_Z),
      [](Plane_handle_3& plane) {
        plane.align({0, 0, 1});
      });
  add("plane-view", tr("Across the &view"), tr("Turn the cutting plane so that it faces you"),
      QKeySequence(Qt::SHIFT | Qt::Key_V),
      [this](Plane_handle_3& plane) { plane.align(viewer_->destination().camera.axes().back); });
  add("plane-flip", tr("&Flip"), tr("Cut away the other side"), QKeySequence(Qt::SHIFT | Qt::Key_C),
      [](Plane_handle_3& plane) { plane.flip(); });
}

void Main_window_3::make_path_actions() {
  const QString group = tr("Camera path");
  const auto add = [&](const char* id, const QString& text, const QString& tip, const QKeySequence& key,
                       std::function<void(Camera_player_3&)> run, bool is_checkable = false) {
    actions_->add(group, {QLatin1String(id), text, tip, {key}, {}, is_checkable}, [this, run = std::move(run)] {
      if (player_) run(*player_);
      show_view_state();
    });
  };
  add("add-key-frame", tr("&Add key frame"), tr("The camera will come through the present view at last"),
      QKeySequence(Qt::Key_K), [](Camera_player_3& player) { player.add(); });
  add("delete-key-frame", tr("&Delete key frame"), tr("Take away the key frame that is most like the present view"),
      QKeySequence(Qt::SHIFT | Qt::Key_K), [](Camera_player_3& player) { player.remove(); });
  add(
      "play-camera-path", tr("&Play"), tr("Move the camera through the key frames; again: stop it"),
      QKeySequence(Qt::CTRL | Qt::Key_K),
      [](Camera_player_3& player) { player.is_playing() ? player.stop() : player.play(); }, true);
  add(
      "loop-camera-path", tr("&Loop"), tr("Go on from the last key frame to the first"),
      QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_K),
      [this](Camera_player_3& player) {
        player.set_loop((*actions_)[QStringLiteral("loop-camera-path")]->isChecked());
      },
      true);
  add("slower-camera-path", tr("&Slower"), tr("Half as fast from key frame to key frame"),
      QKeySequence(Qt::ALT | Qt::Key_Minus), [](Camera_player_3& player) { player.set_seconds(2 * player.seconds()); });
  add("faster-camera-path", tr("&Faster"), tr("Twice as fast from key frame to key frame"),
      QKeySequence(Qt::ALT | Qt::Key_Plus), [](Camera_player_3& player) { player.set_seconds(player.seconds() / 2); });
}

void Main_window_3::add_view_menus(QMenu* view) const {
  actions_->add_to(view, {"fit", "reset-view", "previous-view", "zoom-in", "zoom-out", "projection", "-"});
  const auto add_menu = [&](QMenu* parent, const QString& title, const QStringList& ids) {
    QMenu* menu = parent->addMenu(title);
    menu->setToolTipsVisible(true);
    actions_->add_to(menu, ids);
    return menu;
  };
  add_menu(view, tr("&Standard views"),
           {"view-front", "view-back", "view-right", "view-left", "view-top", "view-bottom", "view-isometric"});
  add_menu(view, tr("Cuttin&g plane"),
           {"cutting-plane", "plane-settings", "-", "plane-x", "plane-y", "plane-z", "plane-view", "plane-flip"});
  add_menu(view, tr("Camera &path"),
           {"add-key-frame", "delete-key-frame", "-", "play-camera-path", "loop-camera-path", "slower-camera-path",
            "faster-camera-path"});
  QMenu* camera = add_menu(view, tr("Ca&mera and mouse"), {"free-turning", "z-up", "smooth-flights", "-"});
  actions_->add_to(camera, {"mouse-standard", "mouse-blender", "mouse-cad", "-", "axes", "scale-bar"});
  actions_->add_to(view, {"copy-view", "paste-view"});
}

void Main_window_3::show_view_state() {
  const bool has_plane = viewer_ && viewer_->view().cutting_plane.has_value();
  const std::size_t frames = player_ ? player_->key_frames().size() : 0;
  const auto action = [this](const char* id) { return (*actions_)[QLatin1String(id)]; };
  action("cutting-plane")->setChecked(has_plane);
  action("plane-flip")->setEnabled(has_plane);
  action("delete-key-frame")->setEnabled(frames > 0);
  action("play-camera-path")->setEnabled(frames > 1);
  action("play-camera-path")->setChecked(player_ && player_->is_playing());
}

void Main_window_3::open_plane_popover() {
  if (popover_) popover_->dismiss();
  if (!viewer_->view().cutting_plane) plane_->toggle();
  open_popover(make_plane_popover(*plane_, *viewer_, *actions_));
}

std::string Main_window_3::view_text() const { return to_json(viewer_->destination(), player_->key_frames()); }

void Main_window_3::read_view(const std::string& text) {
  const View_3 view = parse_view_3(text);
  std::vector<Camera_3> key_frames = parse_camera_path_3(text);
  viewer_->go_to(view);
  if (!key_frames.empty()) player_->set_key_frames(std::move(key_frames));
}

void Main_window_3::save_view() {
  if (!viewer_) return;
  const QString path =
      files_->choose_for_writing(tr("Save view"), files_->stem() + QStringLiteral(".view"), tr("View (*.json)"));
  if (path.isEmpty()) return;
  try {
    write_file(path.toStdString(), [&](std::ostream& stream) { stream << view_text(); });
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::error, QString::fromUtf8(error.what()));
  }
}

void Main_window_3::open_view() {
  if (!viewer_) return;
  const QString path = QFileDialog::getOpenFileName(this, tr("Open view"), {}, tr("View (*.json)"));
  if (path.isEmpty()) return;
  QFile file(path);
  try {
    if (!file.open(QIODevice::ReadOnly)) throw std::invalid_argument("the file cannot be read");
    read_view(file.readAll().toStdString());
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::error, tr("%1: %2").arg(path, QString::fromUtf8(error.what())));
  }
}

void Main_window_3::paste_view() {
  try {
    read_view(QApplication::clipboard()->text().toStdString());
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::error, tr("The copied text is no view: %1").arg(QString::fromUtf8(error.what())));
  }
}

}  // namespace mesecina

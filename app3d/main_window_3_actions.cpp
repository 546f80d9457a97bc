// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QMenu>
#include <QMenuBar>
#include <map>

#include "app3d/main_window_3.h"
#include "core/formats/format.h"
#include "shell/key_sheet.h"
#include "shell/tool_icons.h"

namespace mesecina {

void Main_window_3::make_actions() {
  begin_actions();
  make_file_actions();
  make_save_actions();
  make_undo_actions(tool_icon(Tool_icon::undo), tool_icon(Tool_icon::redo));
  make_edit_actions();
  actions_->add(tr("Edit"),
                {QStringLiteral("escape"),
                 tr("Cancel or deselect"),
                 tr("Cancel what is going on; if nothing is, select nothing"),
                 {QKeySequence(Qt::Key_Escape)}},
                [this] { escape(); });
  actions_->add(tr("Edit"),
                {QStringLiteral("copy-facts"),
                 tr("Copy &facts"),
                 tr("Copy what is known of the element under the mouse"),
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)}},
                [this] {
                  if (hover_ && !hover_->text().isEmpty()) QApplication::clipboard()->setText(hover_->text());
                });
  make_tool_actions();
  make_insert_actions();
  make_view_actions();
  make_recording();
  make_help_actions();
}

void Main_window_3::make_file_actions() {
  const QString group = tr("File");
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run) {
    actions_->add(group, {QLatin1String(id), text, tip, std::move(keys)}, std::move(run));
  };
  add("open", tr("&Open…"), tr("Replace the data by that of files; they can also be dropped on the window"),
      {QKeySequence(Qt::CTRL | Qt::Key_O)}, [this] { files_->choose_and_open(false); });
  add("add-file", tr("&Add file…"), tr("Add the data of files to what there is, as dropping with Ctrl does"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)}, [this] { files_->choose_and_open(true); });
  make_picture_actions();
  add("export-layers", tr("Export &layers…"), tr("Write the visible layers as data: JSON and PLY"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)}, [this] { export_layers(); });
  add("save-view", tr("Save &view…"),
      tr("Write where the scene is seen from, cutting plane and key frames, for --view and for later"),
      {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_S)}, [this] { save_view(); });
  add("open-view", tr("Open v&iew…"), tr("See the scene from where a view file says"),
      {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_O)}, [this] { open_view(); });
  make_session_actions();
  add("quit", tr("&Quit"), tr("Close the window"), {QKeySequence(Qt::CTRL | Qt::Key_Q)}, [this] { close(); });
}

void Main_window_3::make_help_actions() {
  make_command_actions();
  const QString help = tr("Help");
  actions_->add(help,
                {QStringLiteral("keys"),
                 tr("&Keys and mouse"),
                 tr("Every key and what the mouse does"),
                 {QKeySequence(Qt::Key_Question)}},
                [this] {
                  std::vector<Gesture> gestures = camera_gestures(mouse_);
                  for (const Gesture& gesture :
                       {Gesture{tr("Wheel"), tr("Zoom about the cursor")},
                        Gesture{tr("Double click"), tr("Turn about this place from now on")},
                        Gesture{tr("Click on an axis"), tr("Look along it")},
                        Gesture{tr("Drag the arrow of the cutting plane, Ctrl + wheel"), tr("Move the plane")},
                        Gesture{tr("Drag the frame of the cutting plane"), tr("Turn the plane")},
                        Gesture{tr("Click, drag on a ball or point (select)"), tr("Select it, move it")},
                        Gesture{tr("Shift, Ctrl while moving"), tr("Keep to an axis, stay on the surface")},
                        Gesture{tr("Shift, Ctrl + drag on nothing (select)"), tr("Select in a rectangle, toggle")},
                        Gesture{tr("Handle of a ball, Shift + wheel"), tr("Resize the selected balls")},
                        Gesture{tr("Click (add)"), tr("Add a point or a ball there")},
                        Gesture{tr("Rest on something"), tr("See what it is")},
                        Gesture{tr("Drop a file"), tr("Open it; with Ctrl or Shift: add it")}})
                    gestures.push_back(gesture);
                  make_key_sheet(*actions_, gestures, this);
                });
  actions_->add(help, {QStringLiteral("about"), tr("&About Mesecina"), tr("Version, licence, graphics")}, [this] {
    make_about(
        tr("Mesecina 3D"),
        {tr("Version %1").arg(QCoreApplication::applicationVersion()), tr("Qt %1").arg(QLatin1String(qVersion())),
         tr("Canvas: %1").arg(viewer_ ? viewer_->description() : tr("none"))},
        this);
  });
}

void Main_window_3::make_menus() {
  const auto menu = [this](const QString& title) { return menuBar()->addMenu(title); };
  QMenu* file = menu(tr("&File"));
  file->setToolTipsVisible(true);
  actions_->add_to(file, {"new", "open", "add-file"});
  file->addMenu(recent_files_);
  add_earlier_scenes(file);
  actions_->add_to(file, {"-", "save", "save-as", "save-session"});
  QMenu* parts = file->addMenu(tr("Save a pa&rt"));
  actions_->add_to(parts, {"save-mesh", "save-balls", "save-points"});
  actions_->add_to(file, {"-", "export-picture", "copy-picture", "record", "pictures-with-scene", "export-layers", "-",
                          "save-view", "open-view", "-", "reopen-last-scene", "quit"});
  make_editing_menus();
  QMenu* view = menu(tr("&View"));
  add_view_menus(view);
  actions_->add_to(view, {"-", "toggle-layers", "solo-layers", "show-all-layers", "find-layer", "find-setting", "-"});
  add_bundle_menu(view);
  actions_->add_to(view, {"show-statistics", "show-log"});
  add_look_menus(view);
  add_evolution_menu();
  // Alt+H shows all layers.
  QMenu* help = menu(tr("Hel&p"));
  actions_->add_to(help, {"manual", "palette", "keys", "shortcuts", "whats-this", "-", "about"});
}

Film_frame Main_window_3::picture_frame(const QSize&, const QSize&) const {
  return {computation_.scene(background()), {}, viewer_ ? viewer_->view() : seen_view()};
}

void Main_window_3::export_layers() {
  const QString folder = files_->choose_folder(tr("Export layers into a folder"));
  if (folder.isEmpty()) return;
  std::map<std::string, Setting_value> settings;
  for (const Setting_spec& spec : registry_->settings())
    settings[spec.id] = registry_->value(document_.settings(), spec.id);
  std::map<std::string, QString> reasons;
  for (const Layer_entry& entry : document_.layers()) reasons[entry.id] = computation_.status(entry.id).reason;
  files_->export_layers(folder, computation_.scene({255, 255, 255}), {"json", "ply"}, settings, reasons);
}

}  // namespace mesecina

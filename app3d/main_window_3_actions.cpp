// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <map>

#include "app3d/main_window_3.h"
#include "core/formats/format.h"
#include "shell/key_sheet.h"

namespace mesecina {

namespace {

constexpr double zoom_step = 1.25;

}  // namespace

void Main_window_3::make_actions() {
  begin_actions();
  make_file_actions();
  make_undo_actions({}, {});
  actions_->add(tr("Edit"),
                {QStringLiteral("escape"), tr("Cancel"), tr("Cancel what is going on"), {QKeySequence(Qt::Key_Escape)}},
                [this] { escape(); });
  actions_->add(tr("Edit"),
                {QStringLiteral("copy-facts"),
                 tr("Copy &facts"),
                 tr("Copy what is known of the element under the mouse"),
                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)}},
                [this] {
                  if (hover_ && !hover_->text().isEmpty()) QApplication::clipboard()->setText(hover_->text());
                });
  make_view_actions();
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
  add("export-picture", tr("Export &picture…"), tr("Write what is in view as PNG"),
      {QKeySequence(Qt::CTRL | Qt::Key_E)}, [this] { export_picture(); });
  add("export-layers", tr("Export &layers…"), tr("Write the visible layers as data: JSON and PLY"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)}, [this] { export_layers(); });
  add("save-view", tr("Save &view…"), tr("Write where the scene is seen from, for --view and for later"), {},
      [this] { save_view(); });
  add("open-view", tr("Open v&iew…"), tr("See the scene from where a view file says"), {}, [this] { open_view(); });
  add("quit", tr("&Quit"), tr("Close the window"), {QKeySequence(Qt::CTRL | Qt::Key_Q)}, [this] { close(); });
}

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
      {QKeySequence(Qt::Key_0)}, [this](Viewer_3&) { fit(); });
  add("zoom-in", tr("Zoom &in"), tr("Larger; the wheel zooms about the cursor"),
      {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)},
      [](Viewer_3& viewer) { viewer.zoom(zoom_step); });
  add("zoom-out", tr("Zoom &out"), tr("Smaller; the wheel zooms about the cursor"),
      {QKeySequence(Qt::Key_Minus), QKeySequence(Qt::CTRL | Qt::Key_Minus)},
      [](Viewer_3& viewer) { viewer.zoom(1 / zoom_step); });
  add("projection", tr("Perspective or &orthographic"), tr("Parallel lines meet far away, or stay parallel"),
      {QKeySequence(Qt::KeypadModifier | Qt::Key_5), QKeySequence(Qt::Key_5)}, [](Viewer_3& viewer) {
        viewer.set_projection(viewer.view().camera.projection == Camera_3::Projection::perspective
                                  ? Camera_3::Projection::orthographic
                                  : Camera_3::Projection::perspective);
      });
  struct Standard_view {
    const char* id;
    QString text;
    QString tip;
    QKeySequence key;
    Point_3 direction;
    Point_3 up;
  };
  const Qt::KeyboardModifiers pad = Qt::KeypadModifier;
  const Qt::KeyboardModifiers opposite = Qt::KeypadModifier | Qt::ControlModifier;
  const Standard_view standard_views[] = {{"view-front",
                                           tr("Fro&nt"),
                                           tr("Look along -z"),
                                           QKeySequence(QKeyCombination(pad, Qt::Key_1)),
                                           {0, 0, 1},
                                           {0, 1, 0}},
                                          {"view-back",
                                           tr("&Back"),
                                           tr("Look along z"),
                                           QKeySequence(QKeyCombination(opposite, Qt::Key_1)),
                                           {0, 0, -1},
                                           {0, 1, 0}},
                                          {"view-right",
                                           tr("Ri&ght"),
                                           tr("Look along -x"),
                                           QKeySequence(QKeyCombination(pad, Qt::Key_3)),
                                           {1, 0, 0},
                                           {0, 1, 0}},
                                          {"view-left",
                                           tr("&Left"),
                                           tr("Look along x"),
                                           QKeySequence(QKeyCombination(opposite, Qt::Key_3)),
                                           {-1, 0, 0},
                                           {0, 1, 0}},
                                          {"view-top",
                                           tr("&Top"),
                                           tr("Look along -y"),
                                           QKeySequence(QKeyCombination(pad, Qt::Key_7)),
                                           {0, 1, 0},
                                           {0, 0, -1}},
                                          {"view-bottom",
                                           tr("Botto&m"),
                                           tr("Look along y"),
                                           QKeySequence(QKeyCombination(opposite, Qt::Key_7)),
                                           {0, -1, 0},
                                           {0, 0, 1}}};
  for (const Standard_view& view : standard_views)
    add(view.id, view.text, view.tip, {view.key},
        [direction = view.direction, up = view.up](Viewer_3& viewer) { viewer.look_from(direction, up); });
  make_layer_actions();
  make_look_actions();
}

void Main_window_3::make_help_actions() {
  const QString help = tr("Help");
  actions_->add(help,
                {QStringLiteral("keys"),
                 tr("&Keys and mouse"),
                 tr("Every key and what the mouse does"),
                 {QKeySequence(Qt::Key_Question), QKeySequence(Qt::Key_F1)}},
                [this] {
                  const std::vector<Gesture> gestures = {
                      {tr("Left"), tr("Turn the scene")},
                      {tr("Middle, Shift + left"), tr("Move the view")},
                      {tr("Wheel, pinch"), tr("Zoom about the cursor")},
                      {tr("Double click"), tr("Turn about this place from now on")},
                      {tr("Rest on something"), tr("See what it is")},
                      {tr("Drop a file"), tr("Open it; with Ctrl or Shift: add it")},
                  };
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
  actions_->add_to(file, {"open", "add-file"});
  file->addMenu(recent_files_);
  actions_->add_to(file, {"-", "export-picture", "export-layers", "-", "save-view", "open-view", "-", "quit"});
  QMenu* edit = menu(tr("&Edit"));
  actions_->add_to(edit, {"undo", "redo", "-", "escape", "copy-facts"});
  QMenu* view = menu(tr("&View"));
  actions_->add_to(view, {"fit", "reset-view", "zoom-in", "zoom-out", "projection", "-"});
  QMenu* standard = view->addMenu(tr("&Standard views"));
  actions_->add_to(standard, {"view-front", "view-back", "view-right", "view-left", "view-top", "view-bottom"});
  actions_->add_to(view, {"-", "toggle-layers", "solo-layers", "show-all-layers", "find-layer", "-"});
  add_look_menus(view);
  // Alt+H shows all layers.
  QMenu* help = menu(tr("Hel&p"));
  actions_->add_to(help, {"keys", "about"});
}

void Main_window_3::export_picture() {
  if (!viewer_) return;
  const QString path = files_->choose_for_writing(tr("Export picture"), files_->stem(), tr("PNG picture (*.png)"));
  if (path.isEmpty()) return;
  const QSize size = (QSizeF(viewer_->size()) * viewer_->devicePixelRatioF()).toSize();
  files_->export_picture(path, computation_.scene(background()), viewer_->view(), size.width(), size.height());
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

void Main_window_3::save_view() {
  if (!viewer_) return;
  const QString path =
      files_->choose_for_writing(tr("Save view"), files_->stem() + QStringLiteral(".view"), tr("View (*.json)"));
  if (path.isEmpty()) return;
  try {
    write_file(path.toStdString(), [&](std::ostream& stream) { stream << to_json(viewer_->view()); });
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
    viewer_->set_view(parse_view_3(file.readAll().toStdString()));
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::error, tr("%1: %2").arg(path, QString::fromUtf8(error.what())));
  }
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSpinBox>
#include <QToolBar>

#include "app2d/generators_2.h"
#include "app2d/main_window_2.h"
#include "app2d/popovers_2.h"
#include "shell/key_sheet.h"
#include "shell/preferences.h"
#include "shell/tool_icons.h"

namespace mesecina {

namespace {

constexpr double zoom_step = 1.25;

QString generator_text(const char* text) { return QCoreApplication::translate("generators", text); }

}  // namespace

void Main_window_2::make_actions() {
  begin_actions();
  make_file_actions();
  make_edit_actions();
  make_tool_actions();
  make_view_actions();
  make_recording();
}

void Main_window_2::make_file_actions() {
  const QString group = tr("File");
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run) {
    actions_->add(group, {QLatin1String(id), text, tip, std::move(keys)}, std::move(run));
  };
  add("new", tr("&New"), tr("Start with an empty plane"), {QKeySequence(Qt::CTRL | Qt::Key_N)},
      [this] { files_->new_document(); });
  add("open", tr("&Open…"), tr("Replace the data by that of files; they can also be dropped on the window"),
      {QKeySequence(Qt::CTRL | Qt::Key_O)}, [this] { files_->choose_and_open(false); });
  add("add-file", tr("&Add file…"), tr("Add the data of files to what there is, as dropping with Ctrl does"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)}, [this] { files_->choose_and_open(true); });
  add("save", tr("&Save"), tr("Save the points, the outline or the disks"), {QKeySequence(Qt::CTRL | Qt::Key_S)},
      [this] { files_->save(); });
  add("save-as", tr("Save &as…"), tr("Save the points, the outline or the disks into another file"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)}, [this] { files_->save_as(); });
  add("save-points", tr("&Points…"), tr("Save the points alone"), {},
      [this] { files_->save_part_as(std::string(points_input.id)); });
  add("save-outline", tr("&Outline…"), tr("Save the outline alone"), {},
      [this] { files_->save_part_as(std::string(outline_input.id)); });
  add("save-disks", tr("&Disks…"), tr("Save the disks alone"), {},
      [this] { files_->save_part_as(std::string(disks_input.id)); });
  make_picture_actions();
  add("export-layers", tr("Export &layers…"), tr("Write the visible layers as data: JSON, CSV, OBJ, PLY"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)}, [this] { export_layers(); });
  make_session_actions();
  add("quit", tr("&Quit"), tr("Close the window"), {QKeySequence(Qt::CTRL | Qt::Key_Q)}, [this] { close(); });
}

void Main_window_2::make_edit_actions() {
  const QString group = tr("Edit");
  make_undo_actions(tool_icon(Tool_icon::undo), tool_icon(Tool_icon::redo));
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run, QWidget* scope = nullptr) {
    actions_->add(group, {QLatin1String(id), text, tip, std::move(keys), {}, false, scope}, std::move(run));
  };
  add("cut", tr("Cu&t"), tr("Copy the selected points and disks as text and delete them"),
      {QKeySequence(Qt::CTRL | Qt::Key_X)}, [this] { editor_->cut(); });
  add("copy", tr("&Copy"), tr("Copy the selected points and disks as text, one \"x y\" or \"x y radius\" per line"),
      {QKeySequence(Qt::CTRL | Qt::Key_C)}, [this] { editor_->copy(); });
  add("paste", tr("&Paste"),
      tr("Add points or disks from text: lines of \"x y\" or \"x y radius\", also from a spreadsheet"),
      {QKeySequence(Qt::CTRL | Qt::Key_V)}, [this] { editor_->paste(); });
  add("duplicate", tr("D&uplicate"), tr("Copies of the selected points and disks beside them"),
      {QKeySequence(Qt::CTRL | Qt::Key_D)}, [this] { editor_->duplicate(); });
  add("delete", tr("&Delete"), tr("Delete the selected points, vertices and disks"), {QKeySequence(Qt::Key_Delete)},
      [this] { editor_->remove_selected(); });
  add("select-all", tr("Select &all"), tr("Select all points, vertices and disks that are shown"),
      {QKeySequence(Qt::CTRL | Qt::Key_A)}, [this] { editor_->select_all(); });
  add("escape", tr("Cancel or deselect"), tr("Cancel what is going on; if nothing is, select nothing"),
      {QKeySequence(Qt::Key_Escape)}, [this] { escape(); });
  add("coordinates", tr("E&xact coordinates…"),
      tr("Type the coordinates of the selected point, or center and radius of the disk"),
      {QKeySequence(Qt::CTRL | Qt::Key_Return)}, [this] {
        if (popover_) popover_->dismiss();
        open_popover(open_coordinates_popover(*editor_, canvas_));
      });
  add("copy-facts", tr("Copy &facts"), tr("Copy what is known of the element under the mouse"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)}, [this] {
        if (!hover_->facts_text().isEmpty()) QApplication::clipboard()->setText(hover_->facts_text());
      });
  add(
      "complete-outline", tr("Close the outline"), tr("Close the outline that is being drawn"),
      {QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)}, [this] { tool_->complete(); }, canvas_);

  make_nudge_actions([this](int right, int up) {
    const double step = 1 / canvas_->view().scale;
    editor_->nudge(right * step, up * step);
    return !editor_->selection().is_empty();
  });
}

void Main_window_2::make_tool_actions() {
  const QString group = tr("Tools");
  auto* choices = new QActionGroup(this);
  const auto add = [&](const char* id, const QString& text, const QString& tip, Qt::Key key, Tool_icon icon,
                       Tool_2* tool) {
    const QString name = QLatin1String(id);
    tools_[name] = tool;
    QAction* action = actions_->add(group, {name, text, tip, {QKeySequence(key)}, tool_icon(icon), true},
                                    [this, name] { use_tool(name); });
    choices->addAction(action);
  };
  add("tool-select", tr("&Select and move"),
      tr("Click selects, drag moves, resizes or draws a box, double click adds a point"), Qt::Key_V, Tool_icon::select,
      new Select_tool_2(*editor_));
  add("tool-insert", tr("Add &points"), tr("Every click adds a point"), Qt::Key_P, Tool_icon::insert,
      new Insert_tool_2(*editor_));
  auto* spray = new Spray_tool_2(*editor_);
  add("tool-spray", tr("Spra&y points"), tr("Drag leaves points behind, a spacing apart"), Qt::Key_B, Tool_icon::spray,
      spray);
  add("tool-outline", tr("Draw an &outline"), tr("Click sets vertices, drag draws freely, double click closes"),
      Qt::Key_O, Tool_icon::outline, new Outline_tool_2(*editor_));
  add("tool-disk", tr("Draw &disks"),
      tr("Drag from the center to the radius; click repeats the last, Ctrl+drag sprays"), Qt::Key_D, Tool_icon::disk,
      new Disk_tool_2(*editor_));
  add("tool-pan", tr("&Move the view"), tr("Drag moves the view, as the middle button does with every tool"), Qt::Key_M,
      Tool_icon::pan, new Pan_tool_2(*editor_));
}

void Main_window_2::make_view_actions() {
  const QString group = tr("View");
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run) {
    return actions_->add(group, {QLatin1String(id), text, tip, std::move(keys)}, std::move(run));
  };
  QAction* fit = add("fit", tr("&Fit"), tr("Show all of the data"), {QKeySequence(Qt::Key_F), QKeySequence(Qt::Key_0)},
                     [this] { canvas_->fit(bounding_box(document_.inputs())); });
  fit->setIcon(tool_icon(Tool_icon::fit));
  add("previous-view", tr("&Previous view"), tr("Go back to where the view was"), {QKeySequence(Qt::Key_Backspace)},
      [this] { canvas_->previous_view(); });
  add("zoom-in", tr("Zoom &in"), tr("Larger; the wheel zooms about the cursor"),
      {QKeySequence(Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Plus), QKeySequence(Qt::CTRL | Qt::Key_Equal)},
      [this] { canvas_->zoom(zoom_step); });
  add("zoom-out", tr("Zoom &out"), tr("Smaller; the wheel zooms about the cursor"),
      {QKeySequence(Qt::Key_Minus), QKeySequence(Qt::CTRL | Qt::Key_Minus)}, [this] { canvas_->zoom(1 / zoom_step); });
  make_layer_actions();
  make_bundle_actions();
  make_settings_actions();
  make_evolution_actions();
  make_look_actions();

  make_command_actions();
  const QString help = tr("Help");
  actions_->add(help,
                {QStringLiteral("keys"),
                 tr("&Keys and mouse"),
                 tr("Every key and what the mouse does"),
                 {QKeySequence(Qt::Key_Question)}},
                [this] {
                  const std::vector<Gesture> gestures = {
                      {tr("Left"), tr("Select, move, or what the tool does")},
                      {tr("Left on nothing"), tr("Draw a selection box")},
                      {tr("Shift, Ctrl + click"), tr("Add to the selection, toggle")},
                      {tr("Shift while moving"), tr("Keep to one axis")},
                      {tr("Double click"), tr("Add a point; close an outline")},
                      {tr("Right"), tr("Menu")},
                      {tr("Middle, Space + left"), tr("Move the view")},
                      {tr("Wheel, pinch"), tr("Zoom about the cursor")},
                      {tr("Wheel on a selected disk"), tr("Resize; Shift: finely, Ctrl: zoom")},
                      {tr("Handle of a disk"), tr("Resize the selected disks")},
                      {tr("Ctrl + drag (disks)"), tr("Spray disks of the last radius")},
                      {tr("Rest on something"), tr("See what it is")},
                      {tr("Drop a file"), tr("Open it; with Ctrl or Shift: add it")},
                  };
                  make_key_sheet(*actions_, gestures, this);
                });
  actions_->add(help, {QStringLiteral("about"), tr("&About Mesecina"), tr("Version, licence, graphics")}, [this] {
    make_about(tr("Mesecina 2D"),
               {tr("Version %1").arg(QCoreApplication::applicationVersion()),
                tr("Qt %1").arg(QLatin1String(qVersion())), tr("Canvas: %1").arg(canvas_->backend_name())},
               this);
  });
}

void Main_window_2::make_menus() {
  const auto menu = [this](const QString& title) { return menuBar()->addMenu(title); };
  QMenu* file = menu(tr("&File"));
  file->setToolTipsVisible(true);
  actions_->add_to(file, {"new", "open", "add-file"});
  file->addMenu(recent_files_);
  QMenu* examples = file->addMenu(tr("Open &example"));
  for (const QString& name : Files_2::examples()) {
    if (formats_->reader_for(name.toStdString()))
      examples->addAction(name, this, [this, name] { files_->open_example(name); });
  }
  add_earlier_scenes(file);
  actions_->add_to(file, {"-", "save", "save-as", "save-session"});
  QMenu* parts = file->addMenu(tr("Save a pa&rt"));
  actions_->add_to(parts, {"save-points", "save-outline", "save-disks"});
  actions_->add_to(file, {"-", "export-picture", "copy-picture", "record", "pictures-with-scene", "export-layers", "-",
                          "reopen-last-scene", "quit"});

  QMenu* edit = menu(tr("&Edit"));
  actions_->add_to(edit, {"undo", "redo", "-", "cut", "copy", "paste", "duplicate", "delete", "-", "select-all",
                          "escape", "-", "coordinates", "copy-facts"});

  QMenu* insert = menu(tr("&Insert"));
  insert->setToolTipsVisible(true);
  QMenu* degenerate = nullptr;
  QMenu* disks = nullptr;
  for (const Generator_2& generator : generators_2()) {
    const QString id = QStringLiteral("insert-") + QString::fromStdString(generator.id);
    QAction* action = actions_->add(
        tr("Insert"), {id, generator_text(generator.label) + QStringLiteral("…"), generator_text(generator.tip)},
        [this, &generator] { generate(generator); });
    if (generator.make_disks && !disks) disks = insert->addMenu(tr("D&isks"));
    if (generator.id == "collinear") degenerate = insert->addMenu(tr("&Degenerate sets"));
    QMenu* place = degenerate ? degenerate : insert;
    (generator.make_disks ? disks : place)->addAction(action);
  }

  QMenu* tools = menu(tr("&Tools"));
  actions_->add_to(tools, {"tool-select", "tool-insert", "tool-spray", "tool-outline", "tool-disk", "tool-pan"});

  QMenu* view = menu(tr("&View"));
  actions_->add_to(view, {"fit", "previous-view", "zoom-in", "zoom-out", "-", "toggle-layers", "solo-layers",
                          "show-all-layers", "find-layer", "find-setting", "-"});
  add_bundle_menu(view);
  actions_->add_to(view, {"show-statistics", "show-log"});
  add_look_menus(view);
  add_evolution_menu();

  // Alt+H shows all layers.
  QMenu* help = menu(tr("Hel&p"));
  actions_->add_to(help, {"manual", "palette", "keys", "shortcuts", "whats-this", "-", "about"});
}

void Main_window_2::make_tool_bar() {
  auto* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tool-bar"));
  bar->setMovable(false);
  actions_->add_to(bar, {"tool-select", "tool-insert", "tool-spray", "tool-outline", "tool-disk", "tool-pan", "-",
                         "undo", "redo", "-", "fit"});
  auto* spray = static_cast<Spray_tool_2*>(tools_.at(QStringLiteral("tool-spray")));
  auto* spacing = new QSpinBox(bar);
  constexpr int widest = 200;
  spacing->setRange(1, widest);
  spacing->setValue(static_cast<int>(spray->spacing()));
  spacing->setPrefix(tr("Spacing "));
  spacing->setSuffix(tr(" px"));
  spacing->setAccessibleName(tr("Spacing of sprayed points and disks"));
  spacing->setToolTip(tr("Least distance between sprayed points or centers of sprayed disks"));
  auto* disks = static_cast<Disk_tool_2*>(tools_.at(QStringLiteral("tool-disk")));
  connect(spacing, &QSpinBox::valueChanged, spray, [spray, disks](int pixels) {
    spray->set_spacing(pixels);
    disks->set_spacing(pixels);
  });
  spacing_action_ = bar->addWidget(spacing);
}

void Main_window_2::open_menu(const QPointF& pixel) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  actions_->add_to(menu, {"delete", "duplicate", "coordinates", "-", "copy", "paste", "-", "select-all", "fit"});
  menu->popup(canvas_->mapToGlobal(pixel.toPoint()));
}

Film_frame Main_window_2::picture_frame(const QSize& size, const QSize& seen) const {
  View_2 view = canvas_->view();
  view.scale *= std::min(double(size.width()) / seen.width(), double(size.height()) / seen.height());
  return {computation_.scene(background()), view, {}};
}

void Main_window_2::export_layers() {
  if (popover_) popover_->dismiss();
  open_popover(open_layers_popover(*formats_, canvas_, [this](const std::vector<std::string>& formats) {
    const QString folder = files_->choose_folder(tr("Export layers into a folder"));
    if (folder.isEmpty()) return;
    std::map<std::string, Setting_value> settings;
    for (const Setting_spec& spec : registry_->settings())
      settings[spec.id] = registry_->value(document_.settings(), spec.id);
    std::map<std::string, QString> reasons;
    for (const Layer_entry& entry : document_.layers()) reasons[entry.id] = computation_.status(entry.id).reason;
    files_->export_layers(folder, computation_.scene({255, 255, 255}), formats, settings, reasons);
  }));
}

}  // namespace mesecina

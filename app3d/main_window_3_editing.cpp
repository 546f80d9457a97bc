// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QCoreApplication>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <algorithm>

#include "app3d/main_window_3.h"
#include "app3d/marks_3.h"
#include "app3d/popovers_3.h"
#include "shell/tool_icons.h"

namespace mesecina {

namespace {

QString generator_text(const char* text) { return QCoreApplication::translate("generators", text); }

}  // namespace

void Main_window_3::make_save_actions() {
  const QString group = tr("File");
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run) {
    actions_->add(group, {QLatin1String(id), text, tip, std::move(keys)}, std::move(run));
  };
  add("new", tr("&New"), tr("Start with an empty space"), {QKeySequence(Qt::CTRL | Qt::Key_N)},
      [this] { files_->new_document(); });
  add("save", tr("&Save"), tr("Save the mesh, the balls or the points"), {QKeySequence(Qt::CTRL | Qt::Key_S)},
      [this] { files_->save(); });
  add("save-as", tr("Save &as…"), tr("Save the mesh, the balls or the points into another file"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S)}, [this] { files_->save_as(); });
  add("save-mesh", tr("&Mesh…"), tr("Save the mesh alone"), {},
      [this] { files_->save_part_as(std::string(mesh_input.id)); });
  add("save-balls", tr("&Balls…"), tr("Save the balls alone"), {},
      [this] { files_->save_part_as(std::string(balls_input.id)); });
  add("save-points", tr("&Points…"), tr("Save the points alone"), {},
      [this] { files_->save_part_as(std::string(cloud_input.id)); });
}

void Main_window_3::make_edit_actions() {
  const QString group = tr("Edit");
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run, QWidget* scope = nullptr) {
    actions_->add(group, {QLatin1String(id), text, tip, std::move(keys), {}, false, scope}, std::move(run));
  };
  add("delete", tr("&Delete"), tr("Delete the selected balls and points"), {QKeySequence(Qt::Key_Delete)},
      [this] { editor_->remove_selected(); });
  add("cut", tr("Cu&t"), tr("Copy the selected balls and points as text and delete them"),
      {QKeySequence(Qt::CTRL | Qt::Key_X)}, [this] { editor_->cut(); });
  add("copy", tr("&Copy"),
      tr("Copy the selected balls and points as text, one \"x y z radius\" or \"x y z\" per line, as spreadsheets do"),
      {QKeySequence(Qt::CTRL | Qt::Key_C)}, [this] { editor_->copy(); });
  add("paste", tr("&Paste"), tr("Add balls or points from text, one \"x y z radius\" or \"x y z\" per line"),
      {QKeySequence(Qt::CTRL | Qt::Key_V)}, [this] { editor_->paste(); });
  add("duplicate", tr("D&uplicate"), tr("Copies of the selected balls and points beside them"),
      {QKeySequence(Qt::CTRL | Qt::Key_D)}, [this] {
        if (!viewer_) return;
        constexpr double share = 0.03;
        const Camera_3 camera = viewer_->view().camera;
        editor_->duplicate((share * camera.height_at_target()) * (camera.axes().right - camera.axes().up));
      });
  add("select-all", tr("Select &all"), tr("Select all balls and points that are shown"),
      {QKeySequence(Qt::CTRL | Qt::Key_A)}, [this] { editor_->select_all(); });
  add("select-none", tr("Select &none"), tr("Select nothing; so does Esc, and a click where nothing is"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A)}, [this] { editor_->select({}); });
  add("invert-selection", tr("&Invert the selection"), tr("Select what is shown and not selected, and nothing else"),
      {QKeySequence(Qt::CTRL | Qt::Key_I)}, [this] { editor_->invert_selection(); });
  add("coordinates", tr("E&xact coordinates…"),
      tr("Type the coordinates of the selected point, or center and radius of the ball"),
      {QKeySequence(Qt::CTRL | Qt::Key_Return)}, [this] {
        if (popover_) popover_->dismiss();
        open_popover(open_coordinates_popover_3(*editor_, canvas_));
      });
  add("transform", tr("&Transform…"), tr("Move, turn, scale, mirror, center or normalize all of the data"),
      {QKeySequence(Qt::CTRL | Qt::Key_T)}, [this] {
        if (popover_) popover_->dismiss();
        open_popover(open_transform_popover_3(*editor_, canvas_));
      });
  make_nudge_actions([this](int right, int up) {
    if (!viewer_ || editor_->selection().is_empty()) return false;
    const Camera_3 camera = viewer_->view().camera;
    const Camera_3::Axes axes = camera.axes();
    const double step = camera.height_at_target() / std::max(1, viewer_->height());
    editor_->nudge((right * step) * axes.right + (up * step) * axes.up);
    return true;
  });
}

void Main_window_3::make_tool_actions() {
  const QString group = tr("Tools");
  auto* choices = new QActionGroup(this);
  const auto add = [&](const char* id, const QString& text, const QString& tip, Qt::Key key, Tool_icon icon,
                       Tool_3* tool) {
    const QString name = QLatin1String(id);
    if (tool) tools_[name] = tool;
    QAction* action = actions_->add(group, {name, text, tip, {QKeySequence(key)}, tool_icon(icon), true},
                                    [this, name] { use_tool(name); });
    choices->addAction(action);
  };
  const bool is_drawn = viewer_ != nullptr;
  add("tool-turn", tr("&Turn the scene"),
      tr("Drag turns the scene, as it does with the tools that add, and where nothing is"), Qt::Key_T, Tool_icon::turn,
      is_drawn ? new Turn_tool_3(*editor_, *viewer_) : nullptr);
  add("tool-select", tr("&Select and move"),
      tr("Click selects balls and points, drag moves them or resizes by a handle, Shift+drag from nothing draws a "
         "rectangle"),
      Qt::Key_V, Tool_icon::select, is_drawn ? new Select_tool_3(*editor_, *viewer_) : nullptr);
  add("tool-points", tr("Add &points"),
      tr("Every click adds a point: on what is there, on the cutting plane or in the middle"), Qt::Key_P,
      Tool_icon::insert, is_drawn ? new Add_tool_3(Add_tool_3::Kind::point, *editor_, *viewer_) : nullptr);
  add("tool-balls", tr("Add &balls"),
      tr("Every click adds a ball: on what is there, on the cutting plane or in the middle"), Qt::Key_B,
      Tool_icon::disk, is_drawn ? new Add_tool_3(Add_tool_3::Kind::ball, *editor_, *viewer_) : nullptr);
}

void Main_window_3::make_insert_actions() {
  for (const Generator_3& generator : generators_3()) {
    actions_->add(tr("Insert"),
                  {QStringLiteral("insert-") + QString::fromStdString(generator.id),
                   generator_text(generator.label) + QStringLiteral("…"), generator_text(generator.tip)},
                  [this, &generator] { generate(generator); });
  }
}

void Main_window_3::make_editing_menus() {
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  actions_->add_to(edit, {"undo", "redo", "-", "cut", "copy", "paste", "duplicate", "delete", "-", "select-all",
                          "select-none", "invert-selection", "escape", "-", "coordinates", "transform", "copy-facts"});
  QMenu* insert = menuBar()->addMenu(tr("&Insert"));
  insert->setToolTipsVisible(true);
  Product_3 last = generators_3().front().product;
  for (const Generator_3& generator : generators_3()) {
    if (generator.product != last) insert->addSeparator();
    last = generator.product;
    insert->addAction((*actions_)[QStringLiteral("insert-") + QString::fromStdString(generator.id)]);
  }
  QMenu* tools = menuBar()->addMenu(tr("&Tools"));
  tools->setToolTipsVisible(true);
  actions_->add_to(tools, {"tool-turn", "tool-select", "tool-points", "tool-balls"});
}

void Main_window_3::make_tool_bar() {
  auto* bar = addToolBar(tr("Tools"));
  bar->setObjectName(QStringLiteral("tool-bar"));
  bar->setMovable(false);
  (*actions_)[QStringLiteral("fit")]->setIcon(tool_icon(Tool_icon::fit));
  actions_->add_to(bar, {"tool-turn", "tool-select", "tool-points", "tool-balls", "-", "undo", "redo", "-", "fit"});
}

void Main_window_3::connect_editing() {
  connect(editor_, &Editor_3::selection_changed, this, &Main_window_3::show_selection);
  connect(editor_, &Editor_3::failed, this,
          [this](const QString& message) { messages_->add(Message_bar::Kind::error, message); });
  if (!viewer_) return;
  connect(viewer_, &Viewer_3::hovered, this, [this](const QPointF& pixel) {
    tool_->hover(pixel);
    show_tool(pixel);
  });
  connect(viewer_, &Viewer_3::left, this, [this] {
    tool_->leave();
    hint_->setText(tr("? shows keys and mouse"));
    show_readout({}, {});
  });
  for (auto& [id, tool] : tools_) connect(tool, &Tool_3::used, this, &Main_window_3::show_tool);
}

void Main_window_3::use_tool(const QString& id) {
  if (tools_.empty()) return;
  if (tool_) {
    tool_->cancel();
    tool_->leave();
  }
  tool_ = tools_.at(id);
  viewer_->set_tool(tool_);
  (*actions_)[id]->setChecked(true);
  hint_->setText((*actions_)[id]->statusTip());
  viewer_->setCursor(Qt::ArrowCursor);
  viewer_->setFocus();
}

void Main_window_3::show_tool(const QPointF& pixel) {
  hint_->setText(tool_->hint(pixel));
  const Qt::CursorShape cursor = tool_->cursor(pixel);
  if (viewer_->cursor().shape() != cursor) viewer_->setCursor(cursor);
  show_readout(tool_->readout(), pixel);
}

void Main_window_3::show_readout(const QString& text, const QPointF& pixel) {
  if (text.isEmpty()) {
    readout_->hide();
    return;
  }
  readout_->setText(text);
  readout_->adjustSize();
  const int gap = fontMetrics().height();
  const QPoint wanted = pixel.toPoint() + QPoint(gap, gap);
  readout_->move(std::max(0, std::min(wanted.x(), canvas_->width() - readout_->width())),
                 std::max(0, std::min(wanted.y(), canvas_->height() - readout_->height())));
  readout_->show();
  readout_->raise();
}

void Main_window_3::show_selection() {
  const Selection_3& selection = editor_->selection();
  selected_->setText(selection.is_empty() ? QString() : tr("%1 selected").arg(Editor_3::words(selection)));
  for (const char* id : {"delete", "cut", "copy", "duplicate", "coordinates", "select-none"})
    (*actions_)[QLatin1String(id)]->setEnabled(!selection.is_empty());
  if (viewer_) viewer_->update();
}

std::pair<Point_3, double> Main_window_3::usual_place() const {
  if (document_.inputs().is_empty() || !viewer_) return {{}, 1};
  constexpr double share = 0.35;
  const Camera_3 camera = viewer_->view().camera;
  return {camera.target, share * camera.height_at_target()};
}

void Main_window_3::generate(const Generator_3& generator) {
  if (popover_) popover_->dismiss();
  const bool is_first_data = document_.inputs().is_empty();
  const auto [center, size] = usual_place();
  open_popover(open_generator_popover_3(generator, *editor_, center, size, canvas_));
  if (is_first_data) fit();
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/main_window_2.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app2d/first_look.h"
#include "app2d/generators_2.h"
#include "app2d/overlay_2.h"
#include "app2d/popovers_2.h"
#include "core/formats/number.h"
#include "geometries/dual_2/module.h"
#include "geometries/scale_axis_2/module.h"
#include "layers/panel_paint.h"
#include "shell/panel_focus.h"

// The macro needs the global namespace.
static void load_icons() { Q_INIT_RESOURCE(icons); }

namespace mesecina {

namespace {

Document_state first_state_2(const Registry& registry, const Startup& startup) {
  constexpr std::size_t samples = 120;
  constexpr double size = 100;
  return first_state(registry, startup, Inputs().with(points_input, wiggly_curve(samples, size)),
                     [&](const Inputs& inputs) { return first_look(registry, inputs); });
}

}  // namespace

Main_window_2::Main_window_2(const std::shared_ptr<const Registry>& registry, Formats formats, const Startup& startup)
    : Program_window(
          QStringLiteral("mesecina2d"), registry, std::move(formats), first_state_2(*registry, startup),
          [registry](const Inputs& inputs, const Layer_list& layers) { return look_at(*registry, inputs, layers); }) {
  load_icons();
  seen_first_ = startup.seen;
  setWindowIcon(QIcon(QStringLiteral(":/icons/org.mesecina.mesecina2d.svg")));
  build_canvas();
  files_ = new Files_2(document_, formats_, this);
  set_files(files_);
  build_docks();
  build_status_bar();
  selected_ = new QLabel(this);
  constexpr int before_coordinates = 4;
  statusBar()->insertPermanentWidget(before_coordinates, selected_);
  make_actions();
  make_menus();
  make_tool_bar();
  connect_parts();
  make_own_commands();
  restore();
  use_tool(QStringLiteral("tool-select"));
  canvas_->fit(bounding_box(document_.inputs()));
  start(startup, QStringLiteral("medial-axis"));
  show_selection();
}

Main_window_2::~Main_window_2() {
  canvas_->set_tool(nullptr);
  hover_.reset();
  take_apart();
  delete editor_;
  delete files_;
}

void Main_window_2::build_canvas() {
  canvas_ = new Canvas_2(Canvas_2::Backend::automatic);
  build_center(canvas_);
  canvas_->installEventFilter(this);
  editor_ = new Editor_2(document_, *canvas_, *formats_, this);
  hover_ = std::make_unique<Hover_2>(computation_, *canvas_);
  readout_ = make_plate(QStringLiteral("readout"));
}

void Main_window_2::build_docks() {
  build_panels();
  bundles_->set_view_access([this](Bundle& bundle) { bundle.view = canvas_->view(); },
                            [this](const Bundle& bundle) { canvas_->set_view(*bundle.view); });
  // Few shapes are more than one disk beyond this.
  constexpr double usual_maximum = 3;
  settings_panel_->set_slider_maximum(std::string(scale_setting.id), usual_maximum);
  points_table_ = new Input_table_2(Rows_2::points, *editor_, this);
  disks_table_ = new Input_table_2(Rows_2::disks, *editor_, this);
  QDockWidget* points = add_dock(QStringLiteral("points-dock"), tr("Points"), points_table_, Qt::RightDockWidgetArea);
  QDockWidget* disks = add_dock(QStringLiteral("disks-dock"), tr("Disks"), disks_table_, Qt::RightDockWidgetArea);
  tabifyDockWidget(settings_dock_, points);
  tabifyDockWidget(points, disks);
  settings_dock_->raise();
}

void Main_window_2::connect_parts() {
  connect_common();
  connect(editor_, &Editor_2::selection_changed, this, &Main_window_2::show_selection);
  connect(editor_, &Editor_2::failed, this,
          [this](const QString& message) { messages_->add(Message_bar::Kind::error, message); });
  connect(editor_, &Editor_2::menu_requested, this, &Main_window_2::open_menu);
  connect(hover_.get(), &Hover_2::changed, this, [this] {
    show_overlay();
    show_facts_text(hover_->short_facts_text());
  });
  connect(canvas_, &Canvas_2::view_changed, this, [this] {
    touch_scene();
    recording().note_change();
    hover_->forget();
    // Handles keep their distance on the screen.
    if (!editor_->selection().disks.empty()) show_overlay();
  });
  connect(canvas_, &Canvas_2::backend_failed, this, [this](const QString& reason) {
    messages_->add(Message_bar::Kind::note,
                   tr("Drawing without OpenGL, which is slower for large scenes: %1").arg(reason));
  });
  for (auto& [id, tool] : tools_) {
    connect(tool, &Tool_2::hovered, this, &Main_window_2::show_hover);
    connect(tool, &Tool_2::preview_changed, this, &Main_window_2::show_overlay);
    connect(tool, &Tool_2::left, this, [this] {
      coordinates_->clear();
      hint_->setText(tr("? shows keys and mouse"));
      show_readout({}, {});
      hover_->forget();
    });
  }
}

void Main_window_2::use_tool(const QString& id) {
  if (tool_) tool_->cancel();
  tool_ = tools_.at(id);
  canvas_->set_tool(tool_);
  spacing_action_->setVisible(id == QLatin1String("tool-spray") || id == QLatin1String("tool-disk"));
  for (const auto& [other, tool] : tools_) (*actions_)[other]->setChecked(other == id);
  show_overlay();
  canvas_->setFocus();
}

void Main_window_2::show_scene() {
  hover_->check();
  const bool is_empty = document_.inputs().is_empty();
  Scene scene = computation_.scene(background());
  // The last pictures of data that is gone would tell a lie next to the hint.
  if (is_empty) {
    for (Scene_layer& layer : scene.layers) layer.primitives = nullptr;
  }
  canvas_->set_scene(std::move(scene));
  canvas_->set_hint(is_empty ? tr("Drop a file here, double-click to add points, or press D and drag to draw disks")
                             : QString());
  show_notes();
  show_overlay();
}

void Main_window_2::show_overlay() {
  const Layer_entry* points = find_entry(document_.layers(), points_input.id);
  constexpr double usual_size = 6;
  const auto& hovered = hover_->hovered();
  Overlay_2 overlay;
  overlay.selected = positions(document_.inputs(), editor_->selection());
  overlay.selected_disks = selected_disks(document_.inputs(), editor_->selection());
  if (tool_) overlay.preview = tool_->preview();
  if (tool_ && tool_->uses_handles()) overlay.handles = editor_->handles();
  if (overlay.preview.readout.isEmpty()) show_readout({}, {});
  overlay.hovered = hovered ? &*hovered : nullptr;
  overlay.background = background();
  overlay.marker_size = points ? points->style.point_size : usual_size;
  canvas_->set_overlay(make_overlay(overlay));
}

void Main_window_2::show_document(const Document_change& change) {
  Program_window::show_document(change);
  if (change.inputs) {
    // Radii grow by about this part of the diagonal at the end of the slider.
    constexpr double part = 0.05;
    const double growth = part * bounding_box(document_.inputs()).diagonal();
    if (growth > 0) settings_panel_->set_slider_maximum(std::string(alpha_setting.id), growth * growth);
  }
  if (change.inputs || change.layers) {
    show_overlay();
    show_selection();
  }
}

void Main_window_2::show_hover(const Canvas_event& event) {
  const double pixel = 1 / canvas_->view().scale;
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(pixel))), 0, 12);
  coordinates_->setText(
      QStringLiteral("%1, %2").arg(event.position.x, 0, 'f', decimals).arg(event.position.y, 0, 'f', decimals));
  hint_->setText(tool_->hint(event));
  if (canvas_->cursor().shape() != tool_->cursor(event)) canvas_->setCursor(tool_->cursor(event));
  const Preview_2 preview = tool_->preview();
  show_readout(preview.readout, event.pixel);
  if (event.buttons == Qt::NoButton && preview.is_empty()) {
    hover_->look_at(event.pixel);
  } else {
    hover_->forget();
  }
}

void Main_window_2::show_readout(const QString& text, const QPointF& pixel) {
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

bool Main_window_2::use_wheel(const QWheelEvent& event) {
  // Ctrl always zooms, so that one can also while a selected disk covers the view.
  if (!tool_ || event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) return false;
  const QPoint turned = event.angleDelta();
  // Some systems turn the wheel sideways while Shift is held.
  const bool is_fine = event.modifiers() & Qt::ShiftModifier;
  const int eighths = turned.y() == 0 && is_fine ? turned.x() : turned.y();
  if (eighths == 0) return false;
  constexpr double eighths_per_degree = 8;
  constexpr double fineness = 10;
  const QPointF pixel = event.position();
  const Point_2 position = canvas_->view().to_plane({pixel.x(), pixel.y()}, canvas_->width(), canvas_->height());
  const double degrees = eighths / eighths_per_degree / (is_fine ? fineness : 1);
  if (!tool_->wheel({pixel, position, Qt::NoButton, event.buttons(), event.modifiers()}, degrees)) return false;
  const std::vector<Disk_2> disks = selected_disks(document_.inputs(), editor_->selection());
  show_readout(disks.size() == 1 ? radius_readout(disks.front().radius) : editor_->document().history().undoText(),
               pixel);
  return true;
}

bool Main_window_2::eventFilter(QObject* watched, QEvent* event) {
  if (watched == canvas_ && event->type() == QEvent::Wheel && use_wheel(static_cast<QWheelEvent&>(*event))) {
    event->accept();
    return true;
  }
  return QMainWindow::eventFilter(watched, event);
}

void Main_window_2::show_title() {
  setWindowTitle(tr("%1[*] — Mesecina 2D").arg(files_->title()));
  setWindowModified(document_.is_modified());
}

void Main_window_2::show_selection() {
  const Selection_2& selection = editor_->selection();
  selected_->setText(selection.is_empty() ? QString() : tr("%1 selected").arg(Editor_2::words(selection)));
  for (const char* id : {"cut", "copy", "duplicate", "delete", "coordinates"})
    (*actions_)[QLatin1String(id)]->setEnabled(!selection.is_empty());
  show_overlay();
}

void Main_window_2::escape() {
  if (tool_->cancel()) return;
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

void Main_window_2::generate(const Generator_2& generator) {
  if (popover_) popover_->dismiss();
  open_popover(open_generator_popover(generator, *editor_, canvas_));
}

QString Main_window_2::unsaved_text() const {
  return tr("The points, outlines or disks of %1 were changed.").arg(files_->title());
}

void Main_window_2::showEvent(QShowEvent* event) {
  Program_window::showEvent(event);
  // Before, the size of the canvas is not known.
  if (!std::exchange(was_shown_, true) && seen_first_) show_first_view();
}

void Main_window_2::files_loaded() {
  show_first_view();
  seen_first_.reset();
}

void Main_window_2::show_first_view() {
  if (!seen_first_) {
    canvas_->fit(bounding_box(document_.inputs()));
    return;
  }
  View_2 view = seen_first_->view;
  view.scale *= std::min(static_cast<double>(canvas_->width()) / seen_first_->width,
                         static_cast<double>(canvas_->height()) / seen_first_->height);
  canvas_->set_view(view);
}

void Main_window_2::add_view(Session& session) const {
  session.view_2 = canvas_->view();
  session.width = canvas_->width();
  session.height = canvas_->height();
}

void Main_window_2::show_view(const Session& session) {
  if (const auto view = view_for(session, canvas_->width(), canvas_->height())) {
    canvas_->set_view(*view);
  } else {
    canvas_->fit(bounding_box(document_.inputs()));
  }
}

void Main_window_2::show_places(const std::vector<Place>& places) {
  Selection_2 selection;
  const auto points = document_.inputs().get(points_input);
  const auto disks = document_.inputs().get(disks_input);
  for (const Place& place : places) {
    // They may be gone by now.
    if (place.input == points_input.id && points && place.element < points->size())
      selection.points.push_back(place.element);
    if (place.input == disks_input.id && disks && place.element < disks->size())
      selection.disks.push_back(place.element);
  }
  if (!selection.is_empty()) editor_->select(std::move(selection));
  canvas_->fit(box_around(places, bounding_box(document_.inputs())));
}

void Main_window_2::finish_drawing() { canvas_->grab_picture(); }

}  // namespace mesecina

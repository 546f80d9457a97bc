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

// The macro needs the global namespace.
static void load_icons() { Q_INIT_RESOURCE(icons); }

namespace mesecina {

namespace {

/// Empty when none is visible.
QString topmost_visible(const Layer_list& layers) {
  for (auto entry = layers.rbegin(); entry != layers.rend(); ++entry)
    if (entry->style.visible) return QString::fromStdString(entry->id);
  return {};
}

Document_state first_state(const Registry& registry, const Startup& startup) {
  constexpr std::size_t samples = 120;
  constexpr double size = 100;
  Document_state state{{}, startup.settings, {}};
  if (startup.files.empty()) state.inputs = state.inputs.with(points_input, wiggly_curve(samples, size));
  if (startup.layers.empty()) {
    state.layers = first_look(registry, state.inputs);
  } else {
    state.layers = default_layers(registry);
    for (Layer_entry& entry : state.layers) entry.style.visible = std::ranges::count(startup.layers, entry.id) > 0;
  }
  return state;
}

}  // namespace

Main_window_2::Main_window_2(std::shared_ptr<const Registry> registry, Formats formats, const Startup& startup)
    : registry_(std::move(registry)),
      formats_(std::make_shared<const Formats>(std::move(formats))),
      document_(first_state(*registry_, startup),
                [known = registry_](const Inputs& inputs, const Layer_list& layers) {
                  return look_at(*known, inputs, layers);
                }),
      computation_(registry_, document_) {
  load_icons();
  setObjectName(QStringLiteral("main-window"));
  setWindowIcon(QIcon(QStringLiteral(":/icons/org.mesecina.mesecina2d.svg")));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  build_center();
  files_ = new Files_2(document_, formats_, this);
  build_docks();
  build_status_bar();
  make_actions();
  make_menus();
  make_tool_bar();
  connect_parts();
  restore();
  use_tool(QStringLiteral("tool-select"));
  start(startup);
}

Main_window_2::~Main_window_2() {
  // What is deleted with the base class must not call back into members that are gone by then.
  for (QObject* child : findChildren<QObject*>()) child->disconnect(this);
  document_.disconnect();
  computation_.disconnect();
  canvas_->set_tool(nullptr);
  hover_.reset();
  for (QDockWidget* dock : {layers_dock_, settings_dock_, points_dock_, disks_dock_}) delete dock;
  delete takeCentralWidget();
  delete editor_;
  delete files_;
}

void Main_window_2::build_center() {
  auto* center = new QWidget(this);
  auto* column = new QVBoxLayout(center);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  messages_ = new Message_bar(center);
  canvas_ = new Canvas_2(Canvas_2::Backend::automatic, center);
  column->addWidget(messages_);
  column->addWidget(canvas_, 1);
  setCentralWidget(center);
  canvas_->installEventFilter(this);
  editor_ = new Editor_2(document_, *canvas_, *formats_, this);
  hover_ = std::make_unique<Hover_2>(computation_, *canvas_);
  notes_ = new Layer_notes(canvas_);
  const auto make_plate = [this](const QString& name) {
    auto* plate = new QLabel(canvas_);
    plate->setObjectName(name);
    plate->setAttribute(Qt::WA_TransparentForMouseEvents);
    plate->setAutoFillBackground(true);
    plate->setFrameShape(QFrame::StyledPanel);
    plate->setMargin(fontMetrics().height() / 3);
    plate->setTextFormat(Qt::PlainText);
    plate->hide();
    return plate;
  };
  facts_ = make_plate(QStringLiteral("facts"));
  readout_ = make_plate(QStringLiteral("readout"));
}

void Main_window_2::build_docks() {
  const auto add = [this](const QString& name, const QString& title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setWidget(widget);
    addDockWidget(area, dock);
    return dock;
  };
  layer_panel_ = new Layer_panel(registry_, this);
  settings_panel_ = new Settings_panel(registry_, this);
  // Few shapes are more than one disk beyond this.
  constexpr double usual_maximum = 3;
  settings_panel_->set_slider_maximum(std::string(scale_setting.id), usual_maximum);
  points_table_ = new Input_table_2(Rows_2::points, *editor_, this);
  disks_table_ = new Input_table_2(Rows_2::disks, *editor_, this);
  layers_dock_ = add(QStringLiteral("layers-dock"), tr("Layers"), layer_panel_, Qt::LeftDockWidgetArea);
  settings_dock_ = add(QStringLiteral("settings-dock"), tr("Settings"), settings_panel_, Qt::RightDockWidgetArea);
  points_dock_ = add(QStringLiteral("points-dock"), tr("Points"), points_table_, Qt::RightDockWidgetArea);
  disks_dock_ = add(QStringLiteral("disks-dock"), tr("Disks"), disks_table_, Qt::RightDockWidgetArea);
  tabifyDockWidget(settings_dock_, points_dock_);
  tabifyDockWidget(points_dock_, disks_dock_);
  settings_dock_->raise();
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  constexpr int left_width = 300;
  constexpr int right_width = 260;
  resizeDocks({layers_dock_, settings_dock_}, {left_width, right_width}, Qt::Horizontal);
}

void Main_window_2::build_status_bar() {
  hint_ = new QLabel(tr("? shows keys and mouse"), this);
  selected_ = new QLabel(this);
  coordinates_ = new QLabel(this);
  computing_ = new Status_progress(this);
  working_ = new Status_progress(this);
  coordinates_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-000.0000, -000.0000")));
  coordinates_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  coordinates_->setAccessibleName(tr("Coordinates under the mouse"));
  statusBar()->addWidget(hint_, 1);
  for (QWidget* widget : {static_cast<QWidget*>(working_), static_cast<QWidget*>(computing_),
                          static_cast<QWidget*>(selected_), static_cast<QWidget*>(coordinates_)})
    statusBar()->addPermanentWidget(widget);
  // A permanent widget is shown by the status bar; these two show themselves when there is something to tell.
  computing_->hide();
  working_->hide();
}

void Main_window_2::connect_parts() {
  connect(&document_, &Document::changed, this, &Main_window_2::show_document);
  connect(&document_, &Document::modified_changed, this, &QWidget::setWindowModified);
  connect(&computation_, &Computation::scene_changed, this, &Main_window_2::show_scene);
  connect(&computation_, &Computation::layer_changed, this,
          [this](const QString& layer) { show_layer(layer.toStdString()); });
  connect(&computation_, &Computation::busy_changed, this,
          [this](bool is_busy) { is_busy ? computing_->begin(tr("Computing")) : computing_->end(); });
  connect(&computation_, &Computation::progressed, computing_, &Status_progress::report);
  connect(computing_, &Status_progress::cancel_requested, &computation_, &Computation::cancel);
  connect(&files_->jobs(), &Background_jobs::started, working_, &Status_progress::begin);
  connect(&files_->jobs(), &Background_jobs::idle, working_, &Status_progress::end);
  connect(working_, &Status_progress::cancel_requested, &files_->jobs(), &Background_jobs::cancel);
  connect(files_, &Files_2::told, messages_, &Message_bar::add);
  connect(files_, &Files_2::opened, recent_files_, &Recent_files::add);
  connect(files_, &Files_2::title_changed, this, &Main_window_2::show_title);
  connect(files_, &Files_2::loaded, this, [this] { canvas_->fit(bounding_box(document_.inputs())); });
  connect(recent_files_, &Recent_files::chosen, this, [this](const QString& file) { files_->open({file}, false); });
  connect(editor_, &Editor_2::selection_changed, this, &Main_window_2::show_selection);
  connect(editor_, &Editor_2::failed, this,
          [this](const QString& message) { messages_->add(Message_bar::Kind::error, message); });
  connect(editor_, &Editor_2::menu_requested, this, &Main_window_2::open_menu);
  connect(notes_, &Layer_notes::chosen, this, [this](const QString& layer) {
    layers_dock_->show();
    layer_panel_->select({layer});
  });
  connect(hover_.get(), &Hover_2::changed, this, &Main_window_2::show_facts);
  connect(canvas_, &Canvas_2::view_changed, this, [this] {
    hover_->forget();
    // Handles keep their distance on the screen.
    if (!editor_->selection().disks.empty()) show_overlay();
  });
  connect(canvas_, &Canvas_2::backend_failed, this, [this](const QString& reason) {
    messages_->add(Message_bar::Kind::note,
                   tr("Drawing without OpenGL, which is slower for large scenes: %1").arg(reason));
  });
  connect(layer_panel_, &Layer_panel::layers_edited, &document_, &Document::edit_layers);
  connect(layer_panel_, &Layer_panel::setting_edited, this, &Main_window_2::edit_cut);
  connect(settings_panel_, &Settings_panel::edited, &document_, &Document::edit_settings);
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

void Main_window_2::start(const Startup& startup) {
  layer_panel_->set_layers(document_.layers());
  layer_panel_->set_settings(document_.settings());
  settings_panel_->set_settings(document_.settings());
  layer_panel_->select({startup.layers.empty() ? QStringLiteral("medial-axis") : topmost_visible(document_.layers())});
  canvas_->fit(bounding_box(document_.inputs()));
  show_title();
  show_scene();
  show_selection();
  QStringList paths;
  for (const std::filesystem::path& file : startup.files) paths << QString::fromStdString(file.string());
  if (paths.isEmpty()) {
    files_->name_example();
  } else {
    files_->open_first(paths);
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
}

void Main_window_2::show_notes() {
  std::vector<Layer_notes::Note> notes;
  const Layer_list& layers = document_.layers();
  for (auto entry = layers.rbegin(); entry != layers.rend() && !document_.inputs().is_empty(); ++entry) {
    const Layer_spec* spec = registry_->find_layer(entry->id);
    if (!entry->style.visible || !spec) continue;
    const QString reason = computation_.status(entry->id).reason;
    if (is_worth_a_note(reason))
      notes.push_back({QString::fromStdString(entry->id), QString::fromStdString(spec->label), reason});
  }
  notes_->set_notes(std::move(notes), background());
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

void Main_window_2::show_layer(const std::string& layer) {
  layer_panel_->set_status(layer, computation_.status(layer));
  const auto primitives = computation_.primitives(layer);
  layer_panel_->set_primitives(layer, primitives);
  const Layer_spec* spec = registry_->find_layer(layer);
  if (!spec || spec->cut_setting.empty() || !primitives) return;
  const Values* values = primitives->find_values(spec->cut_value);
  if (!values || std::isfinite(registry_->find_setting(spec->cut_setting)->maximum)) return;
  double largest = 0;
  for (const double value : values->data)
    if (std::isfinite(value)) largest = std::max(largest, value);
  if (largest > 0) settings_panel_->set_slider_maximum(spec->cut_setting, largest);
}

void Main_window_2::show_document(const Document_change& change) {
  if (change.layers) layer_panel_->set_layers(document_.layers());
  if (change.settings) {
    layer_panel_->set_settings(document_.settings());
    settings_panel_->set_settings(document_.settings());
  }
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
  show_title();
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

void Main_window_2::show_facts() {
  show_overlay();
  const QString text = hover_->short_facts_text();
  if (text.isEmpty()) {
    facts_->hide();
    return;
  }
  facts_->setText(text);
  facts_->adjustSize();
  const int margin = fontMetrics().height() / 2;
  facts_->move(canvas_->width() - facts_->width() - margin, margin);
  facts_->show();
  facts_->raise();
}

void Main_window_2::edit_cut(const QString& setting, double value, const QString& merge) {
  const Setting_spec* spec = registry_->find_setting(setting.toStdString());
  if (!spec) return;
  Setting_value typed = value;
  if (std::holds_alternative<std::int64_t>(spec->default_value)) typed = static_cast<std::int64_t>(value);
  document_.edit_settings(typed == spec->default_value ? document_.settings().without(spec->id)
                                                       : document_.settings().with(spec->id, typed),
                          QString::fromStdString(spec->label), merge);
}

void Main_window_2::escape() {
  if (tool_->cancel()) return;
  if (popover_) {
    popover_->dismiss();
  } else if (files_->jobs().is_busy()) {
    files_->jobs().cancel();
  } else if (computation_.is_busy() && computing_->isVisible()) {
    computation_.cancel();
  } else if (!editor_->selection().is_empty()) {
    editor_->select({});
  } else {
    messages_->dismiss();
  }
}

void Main_window_2::open_popover(Popover* popover) {
  if (!popover) return;
  popover_ = popover;
  connect(popover, &Popover::closed, this, [this, popover] {
    if (popover_ == popover) popover_ = nullptr;
    canvas_->setFocus();
  });
}

void Main_window_2::generate(const Generator_2& generator) {
  if (popover_) popover_->dismiss();
  open_popover(open_generator_popover(generator, *editor_, canvas_));
}

Color Main_window_2::background() const { return canvas_color(background_, palette()); }

bool Main_window_2::may_close() {
  if (!document_.is_modified() || qEnvironmentVariableIsSet("MESECINA_NO_PROMPT")) return true;
  const auto answer = QMessageBox::question(
      this, tr("Save changes?"), tr("The points, outlines or disks of %1 were changed.").arg(files_->title()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  if (answer == QMessageBox::Save) return files_->save();
  return answer == QMessageBox::Discard;
}

void Main_window_2::closeEvent(QCloseEvent* event) {
  if (!may_close()) {
    event->ignore();
    return;
  }
  computation_.cancel();
  files_->jobs().cancel();
  store();
  event->accept();
}

void Main_window_2::dragEnterEvent(QDragEnterEvent* event) {
  const auto is_local = [](const QUrl& url) { return url.isLocalFile(); };
  const auto urls = event->mimeData()->urls();
  if (std::ranges::any_of(urls, is_local)) event->acceptProposedAction();
}

void Main_window_2::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  files_->open(paths, event->modifiers() & (Qt::ControlModifier | Qt::ShiftModifier));
  event->acceptProposedAction();
}

void Main_window_2::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && canvas_ && tool_) {
    show_scene();
    show_overlay();
  }
}

}  // namespace mesecina

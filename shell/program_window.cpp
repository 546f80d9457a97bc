// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/program_window.h"

#include <QDockWidget>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QScreen>
#include <QStatusBar>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "bundles/bundle_panel.h"
#include "shell/preferences.h"
#include "shell/session_state.h"
#include "shell/setting_values.h"

namespace mesecina {

QString topmost_visible(const Layer_list& layers) {
  for (auto entry = layers.rbegin(); entry != layers.rend(); ++entry)
    if (entry->style.visible) return QString::fromStdString(entry->id);
  return {};
}

Program_window::Program_window(QString program, std::shared_ptr<const Registry> registry, Formats formats,
                               Document_state first, Document::Layers_for_inputs layers_for_inputs)
    : registry_(std::move(registry)),
      formats_(std::make_shared<const Formats>(std::move(formats))),
      document_(std::move(first), std::move(layers_for_inputs)),
      computation_(registry_, document_),
      evolution_(registry_, document_, computation_),
      program_(std::move(program)) {
  setObjectName(QStringLiteral("main-window"));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
}

void Program_window::take_apart() {
  // What is deleted with the base class must not call back into members that are gone by then.
  for (QObject* child : findChildren<QObject*>()) child->disconnect(this);
  delete recording_;
  document_.disconnect();
  computation_.disconnect();
  evolution_.disconnect();
  evolution_.evolver().disconnect();
  for (QDockWidget* dock : docks_) delete dock;
  delete takeCentralWidget();
}

void Program_window::build_center(QWidget* canvas) {
  common_canvas_ = canvas;
  auto* center = new QWidget(this);
  center_column_ = new QVBoxLayout(center);
  center_column_->setContentsMargins(0, 0, 0, 0);
  center_column_->setSpacing(0);
  recovery_bar_ = new Recovery_bar(center);
  center_column_->addWidget(recovery_bar_);
  messages_ = new Message_bar(center);
  center_column_->addWidget(messages_);
  center_column_->addWidget(canvas, 1);
  setCentralWidget(center);
  notes_ = new Layer_notes(canvas);
  facts_ = make_plate(QStringLiteral("facts"));
}

QLabel* Program_window::make_plate(const QString& name) {
  auto* plate = new QLabel(common_canvas_);
  plate->setObjectName(name);
  plate->setAttribute(Qt::WA_TransparentForMouseEvents);
  plate->setAutoFillBackground(true);
  plate->setFrameShape(QFrame::StyledPanel);
  plate->setMargin(fontMetrics().height() / 3);
  plate->setTextFormat(Qt::PlainText);
  plate->hide();
  return plate;
}

void Program_window::show_facts_text(const QString& text) {
  if (text.isEmpty()) {
    facts_->hide();
    return;
  }
  facts_->setText(text);
  facts_->adjustSize();
  const int margin = fontMetrics().height() / 2;
  facts_->move(common_canvas_->width() - facts_->width() - margin, margin);
  facts_->show();
  facts_->raise();
}

QDockWidget* Program_window::add_dock(const QString& name, const QString& title, QWidget* widget,
                                      Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWhatsThis(
      tr("The panel “%1”. Drag its title to put it elsewhere; View ▸ Panels shows and hides it.").arg(title));
  dock->setWidget(widget);
  addDockWidget(area, dock);
  docks_.push_back(dock);
  return dock;
}

void Program_window::build_panels() {
  layer_panel_ = new Layer_panel(registry_, this);
  settings_panel_ = new Settings_panel(registry_, this);
  settings_browser_ = new Settings_browser(settings_panel_, this);
  layers_dock_ = add_dock(QStringLiteral("layers-dock"), tr("Layers"), layer_panel_, Qt::LeftDockWidgetArea);
  bundles_ = new Window_bundles(registry_, document_, *messages_, program_, this);
  bundles_dock_ = add_dock(QStringLiteral("bundles-dock"), tr("Bundles"), bundles_->panel(), Qt::LeftDockWidgetArea);
  tabifyDockWidget(layers_dock_, bundles_dock_);
  layers_dock_->raise();
  settings_dock_ =
      add_dock(QStringLiteral("settings-dock"), tr("Settings"), settings_browser_, Qt::RightDockWidgetArea);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  constexpr int left_width = 300;
  constexpr int right_width = 260;
  resizeDocks({layers_dock_, settings_dock_}, {left_width, right_width}, Qt::Horizontal);
}

void Program_window::build_status_bar() {
  hint_ = new QLabel(tr("? shows keys and mouse"), this);
  coordinates_ = new QLabel(this);
  evolving_ = new Status_progress(this);
  computing_ = new Status_progress(this);
  working_ = new Status_progress(this);
  coordinates_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-000.0000, -000.0000")));
  coordinates_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  coordinates_->setAccessibleName(tr("Coordinates under the mouse"));
  statusBar()->addWidget(hint_, 1);
  statusBar()->addPermanentWidget(evolving_);
  statusBar()->addPermanentWidget(working_);
  statusBar()->addPermanentWidget(computing_);
  statusBar()->addPermanentWidget(coordinates_);
  // A permanent widget is shown by the status bar; these show themselves when there is something to tell.
  evolving_->hide();
  computing_->hide();
  working_->hide();
}

void Program_window::begin_actions() {
  actions_ = new Actions(program_, this);
  recent_files_ = new Recent_files(program_, this);
}

void Program_window::make_undo_actions(const QIcon& undo_icon, const QIcon& redo_icon) {
  const QString group = tr("Edit");
  QUndoStack& history = document_.history();
  QAction* undo = actions_->add(group,
                                {QStringLiteral("undo"),
                                 tr("&Undo"),
                                 tr("Take back the last change"),
                                 {QKeySequence(Qt::CTRL | Qt::Key_Z)},
                                 undo_icon},
                                [&history] { history.undo(); });
  QAction* redo = actions_->add(group,
                                {QStringLiteral("redo"),
                                 tr("&Redo"),
                                 tr("Do again what was taken back"),
                                 {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)},
                                 redo_icon},
                                [&history] { history.redo(); });
  undo->setEnabled(false);
  redo->setEnabled(false);
  connect(&history, &QUndoStack::canUndoChanged, undo, &QAction::setEnabled);
  connect(&history, &QUndoStack::canRedoChanged, redo, &QAction::setEnabled);
  connect(&history, &QUndoStack::undoTextChanged, undo,
          [undo](const QString& text) { undo->setText(text.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(text)); });
  connect(&history, &QUndoStack::redoTextChanged, redo,
          [redo](const QString& text) { redo->setText(text.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(text)); });
}

void Program_window::make_nudge_actions(const std::function<bool(int right, int up)>& nudge) {
  struct Direction {
    const char* id;
    QString text;
    Qt::Key key;
    int right;
    int up;
  };
  const Direction directions[] = {{"nudge-left", tr("Nudge left"), Qt::Key_Left, -1, 0},
                                  {"nudge-right", tr("Nudge right"), Qt::Key_Right, 1, 0},
                                  {"nudge-up", tr("Nudge up"), Qt::Key_Up, 0, 1},
                                  {"nudge-down", tr("Nudge down"), Qt::Key_Down, 0, -1}};
  constexpr int far_pixels = 10;
  const auto add = [&](const QString& id, const QString& text, const QString& tip, const QKeySequence& key,
                       std::function<void()> run) {
    actions_->add(tr("Edit"), {id, text, tip, {key}, {}, false, common_canvas_}, std::move(run));
  };
  for (const Direction& direction : directions) {
    const QString id = QLatin1String(direction.id);
    const int right = direction.right;
    const int up = direction.up;
    const auto move = [this, nudge](int pixels_right, int pixels_up) {
      if (!nudge(pixels_right, pixels_up)) evolution_.go_by(pixels_right);
    };
    const QString else_steps = right != 0 ? tr("; without one, go through the steps of an evolution") : QString();
    add(id, direction.text, tr("Move the selection by one pixel in the picture%1").arg(else_steps),
        QKeySequence(direction.key), [move, right, up] { move(right, up); });
    add(id + QLatin1String("-far"), tr("%1 by 10").arg(direction.text),
        tr("Move the selection by ten pixels in the picture%1").arg(else_steps),
        QKeySequence(Qt::SHIFT | direction.key), [move, right, up] { move(far_pixels * right, far_pixels * up); });
  }
}

void Program_window::make_layer_actions() {
  const auto add = [&](const char* id, const QString& text, const QString& tip, const QKeySequence& key,
                       std::function<void()> run) {
    actions_->add(tr("View"), {QLatin1String(id), text, tip, {key}}, std::move(run));
  };
  add("toggle-layers", tr("Show or &hide layers"), tr("Show or hide the layers selected in the list"),
      QKeySequence(Qt::Key_H), [this] { layer_panel_->toggle_visibility(); });
  add("solo-layers", tr("&Solo layers"), tr("Show only the layers selected in the list; again: what was shown before"),
      QKeySequence(Qt::Key_S), [this] { layer_panel_->solo(); });
  add("show-all-layers", tr("Show &all layers"), tr("Show every layer"), QKeySequence(Qt::ALT | Qt::Key_H),
      [this] { layer_panel_->show_all(); });
  add("find-layer", tr("Find a &layer"), tr("Type a part of its name"), QKeySequence(Qt::CTRL | Qt::Key_F), [this] {
    layers_dock_->show();
    layer_panel_->focus_filter();
  });
}

void Program_window::make_bundle_actions() {
  bundles_->make_actions(*actions_, bundles_dock_, common_files_);
  bundles_->set_background_access([this] { return background_; },
                                  [this](Canvas_background background) { show_background(background); });
}

void Program_window::add_bundle_menu(QMenu* view) const {
  QMenu* menu = view->addMenu(tr("&Bundles"));
  QStringList ids;
  for (int i = 1; i <= 9; ++i) ids << QStringLiteral("bundle-%1").arg(i);
  ids << QStringLiteral("-");
  actions_->add_to(menu, ids + QStringList{"save-bundle", "save-bundle-with-view", "update-bundle", "rename-bundle"});
  menu->addMenu(bundles_->key_menu());
  actions_->add_to(menu, {"delete-bundle", "-", "import-bundles", "export-bundles", "reset-bundles"});
}

void Program_window::connect_common() {
  connect(&document_, &Document::changed, this, &Program_window::show_document);
  connect(&document_, &Document::modified_changed, this, &QWidget::setWindowModified);
  connect(&computation_, &Computation::scene_changed, this, [this] { show_scene(); });
  connect(&computation_, &Computation::layer_changed, this,
          [this](const QString& layer) { show_layer(layer.toStdString()); });
  connect(&computation_, &Computation::busy_changed, this,
          [this](bool is_busy) { is_busy ? computing_->begin(tr("Computing")) : computing_->end(); });
  connect(&evolution_.evolver(), &Evolver::busy_changed, this,
          [this](bool is_busy) { is_busy ? evolving_->begin(tr("Making steps")) : evolving_->end(); });
  connect(&evolution_.evolver(), &Evolver::progressed, evolving_, &Status_progress::report);
  connect(evolving_, &Status_progress::cancel_requested, this, [this] {
    evolution_.pause();
    evolution_.stop();
  });
  connect(&evolution_, &Evolution_control::told, this,
          [this](const QString& note) { messages_->add(Message_bar::Kind::note, note); });
  connect(&computation_, &Computation::progressed, computing_, &Status_progress::report);
  connect(computing_, &Status_progress::cancel_requested, &computation_, &Computation::cancel);
  connect(&common_files_->jobs(), &Background_jobs::started, working_, &Status_progress::begin);
  connect(&common_files_->jobs(), &Background_jobs::idle, working_, &Status_progress::end);
  connect(&common_files_->saving(), &Background_jobs::started, this,
          [this](const QString& text) { statusBar()->showMessage(text + QChar(0x2026)); });
  connect(&common_files_->saving(), &Background_jobs::idle, statusBar(), &QStatusBar::clearMessage);
  connect(working_, &Status_progress::cancel_requested, &common_files_->jobs(), &Background_jobs::cancel);
  connect(common_files_, &Files::told, messages_, &Message_bar::add);
  connect(common_files_, &Files::opened, recent_files_, &Recent_files::add);
  connect(common_files_, &Files::title_changed, this, [this] { show_title(); });
  connect(common_files_, &Files::loaded, this, [this] {
    unknown_ = {};
    files_loaded();
    if (!first_evolutions_.empty()) evolution_.run(std::exchange(first_evolutions_, {}));
  });
  connect(common_files_, &Files::session_opened, this, &Program_window::show_session);
  connect(common_files_, &Files::title_changed, this, [this] { touch_scene(); });
  common_files_->set_scene({[this] { return session(); },
                            [registry = registry_](const Session& opened) { return state_of(opened, *registry); }});
  connect(recovery_bar_, &Recovery_bar::recovery_requested, this, &Program_window::recover);
  connect(recovery_bar_, &Recovery_bar::declined, this, &Program_window::keep_for_later);
  connect(recent_files_, &Recent_files::chosen, this,
          [this](const QString& file) { common_files_->open({file}, false); });
  connect(notes_, &Layer_notes::chosen, this, [this](const QString& layer) {
    layers_dock_->show();
    layer_panel_->select({layer});
  });
  connect(layer_panel_, &Layer_panel::layers_edited, &document_, &Document::edit_layers);
  connect(layer_panel_, &Layer_panel::setting_edited, this, &Program_window::edit_cut);
  connect(settings_panel_, &Settings_panel::edited, &document_, &Document::edit_settings);
}

Startup startup_of(const Command_line& command_line) {
  Startup startup{command_line.files, command_line.layers, command_line.settings, command_line.styles,
                  command_line.as_listed};
  startup.evolutions = command_line.evolutions;
  startup.warnings = command_line.warnings;
  startup.background = command_line.background;
  const bool brings_data =
      command_line.session && command_line.files == std::vector{command_line.session_file.value_or("")};
  if (command_line.view) startup.seen = Seen_2{*command_line.view, command_line.width, command_line.height};
  if (command_line.view_3) startup.seen_3 = Seen_3{*command_line.view_3, command_line.key_frames};
  if (!brings_data) return startup;
  Session session = *command_line.session;
  session.view_2 = command_line.view;
  session.width = command_line.width;
  session.height = command_line.height;
  session.view_3 = command_line.view_3;
  session.camera_path = command_line.key_frames;
  session.settings = command_line.settings;
  session.background = command_line.background;
  for (auto& [id, style] : session.layers) {
    if (const auto changed = command_line.styles.find(id); changed != command_line.styles.end())
      style = changed->second;
    style.visible = std::ranges::count(command_line.layers, id) > 0;
  }
  startup.files.clear();
  // No reader of files tells what is not understood.
  startup.warnings.insert(startup.warnings.end(), session.unknown.parts.notes.begin(),
                          session.unknown.parts.notes.end());
  startup.session = std::make_shared<const Session>(std::move(session));
  return startup;
}

Document_state first_state(const Registry& registry, const Startup& startup, const Inputs& example,
                           const std::function<Layer_list(const Inputs&)>& usual_layers) {
  Document_state state{startup.files.empty() ? example : Inputs(), startup.settings, {}};
  if (startup.layers.empty()) {
    state.layers = usual_layers(state.inputs);
  } else {
    if (startup.as_listed) {
      for (const std::string& id : startup.layers) {
        if (!find_entry(state.layers, id)) state.layers.push_back({id, registry.find_layer(id)->style});
      }
    }
    state.layers = with_missing_layers(std::move(state.layers), registry);
    for (Layer_entry& entry : state.layers) entry.style.visible = std::ranges::count(startup.layers, entry.id) > 0;
  }
  for (Layer_entry& entry : state.layers) {
    const auto changed = startup.styles.find(entry.id);
    if (changed == startup.styles.end()) continue;
    const bool is_visible = entry.style.visible;
    entry.style = changed->second;
    entry.style.visible = is_visible;
  }
  return state;
}

void Program_window::start(const Startup& startup, const QString& usual_layer) {
  layer_panel_->set_layers(document_.layers());
  layer_panel_->set_settings(document_.settings());
  settings_panel_->set_settings(document_.settings());
  layer_panel_->select({startup.layers.empty() ? usual_layer : topmost_visible(document_.layers())});
  show_title();
  if (startup.background)
    show_background(*startup.background);
  else
    show_scene();
  for (const std::string& warning : startup.warnings)
    messages_->add(Message_bar::Kind::warning, QString::fromStdString(warning));
  QStringList paths;
  for (const std::filesystem::path& file : startup.files) paths << QString::fromStdString(file.string());
  if (!startup.evolutions.empty()) set_evolution_bar_visible(true);
  if (startup.session) {
    // When the canvas has its size, which the view goes by.
    const auto show = [this, session = startup.session, evolutions = startup.evolutions] {
      common_files_->show_session(*session, tr("Open"), true);
      evolution_.run(evolutions);
    };
    QMetaObject::invokeMethod(this, show, Qt::QueuedConnection);
  } else if (paths.isEmpty()) {
    common_files_->name_example();
    evolution_.run(startup.evolutions);
  } else {
    first_evolutions_ = startup.evolutions;
    common_files_->open_first(paths);
  }
}

void Program_window::show_notes() {
  std::vector<Layer_notes::Note> notes;
  std::vector<Layer_notes::Note> missing_inputs;
  bool is_anything_seen = false;
  const Layer_list& layers = document_.layers();
  for (auto entry = layers.rbegin(); entry != layers.rend() && !document_.inputs().is_empty(); ++entry) {
    const Layer_spec* spec = registry_->find_layer(entry->id);
    if (!entry->style.visible || !spec) continue;
    const QString reason = computation_.status(entry->id).reason;
    if (!reason.isEmpty())
      (is_worth_a_note(reason) ? notes : missing_inputs)
          .push_back({QString::fromStdString(entry->id), QString::fromStdString(spec->label), reason});
    const auto primitives = computation_.primitives(entry->id);
    is_anything_seen = is_anything_seen || (primitives && primitives->element_count() > 0);
  }
  if (notes.empty() && !is_anything_seen) notes = std::move(missing_inputs);
  notes_->set_notes(std::move(notes), background());
}

void Program_window::show_layer(const std::string& layer) {
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

void Program_window::show_document(const Document_change& change) {
  if (change.layers) layer_panel_->set_layers(document_.layers());
  if (change.settings) {
    layer_panel_->set_settings(document_.settings());
    settings_panel_->set_settings(document_.settings());
  }
  show_title();
  touch_scene();
}

void Program_window::edit_cut(const QString& setting, double value, const QString& merge) {
  const Setting_spec* spec = registry_->find_setting(setting.toStdString());
  if (!spec) return;
  document_.edit_settings(with_value(document_.settings(), *spec, number_value(*spec, value)),
                          QString::fromStdString(spec->label), merge);
}

void Program_window::open_popover(Popover* popover) {
  if (!popover) return;
  popover_ = popover;
  connect(popover, &Popover::closed, this, [this, popover] {
    if (popover_ == popover) popover_ = nullptr;
    common_canvas_->setFocus();
  });
}

void Program_window::restore() {
  const Preferences preferences(program_);
  constexpr QSize usual(1440, 900);
  constexpr double share_of_screen = 0.92;
  resize(usual.boundedTo(screen()->availableSize() * share_of_screen));
  restoreGeometry(preferences.value(QStringLiteral("geometry")).toByteArray());
  restoreState(preferences.value(QStringLiteral("docks")).toByteArray());
  restore_looks();
  restore_evolution();
}

void Program_window::store() {
  Preferences preferences(program_);
  preferences.set_value(QStringLiteral("geometry"), saveGeometry());
  preferences.set_value(QStringLiteral("docks"), saveState());
  store_evolution();
}

void Program_window::dragEnterEvent(QDragEnterEvent* event) {
  const auto is_local = [](const QUrl& url) { return url.isLocalFile(); };
  const auto urls = event->mimeData()->urls();
  if (std::ranges::any_of(urls, is_local)) event->acceptProposedAction();
}

void Program_window::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) paths << url.toLocalFile();
  common_files_->open(paths, event->modifiers() & (Qt::ControlModifier | Qt::ShiftModifier));
  event->acceptProposedAction();
}

void Program_window::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && notes_ && actions_) show_scene();
}

}  // namespace mesecina

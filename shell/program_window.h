// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/batch/command_line.h"
#include "layers/layer_panel.h"
#include "shell/actions.h"
#include "shell/autosave.h"
#include "shell/command_palette.h"
#include "shell/commands.h"
#include "shell/computation.h"
#include "shell/document.h"
#include "shell/evolution_control.h"
#include "shell/files.h"
#include "shell/layer_notes.h"
#include "shell/log_panel.h"
#include "shell/manual_window.h"
#include "shell/message_bar.h"
#include "shell/picture_popover.h"
#include "shell/popover.h"
#include "shell/recent_files.h"
#include "shell/recovery_bar.h"
#include "shell/settings_browser.h"
#include "shell/settings_panel.h"
#include "shell/shortcut_editor.h"
#include "shell/statistics_panel.h"
#include "shell/status_progress.h"
#include "shell/theme.h"
#include "shell/window_bundles.h"
#include "shell/window_recording.h"

class QDockWidget;
class QLabel;
class QMenu;
class QVBoxLayout;

namespace mesecina {

class Evolution_bar;

/// What a picture of the plane of this size shows; a window of another size shows all of it.
struct Seen_2 {
  View_2 view;
  int width = 1;
  int height = 1;
};

/// What a window of space shows, and the camera path it has.
struct Seen_3 {
  View_3 view;
  std::vector<Camera_3> key_frames;
};

/// What a window shows first.
struct Startup {
  std::vector<std::filesystem::path> files;  ///< none: a live example
  std::vector<std::string> layers;           ///< the visible ones; none: a sensible few
  Settings settings;
  std::map<std::string, Style> styles =
      {};                  ///< by layer: looks other than the usual ones; of `visible` `layers` decides
  bool as_listed = false;  ///< `layers` from bottom to top, not in the order of the registry
  /// None: all of the data.
  std::optional<Seen_2> seen = {};
  std::optional<Seen_3> seen_3 = {};
  std::vector<Evolution_order> evolutions = {};      ///< that the data goes through, one after the other
  std::shared_ptr<const Session> session = {};       ///< shown in place of the example; null for none
  std::optional<Canvas_background> background = {};  ///< none: the user's usual one
  std::vector<std::string> warnings = {};            ///< of what was read for it, for the bar of messages
};

/// What a command line asks for: its session with what else it says, where the session brings the data.
Startup startup_of(const Command_line& command_line);

/// What the document starts with: the settings, layers and looks of `startup`; the inputs are the example's where it
/// names no files. `usual_layers`: those for inputs, where it names none.
Document_state first_state(const Registry& registry, const Startup& startup, const Inputs& example,
                           const std::function<Layer_list(const Inputs&)>& usual_layers);

/// What the windows of all programs have in common: a document that is computed in the background, panels of layers and
/// settings around a canvas, messages, progress, files, themes. A program adds its canvas and what one can do with it.
///
/// The constructor of a program's window calls build_center(), set_files(), build_panels(), build_status_bar(),
/// begin_actions(), the make_... functions, connect_common(), make_commands() and restore(), in this order; its
/// destructor take_apart().
class Program_window : public QMainWindow {
  Q_OBJECT
 public:
  /// `program` names the preferences ("mesecina2d").
  Program_window(QString program, std::shared_ptr<const Registry> registry, Formats formats, Document_state first,
                 Document::Layers_for_inputs layers_for_inputs);

  Document& document() { return document_; }
  Computation& computation() { return computation_; }
  Evolution_control& evolution() { return evolution_; }
  Actions& actions() { return *actions_; }
  /// Null while it is closed.
  Command_palette* command_palette() const { return palette_; }
  Shortcut_editor* shortcut_editor() const { return shortcut_editor_; }
  Manual_window* manual() const { return manual_; }
  /// Everything that a line of text can do here.
  const Commands& commands() const { return *commands_; }
  /// Files are being read or written.
  bool has_file_jobs() const { return common_files_->jobs().is_busy() || common_files_->is_saving(); }
  /// That is so, or something visible is not computed yet, or steps are being made.
  /// A film is recorded that comes to its end by itself, or is as soon as the steps for it are made.
  bool is_filming() const;
  bool is_busy() const { return has_file_jobs() || computation_.is_busy() || evolution_.evolver().is_busy(); }
  Message_bar& messages() { return *messages_; }
  Settings_panel& settings_panel() { return *settings_panel_; }
  Window_bundles& bundles() { return *bundles_; }
  Layer_panel& layer_panel() { return *layer_panel_; }
  Layer_notes& layer_notes() { return *notes_; }
  Window_recording& recording() { return *recording_; }
  /// Of the widget that is open over the canvas; null for none.
  Popover* popover() const { return popover_; }

  /// Everything there is now.
  Session session() const;
  /// From now on the scene is written into the store soon after every change, and what other windows left there is
  /// offered. `is_reopening`: the scene that was closed last is shown, unless the user wants none. For programs; once.
  void keep_scenes(const std::filesystem::path& store, bool is_reopening);
  /// Closes as soon as possible, without a question: dialogs are given up, the film ends where it is, the scene is
  /// kept as when the user closes the window. closed() tells when it is done.
  void end();
  Statistics_panel& statistics() { return *statistics_; }
  Log_panel& log() { return *log_; }
  /// Null before keep_scenes(), and where the store cannot be written.
  Autosave* autosave() { return autosave_.get(); }
  Recovery_bar& recovery_bar() { return *recovery_bar_; }

  /// When everything visible is computed: draws it at once and waits until it is drawn.
  virtual void finish_drawing() = 0;

 Q_SIGNALS:
  void closed();

 protected:
  /// The canvas below the bar of messages.
  void build_center(QWidget* canvas);
  void set_files(Files* files) { common_files_ = files; }
  QDockWidget* add_dock(const QString& name, const QString& title, QWidget* widget, Qt::DockWidgetArea area);
  void build_panels();
  void build_status_bar();
  void begin_actions();
  /// Saving sessions, pictures with scenes, reopening.
  void make_session_actions();
  /// Of scenes that were kept without being saved.
  void add_earlier_scenes(QMenu* file);
  /// Something that is part of a scene, but not of the document, has changed.
  void touch_scene();
  void make_undo_actions(const QIcon& undo_icon, const QIcon& redo_icon);
  /// The arrow keys on the canvas: nudge(right, up) in pixels moves the selection, and is false when there is none.
  /// Left and Right go through the steps of an evolution then.
  void make_nudge_actions(const std::function<bool(int right, int up)>& nudge);
  void make_layer_actions();
  void make_bundle_actions();
  void add_bundle_menu(QMenu* view) const;
  /// Evolutions, their steps and playing; and the bar below the canvas.
  void make_evolution_actions();
  void add_evolution_menu();
  /// To find, reset, save and load settings.
  void make_settings_actions();
  /// Pictures of what is in view, into files and onto the clipboard.
  void make_picture_actions();
  /// Films, their panel, and animated settings. After the panels.
  void make_recording();
  /// Themes, background, full screen.
  void make_look_actions();
  void add_look_menus(QMenu* view) const;
  /// The palette of commands, the keys, what's this.
  void make_command_actions();
  void connect_common();
  /// The commands that every program has; a program adds its own. When all actions are there.
  void make_commands();
  void restore();
  void store();
  void take_apart();

  /// A small plate with text on the canvas, hidden at first.
  QLabel* make_plate(const QString& name);
  /// At the upper right of the canvas; nothing for an empty text.
  void show_facts_text(const QString& text);
  void open_popover(Popover* popover);
  Color background() const;
  /// Whether pictures are to have no background unless it is asked for.
  bool is_without_background() const { return background_ == Canvas_background::none; }
  /// Shows document, panels and files for the first time.
  void start(const Startup& startup, const QString& usual_layer);

  /// Whether there is something that paints.
  virtual bool can_paint() const { return true; }
  /// What is in view, as a picture of this size in pixels shows it. `seen`: the size of the canvas, in which all of it
  /// is in view.
  virtual Film_frame picture_frame(const QSize& size, const QSize& seen) const = 0;

  /// The newest pictures and notes onto the canvas.
  virtual void show_scene() = 0;
  virtual void show_document(const Document_change& change);
  void show_notes();
  virtual void show_title() = 0;
  /// Looks at these places, and selects the elements that are there.
  virtual void show_places(const std::vector<Place>& places) = 0;
  /// What the user is asked about before changed data is lost.
  virtual QString unsaved_text() const = 0;
  /// The data was replaced by that of files, or joined by it.
  virtual void files_loaded() = 0;
  /// Adds what is seen from where.
  virtual void add_view(Session& session) const = 0;
  /// Sees it as a session says; all of the data where it does not say.
  virtual void show_view(const Session& session) = 0;

  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;

  std::shared_ptr<const Registry> registry_;
  std::shared_ptr<const Formats> formats_;
  Document document_;
  Computation computation_;
  Evolution_control evolution_;

  Message_bar* messages_ = nullptr;
  Actions* actions_ = nullptr;
  std::unique_ptr<Commands> commands_;
  Layer_panel* layer_panel_ = nullptr;
  Settings_panel* settings_panel_ = nullptr;
  Settings_browser* settings_browser_ = nullptr;
  Window_bundles* bundles_ = nullptr;
  QDockWidget* layers_dock_ = nullptr;
  QDockWidget* bundles_dock_ = nullptr;
  QDockWidget* settings_dock_ = nullptr;
  Recent_files* recent_files_ = nullptr;
  Status_progress* evolving_ = nullptr;
  Status_progress* computing_ = nullptr;
  Status_progress* working_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* coordinates_ = nullptr;
  Layer_notes* notes_ = nullptr;
  Popover* popover_ = nullptr;

 private:
  void show_layer(const std::string& layer);
  void edit_cut(const QString& setting, double value, const QString& merge);
  void save_settings(const QString& title, const std::vector<std::string>& ids);
  void load_settings(const QString& path);
  void set_theme(Theme theme);
  void set_background(Canvas_background background);
  /// For now: the user's usual one stays what it is.
  void show_background(Canvas_background background);
  /// That which the user chose last, in this program or before.
  Canvas_background usual_background() const;
  bool may_close();
  bool is_settled() const;
  bool settle();
  void try_to_end();
  void make_bundle_commands();
  void make_evolution_commands();
  void make_recording_commands();
  void record_when_steps_are_made();
  QStringList bundle_names() const;
  void open_palette();
  void add_evolution_action(const QString& id, const QString& text, const QString& tip, const QList<QKeySequence>& keys,
                            const QIcon& icon, std::function<void()> run, bool is_for_canvas = false);
  void make_step_actions();
  void make_repeat_actions();
  void make_choice_actions();
  void show_evolution_state();
  void set_evolution_bar_visible(bool is_visible);
  void restore_looks();
  void restore_evolution();
  void store_evolution() const;
  void find_evolution_settings();
  void open_manual();
  void show_figure(const Manual_figure& figure);
  void build_reports();
  QString name_of_run();
  void record_run(const Worker::Report& report);
  void log_layer(const std::string& layer);
  void end_keeping();
  bool reopens_scenes() const;
  void show_session(const Session& session);
  void show_stored_scene(const QString& folder, const QString& step);
  void recover(const QStringList& folders);
  void keep_for_later(const QStringList& folders);
  void fill_earlier_scenes(QMenu* menu);
  bool may_lose_film();
  void export_picture();
  void copy_picture(const Picture_wish& wish);
  Picture_wish picture_wish() const;
  /// Of the canvas, in pixels of the screen.
  QSize picture_size() const;
  void open_animation(const std::string& setting, double from, double to);

  QString program_;
  Theme_switch themes_;
  Canvas_background background_ = Canvas_background::paper;
  QWidget* common_canvas_ = nullptr;
  QVBoxLayout* center_column_ = nullptr;
  Evolution_bar* evolution_bar_ = nullptr;
  std::vector<Evolution_order> first_evolutions_;  ///< when the files of the start are there
  Files* common_files_ = nullptr;
  Window_recording* recording_ = nullptr;
  QDockWidget* record_dock_ = nullptr;
  Picture_wish picture_wish_;  ///< the last; without a size there was none
  bool closes_after_film_ = false;
  std::optional<Film_wish> film_of_steps_;  ///< to be recorded when they are made
  QLabel* facts_ = nullptr;
  QPointer<Command_palette> palette_;
  QPointer<Shortcut_editor> shortcut_editor_;
  QPointer<Manual_window> manual_;
  std::vector<QDockWidget*> docks_;
  Statistics_panel* statistics_ = nullptr;
  Log_panel* log_ = nullptr;
  QDockWidget* statistics_dock_ = nullptr;
  QDockWidget* log_dock_ = nullptr;
  std::map<std::string, QStringList> logged_;  ///< by layer, what the log said of it last
  Recovery_bar* recovery_bar_ = nullptr;
  std::optional<Scene_store> store_;
  std::unique_ptr<Autosave> autosave_;
  bool is_autosave_broken_ = false;
  bool is_closing_ = false;         ///< waits for what is being written, or for an answer
  bool is_ending_ = false;          ///< nobody is there to answer
  std::filesystem::path reopened_;  ///< the kept scene that this window took up; empty for none
  Session::Unknown unknown_;        ///< of the session that was opened last
};

/// Empty when none is visible.
QString topmost_visible(const Layer_list& layers);

}  // namespace mesecina

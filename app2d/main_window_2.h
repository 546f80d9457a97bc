// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app2d/editor_2.h"
#include "app2d/files_2.h"
#include "app2d/generators_2.h"
#include "app2d/hover_2.h"
#include "app2d/input_table_2.h"
#include "app2d/tools_2.h"
#include "layers/layer_panel.h"
#include "shell/actions.h"
#include "shell/computation.h"
#include "shell/document.h"
#include "shell/layer_notes.h"
#include "shell/message_bar.h"
#include "shell/popover.h"
#include "shell/recent_files.h"
#include "shell/settings_panel.h"
#include "shell/status_progress.h"
#include "shell/theme.h"

class QDockWidget;
class QLabel;
class QWheelEvent;

namespace mesecina {

/// What a window shows first.
struct Startup {
  std::vector<std::filesystem::path> files;  ///< none: a live example
  std::vector<std::string> layers;           ///< the visible ones; none: a sensible few
  Settings settings;
};

/// The window of mesecina2d: puts canvas, panels and actions together and lets each hear of the others.
class Main_window_2 : public QMainWindow {
  Q_OBJECT
 public:
  Main_window_2(std::shared_ptr<const Registry> registry, Formats formats, const Startup& startup);
  ~Main_window_2() override;

  Document& document() { return document_; }
  Computation& computation() { return computation_; }
  Canvas_2& canvas() { return *canvas_; }
  Editor_2& editor() { return *editor_; }
  Files_2& files() { return *files_; }
  Actions& actions() { return *actions_; }
  Message_bar& messages() { return *messages_; }
  Settings_panel& settings_panel() { return *settings_panel_; }
  Input_table_2& points_table() { return *points_table_; }
  Input_table_2& disks_table() { return *disks_table_; }
  Layer_panel& layer_panel() { return *layer_panel_; }
  Layer_notes& layer_notes() { return *notes_; }

  void use_tool(const QString& id);
  /// Of the widget that is open over the canvas; null for none.
  Popover* popover() const { return popover_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void changeEvent(QEvent* event) override;
  /// Offers the wheel over the canvas to the tool before the canvas zooms.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void build_center();
  void build_docks();
  void build_status_bar();
  void make_actions();
  void make_file_actions();
  void make_edit_actions();
  void make_tool_actions();
  void make_view_actions();
  void make_menus();
  void make_tool_bar();
  void connect_parts();
  void restore();
  void store();
  void start(const Startup& startup);

  void show_scene();
  void show_notes();
  void show_overlay();
  void show_layer(const std::string& layer);
  void show_document(const Document_change& change);
  void show_hover(const Canvas_event& event);
  /// Beside this pixel of the canvas; nothing for an empty text.
  void show_readout(const QString& text, const QPointF& pixel);
  bool use_wheel(const QWheelEvent& event);
  void show_title();
  void show_selection();
  void show_facts();
  void edit_cut(const QString& setting, double value, const QString& merge);
  void escape();
  void open_menu(const QPointF& pixel);
  void open_popover(Popover* popover);
  void generate(const Generator_2& generator);
  void export_picture();
  void export_layers();
  void set_theme(Theme theme);
  void set_background(Canvas_background background);
  Color background() const;
  bool may_close();

  std::shared_ptr<const Registry> registry_;
  std::shared_ptr<const Formats> formats_;
  Document document_;
  Computation computation_;
  Theme_switch themes_;
  Canvas_background background_ = Canvas_background::paper;

  Canvas_2* canvas_ = nullptr;
  Message_bar* messages_ = nullptr;
  Editor_2* editor_ = nullptr;
  Files_2* files_ = nullptr;
  Actions* actions_ = nullptr;
  Layer_panel* layer_panel_ = nullptr;
  Settings_panel* settings_panel_ = nullptr;
  Input_table_2* points_table_ = nullptr;
  Input_table_2* disks_table_ = nullptr;
  QDockWidget* layers_dock_ = nullptr;
  QDockWidget* settings_dock_ = nullptr;
  QDockWidget* points_dock_ = nullptr;
  QDockWidget* disks_dock_ = nullptr;
  Recent_files* recent_files_ = nullptr;
  Status_progress* computing_ = nullptr;
  Status_progress* working_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* selected_ = nullptr;
  QLabel* coordinates_ = nullptr;
  QLabel* facts_ = nullptr;
  QLabel* readout_ = nullptr;
  Layer_notes* notes_ = nullptr;
  QAction* spacing_action_ = nullptr;
  Popover* popover_ = nullptr;
  std::map<QString, Tool_2*> tools_;
  Tool_2* tool_ = nullptr;
  std::unique_ptr<Hover_2> hover_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app2d/editor_2.h"
#include "app2d/files_2.h"
#include "app2d/generators_2.h"
#include "app2d/hover_2.h"
#include "app2d/input_table_2.h"
#include "app2d/tools_2.h"
#include "shell/program_window.h"

class QLabel;
class QWheelEvent;

namespace mesecina {

/// The window of mesecina2d: puts canvas, panels and actions together and lets each hear of the others.
class Main_window_2 : public Program_window {
  Q_OBJECT
 public:
  Main_window_2(const std::shared_ptr<const Registry>& registry, Formats formats, const Startup& startup);
  ~Main_window_2() override;

  Canvas_2& canvas() { return *canvas_; }
  Editor_2& editor() { return *editor_; }
  Files_2& files() { return *files_; }
  Input_table_2& points_table() { return *points_table_; }
  Input_table_2& disks_table() { return *disks_table_; }

  void use_tool(const QString& id);

 protected:
  /// Offers the wheel over the canvas to the tool before the canvas zooms.
  bool eventFilter(QObject* watched, QEvent* event) override;

  void finish_drawing() override;
  Film_frame picture_frame(const QSize& size, const QSize& seen) const override;
  void show_scene() override;
  void show_title() override;
  void show_places(const std::vector<Place>& places) override;
  void show_document(const Document_change& change) override;
  QString unsaved_text() const override;
  void files_loaded() override;
  void showEvent(QShowEvent* event) override;
  void add_view(Session& session) const override;
  void show_view(const Session& session) override;

 private:
  /// What was asked for at the start, or all of the data.
  void show_first_view();
  void build_canvas();
  void build_docks();
  void make_actions();
  void make_file_actions();
  void make_edit_actions();
  void make_tool_actions();
  void make_view_actions();
  void make_menus();
  void make_tool_bar();
  void connect_parts();
  void make_own_commands();
  void make_insert_commands();
  void make_selection_commands();
  void make_view_commands();

  void show_overlay();
  void show_hover(const Canvas_event& event);
  /// Beside this pixel of the canvas; nothing for an empty text.
  void show_readout(const QString& text, const QPointF& pixel);
  bool use_wheel(const QWheelEvent& event);
  void show_selection();
  void escape();
  void open_menu(const QPointF& pixel);
  void generate(const Generator_2& generator);
  /// "fit", or four sides. Throws Command_error.
  void view_box(const QStringList& words);
  void export_layers();

  Canvas_2* canvas_ = nullptr;
  Editor_2* editor_ = nullptr;
  Files_2* files_ = nullptr;
  Input_table_2* points_table_ = nullptr;
  Input_table_2* disks_table_ = nullptr;
  QLabel* selected_ = nullptr;
  QLabel* readout_ = nullptr;
  QAction* spacing_action_ = nullptr;
  std::map<QString, Tool_2*> tools_;
  Tool_2* tool_ = nullptr;
  std::unique_ptr<Hover_2> hover_;
  std::optional<Seen_2> seen_first_;  ///< until the data is there
  bool was_shown_ = false;
};

}  // namespace mesecina

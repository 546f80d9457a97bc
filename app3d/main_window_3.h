// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "app3d/camera_player_3.h"
#include "app3d/editor_3.h"
#include "app3d/files_3.h"
#include "app3d/generators_3.h"
#include "app3d/hover_3.h"
#include "app3d/input_table_3.h"
#include "app3d/plane_handle_3.h"
#include "app3d/tools_3.h"
#include "app3d/viewer_3.h"
#include "shell/program_window.h"

class QLabel;

namespace mesecina {

/// The window of mesecina3d: puts viewer, panels and actions together and lets each hear of the others. Without OpenGL
/// there is a message in place of the viewer, and everything else works.
class Main_window_3 : public Program_window {
  Q_OBJECT
 public:
  Main_window_3(const std::shared_ptr<const Registry>& registry, Formats formats, const Startup& startup);
  ~Main_window_3() override;

  /// Null without OpenGL.
  Viewer_3* viewer() { return viewer_; }
  /// Null without OpenGL.
  Hover_3* hover() { return hover_.get(); }
  /// Null without OpenGL.
  Plane_handle_3* plane() { return plane_.get(); }
  /// Null without OpenGL.
  Camera_player_3* player() { return player_.get(); }
  Files_3& files() { return *files_; }
  Editor_3& editor() { return *editor_; }
  Input_table_3& points_table() { return *points_table_; }
  Input_table_3& balls_table() { return *balls_table_; }
  /// Does nothing without OpenGL.
  void use_tool(const QString& id);
  void finish_drawing() override;

 protected:
  bool can_paint() const override { return viewer_ != nullptr; }
  Film_frame picture_frame(const QSize& size, const QSize& seen) const override;
  void show_scene() override;
  void show_title() override;
  void show_places(const std::vector<Place>& places) override;
  QString unsaved_text() const override;
  void files_loaded() override;
  void add_view(Session& session) const override;
  void show_view(const Session& session) override;
  void showEvent(QShowEvent* event) override;

 private:
  void build_canvas();
  void build_docks();
  void make_actions();
  void make_file_actions();
  void make_save_actions();
  void make_edit_actions();
  void make_tool_actions();
  void make_insert_actions();
  void make_view_actions();
  void make_standard_views();
  void make_camera_actions();
  void make_plane_actions();
  void make_path_actions();
  void add_view_menus(QMenu* view) const;
  void restore_camera_habits();
  void store_camera_habits();
  void apply_camera_habits();
  void show_view_state();
  void make_help_actions();
  void make_menus();
  void make_editing_menus();
  void make_tool_bar();
  void connect_editing();
  void make_own_commands();
  void make_insert_commands();
  void make_selection_commands();
  void make_view_commands();
  void show_selection();
  void show_tool(const QPointF& pixel);
  /// Beside this pixel of the viewer; nothing for an empty text.
  void show_readout(const QString& text, const QPointF& pixel);
  void generate(const Generator_3& generator);
  /// Where a generator puts what it makes: the center and half the side of a cube.
  std::pair<Point_3, double> usual_place() const;
  void show_hover();
  /// All of the data from the front, a little from the right and above.
  View_3 first_view() const;
  void fit();
  /// What was asked for at the start, or all of the data.
  void show_first_view();
  void escape();
  void export_layers();
  void save_view();
  void open_view();
  /// The view with its key frames, as a view file has it.
  std::string view_text() const;
  /// Throws std::invalid_argument.
  void read_view(const std::string& text);
  void paste_view();
  /// As the viewer has it; without one, of all the data.
  View_3 seen_view() const;
  /// "fit", a view file or its text. Throws Command_error.
  void view_text_or_file(const QString& text);
  void open_plane_popover();

  QWidget* canvas_ = nullptr;
  Viewer_3* viewer_ = nullptr;
  Files_3* files_ = nullptr;
  Editor_3* editor_ = nullptr;
  Input_table_3* points_table_ = nullptr;
  Input_table_3* balls_table_ = nullptr;
  QLabel* selected_ = nullptr;
  QLabel* readout_ = nullptr;
  std::map<QString, Tool_3*> tools_;  ///< empty without OpenGL
  Tool_3* tool_ = nullptr;
  std::unique_ptr<Hover_3> hover_;
  std::unique_ptr<Plane_handle_3> plane_;
  std::unique_ptr<Camera_player_3> player_;
  Mouse_preset mouse_ = Mouse_preset::standard;
  std::optional<Seen_3> seen_first_;  ///< until the data is there
  bool is_view_chosen_ = false;       ///< by the first fit; before, the size of the window is not known
};

}  // namespace mesecina

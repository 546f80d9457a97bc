// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "app3d/edits_3.h"
#include "app3d/mesh_transform_3.h"
#include "shell/document.h"

namespace mesecina {

/// The layers that show the balls and points which can be edited, and the mesh.
inline constexpr std::string_view balls_layer = "given-balls";
inline constexpr std::string_view points_layer = "points";
inline constexpr std::string_view mesh_layer = "mesh";

/// What a user does to balls, points and meshes, in the words of the undo list. Tools, menus and keys all go through
/// it.
class Editor_3 : public QObject {
  Q_OBJECT
 public:
  explicit Editor_3(Document& document, QObject* parent = nullptr);

  Document& document() { return document_; }
  const Document& document() const { return document_; }
  const Selection_3& selection() const { return selection_; }
  /// Only what is shown can be taken hold of.
  Reach_3 reach() const;

  void select(Selection_3 selection);
  void select_all();
  void invert_selection();

  /// The new point is selected, and the layer of points shown.
  void add_point(const Point_3& place);
  /// As add_point.
  void add_ball(const Ball_3& ball);
  /// Of the ball that was added or resized alone last; before that, a part of what is `seen` from the bottom to the top
  /// of the picture.
  double usual_radius(double seen) const;

  /// From begin_drag to the last drag_... it is one step; back at the start it is none.
  void begin_drag();
  void drag_by(const Point_3& shift);
  /// This selected ball gets this radius, and the other selected balls grow or shrink by the same factor. Does nothing
  /// for a radius that is not positive.
  void drag_radius(std::size_t ball, double radius);
  /// Before the drag; none for a ball that was not there.
  std::optional<Ball_3> dragged_ball(std::size_t ball) const;
  const Inputs& drag_start() const { return drag_start_; }
  /// Resizes the selected balls by a factor for each degree of the wheel. Turning on is the same step, turning back to
  /// the start none.
  void turn_wheel(double degrees);
  void nudge(const Point_3& shift);
  /// One row of a table. Nothing happens for an element that is not there or has these numbers already.
  void change_point(std::size_t index, const Point_3& point, const QString& merge = {});
  void change_ball(std::size_t index, const Ball_3& ball, const QString& merge = {});

  /// Undo selects what it brings back.
  void remove_selected();
  /// The copies are beside the originals by this much, and selected.
  void duplicate(const Point_3& shift);
  /// The selected points and balls as rows of text; does nothing where none are.
  void copy() const;
  void cut();
  /// Adds what the rows of the clipboard are, and selects it.
  void paste();
  /// Rows "x y z" or "x y z radius", like in a table file, or both. False, with a message, and nothing is added, where
  /// the text is not that.
  bool paste_text(const QString& text);
  /// Transforms what there was in `start`. Steps with the same merge key are one.
  void transform(const Inputs& start, const Transform_3& transform, const QString& merge);

  /// "3 points", "1 point and 2 balls"
  static QString words(const Selection_3& selection);

 Q_SIGNALS:
  void selection_changed();
  void failed(const QString& message);

 private:
  void react(const Document_change& change);
  void edit(Inputs inputs, Selection_3 selection, const QString& text, const QString& merge = {});
  void add(const Inputs& pasted);
  void show_layer(std::string_view layer, const QString& text, const QString& merge);
  void remember_radius();
  QString merge_key(const QString& kind) const;

  Document& document_;
  Selection_3 selection_;
  bool is_editing_ = false;
  int gesture_ = 0;  ///< numbers drags and selections, for merge keys
  Inputs drag_start_;
  std::optional<double> last_radius_;

  /// A run of the wheel goes on as long as nothing else happens.
  struct Wheel_run {
    Inputs start;
    Inputs end;
    double degrees = 0;
    int gesture = -1;
  };
  Wheel_run wheel_run_;

  struct Removal {
    Inputs before;
    Selection_3 selection;
  };
  std::deque<Removal> removals_;
};

}  // namespace mesecina

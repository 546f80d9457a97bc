// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPoint>
#include <QString>
#include <optional>
#include <vector>

#include "app2d/edits_2.h"
#include "core/formats/format.h"
#include "layers/canvas_2.h"
#include "shell/document.h"

namespace mesecina {

/// Where a selected disk can be taken hold of to change its radius.
struct Disk_handle_2 {
  std::size_t disk = 0;
  Point_2 position;
  bool is_horizontal = false;  ///< beside the center, else above or below it
};

/// What a user does to points, outlines and disks, in the words of the undo list. Tools, menus and keys all go through
/// it.
class Editor_2 : public QObject {
  Q_OBJECT
 public:
  Editor_2(Document& document, Canvas_2& canvas, const Formats& formats, QObject* parent = nullptr);

  Document& document() { return document_; }
  Canvas_2& canvas() { return canvas_; }
  const Selection_2& selection() const { return selection_; }
  /// Only what is shown can be taken hold of.
  Reach_2 reach() const;
  /// The point, vertex or disk (by its center or boundary) under the cursor; empty if there is none near.
  Selection_2 at(const Canvas_event& event) const;
  /// Four for each selected disk; none when more than fifty are selected, where they would only hide the picture. A
  /// disk that is small on the screen has its handles outside of it, or none when others are selected, too.
  std::vector<Disk_handle_2> handles() const;
  /// The nearest of them under the cursor.
  std::optional<Disk_handle_2> handle_at(const Canvas_event& event) const;
  /// In the disk or on its boundary. O(selected disks).
  bool is_over_selected_disk(const Canvas_event& event) const;

  void select(Selection_2 selection);
  void select_all();
  /// The new point is selected. A non-empty merge key joins points that follow each other to one step.
  void add_point(const Point_2& position, const QString& merge = {});
  void add_ring(Ring_2 ring);
  /// The new disk is selected; the merge key is as for points.
  void add_disk(const Disk_2& disk, const QString& merge = {});
  /// Of the disk that was drawn or resized alone last; before that, one that is well seen in this view.
  double usual_radius() const;

  /// From begin_drag to the last drag_by it is one step; back at the start it is none.
  void begin_drag();
  void drag_by(double dx, double dy);
  /// As drag_by: the radius of this selected disk becomes that at the start of the drag plus `change`, but half a pixel
  /// at least, and the other selected disks grow or shrink by the same factor.
  void drag_radius(std::size_t disk, double change);
  /// Resizes the selected disks by a factor for each degree of the wheel. Turning on is the same step, turning back to
  /// the start none.
  void turn_wheel(double degrees);
  void nudge(double dx, double dy);
  void place(const Point_2& position, const QString& merge);
  /// One row of the table.
  void place_point(std::size_t index, const Point_2& position);
  /// Another center or radius for one disk. Does nothing for a disk that is not there.
  void change_disk(std::size_t index, const Disk_2& disk, const QString& merge = {});

  void remove_selected();
  void duplicate();
  void copy();
  void cut();
  void paste();
  /// Points or disks as text, one per line like in a table file, or both as copy() writes them. False, with a message,
  /// when the text is none.
  bool paste_text(const QString& text);

  /// "3 points", "1 point, 2 vertices and 1 disk"
  static QString words(const Selection_2& selection);

 Q_SIGNALS:
  void selection_changed();
  void failed(const QString& message);
  void menu_requested(const QPointF& pixel);

 private:
  void react(const Document_change& change);
  void edit(Inputs inputs, Selection_2 selection, const QString& text, const QString& merge = {});
  void remember_radius();

  Document& document_;
  Canvas_2& canvas_;
  const Formats& formats_;
  Selection_2 selection_;
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
};

}  // namespace mesecina

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

/// What a user does to points and outlines, in the words of the undo list. Tools, menus and keys all go through it.
class Editor_2 : public QObject {
  Q_OBJECT
 public:
  Editor_2(Document& document, Canvas_2& canvas, const Formats& formats, QObject* parent = nullptr);

  Document& document() { return document_; }
  Canvas_2& canvas() { return canvas_; }
  const Selection_2& selection() const { return selection_; }
  /// Only what is shown can be taken hold of.
  Reach_2 reach() const;
  /// The point or vertex under the cursor; empty if there is none near.
  Selection_2 at(const Canvas_event& event) const;

  void select(Selection_2 selection);
  void select_all();
  /// The new point is selected. A non-empty merge key joins points that follow each other to one step.
  void add_point(const Point_2& position, const QString& merge = {});
  void add_ring(Ring_2 ring);

  /// From begin_drag to the last drag_by it is one step; back at the start it is none.
  void begin_drag();
  void drag_by(double dx, double dy);
  void nudge(double dx, double dy);
  void place(const Point_2& position, const QString& merge);
  /// One row of the table.
  void place_point(std::size_t index, const Point_2& position);

  void remove_selected();
  void duplicate();
  void copy();
  void cut();
  void paste();
  /// Points as text, one per line like in a table file. False, with a message, when the text is none.
  bool paste_text(const QString& text);

  /// "3 points", "1 point and 2 vertices"
  static QString words(const Selection_2& selection);

 Q_SIGNALS:
  void selection_changed();
  void failed(const QString& message);
  void menu_requested(const QPointF& pixel);

 private:
  void react(const Document_change& change);
  void edit(Inputs inputs, Selection_2 selection, const QString& text, const QString& merge = {});

  Document& document_;
  Canvas_2& canvas_;
  const Formats& formats_;
  Selection_2 selection_;
  bool is_editing_ = false;
  int gesture_ = 0;  ///< numbers drags and selections, for merge keys
  Inputs drag_start_;
};

}  // namespace mesecina

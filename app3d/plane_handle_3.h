// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <memory>
#include <optional>

#include "app3d/plane_frame_3.h"
#include "app3d/sight_3.h"
#include "app3d/viewer_3.h"

namespace mesecina {

/// The cutting plane of a viewer in the hand: its arrow moves it along the normal, its frame turns it, and the wheel
/// with Ctrl moves it too. Does nothing while the viewer has no plane.
class Plane_handle_3 : public QObject, public Viewer_tool_3 {
  Q_OBJECT
 public:
  enum class Part { none, arrow, frame };

  /// Becomes the handle of the viewer.
  explicit Plane_handle_3(Viewer_3& viewer, QObject* parent = nullptr);
  ~Plane_handle_3() override;
  Plane_handle_3(const Plane_handle_3&) = delete;
  Plane_handle_3& operator=(const Plane_handle_3&) = delete;

  /// The plane's frame is around this; for an empty box around a cube of size 2.
  void set_box(const Box& box);
  /// Never without a size.
  const Box& box() const { return box_; }
  Point_3 middle() const { return midpoint(box_.lower, box_.upper); }
  /// None without a plane.
  std::optional<Plane_frame_3> frame() const;
  Part part_at(const QPointF& pixel) const;

  // What actions do; previous_view() of the viewer leads back.
  /// The plane that was there last, or one through the middle that faces the viewer; none if there is one.
  void toggle();
  /// Makes one where there is none.
  void align(const Point_3& normal);
  void flip();
  void set_plane(const Cutting_plane_3& plane);

  bool press(const QMouseEvent& event) override;
  void drag(const QMouseEvent& event) override;
  void release(const QMouseEvent& event) override;
  bool double_click(const QMouseEvent& event) override;
  bool wheel(const QWheelEvent& event) override;
  std::vector<Scene_layer> overlay() const override;
  void paint(QPainter& painter) const override;

 private:
  Sight_3 sight() const;
  Color color() const;
  void follow();
  void look_at(const QPointF& pixel);
  /// The plane that was there last if it cuts the box, or one through its middle that faces the viewer.
  Cutting_plane_3 new_plane() const;

  Viewer_3& viewer_;
  Box box_ = sized({});
  std::optional<Cutting_plane_3> last_;
  Part dragged_ = Part::none;
  Part hovered_ = Part::none;
  QPointF before_;
  std::optional<Cutting_plane_3> shown_;  ///< of which the outline is
  std::shared_ptr<const Primitive_set> outline_;
};

}  // namespace mesecina

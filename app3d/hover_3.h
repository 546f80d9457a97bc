// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app3d/viewer_3.h"
#include "core/registry.h"
#include "shell/computation.h"

namespace mesecina {

/// What is known of the element under the mouse.
struct Hovered_3 {
  std::string layer;
  std::string label;
  std::size_t element = 0;
  Point_3 place;                                   ///< on the element, where the mouse is
  std::shared_ptr<const Primitive_set> source;     ///< the picture of the layer in which it was found
  std::shared_ptr<const Primitive_set> highlight;  ///< the element alone
  std::shared_ptr<const Primitive_set> dual;       ///< null until known, or when there is none
  std::vector<Fact> facts;
};

/// Finds out what the mouse rests on, by the picture of ids: costs nothing while neither scene nor view change.
class Hover_3 : public QObject {
  Q_OBJECT
 public:
  Hover_3(Computation& computation, Viewer_3& viewer, QObject* parent = nullptr);

  /// Asks soon what is at this pixel.
  void look_at(const QPointF& pixel);
  void forget();
  /// Drops what was found when its layer has changed since.
  void check();
  const std::optional<Hovered_3>& hovered() const { return hovered_; }
  /// "name: text" lines; empty when nothing is hovered.
  QString text() const;
  /// The element and its dual, to be drawn over the scene.
  std::vector<Scene_layer> overlay() const;

 Q_SIGNALS:
  void changed();

 private:
  void ask();

  Computation& computation_;
  Viewer_3& viewer_;
  QTimer timer_;
  QPointF pixel_;
  std::optional<Hovered_3> hovered_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/scene_store.h"

class QVBoxLayout;

namespace mesecina {

/// Offers scenes of windows that ended without being closed: one line for each scene, with its newest state; older
/// states of it are in a menu. It never takes the focus nor waits for an answer, and hides when nothing is left to
/// offer.
class Recovery_bar : public QFrame {
  Q_OBJECT
 public:
  explicit Recovery_bar(QWidget* parent = nullptr);

  /// The newest first.
  void offer(const std::vector<Stored_scene>& scenes);
  /// Lines.
  std::size_t offers() const { return offers_; }

 Q_SIGNALS:
  /// The user wants to see one of these states of a scene, the first, and keep the others for later.
  void recovery_requested(const QStringList& folders);
  /// The user does not want to see it now.
  void declined(const QStringList& folders);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void add(const std::vector<Stored_scene>& states);

  QVBoxLayout* column_;
  std::size_t offers_ = 0;
};

/// "today 14:03"
QString words_for(std::chrono::system_clock::time_point time);
/// "giraffe.wkt (1 204 points, 3 layers), today 14:03"; the words for a scene in menus and messages.
QString words_for(const Stored_scene& scene);

}  // namespace mesecina

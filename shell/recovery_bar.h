// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <filesystem>
#include <functional>
#include <vector>

#include "core/scene_store.h"

class QVBoxLayout;

namespace mesecina {

/// Offers scenes of windows that ended without being closed, one line each with two buttons. It never takes the focus
/// nor waits for an answer, and hides when nothing is left to offer.
class Recovery_bar : public QFrame {
  Q_OBJECT
 public:
  explicit Recovery_bar(QWidget* parent = nullptr);

  void offer(const std::vector<Stored_scene>& scenes);
  std::size_t offers() const { return offers_; }

 Q_SIGNALS:
  /// The user wants to see it.
  void recovery_requested(const QString& folder);
  /// The user does not want to see it now.
  void declined(const QString& folder);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void add(const Stored_scene& scene);

  QVBoxLayout* column_;
  std::size_t offers_ = 0;
};

/// "giraffe.wkt, today 14:03"; the words for a scene in menus and messages.
QString words_for(const Stored_scene& scene);

}  // namespace mesecina

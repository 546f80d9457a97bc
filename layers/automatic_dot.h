// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace mesecina {

/// Stands beside a field: a filled dot where the number was chosen, to be clicked to make it automatic again, else an
/// empty one.
class Automatic_dot : public QToolButton {
  Q_OBJECT
 public:
  explicit Automatic_dot(QWidget* parent = nullptr);
  void show_chosen(bool is_chosen);
};

}  // namespace mesecina

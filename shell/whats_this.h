// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace mesecina {

/// Lets “what’s this” answer for every control: one without a text of its own says what its tip says, and one without a
/// tip what that says in which it lies. Install it on the application.
class Whats_this_from_tips : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/panel_focus.h"

#include <QApplication>
#include <QDockWidget>

namespace mesecina {

bool leave_panel(QWidget& canvas) {
  for (QWidget* widget = QApplication::focusWidget(); widget; widget = widget->parentWidget()) {
    if (!qobject_cast<QDockWidget*>(widget) || widget->parentWidget() != canvas.window()) continue;
    canvas.window()->activateWindow();
    canvas.setFocus(Qt::ShortcutFocusReason);
    return true;
  }
  return false;
}

}  // namespace mesecina

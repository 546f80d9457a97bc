// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/whats_this.h"

#include <QAbstractItemView>
#include <QEvent>
#include <QMenu>
#include <QWidget>

namespace mesecina {

bool Whats_this_from_tips::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::QueryWhatsThis && event->type() != QEvent::WhatsThis) return false;
  auto* widget = qobject_cast<QWidget*>(watched);
  // Lists and menus answer for the row under the mouse.
  if (!widget || !widget->whatsThis().isEmpty() || qobject_cast<QMenu*>(widget) ||
      qobject_cast<QAbstractItemView*>(widget->parentWidget()))
    return false;
  if (!widget->toolTip().isEmpty()) widget->setWhatsThis(widget->toolTip());
  return false;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QStringList>
#include <QTextEdit>
#include <QWidget>

namespace mesecina {

/// Is it a control of ours, and not a part that Qt makes of another?
inline bool is_own_control(const QWidget* widget) {
  const bool is_control = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
                          qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget) ||
                          qobject_cast<const QAbstractSlider*>(widget) ||
                          qobject_cast<const QAbstractItemView*>(widget) || qobject_cast<const QTextEdit*>(widget);
  if (!is_control || widget->objectName().startsWith(QLatin1String("qt_"))) return false;
  if (qobject_cast<const QScrollBar*>(widget) || qobject_cast<const QHeaderView*>(widget)) return false;
  for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
    if (qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent) ||
        qobject_cast<const QLineEdit*>(parent) || qobject_cast<const QAbstractItemView*>(parent) ||
        parent->inherits("QKeySequenceEdit"))
      return false;
    // The buttons in the corner of tabs, docks and menus.
    if (parent->inherits("QTabBar") || parent->inherits("QMenuBar")) return false;
  }
  return true;
}

/// One line for each control in the window without a tip or a name for those who do not see it.
inline QStringList faults_of_controls(const QWidget& window) {
  QStringList faults;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (const auto* dock = qobject_cast<const QDockWidget*>(widget); dock && dock->whatsThis().isEmpty())
      faults << QStringLiteral("no what's this: dock ") + dock->objectName();
    if (!is_own_control(widget)) continue;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const QString text = button ? button->text() : QString();
    const QString place =
        QStringLiteral("%1 '%2' '%3' in %4 %5")
            .arg(QLatin1String(widget->metaObject()->className()), widget->objectName(),
                 widget->accessibleName() + text, QLatin1String(widget->parentWidget()->metaObject()->className()),
                 widget->parentWidget()->objectName());
    // Tips and explanations of the row that a control is in are its own, too.
    const QWidget* row = widget->parentWidget();
    if ((widget->toolTip() + widget->whatsThis() + row->toolTip()).isEmpty())
      faults << QStringLiteral("no tip: ") + place;
    if (widget->accessibleName().isEmpty() && text.isEmpty()) faults << QStringLiteral("no name: ") + place;
  }
  return faults;
}

}  // namespace mesecina

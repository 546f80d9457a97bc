// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "shell/settings_panel.h"

class QLineEdit;
class QToolButton;

namespace mesecina {

/// The panel of settings below a field that searches it.
class Settings_browser : public QWidget {
  Q_OBJECT
 public:
  /// Takes the panel over.
  explicit Settings_browser(Settings_panel* panel, QWidget* parent = nullptr);

  /// In a menu beside the field.
  void set_menu_actions(const QList<QAction*>& actions);
  /// Shows one setting (its id, or any words) and puts the focus into the field.
  void search(const QString& words);

 private:
  Settings_panel* panel_;
  QLineEdit* filter_;
  QToolButton* changed_only_;
  QToolButton* more_;
};

}  // namespace mesecina

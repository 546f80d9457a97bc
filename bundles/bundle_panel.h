// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <QWidget>
#include <vector>

#include "core/bundle.h"

class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace mesecina {

/// The list of bundles. It shows what it was given and tells what the user wants; rows count from 0, also while the
/// filter hides some.
class Bundle_panel : public QWidget {
  Q_OBJECT
 public:
  explicit Bundle_panel(QWidget* parent = nullptr);

  void set_bundles(const std::vector<Bundle>& bundles);
  /// One per bundle: why it has nothing to show now; empty where it has. Such rows are dimmed.
  void set_reasons(const QStringList& reasons);
  /// Marks the row whose bundle is on screen, or was until something of it was changed; -1 for none.
  void set_shown(int row, bool is_changed = false);
  /// In a menu beside the filter, and where a bundle is clicked with the right button.
  void set_menu_actions(const QList<QAction*>& list_actions, const QList<QAction*>& bundle_actions);

  /// -1 for none.
  int selected() const;
  void select(int row);
  /// Lets the user type the name of this bundle in the list.
  void edit_name(int row);

 Q_SIGNALS:
  void chosen(int row);
  void renamed(int row, const QString& name);
  /// The bundle of row `from` goes where it has the row `to` afterwards.
  void moved(int from, int to);
  void remove_requested(int row);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  static void explain(QListWidgetItem* item);
  void tell_rename(const QListWidgetItem* item);
  void filter();
  void open_menu(const QPoint& position);

  QLineEdit* filter_;
  QToolButton* more_;
  QListWidget* list_;
  QList<QAction*> bundle_actions_;
  bool is_filling_ = false;
};

}  // namespace mesecina

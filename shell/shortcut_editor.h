// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QKeySequence>
#include <QList>
#include <QString>
#include <vector>

#include "shell/actions.h"

class QKeySequenceEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace mesecina {

/// A window in which the user gives actions other keys; what is changed there acts at once and is remembered. It never
/// blocks the other windows, and deletes itself when closed.
class Shortcut_editor : public QDialog {
  Q_OBJECT
 public:
  Shortcut_editor(Actions& actions, QWidget* parent);

  /// Lists only actions with these words in name, tip, group or id; or, where there are keys, those with such keys.
  void filter(const QString& words, const QKeySequence& keys = {});
  /// Ids of the actions listed now.
  QStringList listed() const;
  void choose(const QString& id);
  /// Gives the chosen action these keys. Where another one has them, asks inline before it changes anything.
  void assign(const QKeySequence& keys);
  /// What is asked; empty when nothing is.
  QString question() const;

 public Q_SLOTS:
  /// The answer to question(): the keys leave the action that had them.
  void take_over();
  void dismiss_question();

 private:
  void build_search();
  void build_list();
  void build_chosen();
  void fill();
  void show_keys(const QString& id);
  void show_chosen();
  void set_keys(const QString& id, const QKeySequence& keys);
  QString chosen() const;

  Actions& actions_;
  QLineEdit* search_ = nullptr;
  QKeySequenceEdit* search_keys_ = nullptr;
  QTreeWidget* list_ = nullptr;
  QLabel* chosen_name_ = nullptr;
  QKeySequenceEdit* keys_ = nullptr;
  QPushButton* clear_ = nullptr;
  QPushButton* reset_ = nullptr;
  QPushButton* reset_all_ = nullptr;
  QWidget* conflict_ = nullptr;
  QLabel* conflict_text_ = nullptr;
  QKeySequence wanted_;
  std::vector<QTreeWidgetItem*> rows_;  ///< in the order of the actions
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QIcon>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

class QMenu;
class QToolBar;

namespace mesecina {

/// Everything a user can do, each named once: menus, tool bars and the sheet of keys are made from it.
class Actions : public QObject {
  Q_OBJECT
 public:
  struct Spec {
    QString id;    ///< kebab-case; also the object name of its QAction
    QString text;  ///< as in the menu, with its mnemonic
    QString tip;   ///< a sentence
    QList<QKeySequence> shortcuts = {};
    QIcon icon = {};
    bool is_checkable = false;
    QWidget* scope = nullptr;  ///< the keys work only while it, or a child of it, has the focus; null: everywhere
  };

  /// The window that the shortcuts belong to.
  explicit Actions(QWidget* window);

  /// `group` is a heading of the sheet of keys. Throws std::logic_error when the id is taken.
  QAction* add(const QString& group, const Spec& spec, std::function<void()> run);
  /// Throws std::out_of_range for an unknown id.
  QAction* operator[](const QString& id) const;
  void add_to(QMenu* menu, const QStringList& ids) const;         ///< "-" for a separator
  void add_to(QToolBar* tool_bar, const QStringList& ids) const;  ///< "-" for a separator

  struct Entry {
    QString group;
    QAction* action = nullptr;
  };
  const std::vector<Entry>& entries() const { return entries_; }
  /// One sentence for each action that lacks a name or a tip, and each key that two actions claim. For tests.
  QStringList faults() const;

 private:
  QWidget* window_;
  std::vector<Entry> entries_;
};

}  // namespace mesecina

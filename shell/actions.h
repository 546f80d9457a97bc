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
#include <map>
#include <vector>

class QMenu;
class QToolBar;

namespace mesecina {

/// The name of an action without the mnemonic and the dots of its text in a menu.
QString plain_text(QString menu_text);

/// Everything a user can do, each named once: menus, tool bars, the palette and the sheet of keys are made from it. The
/// user's own keys take the place of the usual ones, and are remembered between runs.
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

  /// The window that the shortcuts belong to. `program` names the preferences that keep the user's own keys
  /// ("mesecina2d"); they are read here.
  Actions(QString program, QWidget* window);

  /// `group` is a heading of the sheet of keys. Throws std::logic_error when the id is taken.
  QAction* add(const QString& group, const Spec& spec, std::function<void()> run);
  /// Throws std::out_of_range for an unknown id.
  QAction* operator[](const QString& id) const;
  void add_to(QMenu* menu, const QStringList& ids) const;         ///< "-" for a separator
  void add_to(QToolBar* tool_bar, const QStringList& ids) const;  ///< "-" for a separator

  struct Entry {
    QString group;
    QAction* action = nullptr;
    QString name;                      ///< as it was added, without mnemonic; texts in menus may change
    QList<QKeySequence> usual_keys{};  ///< those of the program
  };
  const std::vector<Entry>& entries() const { return entries_; }
  /// Null for an unknown id.
  const Entry* find(const QString& id) const;

  /// Gives the action these keys from now on and in later runs. Keys of others are not taken from them. Throws
  /// std::out_of_range for an unknown id.
  void set_keys(const QString& id, const QList<QKeySequence>& keys);
  /// The usual keys again: of one action, or of all.
  void reset_keys(const QString& id);
  void reset_all_keys();
  bool has_own_keys(const QString& id) const { return own_keys_.count(id) > 0; }
  /// The action with this key, or with one that begins with it or that it begins with, other than `except`; null for
  /// none. Such two would never be told apart.
  const Entry* holder_of(const QKeySequence& keys, const QString& except = {}) const;

  /// One sentence for each action that lacks a name or a tip, and each key that two actions claim. For tests.
  QStringList faults() const;

 Q_SIGNALS:
  void keys_changed(const QString& id);

 private:
  void apply_keys(const Entry& entry);
  void store_keys() const;

  QString program_;
  QWidget* window_;
  std::vector<Entry> entries_;
  std::map<QString, QList<QKeySequence>> own_keys_;
};

}  // namespace mesecina

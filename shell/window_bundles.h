// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/bundle.h"
#include "core/session.h"
#include "shell/bundle_store.h"

class QAction;
class QDockWidget;
class QMenu;

namespace mesecina {

class Actions;
class Bundle_panel;
class Document;
class Files;
class Message_bar;

/// The bundles of a window: what the panel and the actions do with the list and the document.
class Window_bundles : public QObject {
  Q_OBJECT
 public:
  /// Reads the user's list.
  Window_bundles(std::shared_ptr<const Registry> registry, Document& document, Message_bar& messages,
                 const QString& program, QWidget* parent);

  Bundle_panel* panel() { return panel_; }
  Bundle_store& store() { return store_; }

  /// Bundles keep and show views by these; without them, they do not.
  void set_view_access(std::function<void(Bundle&)> read, std::function<void(const Bundle&)> show);
  /// Bundles keep the background with the view.
  void set_background_access(std::function<Canvas_background()> read, std::function<void(Canvas_background)> show);
  /// `dock` is shown when a name is to be typed. `files` asks for names of files.
  void make_actions(Actions& actions, QDockWidget* dock, Files* files);

  /// The bundle that layers, looks and settings are those of; or, where they are those of none, the one that was shown
  /// or kept last.
  std::optional<Session::Bundle_name> in_force() const;
  /// To give the selected bundle a key.
  QMenu* key_menu() const { return give_menu_; }

  /// Does nothing for a row that is not there.
  void apply(int row);
  /// Shows the bundle that the digit belongs to, or nothing.
  void apply_key(int key);
  /// The digit, 0 for none, for the bundle of this row, and no longer for another one; nullopt: by its place in the
  /// list.
  void give_key_to(int row, std::optional<int> key);
  void save_as_new(bool with_view);
  /// Adds the bundles of the file, `.bnd` or JSON, and tells what was in it.
  void import_file(const QString& path);
  void export_file(const QString& path);

 private:
  Bundle current(const QString& name) const;
  void change(int row, const QString& text, const std::function<void(std::vector<Bundle>&)>& change);
  void update(int row);
  void rename(int row, const QString& name);
  void remove(int row);
  void show_list();
  void mark_shown();
  void mark_what_is_missing();
  void make_key_actions(Actions& actions);
  void name_key_actions();
  void mark_given_key();

  std::shared_ptr<const Registry> registry_;
  Document& document_;
  Message_bar& messages_;
  Bundle_store store_;
  Bundle_panel* panel_;
  QDockWidget* dock_ = nullptr;
  Files* files_ = nullptr;
  std::function<void(Bundle&)> read_view_;
  std::function<void(const Bundle&)> show_view_;
  std::function<Canvas_background()> read_background_;
  std::function<void(Canvas_background)> show_background_;
  std::vector<QAction*> digit_actions_;  ///< that show a bundle, 1 to 9
  std::vector<QAction*> give_actions_;   ///< that give the selected bundle a digit: 1 to 9, none, the usual one
  QMenu* give_menu_ = nullptr;
};

}  // namespace mesecina

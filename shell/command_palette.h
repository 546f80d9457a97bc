// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>
#include <memory>
#include <vector>

#include "shell/palette_sources.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace mesecina {

/// A plate over the upper middle of a window: type some letters of what you want, Enter does it, Esc closes. What was
/// used last comes first, also in later runs. Deletes itself when closed.
class Command_palette : public QFrame {
  Q_OBJECT
 public:
  /// `program` names the preferences that keep what was used ("mesecina2d").
  Command_palette(QString program, std::vector<std::unique_ptr<Palette_source>> sources, QWidget* window);

  void open();
  void set_query(const QString& query);
  const QString& query() const { return query_; }
  /// What is listed, best first.
  const std::vector<Palette_item>& items() const { return items_; }
  /// Of the row that Enter takes; -1 for none.
  int current() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void fill();
  void place();
  void show_detail();
  void take_current();
  void dismiss();
  bool use_key(int key, Qt::KeyboardModifiers modifiers);
  void remember(const QString& key);

  QString program_;
  std::vector<std::unique_ptr<Palette_source>> sources_;
  QPointer<QWidget> focus_before_;
  QLineEdit* line_;
  QListWidget* list_;
  QLabel* detail_;
  QString query_;
  QStringList recent_;
  std::vector<Palette_item> items_;
  bool is_closing_ = false;
};

}  // namespace mesecina

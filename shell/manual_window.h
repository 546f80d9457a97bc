// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "shell/manual.h"

class QLineEdit;
class QListWidget;
class QTextBrowser;
class QUrl;

namespace mesecina {

/// The manual with its contents and a search, beside the window. Deletes itself when closed.
class Manual_window : public QWidget {
  Q_OBJECT
 public:
  Manual_window(Manual manual, QWidget* parent);

  const Manual& manual() const { return manual_; }
  /// A link as in the pages ("layer:ID"). Does nothing for an unknown one.
  void go_to(const QString& link);
  void search(const QString& words);
  /// Titles of what is listed: of the pages, or of what was found.
  QStringList listed() const;
  /// Of the page that is shown.
  const QString& page() const { return page_; }

 Q_SIGNALS:
  void figure_requested(const mesecina::Manual_figure& figure);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void fill();
  void show_page(const QString& id, const QString& anchor);
  /// The page anew, where it was: its pictures fit the window, its colours the theme.
  void lay_out();
  int picture_width() const;
  void follow(const QUrl& url);

  Manual manual_;
  QString page_;
  int laid_out_width_ = 0;  ///< of pictures, in pixels
  QLineEdit* search_;
  QListWidget* list_;
  QTextBrowser* text_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QFormLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace mesecina {

/// A small plate in a corner of another widget with a title, some controls and a button to close it. Everything else
/// stays usable meanwhile; Esc within closes it. Deletes itself when closed. It is no child of that widget but of its
/// parent, so that the keys of the widget do not reach into it.
class Popover : public QFrame {
  Q_OBJECT
 public:
  Popover(const QString& title, QWidget* over);

  QFormLayout* form() const { return form_; }
  QVBoxLayout* column() const { return column_; }
  /// Enter in any of the controls clicks this button, which belongs to the popover.
  void set_default(QPushButton* button) { default_ = button; }
  /// After the controls were added.
  void open();

 public Q_SLOTS:
  void dismiss();

 Q_SIGNALS:
  void closed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QWidget* over_;
  QVBoxLayout* column_;
  QFormLayout* form_;
  QPushButton* default_ = nullptr;
};

}  // namespace mesecina

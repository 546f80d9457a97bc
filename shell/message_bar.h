// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QStringList>

class QLabel;

namespace mesecina {

/// Errors and warnings above the picture. It never takes the focus nor waits for an answer.
class Message_bar : public QFrame {
  Q_OBJECT
 public:
  enum class Kind { note, warning, error };
  explicit Message_bar(QWidget* parent = nullptr);

  /// Adds a line; the bar shows until it is closed. Equal lines are shown once.
  void add(Kind kind, const QString& line);
  /// Every line that was added since the bar was closed last.
  const QStringList& lines() const { return lines_; }

 public Q_SLOTS:
  void dismiss();

 Q_SIGNALS:
  void added(mesecina::Message_bar::Kind kind, const QString& line);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void copy_lines() const;

  QStringList lines_;
  Kind kind_ = Kind::note;
  QLabel* text_;
};

}  // namespace mesecina

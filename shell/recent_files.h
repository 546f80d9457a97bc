// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <QString>
#include <QStringList>

namespace mesecina {

/// A menu of the files used last, the newest first, kept between runs.
class Recent_files : public QMenu {
  Q_OBJECT
 public:
  /// `program` names the preferences ("mesecina2d").
  explicit Recent_files(QString program, QWidget* parent = nullptr);

  void add(const QString& file);
  void remove(const QString& file);
  const QStringList& files() const { return files_; }

 Q_SIGNALS:
  void chosen(const QString& file);

 private:
  void store();
  void fill();

  QString program_;
  QStringList files_;
};

}  // namespace mesecina

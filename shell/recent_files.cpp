// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <utility>

#include "shell/preferences.h"

namespace mesecina {

namespace {
constexpr int most_files = 10;
constexpr QLatin1String key("recent-files");
}  // namespace

Recent_files::Recent_files(QString program, QWidget* parent)
    : QMenu(tr("Open &recent"), parent), program_(std::move(program)) {
  files_ = Preferences(program_).value(key).toStringList();
  fill();
}

void Recent_files::add(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  files_.removeAll(path);
  files_.prepend(path);
  while (files_.size() > most_files) files_.removeLast();
  store();
}

void Recent_files::remove(const QString& file) {
  files_.removeAll(QFileInfo(file).absoluteFilePath());
  store();
}

void Recent_files::store() {
  Preferences(program_).set_value(key, files_);
  fill();
}

void Recent_files::fill() {
  clear();
  setEnabled(!files_.isEmpty());
  for (const QString& file : files_) {
    const QFileInfo info(file);
    QString text = tr("%1  —  %2").arg(info.fileName(), QDir::toNativeSeparators(info.path()));
    addAction(text.replace(QLatin1Char('&'), QStringLiteral("&&")), this, [this, file] { Q_EMIT chosen(file); });
  }
  if (files_.isEmpty()) return;
  addSeparator();
  addAction(tr("Clear this list"), this, [this] {
    files_.clear();
    store();
  });
}

}  // namespace mesecina

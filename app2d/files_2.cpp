// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/files_2.h"

#include <QDir>
#include <QFile>
#include <utility>

#include "app2d/edits_2.h"

// The macro needs the global namespace.
static void load_examples() { Q_INIT_RESOURCE(examples); }

namespace mesecina {

namespace {

QString part_name(const std::string& input_id) {
  if (input_id == points_input.id) return Files_2::tr("points");
  if (input_id == disks_input.id) return Files_2::tr("disks");
  return Files_2::tr("outline");
}

}  // namespace

Files_2::Files_2(Document& document, std::shared_ptr<const Formats> formats, QWidget* window)
    : Files(document, std::move(formats), {QStringLiteral("mesecina2d"), 2, appended, part_name}, window) {
  load_examples();
}

QStringList Files_2::examples() {
  load_examples();
  return QDir(QStringLiteral(":/examples")).entryList(QDir::Files, QDir::Name);
}

void Files_2::open_example(const QString& name) { Files::open_example(QStringLiteral(":/examples/") + name); }

void Files_2::write_example(const QString& name, const QString& folder) {
  load_examples();
  QFile::copy(QStringLiteral(":/examples/") + name, QDir(folder).filePath(name));
}

}  // namespace mesecina

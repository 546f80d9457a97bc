// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include "shell/files.h"

namespace mesecina {

/// Points, outlines, disks and pictures, and the examples that come with the program.
class Files_2 : public Files {
  Q_OBJECT
 public:
  /// `window` is the parent of the file choosers.
  Files_2(Document& document, std::shared_ptr<const Formats> formats, QWidget* window);

  static QStringList examples();
  /// One of examples().
  void open_example(const QString& name);
  /// Into a folder, under its name.
  static void write_example(const QString& name, const QString& folder);
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/view_3.h"
#include "shell/files.h"

namespace mesecina {

/// Meshes, balls and points.
class Files_3 : public Files {
  Q_OBJECT
 public:
  /// `window` is the parent of the file choosers.
  Files_3(Document& document, std::shared_ptr<const Formats> formats, QWidget* window);

  /// Names of built-in data, as of files.
  static QStringList examples();
  /// One of examples().
  static Inputs example(const QString& name);
  /// Into a folder, under its name. Throws File_error.
  static void write_example(const Formats& formats, const QString& name, const QString& folder);
};

/// Everything of both: triangles, balls and points of `more` come after those of `inputs`.
Inputs appended_3(const Inputs& inputs, const Inputs& more);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "core/bundle.h"

class QUndoStack;

namespace mesecina {

/// The user's list of bundles: those that are shipped, until it is changed. Changes are steps of the history and are
/// kept in a file at once.
class Bundle_store : public QObject {
  Q_OBJECT
 public:
  /// file: see user_bundle_file; where it is empty the list lasts as long as the program.
  Bundle_store(std::shared_ptr<const Registry> registry, QUndoStack& history, QString file, QObject* parent = nullptr);

  const std::vector<Bundle>& bundles() const { return bundles_; }
  /// One undoable step; none where nothing changes.
  void edit(std::vector<Bundle> after, const QString& text);
  /// Takes the list from the file. A file that cannot be read is renamed to FILE.broken, and what was wrong with it is
  /// returned; empty when all is well, also without a file.
  QString load();
  const QString& file() const { return file_; }

 Q_SIGNALS:
  void changed();
  /// The list could not be kept; a sentence.
  void failed(const QString& reason);

 private:
  class Step;
  void set(const std::vector<Bundle>& bundles);
  void save();

  std::shared_ptr<const Registry> registry_;
  QUndoStack& history_;
  QString file_;
  std::vector<Bundle> shipped_;
  std::vector<Bundle> bundles_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/bundle_store.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QUndoStack>
#include <stdexcept>
#include <utility>

namespace mesecina {

class Bundle_store::Step : public QUndoCommand {
 public:
  Step(Bundle_store& store, std::vector<Bundle> after, const QString& text)
      : QUndoCommand(text), store_(store), before_(store.bundles_), after_(std::move(after)) {}
  void undo() override { store_.set(before_); }
  void redo() override { store_.set(after_); }

 private:
  Bundle_store& store_;
  std::vector<Bundle> before_;
  std::vector<Bundle> after_;
};

Bundle_store::Bundle_store(std::shared_ptr<const Registry> registry, QUndoStack& history, QString file, QObject* parent)
    : QObject(parent),
      registry_(std::move(registry)),
      history_(history),
      file_(std::move(file)),
      shipped_(shipped_bundles(*registry_)),
      bundles_(shipped_) {}

void Bundle_store::edit(std::vector<Bundle> after, const QString& text) {
  if (after != bundles_) history_.push(new Step(*this, std::move(after), text));
}

QString Bundle_store::load() {
  QFile file(file_);
  if (!file.exists()) return {};
  if (!file.open(QIODevice::ReadOnly)) return tr("%1: the bundles cannot be read (%2)").arg(file_, file.errorString());
  try {
    bundles_ = parse_bundles(file.readAll().toStdString(), *registry_);
  } catch (const std::invalid_argument& error) {
    file.close();
    const QString aside = file_ + QStringLiteral(".broken");
    QFile::remove(aside);
    QFile::rename(file_, aside);
    return tr("%1: the bundles cannot be read (%2). The file is kept as %3; the usual bundles are shown.")
        .arg(file_, QString::fromStdString(error.what()), aside);
  }
  Q_EMIT changed();
  return {};
}

void Bundle_store::set(const std::vector<Bundle>& bundles) {
  bundles_ = bundles;
  save();
  Q_EMIT changed();
}

void Bundle_store::save() {
  if (bundles_ == shipped_) {
    QFile::remove(file_);
    return;
  }
  if (file_.isEmpty()) {
    Q_EMIT failed(
        tr("The bundles are kept only until the program ends: set HOME or XDG_DATA_HOME to where they are to be"));
    return;
  }
  QDir().mkpath(QFileInfo(file_).absolutePath());
  QSaveFile file(file_);
  const std::string text = bundles_to_text(bundles_, *registry_);
  if (file.open(QIODevice::WriteOnly)) file.write(text.data(), static_cast<qint64>(text.size()));
  if (!file.commit()) Q_EMIT failed(tr("%1: the bundles cannot be kept (%2)").arg(file_, file.errorString()));
}

}  // namespace mesecina

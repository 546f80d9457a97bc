// SPDX-License-Identifier: GPL-3.0-or-later
#include <QClipboard>
#include <QFile>
#include <QGuiApplication>
#include <QTemporaryDir>
#include <numeric>
#include <utility>

#include "app3d/clipboard_3.h"
#include "app3d/editor_3.h"
#include "app3d/files_3.h"
#include "core/formats/format.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {

void Editor_3::copy() const {
  if (selection_.is_empty()) return;
  const Inputs& inputs = document_.inputs();
  QGuiApplication::clipboard()->setText(
      QString::fromStdString(to_rows(positions(inputs, {selection_.points, {}}), selected_balls(inputs, selection_))));
}

void Editor_3::cut() {
  copy();
  remove_selected();
}

void Editor_3::paste() {
  const QString text = QGuiApplication::clipboard()->text();
  if (text.trimmed().isEmpty()) {
    Q_EMIT failed(
        tr("The clipboard holds no text to paste; expected a point \"x y z\" or a ball \"x y z radius\" per line."));
    return;
  }
  paste_text(text);
}

bool Editor_3::paste_text(const QString& text) {
  // The readers of files define what a table is and what is wrong with one.
  const QTemporaryDir folder;
  const QString path = folder.filePath(tr("clipboard") + QStringLiteral(".txt"));
  try {
    Inputs pasted;
    for (const std::string& part : parts_of_rows(text.toStdString())) {
      QFile file(path);
      if (!file.open(QIODevice::WriteOnly) || file.write(QByteArray::fromStdString(part)) < 0 || !file.flush()) {
        Q_EMIT failed(tr("Cannot paste: no room for a temporary file (%1).").arg(file.errorString()));
        return false;
      }
      pasted = appended_3(pasted, read_spatial_table(path.toStdString()).inputs);
    }
    add(pasted);
    return true;
  } catch (const File_error& error) {
    Q_EMIT failed(tr("Cannot paste: %1").arg(QString::fromUtf8(error.what()).remove(folder.path() + QLatin1Char('/'))));
    return false;
  }
}

void Editor_3::add(const Inputs& pasted) {
  const Inputs& before = document_.inputs();
  const auto numbers_of_added = [&](auto key) {
    std::vector<std::size_t> numbers(pasted.get(key) ? pasted.get(key)->size() : 0);
    std::iota(numbers.begin(), numbers.end(), before.get(key) ? before.get(key)->size() : 0);
    return numbers;
  };
  Selection_3 added{numbers_of_added(cloud_input), numbers_of_added(balls_input)};
  if (added.is_empty()) return;
  const QString text = tr("Paste %1").arg(words(added));
  const QString merge = merge_key(QStringLiteral("paste"));
  const bool has_points = !added.points.empty();
  const bool has_balls = !added.balls.empty();
  edit(appended_3(before, pasted), std::move(added), text, merge);
  if (has_points) show_layer(points_layer, text, merge);
  if (has_balls) show_layer(balls_layer, text, merge);
  ++gesture_;
}

}  // namespace mesecina

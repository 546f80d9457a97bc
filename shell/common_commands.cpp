// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/common_commands.h"

#include <QCoreApplication>
#include <algorithm>
#include <numeric>
#include <utility>

namespace mesecina {

namespace {

using Kind = Parameter::Kind;
using Count = Parameter::Count;

QString tr(const char* text) { return QCoreApplication::translate("commands", text); }

std::vector<std::size_t> indices_of(const QStringList& words, std::size_t count, const QString& id) {
  std::vector<std::size_t> indices;
  for (const QString& word : words) {
    const std::size_t index = word.toULongLong();
    if (index >= count)
      throw Command_error(count == 0 ? tr("%1: there are none").arg(id)
                                     : tr("%1: expected numbers up to %2, found %3").arg(id).arg(count - 1).arg(word));
    indices.push_back(index);
  }
  if (words.isEmpty()) {
    indices.resize(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
  }
  std::ranges::sort(indices);
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  return indices;
}

}  // namespace

Parameter coordinate_parameter(const char* name) {
  return {QLatin1String(name), tr("in units of the data"), Kind::number};
}

Parameter radius_parameter() {
  return {QStringLiteral("RADIUS"), tr("in units of the data"), Kind::number, Count::one, {}, 0};
}

Command selection_command(const QString& id, const QString& name, const QString& help,
                          std::function<std::size_t()> count, std::function<void(std::vector<std::size_t>)> select) {
  return {id,
          name,
          help,
          tr("Edit"),
          {{QStringLiteral("N"), tr("numbers, counted from 0; all if there is none"), Kind::whole, Count::any, {}, 0}},
          [id, count = std::move(count), select = std::move(select)](const Arguments& arguments) {
            select(indices_of(arguments.all(0), count(), id));
          }};
}

Command picture_command(std::function<QSize()> usual,
                        std::function<void(const QString& file, const QSize& size, bool is_transparent)> write) {
  return {QStringLiteral("export-picture"),
          tr("Export a picture"),
          tr("Writes what is in view, by the extension: .png, .svg or .pdf"),
          tr("File"),
          {{QStringLiteral("FILE"), tr("where to")},
           {QStringLiteral("WxH"), tr("in pixels; that of the canvas if there is none"), Kind::size, Count::optional},
           {QStringLiteral("transparent"), tr("without a background"), Kind::flag}},
          [usual = std::move(usual), write = std::move(write)](const Arguments& arguments) {
            const auto size = arguments.has(1) ? arguments.size(1) : std::pair(usual().width(), usual().height());
            write(arguments.word(0), QSize(size.first, size.second), arguments.has(2));
          },
          true};
}

}  // namespace mesecina

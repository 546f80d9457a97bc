// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/registry.h"
#include "shell/commands.h"
#include "shell/document.h"

namespace mesecina {

/// Something that the palette offers.
struct Palette_item {
  QString key;     ///< the same in every run: "action/fit"
  QString title;   ///< a few words
  QString kind;    ///< what it is, a word or two
  QString detail;  ///< a sentence; why it is not possible, where it is not
  QString keys{};  ///< its shortcut
  bool is_possible = true;
  std::optional<bool> is_on{};  ///< of what can be switched
  int score = 0;                ///< as fuzzy_score
  std::function<void()> run{};  ///< absent: `completion` becomes the query
  QString completion{};
};

/// Where the palette finds what it offers.
class Palette_source {
 public:
  virtual ~Palette_source() = default;
  /// What answers to the query, with scores above 0, in a sensible order of its own; all there is for an empty one.
  virtual std::vector<Palette_item> find(const QString& query) const = 0;
};

/// Actions as they are in menus.
std::unique_ptr<Palette_source> actions_source(const Actions& actions);
/// Layers, to be shown or hidden.
std::unique_ptr<Palette_source> layers_source(const Registry& registry, Document& document);
/// Settings: "delta" goes to its row of the panel by `focus`, "delta 0.02" and "delta=0.02" set it.
std::unique_ptr<Palette_source> settings_source(const Registry& registry, Document& document,
                                                std::function<void(const std::string& setting)> focus);
/// Things of one kind that have no more than a name; `run` is given the one that was chosen.
std::unique_ptr<Palette_source> names_source(QString kind, std::function<QStringList()> names,
                                             std::function<void(const QString& name)> run);
/// Commands with arguments: "add-point 1 2". `report` is told why one cannot be carried out.
std::unique_ptr<Palette_source> commands_source(const Commands& commands,
                                                std::function<void(const QString& error)> report);

}  // namespace mesecina

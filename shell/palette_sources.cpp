// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/palette_sources.h"

#include <QCoreApplication>
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/formats/number.h"
#include "core/help_text.h"
#include "layers/layer_visibility.h"
#include "shell/fuzzy.h"
#include "shell/setting_values.h"

namespace mesecina {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("palette", text); }

QString text_of(const std::string& text) { return QString::fromStdString(text); }

class Actions_source : public Palette_source {
 public:
  explicit Actions_source(const Actions& actions) : actions_(actions) {}

  std::vector<Palette_item> find(const QString& query) const override {
    std::vector<Palette_item> items;
    for (const Actions::Entry& entry : actions_.entries()) {
      QAction* action = entry.action;
      const int score = fuzzy_score(query, plain_text(action->text()), action->objectName(),
                                    entry.group + QLatin1Char(' ') + action->statusTip());
      // The palette itself would only close and open again.
      if (score == 0 || action->objectName() == QLatin1String("palette")) continue;
      Palette_item item{QStringLiteral("action/") + action->objectName(), plain_text(action->text()), entry.group,
                        action->statusTip()};
      item.keys = action->shortcut().toString(QKeySequence::NativeText);
      item.is_possible = action->isEnabled();
      if (!item.is_possible) item.detail = tr("Not possible now: %1").arg(item.detail);
      if (action->isCheckable()) item.is_on = action->isChecked();
      item.score = score;
      item.run = [action] { action->trigger(); };
      items.push_back(std::move(item));
    }
    return items;
  }

 private:
  const Actions& actions_;
};

/// As windows say it.
template <class Spec>
QString help_text_of(const Spec& spec, const Registry& registry) {
  return text_of(with_labels(spec.help, registry));
}

class Layers_source : public Palette_source {
 public:
  Layers_source(const Registry& registry, Document& document) : registry_(registry), document_(document) {}

  std::vector<Palette_item> find(const QString& query) const override {
    std::vector<Palette_item> items;
    for (const Layer_spec& spec : registry_.layers()) {
      const QString label = text_of(spec.label);
      const int score = fuzzy_score(query, label, text_of(spec.id),
                                    text_of(spec.stage) + QLatin1Char(' ') + help_text_of(spec, registry_));
      const Layer_entry* entry = find_entry(document_.layers(), spec.id);
      if (score == 0 || !entry) continue;
      const bool is_visible = entry->style.visible;
      Palette_item item{QStringLiteral("layer/") + text_of(spec.id),
                        (is_visible ? tr("Hide %1") : tr("Show %1")).arg(label), tr("Layer"),
                        help_text_of(spec, registry_)};
      item.is_on = is_visible;
      item.score = score;
      item.run = [&document = document_, id = spec.id, is_visible, title = item.title] {
        document.edit_layers(with_visibility(document.layers(), {id}, !is_visible), title);
      };
      items.push_back(std::move(item));
    }
    return items;
  }

 private:
  const Registry& registry_;
  Document& document_;
};

class Settings_source : public Palette_source {
 public:
  Settings_source(const Registry& registry, Document& document, std::function<void(const std::string&)> focus)
      : registry_(registry), document_(document), focus_(std::move(focus)) {}

  std::vector<Palette_item> find(const QString& query) const override {
    std::vector<Palette_item> items;
    const qsizetype equals = query.indexOf(QLatin1Char('='));
    const qsizetype end_of_name = equals >= 0 ? equals : query.trimmed().lastIndexOf(QLatin1Char(' '));
    for (const Setting_spec& spec : registry_.settings()) {
      if (end_of_name > 0) add_assignment(spec, query.left(end_of_name), query.mid(end_of_name + 1).trimmed(), items);
      if (const int score = score_of(query, spec)) {
        Palette_item item{QStringLiteral("setting/") + text_of(spec.id), text_of(spec.label), tr("Setting"),
                          help_text_of(spec, registry_)};
        item.title +=
            QStringLiteral(": ") + text_of(to_text(registry_.value(document_.settings(), spec.id))) + unit(spec);
        item.score = score;
        item.run = [focus = focus_, id = spec.id] { focus(id); };
        items.push_back(std::move(item));
      }
    }
    return items;
  }

 private:
  static QString unit(const Setting_spec& spec) {
    return spec.unit.empty() ? QString() : QLatin1Char(' ') + text_of(spec.unit);
  }

  int score_of(const QString& query, const Setting_spec& spec) const {
    return fuzzy_score(query, text_of(spec.label), text_of(spec.id), help_text_of(spec, registry_));
  }

  void add_assignment(const Setting_spec& spec, const QString& name, const QString& text,
                      std::vector<Palette_item>& items) const {
    const int score = score_of(name, spec);
    if (score == 0 || name.trimmed().isEmpty() || text.isEmpty()) return;
    // Whoever types a value wants this more than anything that has the same words in its help.
    constexpr int preference = 4;
    Palette_item item{QStringLiteral("setting/") + text_of(spec.id),
                      tr("Set %1 to %2").arg(text_of(spec.label), text) + unit(spec), tr("Setting"),
                      help_text_of(spec, registry_)};
    item.score = preference * score;
    try {
      const Setting_value value = parse_setting(spec, text.toStdString());
      item.run = [&document = document_, &spec, value] {
        document.edit_settings(with_value(document.settings(), spec, value), text_of(spec.label));
      };
    } catch (const std::invalid_argument& error) {
      const bool is_number =
          !std::holds_alternative<std::string>(spec.default_value) && !std::holds_alternative<bool>(spec.default_value);
      // Words that are no numbers are more of a query; a number beyond the bounds is a wish that should be answered.
      if (!is_number || !parse_number(text.toStdString())) return;
      item.is_possible = false;
      item.detail = text_of(error.what());
      item.run = [] {};
    }
    items.push_back(std::move(item));
  }

  const Registry& registry_;
  Document& document_;
  std::function<void(const std::string&)> focus_;
};

class Names_source : public Palette_source {
 public:
  Names_source(QString kind, std::function<QStringList()> names, std::function<void(const QString&)> run)
      : kind_(std::move(kind)), names_(std::move(names)), run_(std::move(run)) {}

  std::vector<Palette_item> find(const QString& query) const override {
    std::vector<Palette_item> items;
    for (const QString& name : names_()) {
      const int score = fuzzy_score(query, name, {}, kind_);
      if (score == 0) continue;
      Palette_item item{kind_ + QLatin1Char('/') + name, name, kind_, {}};
      item.score = score;
      item.run = [run = run_, name] { run(name); };
      items.push_back(std::move(item));
    }
    return items;
  }

 private:
  QString kind_;
  std::function<QStringList()> names_;
  std::function<void(const QString&)> run_;
};

class Commands_source : public Palette_source {
 public:
  Commands_source(const Commands& commands, std::function<void(const QString&)> report)
      : commands_(commands), report_(std::move(report)) {}

  std::vector<Palette_item> find(const QString& query) const override {
    std::vector<Palette_item> items;
    const QString line = query.trimmed();
    const QString id = line.section(QLatin1Char(' '), 0, 0);
    const bool has_arguments = line.size() > id.size();
    for (const Command& command : commands_.list()) {
      // What an action does without arguments is offered as that.
      if (commands_.actions().find(command.id)) continue;
      if (has_arguments && command.id == id) {
        Palette_item item{QStringLiteral("command/") + id, line, tr("Command"),
                          command.usage() + QStringLiteral(" – ") + command.help};
        constexpr int above_all = 1000000;
        item.score = above_all;
        item.run = [this, line] { run(line); };
        items.push_back(std::move(item));
        continue;
      }
      const int score = fuzzy_score(query, command.name, command.id, command.help);
      if (score == 0) continue;
      Palette_item item{QStringLiteral("command/") + command.id, command.name + QStringLiteral("…"), tr("Command"),
                        command.usage() + QStringLiteral(" – ") + command.help};
      item.score = score;
      if (command.parameters.empty()) {
        item.title = command.name;
        item.run = [this, command_id = command.id] { run(command_id); };
      } else {
        item.completion = command.id + QLatin1Char(' ');
      }
      items.push_back(std::move(item));
    }
    return items;
  }

 private:
  void run(const QString& line) const {
    try {
      commands_.run(words_of_line(line));
    } catch (const std::exception& error) {
      report_(QString::fromUtf8(error.what()));
    }
  }

  const Commands& commands_;
  std::function<void(const QString&)> report_;
};

}  // namespace

std::unique_ptr<Palette_source> actions_source(const Actions& actions) {
  return std::make_unique<Actions_source>(actions);
}

std::unique_ptr<Palette_source> layers_source(const Registry& registry, Document& document) {
  return std::make_unique<Layers_source>(registry, document);
}

std::unique_ptr<Palette_source> settings_source(const Registry& registry, Document& document,
                                                std::function<void(const std::string&)> focus) {
  return std::make_unique<Settings_source>(registry, document, std::move(focus));
}

std::unique_ptr<Palette_source> names_source(QString kind, std::function<QStringList()> names,
                                             std::function<void(const QString& name)> run) {
  return std::make_unique<Names_source>(std::move(kind), std::move(names), std::move(run));
}

std::unique_ptr<Palette_source> commands_source(const Commands& commands, std::function<void(const QString&)> report) {
  return std::make_unique<Commands_source>(commands, std::move(report));
}

}  // namespace mesecina

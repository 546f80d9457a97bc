// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/window_commands.h"

#include <QCoreApplication>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "core/batch/style_option.h"
#include "layers/color_map.h"
#include "layers/layer_visibility.h"
#include "shell/setting_values.h"

namespace mesecina {

namespace {

using Kind = Parameter::Kind;
using Count = Parameter::Count;

QString tr(const char* text) { return QCoreApplication::translate("commands", text); }

QStringList layer_ids(const Registry& registry) {
  QStringList ids;
  for (const Layer_spec& spec : registry.layers()) ids << QString::fromStdString(spec.id);
  return ids;
}

QStringList setting_ids(const Registry& registry) {
  QStringList ids;
  for (const Setting_spec& spec : registry.settings()) ids << QString::fromStdString(spec.id);
  return ids;
}

Layer_ids to_ids(const QStringList& words) {
  Layer_ids ids;
  for (const QString& word : words) ids.push_back(word.toStdString());
  return ids;
}

QString label_of(const Registry& registry, const QStringList& layers) {
  if (layers.size() != 1) return QCoreApplication::translate("commands", "%n layers", nullptr, int(layers.size()));
  return QString::fromStdString(registry.find_layer(layers.front().toStdString())->label);
}

void check_that_it_exists(const QString& path) {
  if (!QFileInfo::exists(path)) throw Command_error(tr("expected a file, found none at '%1'").arg(path));
}

void add_file_commands(Commands& commands, const Command_targets& targets) {
  const QString group = tr("File");
  Files& files = targets.files;
  const auto add_opening = [&](const char* id, const QString& name, const QString& help, bool is_added) {
    commands.add({QLatin1String(id),
                  name,
                  help,
                  group,
                  {{QStringLiteral("FILE"), tr("a file of data"), Kind::text, Count::some}},
                  [&files, is_added](const Arguments& arguments) {
                    std::ranges::for_each(arguments.all(0), check_that_it_exists);
                    files.open(arguments.all(0), is_added);
                  }});
  };
  add_opening("open", tr("Open"), tr("Replaces the data by that of files"), false);
  add_opening("add-file", tr("Add file"), tr("Adds the data of files to what there is"), true);
  commands.add({QStringLiteral("save"),
                tr("Save"),
                tr("Saves the data; without FILE into the file that it came from"),
                group,
                {{QStringLiteral("FILE"), tr("where to"), Kind::text, Count::optional}},
                [&files](const Arguments& arguments) {
                  const QString path = arguments.has(0) ? arguments.word(0) : files.current_file();
                  if (path.isEmpty()) throw Command_error(tr("save: expected FILE, as the data has no file yet"));
                  files.save_to(path);
                }});
  commands.add({QStringLiteral("save-as"),
                tr("Save as"),
                tr("Saves the data into a file"),
                group,
                {{QStringLiteral("FILE"), tr("where to")}},
                [&files](const Arguments& arguments) { files.save_to(arguments.word(0)); }});
  commands.add({QStringLiteral("open-session"),
                tr("Open a session"),
                tr("Replaces everything by what a session, or a picture with one within, holds"),
                group,
                {{QStringLiteral("FILE"), tr("a session, or a picture of this program")}},
                [&files](const Arguments& arguments) {
                  check_that_it_exists(arguments.word(0));
                  files.open_session(arguments.word(0));
                }});
  commands.add({QStringLiteral("save-session"),
                tr("Save a session"),
                tr("Saves everything into one file: data, layers, settings, view, steps, what is recorded"),
                group,
                {{QStringLiteral("FILE"), tr("where to, with the extension mesecina")}},
                [&files](const Arguments& arguments) {
                  const QString& path = arguments.word(0);
                  if (QFileInfo(path).suffix().toLower().toStdString() != session_extension)
                    throw Command_error(
                        tr("save-session: expected a name that ends in .mesecina, found '%1'").arg(path));
                  files.save_session_to(path);
                },
                true});
  const auto add_part = [&](std::string_view input) {
    const QString id = QStringLiteral("save-") + QLatin1String(input.data(), static_cast<qsizetype>(input.size()));
    const Actions::Entry* action = commands.actions().find(id);
    if (!action) return;
    commands.add({id,
                  action->name,
                  action->action->statusTip(),
                  group,
                  {{QStringLiteral("FILE"), tr("where to")}},
                  [&files, input = std::string(input)](const Arguments& arguments) {
                    files.save_part_to(arguments.word(0), input);
                  }});
  };
  add_part(outline_input.id);
  add_part(disks_input.id);
  add_part(mesh_input.id);
  add_part(balls_input.id);
  if (targets.registry.dimension() == 2) add_part(points_input.id);
  commands.add(
      {QStringLiteral("export-layers"),
       tr("Export layers"),
       tr("Writes the visible layers as data into a folder, named as by --nogui"),
       group,
       {{QStringLiteral("FOLDER"), tr("where to")},
        {QStringLiteral("FORMAT"), tr("as in --formats; json if there is none"), Kind::text, Count::any,
         [&targets_formats = targets.formats] {
           QStringList names;
           for (const Layer_writer& writer : targets_formats.layer_writers)
             names << QString::fromStdString(writer.name);
           return names;
         }}},
       [targets](const Arguments& arguments) {
         const QString& folder = arguments.word(0);
         if (!QDir().mkpath(folder))
           throw Command_error(tr("export-layers: the folder '%1' cannot be made").arg(folder));
         std::vector<std::string> formats;
         for (const QString& name : arguments.all(1)) formats.push_back(name.toStdString());
         if (formats.empty()) formats.emplace_back("json");
         std::map<std::string, Setting_value> settings;
         for (const Setting_spec& spec : targets.registry.settings())
           settings[spec.id] = targets.registry.value(targets.document.settings(), spec.id);
         std::map<std::string, QString> reasons;
         for (const Layer_entry& entry : targets.document.layers())
           reasons[entry.id] = targets.computation.status(entry.id).reason;
         targets.files.export_layers(folder, targets.computation.scene({255, 255, 255}), formats, settings, reasons);
       },
       true});
}

void set_style(const Command_targets& targets, const QString& change) {
  const auto equals = change.indexOf(QLatin1Char('='));
  const auto dot = change.indexOf(QLatin1Char('.'));
  if (equals < 0 || dot < 0 || dot > equals)
    throw Command_error(tr("style: expected LAYER.PROPERTY=VALUE, found '%1'").arg(change));
  const QString layer = change.left(dot);
  Layer_list layers = targets.document.layers();
  Layer_entry* entry = find_entry(layers, layer.toStdString());
  if (!entry)
    throw Command_error(tr("style: unknown LAYER '%1'").arg(layer) + did_you_mean(layer, layer_ids(targets.registry)));
  std::vector<std::string> maps;
  for (const Color_map& map : color_maps()) maps.push_back(map.name());
  try {
    set_style_property(entry->style, change.mid(dot + 1, equals - dot - 1).toStdString(),
                       change.mid(equals + 1).toStdString(), maps);
  } catch (const std::invalid_argument& error) {
    throw Command_error(tr("style: %1").arg(QString::fromUtf8(error.what())));
  }
  targets.document.edit_layers(std::move(layers), tr("Style of %1").arg(label_of(targets.registry, {layer})));
}

void add_layer_commands(Commands& commands, const Command_targets& targets) {
  const QString group = tr("Layers");
  const auto known = [&registry = targets.registry] { return layer_ids(registry); };
  const Parameter layers{QStringLiteral("LAYER"), tr("id of a layer"), Kind::text, Count::some, known};
  const auto add = [&](const char* id, const QString& name, const QString& help, const QString& step,
                       std::function<Layer_list(const Layer_list&, const Layer_ids&)> change) {
    commands.add({QLatin1String(id),
                  name,
                  help,
                  group,
                  {layers},
                  [targets, step, change = std::move(change)](const Arguments& arguments) {
                    targets.document.edit_layers(change(targets.document.layers(), to_ids(arguments.all(0))),
                                                 step.arg(label_of(targets.registry, arguments.all(0))));
                  }});
  };
  add("show", tr("Show layers"), tr("Shows these layers, too"), tr("Show %1"),
      [](const Layer_list& list, const Layer_ids& ids) { return with_visibility(list, ids, true); });
  add("hide", tr("Hide layers"), tr("Hides these layers"), tr("Hide %1"),
      [](const Layer_list& list, const Layer_ids& ids) { return with_visibility(list, ids, false); });
  add("solo", tr("Show only layers"), tr("Shows these layers and no others"), tr("Solo %1"),
      [](const Layer_list& list, const Layer_ids& ids) { return with_only_visible(list, ids); });
  commands.add({QStringLiteral("style"),
                tr("Style"),
                tr("Changes how a layer looks, as --style does"),
                group,
                {{QStringLiteral("LAYER.PROPERTY=VALUE"), tr("as for --style"), Kind::text, Count::some}},
                [targets](const Arguments& arguments) {
                  for (const QString& change : arguments.all(0)) set_style(targets, change);
                }});
}

void add_setting_commands(Commands& commands, const Command_targets& targets) {
  const QString group = tr("Settings");
  commands.add({QStringLiteral("set"),
                tr("Set"),
                tr("Gives settings other values, as --set does"),
                group,
                {{QStringLiteral("ID=VALUE"), tr("id of a setting and its value"), Kind::text, Count::some}},
                [targets](const Arguments& arguments) {
                  for (const QString& assignment : arguments.all(0)) set_setting(targets, assignment);
                }});
  commands.add({QStringLiteral("reset"),
                tr("Reset settings"),
                tr("Gives settings, or all of them, their defaults"),
                group,
                {{QStringLiteral("ID"), tr("id of a setting; all if there is none"), Kind::text, Count::any,
                  [&registry = targets.registry] { return setting_ids(registry); }}},
                [targets](const Arguments& arguments) {
                  Settings settings = arguments.has(0) ? targets.document.settings() : Settings();
                  for (const QString& id : arguments.all(0)) settings = settings.without(id.toStdString());
                  targets.document.edit_settings(std::move(settings), tr("Reset settings"));
                }});
}

void add_history_commands(Commands& commands, const Command_targets& targets) {
  QUndoStack& history = targets.document.history();
  const Parameter times{QStringLiteral("N"), tr("how many; 1 if there is none"), Kind::whole, Count::optional, {}, 0};
  commands.add(
      {QStringLiteral("undo"),
       tr("Undo"),
       tr("Takes back changes"),
       tr("Edit"),
       {times},
       [&history](const Arguments& arguments) {
         const int steps = arguments.whole(0, 1);
         if (steps > history.index())
           throw Command_error(
               tr("undo: expected at most %1 steps, as there are so many; found %2").arg(history.index()).arg(steps));
         history.setIndex(history.index() - steps);
       }});
  commands.add({QStringLiteral("redo"),
                tr("Redo"),
                tr("Does again what was taken back"),
                tr("Edit"),
                {times},
                [&history](const Arguments& arguments) {
                  const int steps = arguments.whole(0, 1);
                  const int most = history.count() - history.index();
                  if (steps > most)
                    throw Command_error(
                        tr("redo: expected at most %1 steps, as there are so many; found %2").arg(most).arg(steps));
                  history.setIndex(history.index() + steps);
                }});
}

}  // namespace

void set_setting(const Command_targets& targets, const QString& assignment) {
  const auto equals = assignment.indexOf(QLatin1Char('='));
  if (equals < 0) throw Command_error(tr("set: expected ID=VALUE, found '%1'").arg(assignment));
  const QString id = assignment.left(equals);
  const Setting_spec* spec = targets.registry.find_setting(id.toStdString());
  if (!spec)
    throw Command_error(tr("set: unknown setting '%1'").arg(id) + did_you_mean(id, setting_ids(targets.registry)));
  try {
    const Setting_value value = parse_setting(*spec, assignment.mid(equals + 1).toStdString());
    targets.document.edit_settings(with_value(targets.document.settings(), *spec, value),
                                   QString::fromStdString(spec->label));
  } catch (const std::invalid_argument& error) {
    throw Command_error(tr("set: %1").arg(QString::fromUtf8(error.what())));
  }
}

void add_window_commands(Commands& commands, const Command_targets& targets) {
  add_file_commands(commands, targets);
  add_history_commands(commands, targets);
  add_layer_commands(commands, targets);
  add_setting_commands(commands, targets);
  const QString group = tr("Window");
  commands.add({QStringLiteral("wait"),
                tr("Wait"),
                tr("Waits until everything visible is computed"),
                group,
                {},
                [](const Arguments&) {},
                true});
  commands.add({QStringLiteral("window"),
                tr("Size of the window"),
                tr("Gives the window another size"),
                group,
                {{QStringLiteral("WxH"), tr("width and height in logical pixels"), Kind::size}},
                [&window = targets.window](const Arguments& arguments) {
                  const auto [width, height] = arguments.size(0);
                  window.resize(width, height);
                }});
  commands.add({QStringLiteral("picture-of-window"),
                tr("Picture of the window"),
                tr("Saves what the whole window shows, panels and all"),
                group,
                {{QStringLiteral("FILE"), tr("where to, with the extension png")}},
                [&window = targets.window](const Arguments& arguments) {
                  if (!window.grab().save(arguments.word(0)))
                    throw Command_error(
                        tr("picture-of-window: expected a place for a file .png, found '%1', where none "
                           "can be written")
                            .arg(arguments.word(0)));
                },
                true});
  const auto panels = [&window = targets.window] {
    QStringList names;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
      names << dock->objectName().chopped(QLatin1String("-dock").size());
    return names;
  };
  commands.add({QStringLiteral("panel"),
                tr("Panel"),
                tr("Shows a panel, before those that it shares its place with, or hides it"),
                group,
                {{QStringLiteral("NAME"), tr("one of %1").arg(panels().join(QStringLiteral(", "))), Kind::text,
                  Count::one, panels},
                 {QStringLiteral("off"), tr("hides it"), Kind::flag}},
                [&window = targets.window](const Arguments& arguments) {
                  auto* dock = window.findChild<QDockWidget*>(arguments.word(0) + QLatin1String("-dock"));
                  dock->setVisible(!arguments.has(1));
                  if (!arguments.has(1)) dock->raise();
                }});
  const QStringList tools = [&] {
    QStringList names;
    for (const Actions::Entry& entry : commands.actions().entries())
      if (entry.action->objectName().startsWith(QLatin1String("tool-"))) names << entry.action->objectName().mid(5);
    return names;
  }();
  commands.add({QStringLiteral("tool"),
                tr("Tool"),
                tr("Takes a tool into the hand"),
                tr("Tools"),
                {{QStringLiteral("NAME"), tr("one of %1").arg(tools.join(QStringLiteral(", "))), Kind::text, Count::one,
                  [tools] { return tools; }}},
                [&actions = commands.actions()](const Arguments& arguments) {
                  actions[QStringLiteral("tool-") + arguments.word(0)]->trigger();
                }});
}

}  // namespace mesecina

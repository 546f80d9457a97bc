// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDockWidget>
#include <QWhatsThis>
#include <algorithm>
#include <utility>

#include "shell/program_window.h"
#include "shell/script_runner.h"
#include "shell/whats_this.h"
#include "shell/window_commands.h"

namespace mesecina {

void Program_window::make_commands() {
  commands_ = std::make_unique<Commands>(*actions_);
  add_window_commands(*commands_, {*registry_, *formats_, document_, computation_, *common_files_, *this});
  make_bundle_commands();
  if (!registry_->evolutions().empty()) make_evolution_commands();
  make_recording_commands();
}

void Program_window::make_evolution_commands() {
  const QString group = tr("Evolution");
  const auto known = [registry = registry_] {
    QStringList ids;
    for (const Evolution_spec& spec : registry->evolutions()) ids << QString::fromStdString(spec.id);
    return ids;
  };
  commands_->add(
      {QStringLiteral("evolve"),
       tr("Make steps"),
       tr("Makes steps of an evolution, from what is shown"),
       group,
       {{QStringLiteral("ID"), tr("of an evolution"), Parameter::Kind::text, Parameter::Count::one, known},
        {QStringLiteral("N"),
         tr("how many; 1 if there is none"),
         Parameter::Kind::whole,
         Parameter::Count::optional,
         {},
         1}},
       [this](const Arguments& arguments) {
         evolution_.run({{arguments.word(0).toStdString(), static_cast<std::uint64_t>(arguments.whole(1, 1))}});
       }});
  commands_->add(
      {QStringLiteral("step"),
       tr("Go to a step"),
       tr("Shows a step of the evolution; 0 is where it began"),
       group,
       {{QStringLiteral("N"), tr("number of the step"), Parameter::Kind::whole, Parameter::Count::one, {}, 0}},
       [this](const Arguments& arguments) {
         const std::size_t step = static_cast<std::size_t>(arguments.whole(0));
         if (step > document_.step_count())
           throw Command_error(tr("step: expected at most %1, found %2").arg(document_.step_count()).arg(step));
         evolution_.go_to(step);
       }});
}

QStringList Program_window::bundle_names() const {
  QStringList names;
  for (const Bundle& bundle : bundles_->store().bundles()) names << QString::fromStdString(bundle.name);
  return names;
}

void Program_window::make_bundle_commands() {
  const QString group = tr("Bundles");
  const auto file = [](const QString& help) { return Parameter{QStringLiteral("FILE"), help}; };
  commands_->add({QStringLiteral("bundle"),
                  tr("Show a bundle"),
                  tr("Shows layers, looks and settings as a bundle has them"),
                  group,
                  {{QStringLiteral("NAME"), tr("of a bundle of the list"), Parameter::Kind::text, Parameter::Count::one,
                    [this] { return bundle_names(); }}},
                  [this](const Arguments& arguments) {
                    bundles_->apply(static_cast<int>(bundle_names().indexOf(arguments.word(0))));
                  }});
  commands_->add({QStringLiteral("import-bundles"),
                  tr("Import bundles"),
                  tr("Adds the bundles of a file to the list"),
                  group,
                  {file(tr("JSON or .bnd"))},
                  [this](const Arguments& arguments) { bundles_->import_file(arguments.word(0)); }});
  commands_->add({QStringLiteral("export-bundles"),
                  tr("Export bundles"),
                  tr("Writes all bundles of the list to a file"),
                  group,
                  {file(tr("where to"))},
                  [this](const Arguments& arguments) { bundles_->export_file(arguments.word(0)); }});
}

void Program_window::make_command_actions() {
  qApp->installEventFilter(new Whats_this_from_tips(this));
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run) {
    actions_->add(tr("Help"), {QLatin1String(id), text, tip, std::move(keys)}, std::move(run));
  };
  add("manual", tr("&Manual"), tr("What everything is, and how to use it"), {QKeySequence(Qt::Key_F1)},
      [this] { open_manual(); });
  add("palette", tr("&Find a command…"), tr("Do anything by typing some letters of it"),
      {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_P)}, [this] { open_palette(); });
  add("shortcuts", tr("Keyboard &shortcuts…"), tr("See and change the keys of every action"),
      {QKeySequence(Qt::CTRL | Qt::ALT | Qt::Key_K)}, [this] {
        if (!shortcut_editor_) shortcut_editor_ = new Shortcut_editor(*actions_, this);
        shortcut_editor_->show();
        shortcut_editor_->raise();
        shortcut_editor_->activateWindow();
      });
  add("whats-this", tr("&What’s this?"), tr("Click on something to have it explained"),
      {QKeySequence(Qt::SHIFT | Qt::Key_F1)}, [] { QWhatsThis::enterWhatsThisMode(); });
}

void Program_window::open_palette() {
  if (palette_) return;
  std::vector<std::unique_ptr<Palette_source>> sources;
  sources.push_back(actions_source(*actions_));
  sources.push_back(layers_source(*registry_, document_));
  sources.push_back(settings_source(*registry_, document_, [this](const std::string& setting) {
    settings_dock_->show();
    settings_dock_->raise();
    if (std::ranges::count(settings_panel_->listed(), setting) == 0) settings_browser_->search({});
    settings_panel_->focus_setting(setting);
  }));
  sources.push_back(names_source(
      tr("Bundle"), [this] { return bundle_names(); },
      [this](const QString& name) { bundles_->apply(static_cast<int>(bundle_names().indexOf(name))); }));
  sources.push_back(
      commands_source(*commands_, [this](const QString& error) { messages_->add(Message_bar::Kind::error, error); }));
  palette_ = new Command_palette(program_, std::move(sources), this);
  palette_->open();
}

void Program_window::open_manual() {
  if (!manual_) {
    manual_ = new Manual_window(Manual({program_, *registry_, *formats_, commands_.get()}), this);
    connect(manual_, &Manual_window::figure_requested, this, &Program_window::show_figure);
  }
  manual_->show();
  manual_->raise();
  manual_->activateWindow();
}

void Program_window::show_figure(const Manual_figure& figure) {
  auto* runner = new Script_runner(*this, tr("figure %1").arg(figure.name), figure_script(figure));
  connect(runner, &Script_runner::finished, this, [this, runner](const QString& error) {
    if (!error.isEmpty()) messages_->add(Message_bar::Kind::error, error);
    runner->deleteLater();
  });
  runner->start();
}

}  // namespace mesecina

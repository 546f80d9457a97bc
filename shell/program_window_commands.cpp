// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QWhatsThis>
#include <algorithm>
#include <utility>

#include "shell/program_window.h"
#include "shell/window_commands.h"

namespace mesecina {

void Program_window::make_commands() {
  commands_ = std::make_unique<Commands>(*actions_);
  add_window_commands(*commands_, {*registry_, *formats_, document_, computation_, *common_files_, *this});
}

void Program_window::make_command_actions() {
  const auto add = [&](const char* id, const QString& text, const QString& tip, QList<QKeySequence> keys,
                       std::function<void()> run) {
    actions_->add(tr("Help"), {QLatin1String(id), text, tip, std::move(keys)}, std::move(run));
  };
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
  sources.push_back(
      commands_source(*commands_, [this](const QString& error) { messages_->add(Message_bar::Kind::error, error); }));
  palette_ = new Command_palette(program_, std::move(sources), this);
  palette_->open();
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QFileInfo>

#include "core/formats/settings_file.h"
#include "shell/program_window.h"

namespace mesecina {

void Program_window::make_settings_actions() {
  const auto add = [&](const char* id, const QString& text, const QString& tip, const QKeySequence& key,
                       std::function<void()> run) {
    return actions_->add(
        tr("Settings"),
        {QLatin1String(id), text, tip, key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{key}},
        std::move(run));
  };
  add("find-setting", tr("Find a se&tting"), tr("Type a part of its name or of what it does"),
      QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_F), [this] {
        settings_dock_->show();
        settings_dock_->raise();
        settings_browser_->search({});
      });
  QAction* load =
      add("load-settings", tr("&Load settings…"), tr("Take the values that a file of settings has"), {}, [this] {
        const QString path = common_files_->choose_for_reading(tr("Load settings"), tr("Settings (*.json)"));
        if (!path.isEmpty()) load_settings(path);
      });
  QAction* save =
      add("save-settings", tr("&Save settings…"), tr("Save the values of all settings into a file"), {}, [this] {
        std::vector<std::string> ids;
        for (const Setting_spec& spec : registry_->settings()) ids.push_back(spec.id);
        save_settings(tr("Save settings"), ids);
      });
  QAction* save_listed = add("save-listed-settings", tr("Save l&isted settings…"),
                             tr("Save the values of the settings that the search lists into a file"), {},
                             [this] { save_settings(tr("Save listed settings"), settings_panel_->listed()); });
  QAction* reset_listed = add("reset-listed-settings", tr("&Reset listed settings"),
                              tr("Give the settings that are listed their defaults"), {}, [this] {
                                Settings settings = document_.settings();
                                for (const std::string& id : settings_panel_->listed()) settings = settings.without(id);
                                document_.edit_settings(settings, tr("Reset settings"));
                              });
  settings_browser_->set_menu_actions({load, save, save_listed, reset_listed});
}

void Program_window::save_settings(const QString& title, const std::vector<std::string>& ids) {
  const QString path = common_files_->choose_for_writing(title, tr("settings"), tr("Settings (*.json)"));
  if (path.isEmpty()) return;
  try {
    write_file(path.toStdString(),
               [&](std::ostream& stream) { write_settings_file(stream, *registry_, document_.settings(), ids); });
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::error, QString::fromUtf8(error.what()));
  }
}

void Program_window::load_settings(const QString& path) {
  try {
    const Settings_file file = read_settings_file(path.toStdString(), *registry_);
    for (const std::string& note : file.notes)
      messages_->add(Message_bar::Kind::warning,
                     tr("%1: %2").arg(QFileInfo(path).fileName(), QString::fromStdString(note)));
    document_.edit_settings(with_settings_of(file, document_.settings()),
                            tr("Load %1").arg(QFileInfo(path).fileName()));
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::error, QString::fromUtf8(error.what()));
  }
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QMenu>
#include <exception>
#include <utility>

#include "shell/preferences.h"
#include "shell/program_window.h"
#include "shell/session_state.h"

namespace mesecina {

namespace {

constexpr std::chrono::hours kept_for{30 * 24};
constexpr std::size_t most_kept = 30;
constexpr QLatin1String reopen_key("reopen-last-scene");
constexpr QLatin1String pictures_key("pictures-with-scene");

}  // namespace

Session Program_window::session() const {
  Session session = session_of(document_.state(), registry_->dimension());
  session.title = common_files_->title().toStdString();
  session.file = common_files_->current_file().toStdString();
  session.is_modified = document_.is_modified();
  session.unknown = unknown_;
  session.bundle = bundles_->in_force();
  session.background = background_;
  if (recording_) session.film = recording_->wish();
  add_view(session);
  return session;
}

void Program_window::make_session_actions() {
  const QString group = tr("File");
  actions_->add(group,
                {QStringLiteral("save-session"),
                 tr("Save s&ession as…"),
                 tr("Save everything into one file: data, layers, settings, view, steps, background, what is recorded"),
                 {QKeySequence(Qt::CTRL | Qt::ALT | Qt::SHIFT | Qt::Key_S)}},
                [this] { common_files_->save_session_as(); });
  const auto add_habit = [&](QLatin1String key, const QString& text, const QString& tip, std::function<void()> run) {
    QAction* action = actions_->add(group, {key, text, tip, {}, {}, true}, std::move(run));
    action->setChecked(Preferences(program_).value(key, true).toBool());
    connect(action, &QAction::toggled, this, [this, key](bool is_on) { Preferences(program_).set_value(key, is_on); });
    return action;
  };
  add_habit(reopen_key, tr("&Reopen the last scene at the start"),
            tr("Without files on the command line, begin where the window was closed"), [] {});
  QAction* pictures = add_habit(pictures_key, tr("P&ictures hold the scene"),
                                tr("Opening an exported picture brings back data, layers, settings and view"), [] {});
  connect(pictures, &QAction::toggled, common_files_, &Files::set_scenes_in_pictures);
  common_files_->set_scenes_in_pictures(pictures->isChecked());
}

void Program_window::add_earlier_scenes(QMenu* file) {
  QMenu* menu = file->addMenu(tr("Ear&lier scenes"));
  menu->setToolTipsVisible(true);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill_earlier_scenes(menu); });
}

void Program_window::fill_earlier_scenes(QMenu* menu) {
  menu->clear();
  if (store_) {
    for (const Stored_scene& scene : store_->kept()) {
      const QString folder = QString::fromStdString(scene.folder.string());
      // An ampersand in a menu would mark a key.
      QAction* action = menu->addAction(words_for(scene).replace(QLatin1Char('&'), QLatin1String("&&")));
      action->setToolTip(tr("Show this scene in place of the present one; Undo brings that back"));
      connect(action, &QAction::triggered, this,
              [this, folder, text = action->text()] { show_stored_scene(folder, tr("Open %1").arg(text)); });
    }
  }
  if (menu->isEmpty()) menu->addAction(tr("None yet"))->setEnabled(false);
}

void Program_window::keep_scenes(const std::filesystem::path& store, bool is_reopening) {
  store_.emplace(store);
  recovery_bar_->offer(store_->crashed());
  store_->expire(kept_for, most_kept);
  const auto kept = store_->kept();
  if (is_reopening && !kept.empty() && reopens_scenes()) {
    show_stored_scene(QString::fromStdString(kept.front().folder.string()), {});
  }
  try {
    autosave_ = std::make_unique<Autosave>(*store_, [this] { return session(); });
    connect(autosave_.get(), &Autosave::failed, this, [this](const QString& reason) {
      is_autosave_broken_ = true;
      messages_->add(Message_bar::Kind::warning, tr("The scene is not kept for recovery: %1").arg(reason));
    });
    connect(autosave_.get(), &Autosave::written, this, [this] { is_autosave_broken_ = false; });
    touch_scene();
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::warning,
                   tr("The scene is not kept for recovery: %1").arg(QString::fromUtf8(error.what())));
  }
}

bool Program_window::reopens_scenes() const { return (*actions_)[reopen_key]->isChecked(); }

void Program_window::touch_scene() {
  if (autosave_) autosave_->touch();
}

void Program_window::show_session(const Session& session) {
  unknown_ = session.unknown;
  show_view(session);
  show_background(session.background.value_or(usual_background()));
  if (session.film && recording_) recording_->show(*session.film);
  touch_scene();
}

void Program_window::show_stored_scene(const QString& folder, const QString& step) {
  common_files_->jobs().run(tr("Reading a scene"),
                            [this, registry = registry_, path = folder.toStdString(), step]() -> std::function<void()> {
                              try {
                                auto session = std::make_shared<const Session>(read_scene_folder(path, *registry));
                                return [this, session, step, path] {
                                  if (step.isEmpty()) reopened_ = path;
                                  for (const std::string& warning : session->unknown.parts.notes)
                                    messages_->add(Message_bar::Kind::warning, QString::fromStdString(warning));
                                  common_files_->show_session(*session, step, step.isEmpty());
                                };
                              } catch (const std::exception& error) {
                                return [this, text = QString::fromUtf8(error.what())] {
                                  messages_->add(Message_bar::Kind::error, text);
                                };
                              }
                            });
}

void Program_window::recover(const QStringList& folders) {
  try {
    const auto place = store_->keep(folders.front().toStdString());
    show_stored_scene(QString::fromStdString(place.string()), tr("Recover a scene"));
  } catch (const std::exception& error) {
    messages_->add(Message_bar::Kind::error, QString::fromUtf8(error.what()));
  }
  keep_for_later(folders.mid(1));
}

void Program_window::keep_for_later(const QStringList& folders) {
  for (const QString& folder : folders) {
    try {
      store_->keep(folder.toStdString());
    } catch (const std::exception& error) {
      messages_->add(Message_bar::Kind::error, QString::fromUtf8(error.what()));
    }
  }
}

}  // namespace mesecina

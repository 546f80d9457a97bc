// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QVBoxLayout>
#include <utility>

#include "core/help_text.h"
#include "shell/evolution_bar.h"
#include "shell/preferences.h"
#include "shell/program_window.h"
#include "shell/transport_icons.h"

namespace mesecina {

namespace {

using Motion = Evolution_control::Motion;
using Repeat = Evolution_control::Repeat;

struct Repeat_choice {
  Repeat repeat;
  const char* id;
};
constexpr Repeat_choice repeat_choices[] = {
    {Repeat::once, "evolution-once"}, {Repeat::wrap, "evolution-wrap"}, {Repeat::ping_pong, "evolution-ping-pong"}};

constexpr std::size_t megabyte = std::size_t{1} << 20;
constexpr const char* bar_preference = "evolution-bar";
constexpr const char* memory_preference = "evolution-memory";
constexpr const char* speed_preference = "evolution-speed";
constexpr const char* ahead_preference = "evolution-steps-ahead";

QString action_of(const std::string& evolution) {
  return QStringLiteral("evolve-") + QString::fromStdString(evolution);
}

}  // namespace

void Program_window::add_evolution_action(const QString& id, const QString& text, const QString& tip,
                                          const QList<QKeySequence>& keys, const QIcon& icon, std::function<void()> run,
                                          bool is_for_canvas) {
  actions_->add(tr("Evolution"), {id, text, tip, keys, icon, false, is_for_canvas ? common_canvas_ : nullptr},
                [this, run = std::move(run)] {
                  set_evolution_bar_visible(true);
                  run();
                });
}

void Program_window::make_step_actions() {
  const auto play = [this](Motion motion) {
    if (evolution_.motion() == motion) {
      evolution_.pause();
    } else {
      evolution_.play(motion);
    }
  };
  add_evolution_action(
      QStringLiteral("evolution-play"), tr("&Play or pause"),
      tr("Show one step after the other; at the last one, make more and show them"), {QKeySequence(Qt::Key_Space)},
      transport_icon(Transport_icon::play),
      [this, play] {
        if (evolution_.is_playing()) {
          evolution_.pause();
        } else {
          play(Motion::forward);
        }
      },
      true);
  add_evolution_action(
      QStringLiteral("evolution-play-backward"), tr("Play &backward"), tr("Show one step before the other"),
      {QKeySequence(Qt::SHIFT | Qt::Key_Space)}, transport_icon(Transport_icon::play_backward),
      [play] { play(Motion::backward); }, true);
  add_evolution_action(QStringLiteral("evolution-forward"), tr("One step &forward"),
                       tr("Show the next step; after the last one, make it"), {QKeySequence(Qt::CTRL | Qt::Key_Right)},
                       transport_icon(Transport_icon::forward), [this] { evolution_.forward(); });
  add_evolution_action(QStringLiteral("evolution-back"), tr("One step b&ack"), tr("Show the step before"),
                       {QKeySequence(Qt::CTRL | Qt::Key_Left)}, transport_icon(Transport_icon::back),
                       [this] { evolution_.back(); });
  add_evolution_action(
      QStringLiteral("evolution-first"), tr("To the s&tart"), tr("Show the data before the first step"),
      {QKeySequence(Qt::Key_Home)}, transport_icon(Transport_icon::first), [this] { evolution_.first(); }, true);
  add_evolution_action(
      QStringLiteral("evolution-last"), tr("To the &last step"), tr("Show the last step that was made"),
      {QKeySequence(Qt::Key_End)}, transport_icon(Transport_icon::last), [this] { evolution_.last(); }, true);
  add_evolution_action(QStringLiteral("evolution-make-steps"), tr("&Make steps"),
                       tr("Make as many more steps as the bar of evolutions says"),
                       {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Right)}, transport_icon(Transport_icon::more),
                       [this] { evolution_.make_steps(); });
  add_evolution_action(QStringLiteral("evolution-settings"), tr("&Settings of the evolution"),
                       tr("Show the settings that its steps are made by"), {}, transport_icon(Transport_icon::settings),
                       [this] { find_evolution_settings(); });
}

void Program_window::make_repeat_actions() {
  auto* group = new QActionGroup(this);
  const auto add = [&](Repeat repeat, const char* id, const QString& text, const QString& tip) {
    group->addAction(actions_->add(tr("Evolution"), {QLatin1String(id), text, tip, {}, {}, true},
                                   [this, repeat] { evolution_.set_repeat(repeat); }));
  };
  add(Repeat::once, "evolution-once", tr("&Once"), tr("Playing ends at the last step"));
  add(Repeat::wrap, "evolution-wrap", tr("&Again and again"), tr("After the last step the first one is played"));
  add(Repeat::ping_pong, "evolution-ping-pong", tr("Back and &forth"), tr("After the last step it is played back"));
  add_evolution_action(QStringLiteral("evolution-range-begin"), tr("Repeat fro&m here"),
                       tr("The step that is shown is the first one that is repeated"),
                       {QKeySequence(Qt::Key_BracketLeft)}, {},
                       [this] { evolution_.set_range(document_.position(), evolution_.range_end()); });
  add_evolution_action(QStringLiteral("evolution-range-end"), tr("Repeat &to here"),
                       tr("The step that is shown is the last one that is repeated"),
                       {QKeySequence(Qt::Key_BracketRight)}, {},
                       [this] { evolution_.set_range(evolution_.range_begin(), document_.position()); });
  add_evolution_action(QStringLiteral("evolution-whole-range"), tr("&Repeat all steps"),
                       tr("All steps that were made are repeated"), {}, {}, [this] { evolution_.set_whole_range(); });
}

void Program_window::make_choice_actions() {
  auto* group = new QActionGroup(this);
  for (const Evolution_spec& spec : registry_->evolutions()) {
    group->addAction(actions_->add(tr("Evolution"),
                                   {action_of(spec.id),
                                    QString::fromStdString(spec.label),
                                    QString::fromStdString(with_labels(spec.help, *registry_)),
                                    {},
                                    {},
                                    true},
                                   [this, id = spec.id] {
                                     set_evolution_bar_visible(true);
                                     evolution_.choose(id);
                                   }));
  }
  add_evolution_action(QStringLiteral("evolution-next"), tr("&Next evolution"), tr("Choose the next one of the list"),
                       {QKeySequence(Qt::CTRL | Qt::Key_Down)}, {}, [this] { evolution_.choose_next(1); });
  add_evolution_action(QStringLiteral("evolution-previous"), tr("Pre&vious evolution"),
                       tr("Choose the one before in the list"), {QKeySequence(Qt::CTRL | Qt::Key_Up)}, {},
                       [this] { evolution_.choose_next(-1); });
}

void Program_window::make_evolution_actions() {
  make_step_actions();
  make_repeat_actions();
  make_choice_actions();
  actions_->add(tr("Evolution"),
                {QStringLiteral("evolution-bar"),
                 tr("Bar of &evolutions"),
                 tr("Evolutions, their steps and playing below the picture"),
                 {},
                 {},
                 true},
                [this] { set_evolution_bar_visible(evolution_bar_->isHidden()); });
  evolution_bar_ = new Evolution_bar(evolution_, computation_, *actions_, center_column_->parentWidget());
  evolution_bar_->hide();
  center_column_->addWidget(evolution_bar_);
  connect(&evolution_, &Evolution_control::changed, this, &Program_window::show_evolution_state);
  connect(evolution_bar_, &Evolution_bar::budget_edited, this,
          [this](int megabytes) { Preferences(program_).set_value(QLatin1String(memory_preference), megabytes); });
  show_evolution_state();
}

void Program_window::add_evolution_menu() {
  QMenu* menu = menuBar()->addMenu(tr("Ev&olution"));
  menu->setToolTipsVisible(true);
  for (const Evolution_spec& spec : registry_->evolutions()) actions_->add_to(menu, {action_of(spec.id)});
  actions_->add_to(menu, {"evolution-next", "evolution-previous", "evolution-settings", "-", "evolution-make-steps",
                          "evolution-play", "evolution-play-backward", "evolution-forward", "evolution-back",
                          "evolution-first", "evolution-last", "-"});
  QMenu* repeat = menu->addMenu(tr("&Repeat"));
  actions_->add_to(repeat, {"evolution-once", "evolution-wrap", "evolution-ping-pong", "-", "evolution-range-begin",
                            "evolution-range-end", "evolution-whole-range"});
  actions_->add_to(menu, {"-", "evolution-bar"});
}

void Program_window::show_evolution_state() {
  const auto enable = [this](const char* id, bool is_enabled) {
    (*actions_)[QLatin1String(id)]->setEnabled(is_enabled);
  };
  const bool has_any = !registry_->evolutions().empty();
  const std::size_t count = document_.step_count();
  const Evolution_spec* chosen = registry_->find_evolution(evolution_.chosen());
  enable("evolution-back", document_.position() > 0);
  enable("evolution-first", document_.position() > 0);
  enable("evolution-last", document_.position() < count);
  enable("evolution-play-backward", count > 0);
  enable("evolution-settings", chosen && !chosen->settings.empty());
  for (const char* id : {"evolution-play", "evolution-forward"}) enable(id, has_any || count > 0);
  for (const char* id : {"evolution-make-steps", "evolution-next", "evolution-previous"}) enable(id, has_any);
  if (chosen) (*actions_)[action_of(chosen->id)]->setChecked(true);
  for (const Repeat_choice& choice : repeat_choices)
    (*actions_)[QLatin1String(choice.id)]->setChecked(choice.repeat == evolution_.repeat());
  const auto show_playing = [this](const char* id, Motion motion, Transport_icon icon) {
    (*actions_)[QLatin1String(id)]->setIcon(
        transport_icon(evolution_.motion() == motion ? Transport_icon::pause : icon));
  };
  show_playing("evolution-play", Motion::forward, Transport_icon::play);
  show_playing("evolution-play-backward", Motion::backward, Transport_icon::play_backward);
}

void Program_window::set_evolution_bar_visible(bool is_visible) {
  (*actions_)[QStringLiteral("evolution-bar")]->setChecked(is_visible);
  if (evolution_bar_->isHidden() != is_visible) return;
  evolution_bar_->setVisible(is_visible);
  Preferences(program_).set_value(QLatin1String(bar_preference), is_visible);
}

void Program_window::restore_evolution() {
  const Preferences preferences(program_);
  const auto restored = [&](const QString& key, int otherwise) {
    bool is_number = false;
    const int number = preferences.value(key, otherwise).toInt(&is_number);
    return is_number && number > 0 ? number : otherwise;
  };
  constexpr int usual_megabytes = 512;
  computation_.set_kept_bytes_budget(
      static_cast<std::size_t>(restored(QLatin1String(memory_preference), usual_megabytes)) * megabyte);
  evolution_.set_steps_per_second(
      restored(QLatin1String(speed_preference), static_cast<int>(evolution_.steps_per_second())));
  evolution_.set_steps_ahead(restored(QLatin1String(ahead_preference), evolution_.steps_ahead()));
  set_evolution_bar_visible(preferences.value(QLatin1String(bar_preference), false).toBool());
}

void Program_window::store_evolution() const {
  Preferences preferences(program_);
  preferences.set_value(QLatin1String(speed_preference), evolution_.steps_per_second());
  preferences.set_value(QLatin1String(ahead_preference), evolution_.steps_ahead());
}

void Program_window::find_evolution_settings() {
  settings_dock_->show();
  settings_dock_->raise();
  settings_browser_->search(QString::fromStdString(evolution_.chosen()));
}

}  // namespace mesecina

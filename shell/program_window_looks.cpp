// SPDX-License-Identifier: GPL-3.0-or-later
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <utility>

#include "layers/panel_paint.h"
#include "shell/preferences.h"
#include "shell/program_window.h"

namespace mesecina {

namespace {

struct Theme_choice {
  Theme theme;
  const char* id;
};
constexpr Theme_choice theme_choices[] = {
    {Theme::system, "theme-system"}, {Theme::light, "theme-light"}, {Theme::dark, "theme-dark"}};

struct Background_choice {
  Canvas_background background;
  const char* id;
};
constexpr Background_choice background_choices[] = {{Canvas_background::paper, "background-paper"},
                                                    {Canvas_background::dark, "background-dark"},
                                                    {Canvas_background::window, "background-window"},
                                                    {Canvas_background::none, "background-none"}};

}  // namespace

void Program_window::make_look_actions() {
  const QString group = tr("View");
  const auto add_choice = [&](QActionGroup* choices, const char* id, const QString& text, const QString& tip,
                              std::function<void()> run) {
    QAction* action = actions_->add(group, {QLatin1String(id), text, tip, {}, {}, true}, std::move(run));
    choices->addAction(action);
  };
  auto* themes = new QActionGroup(this);
  add_choice(themes, "theme-system", tr("&System"), tr("Dress the window as the desktop does"),
             [this] { set_theme(Theme::system); });
  add_choice(themes, "theme-light", tr("&Light"), tr("Light window"), [this] { set_theme(Theme::light); });
  add_choice(themes, "theme-dark", tr("&Dark"), tr("Dark window"), [this] { set_theme(Theme::dark); });
  auto* backgrounds = new QActionGroup(this);
  add_choice(backgrounds, "background-paper", tr("&Paper white"), tr("White canvas, as on paper"),
             [this] { set_background(Canvas_background::paper); });
  add_choice(backgrounds, "background-dark", tr("&Dark canvas"),
             tr("Dark canvas; dark colours of layers are lightened"),
             [this] { set_background(Canvas_background::dark); });
  add_choice(backgrounds, "background-window", tr("Like the &window"), tr("Canvas in the colour of the window"),
             [this] { set_background(Canvas_background::window); });
  add_choice(backgrounds, "background-none", tr("&None in pictures"),
             tr("White canvas; pictures that are saved or copied are transparent"),
             [this] { set_background(Canvas_background::none); });
  QAction* full = actions_->add(group,
                                {QStringLiteral("full-screen"),
                                 tr("F&ull screen"),
                                 tr("Use the whole screen"),
                                 {QKeySequence(Qt::Key_F11)},
                                 {},
                                 true},
                                [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setChecked(isFullScreen());
  build_reports();
}

void Program_window::add_look_menus(QMenu* view) const {
  QMenu* themes = view->addMenu(tr("&Theme"));
  for (const Theme_choice& choice : theme_choices) actions_->add_to(themes, {QLatin1String(choice.id)});
  QMenu* backgrounds = view->addMenu(tr("&Background"));
  for (const Background_choice& choice : background_choices) actions_->add_to(backgrounds, {QLatin1String(choice.id)});
  QMenu* panels = view->addMenu(tr("Pa&nels"));
  for (QDockWidget* dock : docks_) panels->addAction(dock->toggleViewAction());
  actions_->add_to(view, {"-", "full-screen"});
}

Color Program_window::background() const {
  return canvas_color(background_, from_qcolor(palette().color(QPalette::Window)));
}

void Program_window::set_theme(Theme theme) {
  themes_.apply(theme);
  for (const Theme_choice& choice : theme_choices)
    (*actions_)[QLatin1String(choice.id)]->setChecked(choice.theme == theme);
  for (const Theme_choice& choice : theme_choices)
    if (choice.theme == theme) Preferences(program_).set_value(QStringLiteral("theme"), QLatin1String(choice.id));
}

void Program_window::show_background(Canvas_background background) {
  if (is_without_background() != (background == Canvas_background::none))
    picture_wish_.is_transparent = background == Canvas_background::none;
  background_ = background;
  for (const Background_choice& choice : background_choices)
    (*actions_)[QLatin1String(choice.id)]->setChecked(choice.background == background);
  show_scene();
  touch_scene();
}

void Program_window::set_background(Canvas_background background) {
  show_background(background);
  for (const Background_choice& choice : background_choices)
    if (choice.background == background)
      Preferences(program_).set_value(QStringLiteral("background"), QLatin1String(choice.id));
}

Canvas_background Program_window::usual_background() const {
  const QString chosen =
      Preferences(program_).value(QStringLiteral("background"), QStringLiteral("background-paper")).toString();
  for (const Background_choice& choice : background_choices)
    if (chosen == QLatin1String(choice.id)) return choice.background;
  return Canvas_background::paper;
}

void Program_window::restore_looks() {
  const Preferences preferences(program_);
  const QString theme = preferences.value(QStringLiteral("theme"), QStringLiteral("theme-light")).toString();
  for (const Theme_choice& choice : theme_choices)
    if (theme == QLatin1String(choice.id)) set_theme(choice.theme);
  show_background(usual_background());
}

}  // namespace mesecina

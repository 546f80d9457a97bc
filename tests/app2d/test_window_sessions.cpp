// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>

#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QTimer>
#include <QtTest>
#include <iostream>

#include "bundles/bundle_panel.h"
#include "core/session_formats.h"
#include "geometries/modules_2.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

class Window_sessions : public Window_fixture {
 protected:
  void SetUp() override {
    Window_fixture::SetUp();
    store_ = folder_.filePath("scenes").toStdString();
  }
  void open(const QString& path) {
    window().files().open({path}, false);
    EXPECT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  }
  /// Everything that is not as it was at the start.
  void change_everything() {
    document().edit_inputs(Inputs()
                               .with(points_input, std::vector<Point_2>{{0.1, 1.0 / 3}, {4, 5}, {7, -1e-300}})
                               .with(disks_input, std::vector<Disk_2>{{{1, 2}, 0.1}}),
                           "points");
    document().edit_settings(document().settings().with("scale", 1.7), "scale");
    Layer_list layers = document().layers();
    std::swap(layers.front(), layers.back());
    find_entry(layers, "delaunay")->style.visible = true;
    find_entry(layers, "delaunay")->style.color = {1, 2, 3};
    document().edit_layers(layers, "layers");
    canvas().set_view({{3, 4}, 55});
  }
  void expect_everything(const Document_state& state, const View_2& view) {
    EXPECT_TRUE(same_data(document().inputs(), state.inputs));
    EXPECT_TRUE(document().settings() == state.settings);
    EXPECT_TRUE(document().layers() == state.layers);
    EXPECT_EQ(canvas().view().center, view.center);
    EXPECT_NEAR(canvas().view().scale, view.scale, 1e-9 * view.scale);
  }
  /// Ends the window without closing it, as a crash does, and opens another.
  void crash() { open_window(); }
  void keep(bool is_reopening = false) {
    window().keep_scenes(store_, is_reopening);
    ASSERT_NE(window().autosave(), nullptr);
    wait_until([&] { return !window().files().jobs().is_busy(); });
  }
  void wait_written() {
    QSignalSpy spy(window().autosave(), &Autosave::written);
    EXPECT_TRUE(spy.wait(5000));
  }
  std::size_t kept() const { return Scene_store(store_).kept().size(); }

  std::filesystem::path store_;
};

TEST_F(Window_sessions, ASavedSessionBringsEverythingBack) {
  change_everything();
  const Document_state state = document().state();
  const View_2 view = canvas().view();
  const QString path = folder_.filePath("all.mesecina");
  ASSERT_TRUE(window().files().save_session_to(path));
  ASSERT_TRUE(wait_until_saved());
  EXPECT_FALSE(document().is_modified());
  EXPECT_TRUE(window().windowTitle().startsWith("all.mesecina[*]"));
  // A look is part of it.
  document().edit_settings({}, "other");
  EXPECT_TRUE(document().is_modified());
  trigger("undo");
  EXPECT_FALSE(document().is_modified());

  open_window();
  const Document_state before = document().state();
  open(path);
  expect_everything(state, view);
  EXPECT_FALSE(document().is_modified());
  EXPECT_TRUE(window().messages().lines().isEmpty());
  trigger("undo");
  EXPECT_TRUE(same_data(document().inputs(), before.inputs));
  EXPECT_TRUE(document().settings() == before.settings);
  EXPECT_TRUE(document().layers() == before.layers);
  EXPECT_FALSE(window().actions()["undo"]->isEnabled());
}

TEST_F(Window_sessions, TheBackgroundComesBackAndTheUsualOneStays) {
  trigger("background-dark");
  const QString path = folder_.filePath("dark.mesecina");
  ASSERT_TRUE(window().files().save_session_to(path));
  ASSERT_TRUE(wait_until_saved());
  trigger("background-paper");
  open_window();
  EXPECT_TRUE(window().actions()["background-paper"]->isChecked());
  open(path);
  EXPECT_TRUE(window().actions()["background-dark"]->isChecked());
  EXPECT_EQ(window().session().background, Canvas_background::dark);
  open_window();
  EXPECT_TRUE(window().actions()["background-paper"]->isChecked());
}

TEST_F(Window_sessions, TheBundleInForceIsKnownUntilUndone) {
  const auto in_force = [&] { return window().bundles().in_force(); };
  const auto bundle = [&](std::size_t row) { return window().bundles().store().bundles()[row].name; };
  const auto before = in_force();
  window().bundles().apply(2);
  EXPECT_EQ(in_force(), (Session::Bundle_name{bundle(2), false}));
  document().edit_settings(document().settings().with("scale", 1.7), "scale");
  Layer_list layers = document().layers();
  for (Layer_entry& entry : layers) entry.style.opacity = 0.3;
  document().edit_layers(layers, "opacity");
  EXPECT_EQ(in_force(), (Session::Bundle_name{bundle(2), true}));
  const auto* list = window().bundles().panel()->findChild<QListWidget*>("bundle-list");
  EXPECT_TRUE(list->item(2)->data(Qt::AccessibleDescriptionRole).toString().startsWith("Shown, and changed"));

  const QString path = folder_.filePath("bundle.mesecina");
  ASSERT_TRUE(window().files().save_session_to(path));
  ASSERT_TRUE(wait_until_saved());
  const Session saved = read_session_file(path.toStdString(), *make_registry_2());
  EXPECT_EQ(saved.bundle, (Session::Bundle_name{bundle(2), true}));
  trigger("undo");
  trigger("undo");
  EXPECT_EQ(in_force(), (Session::Bundle_name{bundle(2), false}));
  trigger("undo");
  EXPECT_EQ(in_force(), before);
  open_window();
  open(path);
  EXPECT_EQ(in_force(), saved.bundle);
  // One that is shown already is in force from then on, without a step.
  const int steps = document().history().count();
  window().bundles().apply(2);
  window().bundles().apply(2);
  EXPECT_EQ(document().history().count(), steps + 1);
  // What was just kept as another one is that from then on.
  window().bundles().save_as_new(false);
  const std::string kept = window().bundles().store().bundles().back().name;
  EXPECT_EQ(in_force(), (Session::Bundle_name{kept, false}));
  document().edit_layers(layers, "opacity");
  EXPECT_EQ(in_force(), (Session::Bundle_name{kept, true}));
  QFile::remove(window().bundles().store().file());
}

TEST_F(Window_sessions, WhatIsToBeRecordedComesBack) {
  Window_recording* recording = &window().recording();
  const Sweep sweep{"scale", 1, 1.5, 12, Sweep::Easing::smooth, true};
  recording->prepare({sweep});
  recording->panel().set_size({320, 200});
  recording->panel().set_frames_per_second(12.5);
  recording->panel().set_transparent(true);
  recording->panel().set_file(folder_.filePath("film.gif"));
  const Film_wish wish = recording->wish();
  EXPECT_EQ(wish.sweeps, std::vector{sweep});
  const QString path = folder_.filePath("film.mesecina");
  ASSERT_TRUE(window().files().save_session_to(path));
  ASSERT_TRUE(wait_until_saved());
  recording->panel().set_size({640, 480});
  recording->panel().set_source(Film_wish::Source::evolution);

  open_window();
  recording = &window().recording();
  EXPECT_EQ(recording->wish().width, 640);
  open(path);
  EXPECT_EQ(recording->wish(), wish);
  EXPECT_TRUE(recording->panel().findChild<QPushButton*>("record-start")->isEnabled());
  // What a session brings is not what the user chose for all that follow.
  open_window();
  EXPECT_EQ(window().recording().wish().width, 640);
  // A film that is there already is not written over by one click.
  ASSERT_TRUE(write("film.gif", "a film").endsWith("film.gif"));
  open(path);
  EXPECT_EQ(window().recording().wish().file, folder_.filePath("film-2.gif").toStdString());
}

TEST_F(Window_sessions, WhatIsEditedWhileItIsSavedIsNotSaved) {
  change_everything();
  const QString path = folder_.filePath("early.mesecina");
  ASSERT_TRUE(window().files().save_session_to(path));
  EXPECT_TRUE(window().files().is_saving());
  document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{9, 9}}), "later");
  ASSERT_TRUE(wait_until_saved());
  EXPECT_EQ(read_session_file(path.toStdString(), *make_registry_2()).inputs.get(points_input)->size(), 3u);
  EXPECT_TRUE(document().is_modified());
  trigger("undo");
  EXPECT_FALSE(document().is_modified());
  EXPECT_TRUE(window().windowTitle().startsWith("early.mesecina[*]"));
  // What was opened meanwhile keeps its name.
  ASSERT_TRUE(window().files().save_session_to(folder_.filePath("late.mesecina")));
  window().files().new_document();
  ASSERT_TRUE(wait_until_saved());
  EXPECT_TRUE(window().files().current_file().isEmpty());
  EXPECT_TRUE(QFile::exists(folder_.filePath("late.mesecina")));
}

TEST_F(Window_sessions, AFileThatCannotBeWrittenIsToldAndStaysUnsaved) {
  change_everything();
  ASSERT_TRUE(window().files().save_session_to(folder_.filePath("none/all.mesecina")));
  ASSERT_TRUE(wait_until_saved());
  EXPECT_TRUE(document().is_modified());
  ASSERT_EQ(window().messages().lines().size(), 1);
  EXPECT_TRUE(window().messages().lines().front().contains("none/all.mesecina"));
}

TEST_F(Window_sessions, ClosingCutsNoSavingShort) {
  keep();
  change_everything();
  std::vector<Point_2> many;
  for (int i = 0; i < 100000; ++i) many.push_back({i + 0.1, 1.0 / (i + 1)});
  document().edit_inputs(Inputs().with(points_input, many), "many");
  const QString path = folder_.filePath("many.mesecina");
  ASSERT_TRUE(window().files().save_session_to(path));
  EXPECT_TRUE(window().close());
  EXPECT_EQ(*read_session_file(path.toStdString(), *make_registry_2()).inputs.get(points_input), many);
  ASSERT_EQ(kept(), 1u);
  const Session scene = read_scene_folder(Scene_store(store_).kept().front().folder, *make_registry_2());
  EXPECT_EQ(*scene.inputs.get(points_input), many);
  EXPECT_EQ(scene.title, "many.mesecina");
  EXPECT_FALSE(scene.is_modified);
}

TEST_F(Window_sessions, OfManyChangesTheNewestIsWritten) {
  double x = 0;
  std::size_t asked = 0;
  Autosave autosave(Scene_store(store_), [&] {
    ++asked;
    Session session;
    session.inputs = Inputs().with(points_input, std::vector<Point_2>{{x, 0}});
    return session;
  });
  const auto written = [&] {
    return read_scene_folder(autosave.folder(), *make_registry_2()).inputs.get(points_input)->front().x;
  };
  EXPECT_FALSE(autosave.is_busy());
  for (int i = 0; i < 100; ++i) {
    x = i;
    autosave.touch();
  }
  EXPECT_TRUE(autosave.is_busy());
  EXPECT_EQ(asked, 0u);
  autosave.flush();
  EXPECT_EQ(asked, 1u);
  autosave.flush();
  EXPECT_EQ(asked, 1u);
  ASSERT_TRUE(wait_until([&] { return !autosave.is_busy(); }));
  EXPECT_EQ(written(), 99);
  x = 200;
  autosave.touch();
  autosave.close(true);
  EXPECT_EQ(asked, 2u);
  const auto kept = Scene_store(store_).kept();
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(read_scene_folder(kept[0].folder, *make_registry_2()).inputs.get(points_input)->front().x, 200);
}

TEST_F(Window_sessions, WhatIsAbandonedIsFoundAsAfterACrash) {
  {
    Session session;
    session.inputs = Inputs().with(points_input, std::vector<Point_2>(300000, Point_2{1, 2}));
    Autosave autosave(Scene_store(store_), [&] { return session; });
    autosave.touch();
    autosave.flush();
    autosave.abandon();
  }
  ASSERT_TRUE(wait_until([&] { return !Scene_store(store_).crashed().empty(); }));
  EXPECT_EQ(kept(), 0u);
}

TEST_F(Window_sessions, EndingAsksNobodyAndKeepsTheScene) {
  qunsetenv("MESECINA_NO_PROMPT");
  keep(true);
  change_everything();
  const Document_state state = document().state();
  QSignalSpy closed(&window(), &Program_window::closed);
  // A dialog that waits for an answer.
  QTimer::singleShot(0, [&] { window().end(); });
  trigger("open");
  ASSERT_TRUE(wait_until([&] { return !closed.isEmpty(); }));
  EXPECT_EQ(closed.count(), 1);
  ASSERT_EQ(kept(), 1u);
  EXPECT_TRUE(Scene_store(store_).crashed().empty());
  open_window();
  keep(true);
  EXPECT_EQ(window().recovery_bar().offers(), 0u);
  EXPECT_TRUE(same_data(document().inputs(), state.inputs));
  qputenv("MESECINA_NO_PROMPT", "1");
}

TEST_F(Window_sessions, SavingGoesOnInTheFileOfTheSession) {
  change_everything();
  const QString path = folder_.filePath("all.mesecina");
  ASSERT_TRUE(window().files().save_to(path));
  ASSERT_TRUE(wait_until_saved());
  document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{9, 9}}), "one");
  trigger("save");
  ASSERT_TRUE(wait_until_saved());
  const Session session = read_session_file(path.toStdString(), *make_registry_2());
  EXPECT_EQ(session.inputs.get(points_input)->size(), 1u);
  EXPECT_EQ(std::get<double>(*session.settings.find("scale")), 1.7);
}

TEST_F(Window_sessions, ABadSessionChangesNothingAndSaysWhere) {
  change_everything();
  const Document_state state = document().state();
  const View_2 view = canvas().view();
  const QString path = folder_.filePath("bad.mesecina");
  ASSERT_TRUE(window().files().save_session_to(path));
  ASSERT_TRUE(wait_until_saved());
  QFile file(path);
  ASSERT_TRUE(file.resize(file.size() / 2));
  open(path);
  expect_everything(state, view);
  ASSERT_EQ(window().messages().lines().size(), 1);
  EXPECT_TRUE(window().messages().lines().front().contains("bad.mesecina"));
  EXPECT_TRUE(window().messages().lines().front().contains("damaged or cut off"));
}

TEST_F(Window_sessions, PicturesBringEverythingBackAndOthersAreImages) {
  change_everything();
  ASSERT_TRUE(wait_until([&] { return !window().computation().is_busy(); }));
  const Document_state state = document().state();
  const View_2 view = canvas().view();
  for (const char* name : {"scene.png", "scene.svg", "scene.pdf"}) {
    const QString path = folder_.filePath(name);
    window().files().export_picture(path, {window().computation().scene({255, 255, 255}), view, {}}, {300, 200});
    ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
    open_window();
    open(path);
    expect_everything(state, view);
    EXPECT_TRUE(window().messages().lines().isEmpty()) << window().messages().lines().join("\n").toStdString();
  }
  window().files().set_scenes_in_pictures(false);
  const QString plain = folder_.filePath("plain.png");
  window().files().export_picture(plain, {window().computation().scene({255, 255, 255}), view, {}}, {300, 200});
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  open(plain);
  EXPECT_NE(document().inputs().get(image_input), nullptr);
}

TEST_F(Window_sessions, WhatACrashLeavesIsOfferedAndShown) {
  keep();
  wait_written();
  change_everything();
  const Document_state state = document().state();
  const View_2 view = canvas().view();
  wait_written();
  EXPECT_LT(Autosave::delay.count(), 1000);
  crash();
  keep();
  EXPECT_EQ(window().recovery_bar().offers(), 1u);
  EXPECT_TRUE(window().recovery_bar().isVisible());
  EXPECT_FALSE(same_data(document().inputs(), state.inputs));
  window().recovery_bar().findChild<QPushButton*>("recover")->click();
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  expect_everything(state, view);
  EXPECT_TRUE(document().is_modified());
  EXPECT_FALSE(window().recovery_bar().isVisible());
  EXPECT_EQ(kept(), 1u);
  trigger("undo");
  EXPECT_FALSE(same_data(document().inputs(), state.inputs));
}

TEST_F(Window_sessions, StatesOfOneSceneAreOneOfferAndOthersAnother) {
  const auto crash_with = [&](double x) {
    keep();
    document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{x, 9}, {1, 2}}), "two");
    wait_written();
    crash();
  };
  crash_with(0);
  crash_with(1);
  crash_with(2);
  open_window();
  window().files().new_document();
  crash_with(3);
  keep();
  auto& bar = window().recovery_bar();
  ASSERT_EQ(bar.offers(), 2u);
  const auto labels = bar.findChildren<QLabel*>();
  ASSERT_EQ(labels.size(), 2);
  EXPECT_TRUE(labels[0]->text().contains("Untitled (2 points, ")) << labels[0]->text().toStdString();
  EXPECT_TRUE(labels[0]->text().contains("layers), today ")) << labels[0]->text().toStdString();
  EXPECT_TRUE(labels[1]->text().startsWith("And: Example (2 points, ")) << labels[1]->text().toStdString();
  const auto older = bar.findChildren<QPushButton*>("older");
  ASSERT_EQ(older.size(), 1);
  EXPECT_EQ(older[0]->text(), "Older (2)");
  ASSERT_EQ(older[0]->menu()->actions().size(), 2);
  // The oldest state; the others are kept.
  older[0]->menu()->actions().back()->trigger();
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  EXPECT_EQ(points().front().x, 0);
  EXPECT_EQ(bar.offers(), 1u);
  EXPECT_EQ(kept(), 3u);
  for (QPushButton* button : bar.findChildren<QPushButton*>("decline")) button->click();
  EXPECT_EQ(bar.offers(), 0u);
  EXPECT_EQ(kept(), 4u);
  EXPECT_TRUE(Scene_store(store_).crashed().empty());
}

TEST_F(Window_sessions, ClosingAsksNothingAndTheNextStartGoesOn) {
  qunsetenv("MESECINA_NO_PROMPT");
  keep(true);
  change_everything();
  const Document_state state = document().state();
  const View_2 view = canvas().view();
  EXPECT_TRUE(window().close());
  EXPECT_EQ(kept(), 1u);
  open_window();
  keep(true);
  expect_everything(state, view);
  EXPECT_TRUE(document().is_modified());
  EXPECT_FALSE(window().actions()["undo"]->isEnabled());
  // What was taken up is kept once.
  EXPECT_TRUE(window().close());
  EXPECT_EQ(kept(), 1u);
  // With a file on the command line it stays for later.
  open_window();
  keep(false);
  EXPECT_FALSE(same_data(document().inputs(), state.inputs));
  EXPECT_TRUE(window().close());
  EXPECT_EQ(kept(), 2u);
  qputenv("MESECINA_NO_PROMPT", "1");
}

TEST_F(Window_sessions, WhoWantsNoReopeningLosesNothingUnsaved) {
  window().actions()["reopen-last-scene"]->setChecked(false);
  keep(true);
  window().close();
  EXPECT_EQ(kept(), 0u);
  open_window();
  EXPECT_FALSE(window().actions()["reopen-last-scene"]->isChecked());
  keep(true);
  change_everything();
  window().close();
  EXPECT_EQ(kept(), 1u);
  window().actions()["reopen-last-scene"]->setChecked(true);
}

/// Where a process that is going to be killed keeps its scenes.
constexpr const char* victim_store = "MESECINA_TEST_STORE";

/// Not for itself: a process that edits every few milliseconds, and says what it has done, until it is killed.
TEST_F(Window_sessions, DISABLED_EditsUntilKilled) {
  store_ = qgetenv(victim_store).toStdString();
  keep();
  QElapsedTimer time;
  time.start();
  QTimer timer;
  double edits = 0;
  QObject::connect(&timer, &QTimer::timeout, [&] {
    document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{++edits, 0}, {0, 1}}), "edit");
    std::cout << "edit " << edits << ' ' << time.elapsed() << std::endl;
  });
  timer.start(20);
  QTest::qWait(60000);
}

TEST_F(Window_sessions, KilledInTheMiddleOfAnEditNothingButTheLastSecondIsLost) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(victim_store, QString::fromStdString(store_.string()));
  process.setProcessEnvironment(environment);
  process.start(QCoreApplication::applicationFilePath(),
                {"--gtest_also_run_disabled_tests", "--gtest_filter=Window_sessions.DISABLED_EditsUntilKilled"});
  QByteArray told;
  constexpr int enough = 120;
  while (told.count("edit ") < enough && process.waitForReadyRead(20000)) told += process.readAllStandardOutput();
  ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
  process.waitForFinished();
  told += process.readAllStandardOutput();
  double last_time = 0;
  double oldest_allowed = 0;
  for (int pass = 0; pass < 2; ++pass) {
    for (const QByteArray& line : told.split('\n')) {
      const auto words = line.split(' ');
      if (words.size() != 3 || words[0] != "edit") continue;
      const double time = words[2].toDouble();
      if (pass == 0) last_time = time;
      if (pass == 1 && time <= last_time - 1000) oldest_allowed = words[1].toDouble();
    }
  }
  ASSERT_GT(oldest_allowed, 0);
  keep();
  ASSERT_EQ(window().recovery_bar().offers(), 1u);
  window().recovery_bar().findChild<QPushButton*>("recover")->click();
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  ASSERT_EQ(points().size(), 2u);
  EXPECT_GE(points()[0].x, oldest_allowed);
}

TEST_F(Window_sessions, EvolutionStepsComeBack) {
  keep();
  Document_state state = document().state();
  auto track = std::make_shared<Evolution_track>();
  track->places = {{state.inputs, {}, "", 0},
                   {state.inputs.with(points_input, std::vector<Point_2>{{1, 2}, {3, 4}}), {}, "noise", 1}};
  state.track = track;
  state.position = 1;
  state.inputs = track->places[1].inputs;
  document().edit(state, "step");
  wait_written();
  crash();
  keep();
  window().recovery_bar().findChild<QPushButton*>("recover")->click();
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  ASSERT_NE(document().state().track, nullptr);
  EXPECT_EQ(document().state().track->places.size(), 2u);
  EXPECT_EQ(document().state().position, 1u);
  EXPECT_TRUE(document().state().track->places[1].inputs == document().inputs());
}

}  // namespace
}  // namespace mesecina

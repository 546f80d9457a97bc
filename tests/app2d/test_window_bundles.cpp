// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPointer>
#include <QtTest>

#include "bundles/bundle_panel.h"
#include "core/batch/bundle_library.h"
#include "core/batch/bundle_option.h"
#include "core/bundle.h"
#include "geometries/modules_2.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

class Window_bundles_test : public Window_fixture {
 protected:
  void SetUp() override {
    open_window();
    QFile::remove(store().file());
    QFile::remove(store().file() + ".broken");
    open_window();
  }
  void TearDown() override { QFile::remove(store().file()); }

  Bundle_store& store() { return window().bundles().store(); }
  Bundle_panel& panel() { return *window().bundles().panel(); }
  QListWidget* list() { return panel().findChild<QListWidget*>("bundle-list"); }
  std::string name(std::size_t row) { return store().bundles().at(row).name; }
  void show_panel() {
    for (QDockWidget* dock : window().findChildren<QDockWidget*>("bundles-dock")) dock->raise();
    ASSERT_TRUE(wait_until([&] { return list()->isVisible(); }));
  }
  bool is_on_screen(const Bundle& bundle) {
    const Arrangement shown{document().settings(), document().layers()};
    return apply_bundle(bundle, *make_registry_2(), shown) == shown;
  }
  QString text_after_rename(const QString& text) {
    const QPointer<QLineEdit> editor = list()->viewport()->findChild<QLineEdit*>();
    if (!editor) return "no editor";
    editor->setText(text);
    QTest::keyClick(editor, Qt::Key_Return);
    wait_until([&] { return !editor; });
    QCoreApplication::processEvents();
    return QString::fromStdString(store().bundles().back().name);
  }
};

TEST_F(Window_bundles_test, DigitsApplyOneAsOneStep) {
  const Document_state before = document().state();
  const int steps = document().history().index();
  press(Qt::Key_3);
  EXPECT_TRUE(is_on_screen(store().bundles()[2]));
  EXPECT_EQ(document().history().index(), steps + 1);
  EXPECT_EQ(document().history().undoText(), "Bundle '" + QString::fromStdString(name(2)) + "'");
  EXPECT_TRUE(list()->item(2)->data(Qt::UserRole + 1).toBool());
  press(Qt::Key_7);
  EXPECT_TRUE(is_on_screen(store().bundles()[6]));
  EXPECT_FALSE(list()->item(2)->data(Qt::UserRole + 1).toBool());
  document().history().undo();
  document().history().undo();
  EXPECT_EQ(document().layers(), before.layers);
  EXPECT_EQ(document().settings(), before.settings);
}

TEST_F(Window_bundles_test, DigitsInATextFieldAreText) {
  trigger("find-layer");
  auto* field = qobject_cast<QLineEdit*>(QApplication::focusWidget());
  ASSERT_NE(field, nullptr);
  const int steps = document().history().index();
  QTest::keyClick(field, Qt::Key_3);
  EXPECT_EQ(field->text(), "3");
  EXPECT_EQ(document().history().index(), steps);
}

TEST_F(Window_bundles_test, AClickApplies) {
  show_panel();
  QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, list()->visualItemRect(list()->item(1)).center());
  EXPECT_TRUE(is_on_screen(store().bundles()[1]));
}

TEST_F(Window_bundles_test, IsSavedUnderATypedNameAndUndone) {
  const std::size_t count = store().bundles().size();
  press(Qt::Key_4);
  trigger("save-bundle");
  ASSERT_EQ(store().bundles().size(), count + 1);
  EXPECT_EQ(text_after_rename("Figure 3"), "Figure 3");
  press(Qt::Key_1);
  window().bundles().apply(static_cast<int>(count));
  EXPECT_TRUE(is_on_screen(store().bundles()[3]));
  document().history().undo();
  document().history().undo();
  document().history().undo();
  EXPECT_EQ(name(count), "My bundle");
  document().history().undo();
  EXPECT_EQ(store().bundles().size(), count);
  document().history().redo();
  EXPECT_EQ(store().bundles().size(), count + 1);
}

TEST_F(Window_bundles_test, NamesStayUniqueAndAreNeverEmpty) {
  trigger("save-bundle");
  EXPECT_EQ(text_after_rename("Scale axis"), "Scale axis 2");
  trigger("rename-bundle");
  EXPECT_EQ(text_after_rename("  "), "Scale axis 2");
}

TEST_F(Window_bundles_test, DeleteInTheListTakesBundlesAndNotPoints) {
  show_panel();
  const std::size_t count = store().bundles().size();
  const std::size_t point_count = points().size();
  trigger("select-all");
  const std::string second = name(1);
  panel().select(0);
  list()->setFocus();
  QTest::keyClick(list(), Qt::Key_Delete);
  EXPECT_EQ(store().bundles().size(), count - 1);
  EXPECT_EQ(name(0), second);
  EXPECT_EQ(points().size(), point_count);
  document().history().undo();
  EXPECT_EQ(store().bundles().size(), count);
}

TEST_F(Window_bundles_test, RowsThatAreMovedAreMovedInTheList) {
  const std::string first = name(0);
  const std::string second = name(1);
  ASSERT_TRUE(list()->model()->moveRow({}, 0, {}, 2));
  QCoreApplication::processEvents();
  EXPECT_EQ(name(0), second);
  EXPECT_EQ(name(1), first);
  document().history().undo();
  EXPECT_EQ(name(0), first);
  EXPECT_EQ(list()->item(0)->text().toStdString(), first);
}

TEST_F(Window_bundles_test, TheListIsKeptFromRunToRun) {
  trigger("save-bundle");
  text_after_rename("Kept");
  panel().select(0);
  trigger("delete-bundle");
  const std::vector<Bundle> before = store().bundles();
  open_window();
  EXPECT_EQ(store().bundles(), before);
  trigger("reset-bundles");
  EXPECT_EQ(name(0), shipped_bundles(*make_registry_2())[0].name);
  EXPECT_EQ(store().bundles().back().name, "Kept");
}

TEST_F(Window_bundles_test, ABrokenListIsKeptAsideAndTold) {
  QFile file(store().file());
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"format\": \"mesecina-bundles\", \"version\": 99}");
  file.close();
  open_window();
  EXPECT_EQ(store().bundles(), shipped_bundles(*make_registry_2()));
  EXPECT_TRUE(QFile::exists(store().file() + ".broken"));
  ASSERT_EQ(window().messages().lines().size(), 1);
  EXPECT_TRUE(window().messages().lines().front().contains("at most 1"));
}

TEST_F(Window_bundles_test, ExportedFilesAreImportedBesideTheOthers) {
  const std::size_t count = store().bundles().size();
  const QString path = folder_.filePath("all.json");
  window().bundles().export_file(path);
  window().bundles().import_file(path);
  ASSERT_EQ(store().bundles().size(), 2 * count);
  EXPECT_EQ(name(count), name(0) + " 2");
  EXPECT_EQ(store().bundles()[count].layers, store().bundles()[0].layers);
  window().bundles().import_file(write("bad.bnd", "abcdefgh"));
  EXPECT_EQ(store().bundles().size(), 2 * count);
  EXPECT_TRUE(window().messages().lines().join("").contains("byte 0"));
}

TEST_F(Window_bundles_test, UpdateTakesWhatIsOnScreen) {
  press(Qt::Key_2);
  panel().select(0);
  trigger("update-bundle");
  EXPECT_EQ(store().bundles()[0].layers, store().bundles()[1].layers);
  EXPECT_EQ(store().bundles()[0].name, shipped_bundles(*make_registry_2())[0].name);
}

TEST_F(Window_bundles_test, AViewIsKeptOnlyWhenAsked) {
  trigger("save-bundle");
  EXPECT_FALSE(store().bundles().back().view);
  trigger("save-bundle-with-view");
  ASSERT_TRUE(store().bundles().back().view);
  const View_2 view = canvas().view();
  trigger("zoom-in");
  ASSERT_NE(canvas().view(), view);
  window().bundles().apply(static_cast<int>(store().bundles().size()) - 1);
  EXPECT_EQ(canvas().view(), view);
}

TEST_F(Window_bundles_test, ADigitIsGivenToAnyOneAndUndone) {
  trigger("save-bundle");
  const std::size_t last = store().bundles().size() - 1;
  EXPECT_EQ(key_of(store().bundles(), last), 0);
  press(Qt::Key_1);
  panel().select(static_cast<int>(last));
  trigger("bundle-key-4");
  EXPECT_EQ(key_of(store().bundles(), last), 4);
  EXPECT_EQ(key_of(store().bundles(), 3), 0);
  EXPECT_TRUE(window().actions()["bundle-4"]->text().contains("My bundle"));
  EXPECT_TRUE(list()->item(static_cast<int>(last))->toolTip().contains("key 4"));
  EXPECT_FALSE(list()->item(3)->toolTip().contains("key"));
  canvas().setFocus();
  press(Qt::Key_4);
  EXPECT_TRUE(is_on_screen(store().bundles()[last]));
  EXPECT_EQ(document().history().undoText(), "Bundle 'My bundle'");
  const std::vector<Bundle> kept = store().bundles();
  open_window();
  EXPECT_EQ(store().bundles(), kept);
  panel().select(static_cast<int>(last));
  trigger("bundle-key-none");
  EXPECT_EQ(key_of(store().bundles(), last), 0);
  EXPECT_EQ(key_of(store().bundles(), 3), 4);
  document().history().undo();
  EXPECT_EQ(key_of(store().bundles(), last), 4);
  trigger("bundle-key-usual");
  EXPECT_EQ(store().bundles()[last].key, std::nullopt);
}

TEST_F(Window_bundles_test, ImportedOnesTakeNoDigitAway) {
  panel().select(2);
  trigger("bundle-key-5");
  const std::size_t count = store().bundles().size();
  window().bundles().import_file(write("mine.json", R"([{"name": "A", "key": 5}, {"name": "B", "key": 6}])"));
  ASSERT_EQ(store().bundles().size(), count + 2);
  EXPECT_EQ(key_of(store().bundles(), 2), 5);
  EXPECT_EQ(store().bundles()[count].key, std::nullopt);
  EXPECT_EQ(key_of(store().bundles(), count + 1), 6);
}

TEST_F(Window_bundles_test, AnUpdateKeepsKeyNeedsHelpAndWhatIsUnknown) {
  window().bundles().import_file(write(
      "mine.json",
      R"([{"name": "A", "help": "Mine.", "key": 7, "needs": ["outline"], "layers": [{"id": "outlin"}], "settings": {"scal": 2}}])"));
  const Bundle before = store().bundles().back();
  ASSERT_FALSE(before.unknown.layers.empty());
  press(Qt::Key_2);
  panel().select(static_cast<int>(store().bundles().size()) - 1);
  trigger("update-bundle");
  const Bundle& after = store().bundles().back();
  EXPECT_FALSE(after.layers.empty());
  EXPECT_EQ(after.key, 7);
  EXPECT_EQ(after.needs, before.needs);
  EXPECT_EQ(after.help, "Mine.");
  EXPECT_EQ(after.unknown, before.unknown);
}

TEST_F(Window_bundles_test, NoFileIsKeptOfAListThatIsAsItCame) {
  trigger("save-bundle");
  EXPECT_TRUE(QFile::exists(store().file()));
  document().history().undo();
  EXPECT_FALSE(QFile::exists(store().file()));
}

TEST_F(Window_bundles_test, WhatIsUnknownIsToldWhenOneIsShown) {
  window().bundles().import_file(write("mine.json", R"([{"name": "A", "layers": [{"id": "outlin"}]}])"));
  window().messages().dismiss();
  window().bundles().apply(static_cast<int>(store().bundles().size()) - 1);
  EXPECT_TRUE(window().messages().lines().join("").contains("there is no layer 'outlin'"));
}

TEST_F(Window_bundles_test, TheMenuOfKeysShowsTheKeyThatOneHas) {
  panel().select(2);
  trigger("bundle-key-7");
  Q_EMIT window().bundles().key_menu()->aboutToShow();
  EXPECT_TRUE(window().actions()["bundle-key-7"]->isChecked());
  panel().select(0);
  Q_EMIT window().bundles().key_menu()->aboutToShow();
  EXPECT_FALSE(window().actions()["bundle-key-7"]->isChecked());
  EXPECT_TRUE(window().actions()["bundle-key-usual"]->isChecked());
}

TEST_F(Window_bundles_test, TheBackgroundComesWithTheViewAndIsUndone) {
  trigger("background-dark");
  trigger("save-bundle");
  EXPECT_FALSE(store().bundles().back().background);
  trigger("save-bundle-with-view");
  EXPECT_EQ(store().bundles().back().background, Canvas_background::dark);
  trigger("background-paper");
  const Document_state before = document().state();
  const int steps = document().history().index();
  window().bundles().apply(static_cast<int>(store().bundles().size()) - 1);
  EXPECT_TRUE(window().actions()["background-dark"]->isChecked());
  EXPECT_EQ(document().history().index(), steps + 1);
  document().history().undo();
  EXPECT_TRUE(window().actions()["background-paper"]->isChecked());
  EXPECT_EQ(document().layers(), before.layers);
  document().history().redo();
  EXPECT_TRUE(window().actions()["background-dark"]->isChecked());
  // It is what the bundle shows, not what the user wants from now on.
  open_window();
  EXPECT_TRUE(window().actions()["background-paper"]->isChecked());
  panel().select(static_cast<int>(store().bundles().size()) - 1);
  trigger("background-none");
  trigger("update-bundle");
  EXPECT_EQ(store().bundles().back().background, Canvas_background::none);
}

TEST_F(Window_bundles_test, WithoutABackgroundPicturesAreTransparent) {
  const auto corner = [&](const char* name) {
    window().commands().run({"export-picture", folder_.filePath(name)});
    EXPECT_TRUE(wait_until([&] { return !window().has_file_jobs(); }));
    return qAlpha(QImage(folder_.filePath(name)).pixel(0, 0));
  };
  trigger("background-paper");
  EXPECT_EQ(corner("paper.png"), 255);
  trigger("background-none");
  EXPECT_EQ(corner("none.png"), 0);
  trigger("background-paper");
  EXPECT_EQ(corner("paper-again.png"), 255);
}

TEST_F(Window_bundles_test, OnesWithNothingToShowSayWhatTheyNeed) {
  const auto reason = [&](int row) { return list()->item(row)->data(Qt::UserRole + 4).toString(); };
  const int crust = 7;
  ASSERT_EQ(name(crust), "Power crust");
  EXPECT_EQ(reason(crust), "");
  document().edit_inputs(Inputs().with(disks_input, std::vector<Disk_2>{{{0, 0}, 1}}), "Disk");
  EXPECT_EQ(reason(crust), "needs points or an outline");
  EXPECT_TRUE(list()->item(crust)->toolTip().contains("Shows nothing now: needs points or an outline."));
  EXPECT_EQ(reason(0), "");
  document().history().undo();
  EXPECT_EQ(reason(crust), "");
}

TEST_F(Window_bundles_test, TheListIsTheOneThatCommandLinesRead) {
  trigger("save-bundle");
  EXPECT_EQ(text_after_rename("Figure 3"), "Figure 3");
  std::vector<std::string> warnings;
  const Bundle read = read_bundle_option("figure-3", *make_registry_2(), user_bundle_file("mesecina2d"), warnings);
  EXPECT_EQ(read, store().bundles().back());
  EXPECT_TRUE(warnings.empty());
}

TEST_F(Window_bundles_test, ChangesThatNoFileCanKeepStandAndAreTold) {
  QUndoStack history;
  Bundle_store homeless(make_registry_2(), history, QString());
  EXPECT_EQ(homeless.load(), "");
  QString reason;
  QObject::connect(&homeless, &Bundle_store::failed, [&](const QString& text) { reason = text; });
  std::vector<Bundle> fewer = homeless.bundles();
  fewer.pop_back();
  homeless.edit(fewer, "Delete a bundle");
  EXPECT_EQ(homeless.bundles(), fewer);
  EXPECT_TRUE(reason.contains("set HOME or XDG_DATA_HOME")) << reason.toStdString();
}

TEST_F(Window_bundles_test, WhatABundleOfTheCommandLineNamesInVainIsTold) {
  const std::string file =
      write("mine.json",
            R"([{"name": "Mine", "layers": [{"id": "outline"}, {"id": "outlin"}], "settings": {"scal": 2}}])")
          .toStdString();
  const auto registry = make_registry_2();
  const char* words[] = {"mesecina2d", "--bundle", file.c_str()};
  const auto parsed = parse_command_line(3, words, "mesecina2d", *registry, planar_formats(), {});
  open_window(startup_of(std::get<Command_line>(parsed)));
  const QString told = window().messages().lines().join("\n");
  EXPECT_TRUE(told.contains("bundle 'Mine'")) << told.toStdString();
  EXPECT_TRUE(told.contains("there is no layer 'outlin'")) << told.toStdString();
  EXPECT_TRUE(told.contains("there is no setting 'scal'")) << told.toStdString();
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QMessageBox>
#include <QSignalSpy>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "shell/script_runner.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

TEST(Words_of_line, BlanksQuotationsAndComments) {
  EXPECT_EQ(words_of_line("  add-point 1\t2 # there"), (QStringList{"add-point", "1", "2"}));
  EXPECT_EQ(words_of_line(R"(open "a b.xy" 'c "d".xy' "e\"f\\.xy")"),
            (QStringList{"open", "a b.xy", "c \"d\".xy", "e\"f\\.xy"}));
  EXPECT_EQ(words_of_line("style outline.color=#ff0000"), (QStringList{"style", "outline.color=#ff0000"}));
  EXPECT_EQ(words_of_line("\"\" x"), (QStringList{"", "x"}));
  EXPECT_EQ(words_of_line("# all of it"), QStringList());
  EXPECT_THROW(words_of_line("open \"a b"), Command_error);
  for (const QString& word : QStringList{"plain", "a b", "#x", "it's", "say \"yes\"", "back\\slash", ""})
    EXPECT_EQ(words_of_line(quoted(word)), QStringList{word}) << word.toStdString();
}

class Commands_in_window : public Window_fixture {
 protected:
  std::string error_of(const QString& line) {
    try {
      window().commands().run(words_of_line(line));
      return "";
    } catch (const Command_error& error) {
      return error.what();
    }
  }
  /// The error that the script ended with; "quit" when it said so; "..." when it did not end.
  QString play(const QByteArray& text) {
    Script_runner runner(window(), QStringLiteral("test.txt"), QString::fromUtf8(text));
    QSignalSpy finished(&runner, &Script_runner::finished);
    runner.start();
    if (!wait_until([&] { return finished.count() > 0; })) return QStringLiteral("...");
    EXPECT_EQ(finished.count(), 1);
    const QString error = finished.front().at(0).toString();
    return error.isEmpty() && finished.front().at(1).toBool() ? QStringLiteral("quit") : error;
  }
  QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
};

TEST_F(Commands_in_window, EveryActionIsACommandAndAllHaveHelp) {
  const std::vector<Command> list = window().commands().list();
  QStringList ids;
  for (const Command& command : list) {
    ids << command.id;
    EXPECT_FALSE(command.name.isEmpty()) << command.id.toStdString();
    EXPECT_FALSE(command.help.isEmpty()) << command.id.toStdString();
    EXPECT_FALSE(command.group.isEmpty()) << command.id.toStdString();
    for (const Parameter& parameter : command.parameters) EXPECT_FALSE(parameter.help.isEmpty());
  }
  for (const Actions::Entry& entry : window().actions().entries())
    EXPECT_EQ(ids.count(entry.action->objectName()), 1) << entry.action->objectName().toStdString();
  const auto json = nlohmann::json::parse(commands_text(window().commands(), true));
  EXPECT_EQ(json.size(), list.size());
  const std::string text = commands_text(window().commands(), false);
  for (const Command& command : list) EXPECT_NE(text.find(command.usage().toStdString()), std::string::npos);
}

TEST_F(Commands_in_window, ErrorsSayWhatWasExpectedAndWhatIsNear) {
  EXPECT_EQ(error_of("shwo medial-axis"), "unknown command 'shwo'; did you mean 'show'?");
  EXPECT_EQ(error_of("show medial-axsi"), "show: unknown LAYER 'medial-axsi'; did you mean 'medial-axis'?");
  EXPECT_EQ(error_of("add-point 1"), "add-point: expected X Y, found '1'");
  EXPECT_EQ(error_of("add-point 1 b"), "add-point: expected a number for Y, found 'b'");
  EXPECT_EQ(error_of("add-disk 1 2 -3"), "add-disk: expected a number of 0 or more for RADIUS, found '-3'");
  EXPECT_EQ(error_of("add-point 1 2 3"), "add-point: expected nothing more, found '3'; usage: add-point X Y");
  EXPECT_EQ(error_of("window big"), "window: expected WIDTHxHEIGHT in pixels, from 1 to 32768 for WxH, found 'big'");
  EXPECT_EQ(error_of("set scael=2"), "set: unknown setting 'scael'; did you mean 'scale'?");
  EXPECT_NE(error_of("set scale=0").find("expected a number >= 1"), std::string::npos);
  EXPECT_NE(error_of("style outline.colour=#fff").find("did you mean 'color'"), std::string::npos);
  EXPECT_EQ(error_of("cut"), "cut: not possible now");
  EXPECT_NE(error_of("undo 3").find("at most 0 steps"), std::string::npos);
  EXPECT_EQ(document().history().count(), 0);
}

TEST_F(Commands_in_window, EditsAreStepsThatCanBeUndone) {
  EXPECT_EQ(error_of("new"), "");
  EXPECT_EQ(error_of("add-point 1 2"), "");
  EXPECT_EQ(error_of("add-disk 0 0 3"), "");
  EXPECT_EQ(error_of("add-outline 0 0 4 0 4 4"), "");
  EXPECT_EQ(points(), (std::vector<Point_2>{{1, 2}}));
  EXPECT_EQ(document().inputs().get(disks_input)->front(), (Disk_2{{0, 0}, 3}));
  EXPECT_EQ(document().inputs().get(outline_input)->rings.front().size(), 3u);
  EXPECT_EQ(error_of("select-points"), "");
  EXPECT_EQ(error_of("move 1 -1"), "");
  EXPECT_EQ(points(), (std::vector<Point_2>{{2, 1}}));
  EXPECT_EQ(error_of("select-disks 0"), "");
  EXPECT_EQ(error_of("resize 2"), "");
  EXPECT_EQ(document().inputs().get(disks_input)->front().radius, 6);
  EXPECT_EQ(error_of("undo 2"), "");
  EXPECT_EQ(points(), (std::vector<Point_2>{{1, 2}}));
  EXPECT_EQ(error_of("redo"), "");
  EXPECT_EQ(points(), (std::vector<Point_2>{{2, 1}}));
  EXPECT_EQ(error_of("insert-random 7 3"), "");
  EXPECT_EQ(points().size(), 8u);
  EXPECT_EQ(window().popover(), nullptr);
}

TEST_F(Commands_in_window, LayersStylesSettingsAndSwitches) {
  EXPECT_EQ(error_of("solo delaunay voronoi-diagram"), error_of("solo delaunay voronoi-diagram"));
  EXPECT_EQ(error_of("solo delaunay points"), "");
  for (const Layer_entry& entry : document().layers())
    EXPECT_EQ(entry.style.visible, entry.id == "delaunay" || entry.id == "points") << entry.id;
  EXPECT_EQ(error_of("hide points"), "");
  EXPECT_FALSE(find_entry(document().layers(), "points")->style.visible);
  EXPECT_EQ(error_of("style delaunay.line-width=4 delaunay.color=#102030"), "");
  EXPECT_EQ(find_entry(document().layers(), "delaunay")->style.line_width, 4);
  EXPECT_EQ(error_of("set scale=1.5 balls-of-nothing=1").substr(0, 20), "set: unknown setting");
  EXPECT_EQ(document().settings().find("scale")->index(), 2u);
  EXPECT_EQ(error_of("reset scale"), "");
  EXPECT_EQ(document().settings().find("scale"), nullptr);
  EXPECT_EQ(error_of("background-dark on"), "");
  EXPECT_TRUE(window().actions()["background-dark"]->isChecked());
  EXPECT_EQ(error_of("background-dark on"), "");
  EXPECT_TRUE(window().actions()["background-dark"]->isChecked());
  EXPECT_EQ(error_of("background-paper"), "");
  EXPECT_EQ(error_of("tool disk"), "");
  EXPECT_TRUE(window().actions()["tool-disk"]->isChecked());
  EXPECT_EQ(error_of("view 0 10 0 5"), "");
  EXPECT_NEAR(canvas().view().center.x, 5, 1e-12);
  EXPECT_NE(error_of("view 0 10 5 0"), "");
}

TEST_F(Commands_in_window, BundlesByTheirNames) {
  ASSERT_FALSE(window().bundles().store().bundles().empty());
  const Bundle bundle = window().bundles().store().bundles().back();
  EXPECT_EQ(error_of("bundle " + quoted(QString::fromStdString(bundle.name))), "");
  for (const Layer_entry& entry : bundle.layers)
    EXPECT_EQ(find_entry(document().layers(), entry.id)->style.visible, entry.style.visible) << entry.id;
  EXPECT_NE(error_of("bundle nothing-like-this").find("unknown NAME"), std::string::npos);
  const QString file = path("bundles.json");
  EXPECT_EQ(error_of("export-bundles " + quoted(file)), "");
  EXPECT_TRUE(wait_until([&] { return QFile::exists(file); }));
}

TEST_F(Commands_in_window, AScriptMakesStepsOfEvolutions) {
  EXPECT_EQ(play("evolve noise 3\nstep 1\nquit").left(4), "quit");
  EXPECT_EQ(document().step_count(), 3u);
  EXPECT_EQ(document().position(), 1u);
  EXPECT_NE(error_of("step 9").find("at most 3"), std::string::npos);
  EXPECT_NE(error_of("evolve noize 3").find("did you mean 'noise'"), std::string::npos);
}

TEST_F(Commands_in_window, AScriptWaitsForFilesAndPictures) {
  const QString data = write("four.xy", "0 0\n10 0\n10 10\n0 10\n5 3\n");
  const QString script = QStringLiteral(
                             "# comment\n\nopen '%1'\nsolo delaunay\nadd-point 2 7\n"
                             "export-picture '%2' 300x200 transparent\nexport-layers '%3' json csv\n"
                             "save-points '%4'\nquit\nnever this\n")
                             .arg(data, path("p.png"), path("layers"), path("saved.xy"));
  EXPECT_EQ(play(script.toUtf8()), "quit");
  EXPECT_EQ(QImage(path("p.png")).size(), QSize(300, 200));
  EXPECT_TRUE(QImage(path("p.png")).hasAlphaChannel());
  QFile layer(path("layers/four.delaunay.json"));
  ASSERT_TRUE(layer.open(QIODevice::ReadOnly));
  EXPECT_EQ(nlohmann::json::parse(layer.readAll().toStdString()).at("vertices").size(), 6u);
  EXPECT_TRUE(QFile::exists(path("layers/four.delaunay.csv")));
  QFile saved(path("saved.xy"));
  ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
  EXPECT_EQ(saved.readAll(), "0 0\n10 0\n10 10\n0 10\n5 3\n2 7\n");
}

TEST_F(Commands_in_window, AScriptStopsAtTheFirstErrorAndSaysWhere) {
  EXPECT_EQ(play("add-point 1 2\n\nshow nothing-like-this-at-all\nadd-point 3 4\n").left(11), "test.txt:3:");
  EXPECT_EQ(document().history().count(), 1);
  const QString bad = write("bad.xy", "0 0\n1 zero\n");
  const QString error = play(QStringLiteral("open '%1'\nadd-point 3 4").arg(bad).toUtf8());
  EXPECT_TRUE(error.startsWith("test.txt:1: ")) << error.toStdString();
  EXPECT_TRUE(error.contains("bad.xy:2")) << error.toStdString();
  EXPECT_EQ(document().history().count(), 1);
  EXPECT_EQ(play("add-point 'x").left(11), "test.txt:1:");
  EXPECT_EQ(play("add-point 3 4\n"), "");
}

TEST_F(Commands_in_window, AScriptClosesDialogsInsteadOfWaitingForAnswers) {
  window().actions().add(QStringLiteral("Test"), {QStringLiteral("ask"), QStringLiteral("Ask"), QStringLiteral("Asks")},
                         [this] { QMessageBox::question(&window(), QStringLiteral("Sure?"), QStringLiteral("?")); });
  const QString error = play("ask\nadd-point 3 4");
  EXPECT_TRUE(error.startsWith("test.txt:1: ")) << error.toStdString();
  EXPECT_TRUE(error.contains("dialog")) << error.toStdString();
  EXPECT_EQ(document().history().count(), 0);
}

TEST_F(Commands_in_window, PanelsComeForwardAndTheWindowIsPictured) {
  auto* disks = window().findChild<QDockWidget*>("disks-dock");
  auto* statistics = window().findChild<QDockWidget*>("statistics-dock");
  EXPECT_EQ(error_of("panel disks"), "");
  EXPECT_TRUE(wait_until([&] { return !disks->visibleRegion().isEmpty(); }));
  EXPECT_EQ(error_of("panel statistics"), "");
  EXPECT_TRUE(statistics->isVisible());
  EXPECT_EQ(error_of("panel statistics off"), "");
  EXPECT_FALSE(statistics->isVisible());
  EXPECT_NE(error_of("panel disk"), "");
  const QString picture = path("window.png");
  EXPECT_EQ(error_of("picture-of-window " + picture), "");
  EXPECT_EQ(QImage(picture).size(), window().size() * window().devicePixelRatioF());
  EXPECT_NE(error_of("picture-of-window " + path("missing/window.png")), "");
}

}  // namespace
}  // namespace mesecina

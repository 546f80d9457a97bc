// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QMimeData>
#include <QSpinBox>
#include <QUrl>
#include <QtTest>

#include "app2d/popovers_2.h"
#include "geometries/witness_2/module.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

class Files : public Window_fixture {
 protected:
  void drop(const QStringList& paths, Qt::KeyboardModifiers modifiers = {}) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&window(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, modifiers);
    QApplication::sendEvent(&window(), &event);
    EXPECT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  }
  QByteArray content(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
  }
};

TEST_F(Files, ADropReplacesAndCanBeUndone) {
  const auto start = points();
  drop({write("four.xy", "0 0\n1 0\n1 1\n0 1\n")});
  EXPECT_EQ(points().size(), 4u);
  EXPECT_FALSE(document().is_modified());
  EXPECT_TRUE(window().windowTitle().startsWith("four.xy[*]"));
  trigger("undo");
  EXPECT_EQ(points(), start);
}

TEST_F(Files, SeveralFilesAndModifiersAdd) {
  drop({write("a.xy", "0 0\n1 0\n"), write("b.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 0))")});
  EXPECT_EQ(points().size(), 2u);
  ASSERT_NE(document().inputs().get(outline_input), nullptr);
  drop({write("c.xy", "9 9\n")}, Qt::ControlModifier);
  EXPECT_EQ(points(), (std::vector<Point_2>{{0, 0}, {1, 0}, {9, 9}}));
  EXPECT_TRUE(document().is_modified());
}

TEST_F(Files, ABadFileChangesNothingAndSaysWhere) {
  const Inputs start = document().inputs();
  drop({write("bad.xy", "0 0\n1 zero\n")});
  EXPECT_TRUE(document().inputs() == start);
  EXPECT_EQ(document().history().count(), 0);
  ASSERT_TRUE(window().messages().isVisible());
  EXPECT_TRUE(window().messages().lines().front().contains("bad.xy:2"));
  drop({folder_.filePath("missing.xy")});
  EXPECT_TRUE(document().inputs() == start);
  EXPECT_EQ(window().messages().lines().size(), 2);
  press(Qt::Key_Escape);
  EXPECT_FALSE(window().messages().isVisible());
}

TEST_F(Files, OfGoodAndBadFilesTheGoodOnesAreRead) {
  drop({write("bad.wkt", "POLYGON (("), write("good.xy", "1 2\n")});
  EXPECT_EQ(points(), (std::vector<Point_2>{{1, 2}}));
  EXPECT_EQ(window().messages().lines().size(), 1);
}

TEST_F(Files, SavesWhatItReadExactly) {
  drop({write("in.xy", "0.1 1e-300\n-7 123456789.123456789\n")});
  const auto read = points();
  const QString path = folder_.filePath("out.poff");
  ASSERT_TRUE(window().files().save_to(path));
  ASSERT_TRUE(wait_until_saved());
  window().files().open({path}, false);
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  EXPECT_EQ(points(), read);
}

TEST_F(Files, WhatIsBeingSavedIsReadWhenItIsThere) {
  // Large enough to be written for longer than opening takes to begin.
  std::vector<Point_2> many;
  for (int i = 0; i < 50'000; ++i) many.push_back({i / 3.0, i / 7.0});
  drop({write("in.xy", "0 0\n1 1\n")});
  document().edit_inputs(Inputs().with(points_input, many), "points");
  const QString path = write("out.xy", "9 9\n");
  ASSERT_TRUE(window().files().save_to(path));
  window().files().open({path}, false);
  EXPECT_TRUE(wait_until([&] { return points().size() != many.size() || document().history().count() > 2; }));
  EXPECT_EQ(points(), many);
}

TEST_F(Files, SaveWritesTheFileOfTheDocument) {
  const QString path = write("in.xy", "0 0\n1 1\n");
  drop({path});
  window().editor().add_point({5, 5});
  EXPECT_TRUE(window().isWindowModified());
  trigger("save");
  ASSERT_TRUE(wait_until_saved());
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_EQ(content(path), "0 0\n1 1\n5 5\n");
}

TEST_F(Files, RefusesToLoseAPart) {
  drop({write("a.xy", "0 0\n1 0\n"), write("b.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 0))")});
  window().editor().add_point({5, 5});
  const QString path = folder_.filePath("both.xy");
  EXPECT_FALSE(window().files().save_to(path));
  EXPECT_FALSE(QFile::exists(path));
  EXPECT_TRUE(window().messages().lines().front().contains("outline"));
  EXPECT_TRUE(window().files().save_part_to(path, "points"));
  ASSERT_TRUE(wait_until_saved());
  EXPECT_EQ(content(path), "0 0\n1 0\n5 5\n");
  EXPECT_FALSE(document().is_modified());
  EXPECT_FALSE(window().files().save_to(folder_.filePath("what.docx")));
}

TEST_F(Files, StartsWithTheViewThatWasAskedFor) {
  Startup startup;
  startup.files = {write("far.xy", "0 0\n100 0\n100 50\n").toStdString()};
  // A picture of 400 x 200 pixels shows x from 20 to 60 and y from -5 to 15.
  startup.seen = Seen_2{{{40, 5}, 10}, 400, 200};
  open_window(startup);
  ASSERT_TRUE(wait_until([&] { return points().size() == 3; }));
  const View_2 view = canvas().view();
  EXPECT_EQ(view.center, (Point_2{40, 5}));
  EXPECT_DOUBLE_EQ(view.scale, 10 * std::min(canvas().width() / 400.0, canvas().height() / 200.0));

  window().files().open({write("other.xy", "0 0\n1 0\n1 1\n")}, false);
  ASSERT_TRUE(wait_until([&] { return points().size() == 3 && canvas().view().center == Point_2{0.5, 0.5}; }));
}

TEST_F(Files, ExportsThePictureAndTheLayers) {
  ASSERT_TRUE(wait_until_current("medial-axis"));
  const QString picture = folder_.filePath("view.svg");
  window().files().export_picture(picture, {canvas().scene(), canvas().view(), {}}, {400, 300});
  std::map<std::string, QString> reasons;
  window().files().export_layers(folder_.path(), canvas().scene(), {"json", "csv"}, {}, reasons);
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  EXPECT_TRUE(content(picture).contains("medial-axis"));
  EXPECT_TRUE(content(folder_.filePath("Example.medial-axis.json")).contains("\"mesecina-layer\""));
  EXPECT_FALSE(content(folder_.filePath("Example.points.csv")).isEmpty());
  EXPECT_FALSE(QFile::exists(folder_.filePath("Example.delaunay.csv")));
}

TEST_F(Files, EnterInAnExportGoesOnToTheFile) {
  bool was_written = false;
  const auto save = [&](const Picture_wish& wish) { was_written = wish.size == QSize(640, 300); };
  Popover* popover = open_picture_popover({{400, 300}, false}, "PNG", &canvas(), save, {});
  auto* width = popover->findChildren<QSpinBox*>().front();
  width->selectAll();
  QTest::keyClicks(width, "640");
  QTest::keyClick(width, Qt::Key_Return);
  EXPECT_TRUE(was_written);
}

TEST_F(Files, ExamplesOpen) {
  ASSERT_TRUE(Files_2::examples().contains("giraffe.wkt"));
  window().files().open_example("giraffe.wkt");
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  ASSERT_NE(document().inputs().get(outline_input), nullptr);
  EXPECT_TRUE(wait_until_current("medial-axis"));
  EXPECT_FALSE(document().is_modified());
}

TEST_F(Files, OpensTheFilesLayersAndSettingsOfTheCommandLine) {
  const QString path = write("square.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0))");
  Style faint;
  faint.opacity = 0.25;
  open_window({{path.toStdString()},
               {"outline", "delaunay"},
               Settings().with("sampling-step", 0.1),
               {{"delaunay", faint}, {"voronoi", faint}}});
  ASSERT_TRUE(wait_until([&] { return document().inputs().get(outline_input) != nullptr; }));
  EXPECT_FALSE(window().actions()["undo"]->isEnabled());
  EXPECT_TRUE(wait_until_current("delaunay"));
  for (const Layer_entry& entry : document().layers())
    EXPECT_EQ(entry.style.visible, entry.id == "outline" || entry.id == "delaunay") << entry.id;
  for (const Layer_entry& entry : document().layers())
    EXPECT_EQ(entry.style.opacity == 0.25, entry.id == "voronoi" || entry.id == "delaunay") << entry.id;
  EXPECT_EQ(*document().settings().find("sampling-step"), Setting_value(0.1));
  EXPECT_EQ(document().inputs().get(points_input), nullptr);
  EXPECT_EQ(window().layer_panel().selected(), QStringList("delaunay"));
}

TEST_F(Files, OnlyTheFirstFilesCannotBeUndone) {
  const QString path = write("two.xy", "0 0\n1 1\n");
  open_window({{path.toStdString()}, {}, {}});
  ASSERT_TRUE(wait_until([&] { return points().size() == 2; }));
  EXPECT_EQ(document().history().count(), 0);
  EXPECT_FALSE(document().is_modified());
  drop({write("one.xy", "0 0\n")});
  trigger("undo");
  EXPECT_EQ(points().size(), 2u);

  open_window({{folder_.filePath("missing.xy").toStdString()}, {}, {}});
  ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
  window().editor().add_point({7, 7});
  drop({path});
  trigger("undo");
  EXPECT_EQ(points(), (std::vector<Point_2>{{7, 7}}));
}

TEST_F(Files, DisksAreShownWithoutAWord) {
  drop({write("disks.csv", "x,y,r\n1,2,3\n4,5,6\n")});
  ASSERT_NE(document().inputs().get(disks_input), nullptr);
  EXPECT_TRUE(window().messages().lines().isEmpty());
  EXPECT_TRUE(window().layer_notes().lines().isEmpty());
  ASSERT_TRUE(wait_until_current("disks"));
  EXPECT_EQ(window().computation().primitives("disks")->balls.size(), 2u);
}

TEST_F(Files, AFirstLookFollowsWhatTheFilesHold) {
  const auto shown = [this](const char* id) { return find_entry(document().layers(), id)->style.visible; };
  const QString disks = write("disks.wpoff", "WPOFF 2 0 0\n0 0 2\n3 0 2\n");
  open_window({{disks.toStdString()}, {}, {}});
  ASSERT_TRUE(wait_until([&] { return document().inputs().get(disks_input) != nullptr; }));
  EXPECT_TRUE(shown("union-medial-axis") && shown("union-boundary"));
  EXPECT_FALSE(shown("medial-axis") || shown("voronoi"));
  ASSERT_TRUE(wait_until_current("union-medial-axis"));
  EXPECT_TRUE(window().layer_notes().lines().isEmpty());
  EXPECT_EQ(document().history().count(), 0);

  drop({write("three.xy", "0 0\n1 0\n0 1\n")});
  EXPECT_TRUE(shown("medial-axis"));
  EXPECT_FALSE(shown("union-medial-axis"));
  trigger("undo");
  EXPECT_TRUE(shown("union-medial-axis"));
  EXPECT_NE(document().inputs().get(disks_input), nullptr);

  // What the user has chosen stays.
  Layer_list layers = document().layers();
  find_entry(layers, "delaunay")->style.visible = true;
  document().edit_layers(layers, "Show");
  drop({write("three.xy", "0 0\n1 0\n0 1\n")});
  EXPECT_TRUE(shown("union-medial-axis") && shown("delaunay"));
}

TEST_F(Files, DisksAreSavedAndReadExactly) {
  drop({write("in.csv", "x,y,r\n0.1,1e-300,0.30000000000000004\n-7,123456789.12345679,5e-324\n")});
  const auto read = *document().inputs().get(disks_input);
  for (const char* name : {"out.wpoff", "out.csv"}) {
    const QString path = folder_.filePath(name);
    ASSERT_TRUE(window().files().save_to(path));
    ASSERT_TRUE(wait_until_saved());
    EXPECT_FALSE(document().is_modified());
    trigger("new");
    window().files().open({path}, false);
    ASSERT_TRUE(wait_until([&] { return !window().files().jobs().is_busy(); }));
    ASSERT_NE(document().inputs().get(disks_input), nullptr) << name;
    EXPECT_EQ(*document().inputs().get(disks_input), read) << name;
  }
  drop({write("more.wpoff", "WPOFF 1 0 0\n1 2 3\n")}, Qt::ControlModifier);
  EXPECT_EQ(document().inputs().get(disks_input)->size(), 3u);
  drop({write("more.wpoff", "WPOFF 1 0 0\n1 2 3\n")});
  EXPECT_EQ(*document().inputs().get(disks_input), (std::vector<Disk_2>{{{1, 2}, 3}}));
}

TEST_F(Files, NeverLosesDisksOrPointsSilently) {
  const QString path = write("in.xy", "0 0\n1 1\n");
  drop({path});
  window().editor().add_disk({{5, 5}, 1});
  // The user is asked for the name of a session, and gives up.
  bool is_asked = false;
  QTimer::singleShot(0, &window(), [&is_asked] {
    QWidget* chooser = QApplication::activeModalWidget();
    is_asked = chooser != nullptr;
    if (chooser) chooser->close();
  });
  trigger("save");
  ASSERT_TRUE(wait_until_saved());
  EXPECT_TRUE(is_asked);
  EXPECT_EQ(content(path), "0 0\n1 1\n");
  EXPECT_TRUE(document().is_modified());
  ASSERT_EQ(window().messages().lines().size(), 1);
  EXPECT_TRUE(window().messages().lines().front().contains("disks and points"));
  EXPECT_FALSE(window().files().save_to(folder_.filePath("both.wpoff")));
  EXPECT_FALSE(QFile::exists(folder_.filePath("both.wpoff")));
  EXPECT_TRUE(window().files().save_part_to(folder_.filePath("part.wpoff"), "disks"));
  ASSERT_TRUE(wait_until_saved());
  EXPECT_FALSE(document().is_modified());
  EXPECT_EQ(content(folder_.filePath("part.wpoff")), "WPOFF 1 0 0\n5 5 1\n");
}

TEST_F(Files, LandmarksAreShownAtOnceAndAreNoPartThatSavingWouldLose) {
  const auto shown = [this](const char* id) { return find_entry(document().layers(), id)->style.visible; };
  const QString path = write("in.xy", "0 0\n1 1\n3 1\n");
  drop({path});
  EXPECT_TRUE(shown("medial-axis") && !shown("witness-complex"));
  const Inputs before = document().inputs();
  document().edit_inputs(before.with(landmarks_input, std::vector<Point_2>{{0, 0}, {3, 1}}), "Landmarks");
  EXPECT_TRUE(shown("landmarks") && shown("witness-complex") && !shown("medial-axis"));
  window().editor().add_point({5, 5});
  trigger("save");
  ASSERT_TRUE(wait_until_saved());
  EXPECT_FALSE(window().isWindowModified());
  EXPECT_EQ(content(path), "0 0\n1 1\n3 1\n5 5\n");
  document().edit_inputs(before, "Without landmarks");
  EXPECT_TRUE(shown("medial-axis") && !shown("witness-complex"));
}

TEST_F(Files, CancelledReadingChangesNothing) {
  QByteArray many;
  for (int i = 0; i < 300000; ++i) many += QByteArray::number(i) + " " + QByteArray::number(i * i % 1013) + "\n";
  const Inputs start = document().inputs();
  window().files().open({write("many.xy", many)}, false);
  window().files().jobs().cancel();
  EXPECT_FALSE(window().files().jobs().is_busy());
  // The next job runs only after the cancelled one has ended.
  bool is_done = false;
  window().files().jobs().run("mark", [&] { return [&] { is_done = true; }; });
  ASSERT_TRUE(wait_until([&] { return is_done; }));
  EXPECT_TRUE(document().inputs() == start);
}

}  // namespace
}  // namespace mesecina

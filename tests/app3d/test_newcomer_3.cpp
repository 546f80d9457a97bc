// SPDX-License-Identifier: GPL-3.0-or-later
// What a newcomer tries in the first ten minutes in the window of space, by mouse, keys and commands.
#include <gtest/gtest.h>

#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QRegularExpression>
#include <QStatusBar>
#include <algorithm>

#include "bundles/bundle_panel.h"
#include "shell/commands.h"
#include "shell/status_progress.h"
#include "tests/app3d/window_fixture_3.h"

namespace mesecina {
namespace {

class Newcomer_3 : public Window_3 {
 protected:
  void run(const QStringList& words) {
    try {
      window_->commands().run(words);
    } catch (const std::exception& error) {
      FAIL() << words.join(' ').toStdString() << ": " << error.what();
    }
  }
  Document& document() { return window_->document(); }
  Style style(const char* layer) { return find_entry(document().layers(), layer)->style; }
  std::vector<Ball_3> balls() {
    const auto given = document().inputs().get(balls_input);
    return given ? *given : std::vector<Ball_3>();
  }
  QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void drop(const std::filesystem::path& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(path.string()))});
    QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(window_.get(), &event);
    ASSERT_TRUE(wait_until_idle());
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    window_->activateWindow();
    viewer().setFocus();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(&viewer(), key, modifiers);
  }
  void drop_three_balls() {
    drop(write("three.woff", "WOFF 3 0 0\n0 0 0 1\n1.2 0 0 0.8\n0 1.1 0.2 1\n"));
    ASSERT_EQ(balls().size(), 3U);
  }
};

TEST_F(Newcomer_3, DropsMovesAndTakesBack) {
  ASSERT_TRUE(wait_until_idle());
  drop_three_balls();
  EXPECT_TRUE(window_->windowTitle().contains("three.woff"));
  const std::vector<Ball_3> start = balls();
  run({"select-balls", "1"});
  run({"move", "0.5", "0", "0"});
  ASSERT_EQ(balls().size(), 3U);
  EXPECT_EQ(balls()[1].center.x, 1.7);
  run({"add-ball", "3", "0", "0", "0.5"});
  ASSERT_EQ(balls().size(), 4U);
  ASSERT_TRUE(wait_until_idle());
  press(Qt::Key_Z, Qt::ControlModifier);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(balls(), start);
  press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(balls()[1].center.x, 1.7);
}

TEST_F(Newcomer_3, StylesLayersAndTakesThatBack) {
  ASSERT_TRUE(wait_until_idle());
  drop_three_balls();
  const Layer_list before = document().layers();
  run({"solo", "dual-triangles"});
  EXPECT_TRUE(style("dual-triangles").visible);
  EXPECT_FALSE(style("given-balls").visible);
  run({"style", "dual-triangles.opacity=0.25"});
  EXPECT_EQ(style("dual-triangles").opacity, 0.25);
  ASSERT_TRUE(wait_until_idle());
  EXPECT_NE(window_->computation().primitives("dual-triangles"), nullptr);
  run({"undo", "2"});
  EXPECT_EQ(document().layers(), before);
}

TEST_F(Newcomer_3, KeepsABundleAndComesBackToItByKey) {
  ASSERT_TRUE(wait_until_idle());
  drop_three_balls();
  run({"solo", "medial-axis"});
  run({"style", "medial-axis.color=#123456"});
  run({"save-bundle"});
  auto* list = window_->findChild<QListWidget*>("bundle-list");
  ASSERT_NE(list, nullptr);
  QWidget* editor = nullptr;
  ASSERT_TRUE(wait_until([&] { return (editor = list->findChild<QLineEdit*>()) != nullptr; }));
  QTest::keyClicks(editor, "fig3");
  QTest::keyClick(editor, Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return !list->findItems("fig3", Qt::MatchContains).isEmpty(); }));
  Q_EMIT window_->findChild<Bundle_panel*>()->moved(list->count() - 1, 0);
  ASSERT_TRUE(wait_until([&] { return list->item(0)->text().contains("fig3"); }));
  press(Qt::Key_3);
  EXPECT_FALSE(style("medial-axis").visible);
  press(Qt::Key_1);
  EXPECT_TRUE(style("medial-axis").visible);
  EXPECT_EQ(style("medial-axis").color, (Color{0x12, 0x34, 0x56}));
}

TEST_F(Newcomer_3, TurnsWhileItComputesAndCancels) {
  ASSERT_TRUE(wait_until_idle());
  run({"set", "delta=0.0015"});
  ASSERT_TRUE(wait_until([&] { return window_->computation().is_busy(); }));
  const View_3 before = viewer().view();
  const QPoint middle = viewer().rect().center();
  drag(Qt::LeftButton, middle, middle + QPoint(80, 10));
  EXPECT_GT(distance(viewer().view().camera.position, before.camera.position), 0);
  // What is over soon cannot be cancelled: the progress is not shown yet.
  ASSERT_TRUE(wait_until([&] {
    const auto shown = window_->statusBar()->findChildren<Status_progress*>();
    return std::ranges::any_of(shown, [](const auto* progress) { return progress->isVisible(); });
  }));
  EXPECT_TRUE(window_->computation().is_busy());
  press(Qt::Key_Escape);
  ASSERT_TRUE(wait_until([&] { return !window_->computation().is_busy(); }));
  run({"undo"});
  EXPECT_TRUE(document().settings().changed().empty());
}

TEST_F(Newcomer_3, StepsAnEvolutionAndGoesBackAndForth) {
  ASSERT_TRUE(wait_until_idle());
  drop_three_balls();
  run({"evolve-grow-balls"});
  for (std::size_t step = 1; step <= 3; ++step) {
    run({"evolution-forward"});
    ASSERT_TRUE(
        wait_until([&] { return document().step_count() == step && !window_->evolution().evolver().is_busy(); }));
  }
  const double grown = balls()[0].radius;
  EXPECT_GT(grown, 1);
  run({"evolution-first"});
  EXPECT_EQ(balls()[0].radius, 1);
  run({"evolution-last"});
  EXPECT_EQ(balls()[0].radius, grown);
  run({"undo"});
  EXPECT_EQ(balls()[0].radius, 1);
}

TEST_F(Newcomer_3, WritesPicturesOfWhatIsSeen) {
  ASSERT_TRUE(wait_until_idle());
  drop_three_balls();
  run({"solo", "dual-triangles"});
  ASSERT_TRUE(wait_until([&] {
    return window_->computation().status("dual-triangles").state == Layer_status::State::current &&
           window_->computation().primitives("dual-triangles") != nullptr;
  }));
  const QString svg = folder_.filePath("figure.svg");
  const QString png = folder_.filePath("figure.png");
  run({"export-picture", svg, "800x600"});
  run({"export-picture", png, "640x481", "transparent"});
  ASSERT_TRUE(wait_until_idle());
  const QByteArray text = content(svg);
  EXPECT_TRUE(text.contains("inkscape:groupmode=\"layer\""));
  EXPECT_FALSE(QRegularExpression("=\"\\d+,\\d+\"").match(QString::fromUtf8(text)).hasMatch());
  const QImage picture(png);
  EXPECT_EQ(picture.size(), QSize(640, 481));
  EXPECT_EQ(picture.pixelColor(0, 0).alpha(), 0);
  bool is_painted = false;
  for (int x = 0; x < picture.width(); x += 2)
    for (int y = 0; y < picture.height(); y += 2) is_painted = is_painted || picture.pixelColor(x, y).alpha() == 255;
  EXPECT_TRUE(is_painted);
}

}  // namespace
}  // namespace mesecina

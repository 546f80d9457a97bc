// SPDX-License-Identifier: GPL-3.0-or-later
// What a newcomer tries in the first ten minutes, one after the other in one window, by mouse, keys and commands.
#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QRegularExpression>
#include <QUrl>
#include <QtTest>
#include <cmath>

#include "bundles/bundle_panel.h"
#include "shell/commands.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

class Newcomer : public Window_fixture {
 protected:
  void run(const QStringList& words) {
    try {
      window().commands().run(words);
    } catch (const std::exception& error) {
      FAIL() << words.join(' ').toStdString() << ": " << error.what();
    }
  }
  bool wait_until_idle() {
    return wait_until([&] { return !window().computation().is_busy() && !window().files().jobs().is_busy(); });
  }
  QByteArray content(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  void drop(const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window(), &event);
    ASSERT_TRUE(wait_until_idle());
  }
  Style style(const char* layer) { return find_entry(document().layers(), layer)->style; }
  void expect_no_messages() {
    EXPECT_TRUE(window().messages().lines().isEmpty()) << window().messages().lines().join('\n').toStdString();
  }
};

TEST_F(Newcomer, MovesAddsAndTakesBack) {
  // The example is there, and what is computed of it follows the mouse.
  ASSERT_TRUE(wait_until_current("medial-axis"));
  const std::vector<Point_2> start = points();
  ASSERT_GT(start.size(), 20U);
  const auto axis = window().computation().primitives("medial-axis");
  drag(pixel(start.front()), pixel(start.front()) + QPoint(40, 15));
  ASSERT_EQ(points().size(), start.size());
  const std::vector<Point_2> moved = points();
  EXPECT_NE(moved.front(), start.front());
  ASSERT_TRUE(wait_until_current("medial-axis"));
  EXPECT_NE(window().computation().primitives("medial-axis"), axis);

  const QPoint free(canvas().width() / 2, canvas().height() - 12);
  QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, free);
  ASSERT_EQ(points().size(), start.size() + 1);
  drag(free, free + QPoint(30, -10));
  EXPECT_EQ(points().size(), start.size() + 1);
  for (int i = 0; i < 3; ++i) press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(points(), start);
  for (int i = 0; i < 3; ++i) press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(points().size(), start.size() + 1);
  expect_no_messages();
}

TEST_F(Newcomer, DropsAFileAndStylesItsLayers) {
  drop(write("circle.xyz", [] {
    QByteArray text;
    constexpr int count = 60;
    for (int i = 0; i < count; ++i)
      text += QByteArray::number(std::cos(0.1 * i)) + ' ' + QByteArray::number(std::sin(0.1 * i)) + '\n';
    return text;
  }()));
  ASSERT_EQ(points().size(), 60U);
  ASSERT_TRUE(window().windowTitle().contains("circle.xyz"));

  const Layer_list before = document().layers();
  run({"hide", "medial-axis"});
  EXPECT_FALSE(style("medial-axis").visible);
  run({"solo", "delaunay"});
  EXPECT_TRUE(style("delaunay").visible);
  EXPECT_FALSE(style("one-step-crust").visible);
  run({"style", "delaunay.opacity=0.25"});
  EXPECT_EQ(style("delaunay").opacity, 0.25);
  ASSERT_TRUE(wait_until_current("delaunay"));
  run({"undo", "3"});
  EXPECT_EQ(document().layers(), before);
}

TEST_F(Newcomer, KeepsABundleAndComesBackToItByKey) {
  ASSERT_TRUE(wait_until_idle());
  run({"solo", "voronoi"});
  run({"style", "voronoi.color=#123456"});
  run({"save-bundle"});
  auto* list = window().findChild<QListWidget*>("bundle-list");
  ASSERT_NE(list, nullptr);
  // Its name is typed in place.
  QWidget* editor = nullptr;
  ASSERT_TRUE(wait_until([&] { return (editor = list->findChild<QLineEdit*>()) != nullptr; }));
  QTest::keyClicks(editor, "fig3");
  QTest::keyClick(editor, Qt::Key_Return);
  ASSERT_TRUE(wait_until([&] { return !list->findItems("fig3", Qt::MatchContains).isEmpty(); }));
  // A drag to the top of the list gives it the key 1.
  Q_EMIT window().findChild<Bundle_panel*>()->moved(list->count() - 1, 0);
  ASSERT_TRUE(wait_until([&] { return list->item(0)->text().contains("fig3"); }));
  press(Qt::Key_3);
  EXPECT_NE(style("voronoi").color, (Color{0x12, 0x34, 0x56}));
  press(Qt::Key_1);
  EXPECT_TRUE(style("voronoi").visible);
  EXPECT_EQ(style("voronoi").color, (Color{0x12, 0x34, 0x56}));
  EXPECT_FALSE(style("delaunay").visible);
}

TEST_F(Newcomer, LooksAroundWhileItComputesAndCancels) {
  ASSERT_TRUE(wait_until_idle());
  run({"show", "scale-medial-axis"});
  ASSERT_TRUE(wait_until_idle());
  const View_2 before = canvas().view();
  run({"set", "sampling-step=0.00001"});
  run({"open-example", "italy.wkt"});
  ASSERT_TRUE(wait_until([&] { return window().computation().is_busy(); }));
  run({"zoom-in"});
  EXPECT_NE(canvas().view(), before);
  press(Qt::Key_Escape);
  ASSERT_TRUE(wait_until([&] { return !window().computation().is_busy(); }));
}

TEST_F(Newcomer, StepsAnEvolutionAndGoesBackAndForth) {
  ASSERT_TRUE(wait_until_idle());
  const std::vector<Point_2> start = points();
  run({"evolve-laplacian-smoothing"});
  for (std::size_t step = 1; step <= 3; ++step) {
    run({"evolution-forward"});
    ASSERT_TRUE(
        wait_until([&] { return document().step_count() == step && !window().evolution().evolver().is_busy(); }));
  }
  const std::vector<Point_2> smooth = points();
  EXPECT_NE(smooth, start);
  press(Qt::Key_Home);
  EXPECT_EQ(points(), start);
  press(Qt::Key_End);
  EXPECT_EQ(points(), smooth);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(points(), start);
}

TEST_F(Newcomer, WritesVectorsThatNameTheirLayers) {
  ASSERT_TRUE(wait_until_idle());
  const QString svg = folder_.filePath("figure.svg");
  const QString pdf = folder_.filePath("figure.pdf");
  run({"export-picture", svg, "800x600"});
  run({"export-picture", pdf, "800x600"});
  ASSERT_TRUE(wait_until_idle());
  const QByteArray text = content(svg);
  EXPECT_TRUE(text.contains("inkscape:groupmode=\"layer\""));
  EXPECT_TRUE(text.contains("inkscape:label=\"Medial axis\""));
  // No decimal commas, whatever the locale.
  EXPECT_FALSE(QRegularExpression("\\d,\\d+\\.|=\"\\d+,\\d+\"").match(QString::fromUtf8(text)).hasMatch());
  EXPECT_TRUE(content(pdf).startsWith("%PDF"));
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QElapsedTimer>
#include <QtTest>

#include "app2d/generators_2.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

Style visible(Style style) {
  style.visible = true;
  return style;
}

class Live : public Window_fixture {
 protected:
  void show_layer(const char* id) {
    Layer_list layers = document().layers();
    Layer_entry* entry = find_entry(layers, id);
    entry->style = visible(entry->style);
    document().edit_layers(layers, "Show");
  }
  const Scene_layer& layer(const char* id) {
    for (const Scene_layer& each : canvas().scene().layers)
      if (each.id == id) return each;
    throw std::out_of_range(id);
  }
  Inputs random_points(std::size_t count) {
    Generator_order_2 order;
    order.count = count;
    order.box.add(Point_2{0, 0});
    order.box.add(Point_2{100, 100});
    return Inputs().with(points_input, generators_2().front().make(order));
  }
};

TEST_F(Live, MovingALimitChangesTheCutAndComputesNothing) {
  show_layer("angle-medial-axis");
  ASSERT_TRUE(wait_until_current("angle-medial-axis"));
  const auto before = window().computation().primitives("angle-medial-axis");
  const auto requests = window().computation().requests();
  ASSERT_TRUE(layer("angle-medial-axis").cut.has_value());
  for (const double limit : {70.0, 80.0, 120.0}) {
    document().edit_settings(document().settings().with("angle-limit", limit), "Angle limit", "drag");
    EXPECT_EQ(layer("angle-medial-axis").cut->minimum, limit);
    EXPECT_EQ(window().computation().status("angle-medial-axis").state, Layer_status::State::current);
  }
  document().edit_settings(document().settings().with("topology-preserving", false), "Preserve topology");
  QTest::qWait(100);
  EXPECT_EQ(window().computation().requests(), requests);
  EXPECT_EQ(window().computation().primitives("angle-medial-axis"), before);
  EXPECT_EQ(layer("angle-medial-axis").cut->value, "angle");
}

TEST_F(Live, OtherSettingsComputeAnew) {
  ASSERT_TRUE(wait_until_current("medial-axis"));
  const auto requests = window().computation().requests();
  document().edit_settings(document().settings().with("sampling-step", 0.2), "Sampling step");
  EXPECT_GT(window().computation().requests(), requests);
}

TEST_F(Live, AnEditUpdatesWhatIsVisibleAndNothingElse) {
  ASSERT_TRUE(wait_until_current("medial-axis"));
  const auto before = window().computation().primitives("medial-axis");
  EXPECT_EQ(window().computation().primitives("delaunay"), nullptr);
  window().editor().add_point({0, 0});
  EXPECT_EQ(window().computation().status("medial-axis").state, Layer_status::State::stale);
  // The old picture stays meanwhile.
  EXPECT_EQ(layer("medial-axis").primitives, before);
  ASSERT_TRUE(wait_until_current("medial-axis"));
  EXPECT_NE(window().computation().primitives("medial-axis"), before);
  EXPECT_EQ(layer("points").primitives->points.size(), 121u);
  EXPECT_EQ(window().computation().status("delaunay").state, Layer_status::State::not_computed);
  show_layer("delaunay");
  EXPECT_TRUE(wait_until_current("delaunay"));
}

TEST_F(Live, AFailedLayerSaysWhy) {
  document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {1, 0}}), "Two");
  ASSERT_TRUE(
      wait_until([&] { return window().computation().status("medial-axis").state == Layer_status::State::failed; }));
  EXPECT_FALSE(window().computation().status("medial-axis").reason.isEmpty());
  EXPECT_FALSE(window().messages().isVisible());
}

TEST_F(Live, TheCanvasTellsOfFailedLayersThatAreVisible) {
  Layer_notes& notes = window().layer_notes();
  ASSERT_TRUE(wait_until_current("medial-axis"));
  // The outline is visible and absent, which is nothing to tell.
  ASSERT_FALSE(window().computation().status("outline").reason.isEmpty());
  EXPECT_FALSE(notes.isVisible());
  document().edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{0, 0}, {1, 0}}), "Two");
  ASSERT_TRUE(wait_until([&] { return notes.isVisible(); }));
  ASSERT_EQ(notes.lines().size(), 1);
  EXPECT_TRUE(notes.lines().front().startsWith("Medial axis: needs")) << notes.lines().front().toStdString();
  EXPECT_LE(notes.geometry().bottom(), canvas().height());

  window().layer_panel().select({"points"});
  QTest::mouseClick(&notes, Qt::LeftButton, {}, QPoint(notes.fontMetrics().height(), notes.fontMetrics().height() / 2));
  EXPECT_EQ(window().layer_panel().selected(), QStringList("medial-axis"));

  trigger("show-all-layers");
  // While layers are still being computed, there may be three that have failed so far.
  ASSERT_TRUE(wait_until([&] { return notes.lines().size() == 3 && notes.lines().back().startsWith("and "); }));
  trigger("new");
  EXPECT_FALSE(notes.isVisible());
}

TEST_F(Live, CancelKeepsTheOldPictures) {
  // Painting very many points would take longer than what is to be cancelled.
  Layer_list layers = document().layers();
  for (Layer_entry& entry : layers) entry.style.visible = entry.id == "medial-axis";
  document().edit_layers(layers, "Medial axis only");
  ASSERT_TRUE(wait_until_current("medial-axis"));
  const auto before = window().computation().primitives("medial-axis");
  document().edit_inputs(random_points(300000), "Many");
  EXPECT_TRUE(window().computation().is_busy());
  QTest::qWait(50);
  window().computation().cancel();
  EXPECT_FALSE(window().computation().is_busy());
  QTest::qWait(300);
  EXPECT_EQ(window().computation().primitives("medial-axis"), before);
  EXPECT_EQ(window().computation().status("medial-axis").state, Layer_status::State::stale);
  // The next edit computes again.
  trigger("undo");
  EXPECT_TRUE(wait_until_current("medial-axis"));
}

TEST_F(Live, ClosesWhileItComputes) {
  show_layer("scale-medial-axis");
  document().edit_inputs(random_points(300000), "Many");
  QTest::qWait(300);
  ASSERT_TRUE(window().computation().is_busy());
  QElapsedTimer timer;
  timer.start();
  EXPECT_TRUE(window().close());
  window_.reset();
  EXPECT_LT(timer.elapsed(), 1000);
}

TEST_F(Live, DragsTenThousandPointsLive) {
  document().edit_inputs(random_points(10000), "Many");
  canvas().fit(bounding_box(document().inputs()));
  ASSERT_TRUE(wait_until_current("points"));
  window().editor().select_all();
  window().editor().begin_drag();
  QElapsedTimer timer;
  timer.start();
  constexpr int steps = 30;
  for (int i = 1; i <= steps; ++i) window().editor().drag_by(0.01 * i, 0);
  // What the window itself does for one step of the mouse.
  EXPECT_LT(timer.elapsed() / double(steps), 30);
  EXPECT_EQ(document().history().count(), 2);
}

TEST_F(Live, ShowsWhatTheMouseRestsOn) {
  ASSERT_TRUE(wait_until_current("points"));
  const QPoint at = pixel(points()[10]);
  auto* facts = canvas().findChild<QWidget*>("facts");
  ASSERT_NE(facts, nullptr);
  EXPECT_FALSE(facts->isVisible());
  QTest::mouseMove(&canvas(), at + QPoint(1, 0));
  QMouseEvent move(QEvent::MouseMove, at, canvas().mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
  QApplication::sendEvent(&canvas(), &move);
  ASSERT_TRUE(wait_until([&] { return facts->isVisible(); }));
  trigger("copy-facts");
  EXPECT_TRUE(QApplication::clipboard()->text().contains("id: 10"));
  window().editor().add_point({0, 0});
  EXPECT_TRUE(wait_until([&] { return !facts->isVisible(); }));
}

TEST_F(Live, AnEmptyPlaneShowsNoOldPictures) {
  ASSERT_TRUE(wait_until_current("medial-axis"));
  trigger("new");
  for (const Scene_layer& each : canvas().scene().layers) EXPECT_EQ(each.primitives, nullptr) << each.id;
  trigger("undo");
  EXPECT_EQ(points().size(), 120u);
}

TEST_F(Live, ColoursStayVisibleOnADarkCanvas) {
  trigger("background-dark");
  const Color points_color = layer("points").style.color;
  EXPECT_GT(int(points_color.red) + points_color.green + points_color.blue, 380);
  trigger("background-paper");
  EXPECT_EQ(layer("points").style.color, find_entry(document().layers(), "points")->style.color);
}

TEST_F(Live, PanelEditsOfLooksAreUndone) {
  const Layer_list before = document().layers();
  trigger("show-all-layers");
  EXPECT_NE(document().layers(), before);
  trigger("undo");
  EXPECT_EQ(document().layers(), before);
}

}  // namespace
}  // namespace mesecina

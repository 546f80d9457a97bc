// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QWheelEvent>
#include <QtTest>

#include "window_fixture.h"

namespace mesecina {
namespace {

/// An empty plane in which a pixel is a tenth of a unit.
class Disks : public Window_fixture {
 protected:
  void SetUp() override {
    open_window();
    trigger("new");
    document().history().clear();
    canvas().set_view({{0, 0}, 10});
  }
  std::vector<Disk_2> disks() const {
    const auto found = window_->document().inputs().get(disks_input);
    return found ? *found : std::vector<Disk_2>();
  }
  void give(std::vector<Disk_2> given, std::vector<Point_2> points = {}) {
    Inputs inputs = Inputs().with(disks_input, std::move(given));
    if (!points.empty()) inputs = inputs.with(points_input, std::move(points));
    document().edit_inputs(inputs, "Given");
    document().history().clear();
  }
  void move(const QPoint& to, Qt::MouseButtons buttons = Qt::NoButton, Qt::KeyboardModifiers modifiers = {}) {
    QMouseEvent event(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, buttons, modifiers);
    QApplication::sendEvent(&canvas(), &event);
  }
  void turn_wheel(const Point_2& over, int eighths, Qt::KeyboardModifiers modifiers = {}) {
    const QPointF at = pixel(over);
    QWheelEvent event(at, canvas().mapToGlobal(at), {}, {0, eighths}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&canvas(), &event);
  }
  const QLabel& readout() { return *canvas().findChild<QLabel*>("readout"); }
  void expect_undo_and_redo(const std::vector<Disk_2>& before, const std::vector<Disk_2>& after, int steps = 1) {
    EXPECT_EQ(disks(), after);
    EXPECT_EQ(document().history().count(), steps);
    trigger("undo");
    EXPECT_EQ(disks(), before);
    trigger("redo");
    EXPECT_EQ(disks(), after);
  }
};

TEST_F(Disks, ADragFromTheCenterDrawsADiskAndSaysItsRadius) {
  press(Qt::Key_D);
  EXPECT_TRUE(window().actions()["tool-disk"]->isChecked());
  const QPoint center = pixel({-10, 5});
  QTest::mousePress(&canvas(), Qt::LeftButton, {}, center);
  move(center + QPoint(30, 40), Qt::LeftButton);
  EXPECT_TRUE(disks().empty());
  ASSERT_TRUE(readout().isVisible());
  EXPECT_EQ(readout().text(), "radius 5");
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, center + QPoint(30, 40));
  EXPECT_FALSE(readout().isVisible());
  ASSERT_EQ(disks().size(), 1u);
  EXPECT_LT(distance(disks()[0].center, {-10, 5}), 0.1);
  EXPECT_NEAR(disks()[0].radius, 5, 1e-9);
  EXPECT_EQ(document().history().undoText(), "Draw a disk");
  EXPECT_EQ(window().editor().selection(), (Selection_2{{}, {}, {0}}));
  expect_undo_and_redo({}, disks());
  EXPECT_TRUE(wait_until_current("disks"));
  EXPECT_EQ(window().computation().primitives("disks")->balls.size(), 1u);
}

TEST_F(Disks, AClickDrawsTheLastRadiusAgain) {
  trigger("tool-disk");
  click(pixel({0, 0}));
  ASSERT_EQ(disks().size(), 1u);
  const double share = disks()[0].radius * canvas().view().scale / canvas().height();
  EXPECT_GT(share, 0.02);
  EXPECT_LT(share, 0.2);
  drag(pixel({5, 5}), pixel({5, 5}) + QPoint(0, 70));
  click(pixel({-8, 0}));
  ASSERT_EQ(disks().size(), 3u);
  EXPECT_NEAR(disks()[1].radius, 7, 1e-9);
  EXPECT_EQ(disks()[2].radius, disks()[1].radius);
  EXPECT_EQ(document().history().count(), 3);
}

TEST_F(Disks, EscapeDropsWhatIsHalfDrawn) {
  trigger("tool-disk");
  const QPoint center = pixel({0, 0});
  QTest::mousePress(&canvas(), Qt::LeftButton, {}, center);
  move(center + QPoint(50, 0), Qt::LeftButton);
  press(Qt::Key_Escape);
  EXPECT_FALSE(readout().isVisible());
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, center + QPoint(50, 0));
  EXPECT_TRUE(disks().empty());
  EXPECT_EQ(document().history().count(), 0);
}

TEST_F(Disks, ADragWithControlSpraysInOneStep) {
  trigger("tool-disk");
  drag(pixel({-20, 0}), pixel({-20, 0}) + QPoint(20, 0));
  drag(pixel({0, 0}), pixel({0, 0}) + QPoint(100, 0), Qt::ControlModifier);
  // 12 pixels apart unless set otherwise: at 0, 12, ... 96.
  ASSERT_EQ(disks().size(), 1u + 9);
  for (std::size_t i = 1; i < disks().size(); ++i) EXPECT_EQ(disks()[i].radius, disks()[0].radius);
  EXPECT_NEAR(distance(disks()[4].center, disks()[5].center), 1.2, 0.01);
  EXPECT_EQ(document().history().undoText(), "Spray disks");
  expect_undo_and_redo({disks()[0]}, disks(), 2);
}

TEST_F(Disks, AreGrabbedByCenterAndBoundaryAndMovedWithPoints) {
  const std::vector<Disk_2> start = {{{0, 0}, 8}, {{20, 0}, 3}};
  give(start, {{-12, -9}});
  // Inside, but at neither of them.
  click(pixel({3, 2}));
  EXPECT_TRUE(window().editor().selection().is_empty());
  click(pixel({0, 8}));
  EXPECT_EQ(window().editor().selection(), (Selection_2{{}, {}, {0}}));
  click(pixel({20, 0}));
  EXPECT_EQ(window().editor().selection(), (Selection_2{{}, {}, {1}}));
  click(pixel({-12, -9}), Qt::ShiftModifier);
  click(pixel({0, 0}), Qt::ShiftModifier);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{0}, {}, {0, 1}}));
  EXPECT_EQ(document().history().count(), 0);

  drag(pixel({0, 0}), pixel({0, 0}) + QPoint(40, -30));
  ASSERT_EQ(points().size(), 1u);
  EXPECT_LT(distance(points()[0], {-8, -6}), 1e-6);
  EXPECT_LT(distance(disks()[1].center, {24, 3}), 1e-6);
  EXPECT_EQ(disks()[1].radius, 3);
  EXPECT_EQ(document().history().undoText(), "Move 1 point and 2 disks");
  expect_undo_and_redo(start, disks());
}

TEST_F(Disks, ABoxSelectsByCenters) {
  give({{{0, 0}, 8}, {{20, 0}, 3}, {{25, 1}, 1}}, {{21, 1}});
  drag(pixel({15, -5}), pixel({30, 5}));
  EXPECT_EQ(window().editor().selection(), (Selection_2{{0}, {}, {1, 2}}));
}

TEST_F(Disks, AHandleResizes) {
  const std::vector<Disk_2> start = {{{0, 0}, 8}, {{20, 0}, 2}};
  give(start);
  window().editor().select({{}, {}, {0, 1}});
  const QPoint handle = pixel({0, 8});
  move(handle);
  EXPECT_EQ(canvas().cursor().shape(), Qt::SizeVerCursor);
  // Not quite in the middle of the handle: nothing jumps.
  drag(handle + QPoint(2, 0), handle + QPoint(2, -40));
  EXPECT_NEAR(disks()[0].radius, 12, 0.02);
  EXPECT_EQ(disks()[0].center, start[0].center);
  EXPECT_NEAR(disks()[1].radius / disks()[0].radius, 0.25, 1e-12);
  EXPECT_EQ(document().history().undoText(), "Resize 2 disks");
  expect_undo_and_redo(start, disks());
  // Another drag is another step.
  drag(pixel({0, 12}), pixel({0, 10}));
  EXPECT_EQ(document().history().count(), 2);

  trigger("undo");
  trigger("undo");
  QTest::mousePress(&canvas(), Qt::LeftButton, {}, handle);
  move(handle + QPoint(0, 30), Qt::LeftButton);
  EXPECT_EQ(readout().text(), "radius 5");
  EXPECT_TRUE(readout().isVisible());
  press(Qt::Key_Escape);
  EXPECT_FALSE(readout().isVisible());
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, handle + QPoint(0, 30));
  EXPECT_EQ(disks(), start);
}

TEST_F(Disks, AHandleNeverMakesARadiusNegative) {
  give({{{0, 0}, 4}});
  window().editor().select({{}, {}, {0}});
  drag(pixel({4, 0}), pixel({0, 0}));
  ASSERT_EQ(disks().size(), 1u);
  EXPECT_NEAR(disks()[0].radius, 0.05, 1e-12);
}

TEST_F(Disks, HandlesOfSmallDisksLieOutsideAndGrowADiskFromNothing) {
  give({{{0, 0}, 0}});
  window().editor().select({{}, {}, {0}});
  ASSERT_EQ(window().editor().handles().size(), 4u);
  for (const Disk_handle_2& handle : window().editor().handles())
    EXPECT_GT(distance(handle.position, {0, 0}) * canvas().view().scale, 16);
  give({{{0, 0}, 0}, {{5, 0}, 4}});
  window().editor().select({{}, {}, {0, 1}});
  EXPECT_EQ(window().editor().handles().size(), 4u);
  give({{{0, 0}, 0}});
  window().editor().select({{}, {}, {0}});
  const QPoint handle = pixel(window().editor().handles()[0].position);
  drag(handle, handle + QPoint(50, 0));
  EXPECT_NEAR(disks()[0].radius, 5, 1e-9);
  trigger("tool-disk");
  click(handle + QPoint(100, 0));
  EXPECT_EQ(disks().back().radius, disks()[0].radius);
}

TEST_F(Disks, TheWheelResizesTheSelectionAndZoomsElsewhere) {
  const std::vector<Disk_2> start = {{{0, 0}, 8}, {{20, 0}, 2}, {{-20, 0}, 2}};
  give(start);
  const View_2 view = canvas().view();
  turn_wheel({1, 1}, 120);
  EXPECT_NE(canvas().view(), view);
  canvas().set_view(view);

  window().editor().select({{}, {}, {0, 1}});
  for (int i = 0; i < 3; ++i) turn_wheel({3, 3}, 120);
  EXPECT_EQ(canvas().view(), view);
  EXPECT_GT(disks()[0].radius, 8.8);
  EXPECT_NEAR(disks()[1].radius / disks()[0].radius, 0.25, 1e-12);
  EXPECT_EQ(disks()[2], start[2]);
  EXPECT_EQ(document().history().undoText(), "Resize 2 disks");
  expect_undo_and_redo(start, disks());

  // Over nothing that is selected, and with Ctrl, it zooms.
  const auto resized_disks = disks();
  turn_wheel({-20, 0}, 120);
  EXPECT_NE(canvas().view(), view);
  canvas().set_view(view);
  turn_wheel({0, 0}, 120, Qt::ControlModifier);
  EXPECT_NE(canvas().view(), view);
  EXPECT_EQ(disks(), resized_disks);
}

TEST_F(Disks, TurningTheWheelBackIsNoStepAndShiftIsFiner) {
  give({{{0, 0}, 1.0 / 3}});
  const auto start = disks();
  window().editor().select({{}, {}, {0}});
  for (const int eighths : {120, 120, 15, -120, -120, -15}) turn_wheel({0, 0}, eighths);
  EXPECT_EQ(disks(), start);
  EXPECT_EQ(document().history().count(), 0);
  turn_wheel({0, 0}, 120);
  const double coarse = disks()[0].radius / start[0].radius - 1;
  EXPECT_NEAR(coarse, 0.06, 0.01);
  EXPECT_TRUE(readout().isVisible());
  trigger("undo");
  turn_wheel({0, 0}, 120, Qt::ShiftModifier);
  EXPECT_NEAR((disks()[0].radius / start[0].radius - 1) * 10, coarse, 0.01);
  // Something else in between: another step.
  press(Qt::Key_Right);
  turn_wheel(disks()[0].center, 120);
  EXPECT_EQ(document().history().count(), 3);
}

TEST_F(Disks, DeleteCopyPasteDuplicateAndNudge) {
  const std::vector<Disk_2> start = {{{0.1, 1.0 / 3}, 2.0 / 3}, {{20, 0}, 2}, {{-20, 0}, 2}};
  give(start, {{1, 2}});
  window().editor().select({{}, {}, {0, 2}});
  press(Qt::Key_Delete);
  expect_undo_and_redo(start, {start[1]});
  trigger("undo");

  window().editor().select({{}, {}, {0}});
  trigger("copy");
  EXPECT_EQ(QApplication::clipboard()->text(), "0.1 0.3333333333333333 0.6666666666666666\n");
  trigger("paste");
  EXPECT_EQ(document().history().undoText(), "Paste 1 disk");
  EXPECT_EQ(window().editor().selection(), (Selection_2{{}, {}, {3}}));
  expect_undo_and_redo(start, {start[0], start[1], start[2], start[0]});
  trigger("undo");

  window().editor().select({{0}, {}, {0, 1}});
  trigger("copy");
  trigger("paste");
  EXPECT_EQ(document().history().undoText(), "Paste 1 point and 2 disks");
  EXPECT_EQ(window().editor().selection(), (Selection_2{{1}, {}, {3, 4}}));
  EXPECT_EQ(points(), (std::vector<Point_2>{{1, 2}, {1, 2}}));
  expect_undo_and_redo(start, {start[0], start[1], start[2], start[0], start[1]});
  trigger("undo");

  window().editor().select({{}, {}, {1}});
  trigger("duplicate");
  ASSERT_EQ(disks().size(), 4u);
  EXPECT_EQ(disks()[3].radius, 2);
  EXPECT_NE(disks()[3].center, start[1].center);
  expect_undo_and_redo(start, disks());
  trigger("undo");

  window().editor().select({{}, {}, {1}});
  for (int i = 0; i < 3; ++i) press(Qt::Key_Left);
  EXPECT_NEAR(disks()[1].center.x, 19.7, 1e-9);
  expect_undo_and_redo(start, disks());
}

TEST_F(Disks, ABadLineOfAPasteIsNamedByItsNumber) {
  give({{{0, 0}, 1}});
  QApplication::clipboard()->setText("x y\n1 2\nx y radius\n1 2 3\n4 5 -6\n");
  trigger("paste");
  EXPECT_EQ(disks().size(), 1u);
  EXPECT_TRUE(points().empty());
  ASSERT_TRUE(window().messages().isVisible());
  EXPECT_TRUE(window().messages().lines().join("").contains("clipboard.txt:5"))
      << window().messages().lines().join("").toStdString();
}

TEST_F(Disks, TheTableShowsAndEditsExactNumbers) {
  const std::vector<Disk_2> start = {{{0, 0}, 1}, {{20, 0}, 2.0 / 3}};
  give(start);
  Input_table_2& table = window().disks_table();
  for (QWidget* widget = &table; widget; widget = widget->parentWidget()) widget->show();
  table.parentWidget()->raise();
  ASSERT_TRUE(wait_until([&] { return table.isVisible(); }));
  ASSERT_EQ(table.model()->rowCount(), 2);
  ASSERT_EQ(table.model()->columnCount(), 3);
  EXPECT_EQ(table.model()->index(1, 2).data().toString(), "0.6666666666666666");
  EXPECT_EQ(table.model()->headerData(2, Qt::Horizontal).toString(), "radius");

  EXPECT_TRUE(table.model()->setData(table.model()->index(1, 2), "0.1"));
  EXPECT_EQ(document().history().undoText(), "Set numbers of disk 1");
  expect_undo_and_redo(start, {start[0], {{20, 0}, 0.1}});
  EXPECT_TRUE(table.model()->setData(table.model()->index(0, 1), "-7"));
  EXPECT_EQ(disks()[0], (Disk_2{{0, -7}, 1}));
  for (const char* bad : {"-1", "1,5", "inf", ""})
    EXPECT_FALSE(table.model()->setData(table.model()->index(1, 2), bad)) << bad;
  EXPECT_EQ(window().messages().lines().size(), 4);
  EXPECT_EQ(disks()[1].radius, 0.1);

  table.selectRow(1);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{}, {}, {1}}));
  window().editor().select({{}, {}, {0, 1}});
  EXPECT_EQ(table.selectionModel()->selectedRows().size(), 2);
  trigger("delete");
  EXPECT_EQ(table.model()->rowCount(), 0);
}

TEST_F(Disks, ExactCenterAndRadiusAreTyped) {
  give({{{0, 0}, 1}}, {{5, 5}});
  window().editor().select({{0}, {}, {}});
  trigger("coordinates");
  ASSERT_NE(window().popover(), nullptr);
  const auto lines = window().popover()->findChildren<QLineEdit*>();
  ASSERT_EQ(lines.size(), 3);
  EXPECT_FALSE(lines[2]->isVisible());
  window().editor().select({{}, {}, {0}});
  EXPECT_TRUE(lines[2]->isVisible());
  EXPECT_EQ(lines[2]->text(), "1");
  lines[2]->selectAll();
  QTest::keyClicks(lines[2], "12.345678901234567");
  QTest::keyClick(lines[2], Qt::Key_Return);
  EXPECT_EQ(disks()[0], (Disk_2{{0, 0}, 12.345678901234567}));
  lines[2]->selectAll();
  QTest::keyClicks(lines[2], "-1");
  QTest::keyClick(lines[2], Qt::Key_Return);
  EXPECT_EQ(disks()[0].radius, 12.345678901234567);
  EXPECT_TRUE(window().messages().isVisible());
  expect_undo_and_redo({{{0, 0}, 1}}, disks());
}

TEST_F(Disks, HiddenOnesCannotBeGrabbed) {
  give({{{0, 0}, 4}});
  window().editor().select({{}, {}, {0}});
  Layer_list layers = document().layers();
  find_entry(layers, "disks")->style.visible = false;
  document().edit_layers(layers, "Hide");
  const auto start = disks();
  EXPECT_TRUE(window().editor().handles().empty());
  drag(pixel({0, 0}), pixel({3, 3}));
  EXPECT_EQ(disks(), start);
  trigger("select-all");
  EXPECT_TRUE(window().editor().selection().is_empty());
}

TEST_F(Disks, GeneratorsMakeThemInOneStep) {
  trigger("insert-random-disks");
  ASSERT_NE(window().popover(), nullptr);
  EXPECT_EQ(disks().size(), 100u);
  EXPECT_TRUE(points().empty());
  EXPECT_EQ(document().history().count(), 1);
  press(Qt::Key_Escape);
  trigger("insert-ring-of-disks");
  EXPECT_EQ(disks().size(), 112u);
  trigger("undo");
  EXPECT_EQ(disks().size(), 100u);
  trigger("undo");
  EXPECT_TRUE(disks().empty());
}

TEST_F(Disks, DraggingOneOfTenThousandIsCheap) {
  std::vector<Disk_2> many;
  for (int i = 0; i < 10000; ++i) many.push_back({{double(i % 100), double(i / 100)}, 0.3});
  give(many);
  canvas().fit(bounding_box(document().inputs()));
  ASSERT_TRUE(wait_until_current("disks"));
  QElapsedTimer timer;
  const QPoint start = pixel({50, 50});
  QTest::mousePress(&canvas(), Qt::LeftButton, {}, start);
  timer.start();
  constexpr int steps = 50;
  for (int i = 1; i <= steps; ++i) move(start + QPoint(i, 0), Qt::LeftButton);
  // What the window itself does for one step of the mouse.
  EXPECT_LT(timer.elapsed() / double(steps), 10);
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, start + QPoint(steps, 0));
  EXPECT_EQ(document().history().count(), 1);
  EXPECT_NE(disks()[5050], many[5050]);
  trigger("undo");
  EXPECT_EQ(disks(), many);
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QLineEdit>
#include <QSpinBox>
#include <QtTest>

#include "window_fixture.h"

namespace mesecina {
namespace {

TEST_F(Window_fixture, ActionsAreNamedExplainedAndShareNoKey) {
  EXPECT_EQ(window().actions().faults(), QStringList());
  EXPECT_GT(window().actions().entries().size(), 50u);
}

TEST_F(Window_fixture, NoMenuTakesTheKeyOfAnAction) {
  const Layer_list before = document().layers();
  press(Qt::Key_H, Qt::AltModifier);
  EXPECT_NE(document().layers(), before);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_F(Window_fixture, FaultsOfActionsAreFound) {
  Actions actions(QStringLiteral("mesecina-test"), &window());
  actions.add("Edit", {"one", "One", "Tip", {QKeySequence("Ctrl+1")}}, [] {});
  actions.add("Edit", {"two", "Two", "", {QKeySequence("Ctrl+1")}}, [] {});
  EXPECT_EQ(actions.faults().size(), 2);
  EXPECT_THROW(actions.add("Edit", {"one", "One", "Tip"}, [] {}), std::logic_error);
}

TEST_F(Window_fixture, StartsWithALiveExample) {
  EXPECT_EQ(points().size(), 120u);
  EXPECT_TRUE(wait_until_current("medial-axis"));
  EXPECT_GT(window().computation().status("medial-axis").count, 50u);
  EXPECT_FALSE(document().is_modified());
  EXPECT_TRUE(window().windowTitle().startsWith("Example[*]"));
}

TEST_F(Window_fixture, EverythingDoneWithTheMouseCanBeUndone) {
  const auto start = points();
  const QPoint empty = pixel({0, 0});
  QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, empty);
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, empty);
  ASSERT_EQ(points().size(), 121u);
  EXPECT_LT(distance(points().back(), {0, 0}) * canvas().view().scale, 2);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{120}, {}}));

  drag(empty, empty + QPoint(40, -30));
  EXPECT_NEAR(points().back().x * canvas().view().scale, 40, 2);
  EXPECT_NEAR(points().back().y * canvas().view().scale, 30, 2);

  press(Qt::Key_Delete);
  EXPECT_EQ(points(), start);
  EXPECT_EQ(document().history().count(), 3);

  trigger("undo");
  EXPECT_EQ(points().size(), 121u);
  trigger("undo");
  trigger("undo");
  EXPECT_EQ(points(), start);
  EXPECT_FALSE(document().is_modified());
  EXPECT_FALSE(window().actions()["undo"]->isEnabled());
  trigger("redo");
  EXPECT_EQ(points().size(), 121u);
}

TEST_F(Window_fixture, ADragIsOneStepAndBackToTheStartNone) {
  const QPoint at = pixel(points()[10]);
  drag(at, at + QPoint(30, 0));
  EXPECT_EQ(document().history().count(), 1);
  EXPECT_EQ(document().history().text(0), "Move 1 point");
  trigger("undo");
  QTest::mousePress(&canvas(), Qt::LeftButton, {}, at);
  for (const QPoint& to : {at + QPoint(20, 10), at}) {
    QMouseEvent move(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(&canvas(), &move);
  }
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, at);
  EXPECT_EQ(document().history().count(), 0);
}

TEST_F(Window_fixture, ShiftKeepsADragToOneAxis) {
  const Point_2 before = points()[10];
  const QPoint at = pixel(before);
  drag(at, at + QPoint(50, 20), Qt::ShiftModifier);
  EXPECT_EQ(points()[10].y, before.y);
  EXPECT_NEAR((points()[10].x - before.x) * canvas().view().scale, 50, 1);
}

TEST_F(Window_fixture, EscapeTakesADragBack) {
  const auto start = points();
  const QPoint at = pixel(start[10]);
  QTest::mousePress(&canvas(), Qt::LeftButton, {}, at);
  const QPoint to = at + QPoint(60, 60);
  QMouseEvent move(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&canvas(), &move);
  ASSERT_NE(points(), start);
  press(Qt::Key_Escape);
  EXPECT_EQ(points(), start);
  QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, to);
  EXPECT_EQ(points(), start);
  EXPECT_EQ(document().history().count(), 0);
}

TEST_F(Window_fixture, BoxesAndModifiersSelect) {
  drag({5, 5}, {canvas().width() - 5, canvas().height() - 5});
  EXPECT_EQ(window().editor().selection().points.size(), 120u);
  const QPoint at = pixel(points()[10]);
  click(at, Qt::ControlModifier);
  EXPECT_EQ(window().editor().selection().points.size(), 119u);
  click(at);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{10}, {}}));
  click(pixel(points()[60]), Qt::ShiftModifier);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{10, 60}, {}}));
  click(pixel({0, 0}));
  EXPECT_TRUE(window().editor().selection().is_empty());
  trigger("select-all");
  EXPECT_EQ(window().editor().selection().size(), 120u);
  press(Qt::Key_Escape);
  EXPECT_TRUE(window().editor().selection().is_empty());
}

TEST_F(Window_fixture, NudgesMergeAndAreInPixels) {
  window().editor().select({{0, 1}, {}});
  const auto start = points();
  for (int i = 0; i < 3; ++i) press(Qt::Key_Right);
  press(Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_NEAR((points()[1].x - start[1].x) * canvas().view().scale, 3, 1e-6);
  EXPECT_NEAR((points()[1].y - start[1].y) * canvas().view().scale, 10, 1e-6);
  EXPECT_EQ(points()[2], start[2]);
  EXPECT_EQ(document().history().count(), 1);
  trigger("undo");
  EXPECT_EQ(points(), start);
}

TEST_F(Window_fixture, CopyPasteAndDuplicateKeepEveryDigit) {
  window().editor().select({{3, 7}, {}});
  trigger("copy");
  trigger("paste");
  ASSERT_EQ(points().size(), 122u);
  EXPECT_EQ(points()[120], points()[3]);
  EXPECT_EQ(points()[121], points()[7]);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{120, 121}, {}}));
  trigger("cut");
  EXPECT_EQ(points().size(), 120u);
  window().editor().select({{3}, {}});
  trigger("duplicate");
  EXPECT_EQ(points().size(), 121u);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{120}, {}}));
}

TEST_F(Window_fixture, PastesFromASpreadsheetAndRefusesNonsense) {
  QApplication::clipboard()->setText("x\ty\n1.5\t2\n-3\t4e2\n");
  trigger("paste");
  ASSERT_EQ(points().size(), 122u);
  EXPECT_EQ(points()[121], (Point_2{-3, 400}));
  EXPECT_FALSE(window().messages().isVisible());
  QApplication::clipboard()->setText("1 2\nhello world\n");
  trigger("paste");
  EXPECT_EQ(points().size(), 122u);
  ASSERT_TRUE(window().messages().isVisible());
  EXPECT_TRUE(window().messages().lines().join("").contains("clipboard.txt:2"))
      << window().messages().lines().join("").toStdString();
}

TEST_F(Window_fixture, ToolsInsertSprayAndDrawOutlines) {
  trigger("tool-insert");
  click(pixel({0, 0}));
  click(pixel({5, 5}));
  EXPECT_EQ(points().size(), 122u);

  trigger("tool-spray");
  drag(pixel({0, 0}), pixel({0, 0}) + QPoint(100, 0));
  const auto sprayed = points();
  // 12 pixels apart unless set otherwise: at 0, 12, ... 96.
  ASSERT_EQ(sprayed.size(), 122u + 9);
  EXPECT_NEAR(distance(sprayed[123], sprayed[124]) * canvas().view().scale, 12, 0.1);
  trigger("undo");
  EXPECT_EQ(points().size(), 122u);

  trigger("tool-outline");
  for (const Point_2& corner : {Point_2{-20, -20}, Point_2{20, -20}, Point_2{0, 20}}) click(pixel(corner));
  EXPECT_EQ(document().inputs().get(outline_input), nullptr);
  press(Qt::Key_Return);
  ASSERT_NE(document().inputs().get(outline_input), nullptr);
  EXPECT_EQ(document().inputs().get(outline_input)->rings.front().size(), 3u);

  click(pixel({-40, -40}));
  press(Qt::Key_Escape);
  press(Qt::Key_Return);
  EXPECT_EQ(document().inputs().get(outline_input)->rings.size(), 1u);

  trigger("tool-select");
  drag(pixel({0, 20}), pixel({0, 20}) + QPoint(15, 0));
  EXPECT_NEAR(document().inputs().get(outline_input)->rings[0][2].x * canvas().view().scale, 15, 2);
}

TEST_F(Window_fixture, HiddenThingsCannotBeGrabbed) {
  Layer_list layers = document().layers();
  find_entry(layers, "points")->style.visible = false;
  document().edit_layers(layers, "Hide");
  const auto start = points();
  drag(pixel(start[10]), pixel(start[10]) + QPoint(40, 40));
  EXPECT_EQ(points(), start);
  trigger("select-all");
  EXPECT_TRUE(window().editor().selection().is_empty());
}

TEST_F(Window_fixture, TableShowsAndEditsExactCoordinates) {
  Input_table_2& table = window().points_table();
  for (QWidget* widget = &table; widget; widget = widget->parentWidget()) widget->show();
  table.parentWidget()->raise();
  ASSERT_TRUE(wait_until([&] { return table.isVisible(); }));
  ASSERT_EQ(table.model()->rowCount(), 120);
  EXPECT_EQ(table.model()->index(5, 1).data().toString().toDouble(), points()[5].y);

  EXPECT_TRUE(table.model()->setData(table.model()->index(5, 1), "0.1"));
  EXPECT_EQ(points()[5].y, 0.1);
  EXPECT_EQ(document().history().undoText(), "Set coordinates of point 5");
  EXPECT_FALSE(table.model()->setData(table.model()->index(5, 0), "1,5"));
  EXPECT_TRUE(window().messages().isVisible());

  table.selectRow(7);
  EXPECT_EQ(window().editor().selection(), (Selection_2{{7}, {}}));
  window().editor().select({{1, 2, 9}, {}});
  EXPECT_EQ(table.selectionModel()->selectedRows().size(), 3);
  trigger("delete");
  EXPECT_EQ(table.model()->rowCount(), 117);
}

TEST_F(Window_fixture, ExactCoordinatesAreTyped) {
  window().editor().select({{4}, {}});
  trigger("coordinates");
  ASSERT_NE(window().popover(), nullptr);
  auto* x = window().popover()->findChildren<QLineEdit*>().front();
  x->selectAll();
  QTest::keyClicks(x, "12.345678901234567");
  QTest::keyClick(x, Qt::Key_Return);
  EXPECT_EQ(points()[4].x, 12.345678901234567);
  press(Qt::Key_Escape);
  EXPECT_EQ(window().popover(), nullptr);
}

TEST_F(Window_fixture, GeneratorsFollowTheirNumbersInOneStep) {
  trigger("insert-random");
  ASSERT_NE(window().popover(), nullptr);
  EXPECT_EQ(points().size(), 220u);
  auto* count = window().popover()->findChildren<QSpinBox*>().front();
  count->setValue(30);
  EXPECT_EQ(points().size(), 150u);
  EXPECT_EQ(document().history().count(), 1);
  // Something else happens: what was generated stays, and the popover goes.
  trigger("select-all");
  trigger("delete");
  EXPECT_EQ(window().popover(), nullptr);
  EXPECT_TRUE(points().empty());
  trigger("insert-on-outline");
  EXPECT_EQ(window().popover(), nullptr);
  EXPECT_TRUE(window().messages().isVisible());
}

TEST_F(Window_fixture, LettersTypedIntoAFieldAreNoCommands) {
  trigger("find-layer");
  QWidget* field = QApplication::focusWidget();
  ASSERT_NE(qobject_cast<QLineEdit*>(field), nullptr);
  const Layer_list before = document().layers();
  QTest::keyClicks(field, "shf");
  EXPECT_EQ(qobject_cast<QLineEdit*>(field)->text(), "shf");
  EXPECT_EQ(document().layers(), before);
}

TEST_F(Window_fixture, EscapeLeavesAFieldOfAPanelAndThenDeselects) {
  trigger("select-all");
  auto* field = window().settings_panel().findChild<QAbstractSpinBox*>();
  ASSERT_NE(field, nullptr);
  field->setFocus();
  ASSERT_TRUE(field->hasFocus());
  QTest::keyClick(field, Qt::Key_Escape);
  EXPECT_TRUE(canvas().hasFocus());
  EXPECT_FALSE(window().editor().selection().is_empty());
  press(Qt::Key_Escape);
  EXPECT_TRUE(window().editor().selection().is_empty());
  // Keys act on the canvas again.
  press(Qt::Key_2);
  EXPECT_TRUE(find_entry(document().layers(), "delaunay")->style.visible);
}

TEST_F(Window_fixture, ClosingThePanelOfFilmsShowsTheSettings) {
  auto* settings = window().findChild<QDockWidget*>("settings-dock");
  auto* films = window().findChild<QDockWidget*>("record-dock");
  ASSERT_TRUE(settings && films);
  trigger("record");
  ASSERT_TRUE(wait_until([&] { return !films->visibleRegion().isEmpty() && settings->visibleRegion().isEmpty(); }));
  films->close();
  EXPECT_TRUE(wait_until([&] { return !settings->visibleRegion().isEmpty(); }));
}

}  // namespace
}  // namespace mesecina

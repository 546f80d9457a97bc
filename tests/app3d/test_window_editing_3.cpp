// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStatusBar>
#include <algorithm>
#include <array>

#include "app3d/sight_3.h"
#include "layers/number_field.h"
#include "tests/app3d/window_fixture_3.h"

namespace mesecina {
namespace {

class Window_editing_3 : public Window_3 {
 protected:
  void SetUp() override { open_balls(); }

  /// Two balls beside each other, seen from the front without perspective.
  void open_balls() {
    open({{write("two.woff", "WOFF 2 0 0\n-1 0 0 0.5\n1 0 0 0.75\n")}, {"given-balls"}, {}});
    ASSERT_TRUE(wait_until_drawn());
    View_3 view;
    view.camera = fit_camera(bounding_box(inputs()), viewer().width(), viewer().height(), {0, 0, 1}, {0, 1, 0},
                             Camera_3::Projection::orthographic);
    viewer().set_view(view);
    viewer().grab_picture();
    use("tool-select");
  }

  Editor_3& editor() { return window_->editor(); }
  const Inputs& inputs() { return window_->document().inputs(); }
  QUndoStack& history() { return window_->document().history(); }
  std::vector<Ball_3> balls() {
    const auto all = inputs().get(balls_input);
    return all ? *all : std::vector<Ball_3>();
  }
  void use(const char* action) { window_->actions()[QLatin1String(action)]->trigger(); }

  /// The viewer shows the balls as they are.
  bool wait_until_drawn() {
    const bool is_drawn = wait_until_idle() && wait_until([&] {
                            const auto set = window_->computation().primitives("given-balls");
                            if (!set || set->balls.size() != balls().size()) return false;
                            for (std::size_t i = 0; i < set->balls.size(); ++i)
                              if (set->vertices[i] != balls()[i].center || set->balls[i].radius != balls()[i].radius)
                                return false;
                            return true;
                          });
    viewer().grab_picture();
    return is_drawn;
  }
  Sight_3 sight() { return {viewer().view().camera, double(viewer().width()), double(viewer().height())}; }
  QPoint pixel(const Point_3& place) {
    const auto seen = sight().pixel(place);
    return seen ? QPoint(qRound(seen->x), qRound(seen->y)) : QPoint();
  }
  double unit() { return sight().pixel_size({0, 0, 0}); }

  void move(const QPoint& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {}) {
    QMouseEvent event(QEvent::MouseMove, QPointF(to), viewer().mapToGlobal(QPointF(to)), Qt::NoButton, buttons,
                      modifiers);
    QApplication::sendEvent(&viewer(), &event);
  }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
    Window_3::drag(Qt::LeftButton, from, to, modifiers);
  }
  void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {}) {
    // So that two clicks are never a double click.
    QTest::qWait(QApplication::doubleClickInterval() + 20);
    QTest::mouseClick(&viewer(), Qt::LeftButton, modifiers, at);
  }
};

TEST_F(Window_editing_3, APlaceOfTheLogIsLookedAtAndWhatIsThereSelected) {
  const std::vector<Place> places{{{1, 0, 0}, "balls", 1}, {{1, 0, 0}, "balls", 7}};
  Q_EMIT window_->log().places_chosen(places);
  EXPECT_EQ(editor().selection().balls, std::vector<std::size_t>{1});
  EXPECT_NEAR(distance(viewer().view().camera.target, {1, 0, 0}), 0, 1e-6);
  Q_EMIT window_->log().places_chosen({{{-1, 0, 0}}});
  EXPECT_NEAR(distance(viewer().view().camera.target, {-1, 0, 0}), 0, 1e-6);
  EXPECT_EQ(editor().selection().balls, std::vector<std::size_t>{1});
}

TEST_F(Window_editing_3, ClicksSelectAndShiftAddsAndNothingDeselects) {
  click(pixel({-1, 0, 0}));
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {0}}));
  click(pixel({1, 0, 0}), Qt::ShiftModifier);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {0, 1}}));
  click(pixel({-1, 0, 0}), Qt::ControlModifier);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {1}}));
  use("invert-selection");
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {0}}));
  click({5, 5});
  EXPECT_TRUE(editor().selection().is_empty());
  use("select-all");
  EXPECT_EQ(editor().selection().size(), 2U);
  use("select-none");
  EXPECT_TRUE(editor().selection().is_empty());
  EXPECT_EQ(history().count(), 0);
}

TEST_F(Window_editing_3, RectanglesSelectCentersAndPlainDragsTurn) {
  const View_3 before = viewer().view();
  drag({4, 4}, {viewer().width() / 2, viewer().height() - 4}, Qt::ShiftModifier);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {0}}));
  EXPECT_EQ(viewer().view(), before);
  drag({4, 4}, {viewer().width() - 4, viewer().height() - 4}, Qt::ControlModifier);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {1}}));
  drag({4, 4}, {64, 4});
  EXPECT_GT(distance(viewer().view().camera.position, before.camera.position), 0.1);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {1}}));
}

TEST_F(Window_editing_3, LeftDragsDoWhatTheHintSaysWithTheHabitsOfEveryProgram) {
  const QPoint middle{viewer().width() / 2, viewer().height() - 4};
  const auto hint_there = [&] {
    hover(QPointF(4, 4));
    const auto labels = window_->statusBar()->findChildren<QLabel*>();
    return std::ranges::any_of(labels, [](const QLabel* label) { return label->text().startsWith("Drag draws"); });
  };
  for (const char* preset : {"mouse-blender", "mouse-cad"}) {
    use(preset);
    use("tool-select");
    EXPECT_TRUE(hint_there()) << preset;
    const View_3 before = viewer().view();
    editor().select({{}, {1}});
    drag({4, 4}, middle);
    EXPECT_EQ(editor().selection(), (Selection_3{{}, {0}})) << preset;
    drag({viewer().width() - 4, 4}, middle, Qt::ShiftModifier);
    EXPECT_EQ(editor().selection(), (Selection_3{{}, {0, 1}})) << preset;
    EXPECT_EQ(viewer().view(), before) << preset;
    click({5, 5});
    EXPECT_TRUE(editor().selection().is_empty()) << preset;
    // Tools that add nothing by a drag leave it to the camera.
    for (const char* tool : {"tool-turn", "tool-balls"}) {
      use(tool);
      const View_3 seen = viewer().view();
      drag({4, 4}, {64, 4});
      EXPECT_GT(distance(viewer().view().camera.position, seen.camera.position), 0.1) << preset << ", " << tool;
      viewer().set_view(before);
    }
  }
  use("mouse-standard");
  use("tool-select");
  EXPECT_FALSE(hint_there());
  EXPECT_EQ(history().count(), 0);
}

TEST_F(Window_editing_3, ADragMovesAcrossTheLineOfSightAndUndoTakesItBack) {
  const auto start = balls();
  const QPoint from = pixel({-1, 0.2, 0});
  drag(from, from + QPoint(40, -30));
  EXPECT_NEAR(balls()[0].center.x, -1 + 40 * unit(), 1e-9);
  EXPECT_NEAR(balls()[0].center.y, 30 * unit(), 1e-9);
  EXPECT_NEAR(balls()[0].center.z, 0, 1e-9);
  EXPECT_EQ(balls()[1], start[1]);
  EXPECT_EQ(history().count(), 1);
  EXPECT_EQ(history().text(0), "Move 1 ball");
  EXPECT_TRUE(window_->isWindowModified());
  use("undo");
  EXPECT_EQ(balls(), start);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {0}}));
  EXPECT_FALSE(window_->isWindowModified());
}

TEST_F(Window_editing_3, ShiftKeepsADragToAnAxis) {
  const QPoint from = pixel({-1, 0, 0});
  drag(from, from + QPoint(-12, 45), Qt::ShiftModifier);
  EXPECT_EQ(balls()[0].center.x, -1);
  EXPECT_EQ(balls()[0].center.z, 0);
  EXPECT_NEAR(balls()[0].center.y, -45 * unit(), 1e-9);
}

TEST_F(Window_editing_3, ControlKeepsADragOnTheSurface) {
  drag(pixel({-1, 0, 0}), pixel({1, 0, 0}), Qt::ControlModifier);
  // In the middle of the other ball its surface is nearest to the viewer.
  EXPECT_LT(distance(balls()[0].center, {1, 0, 0.75}), 2 * unit());
}

TEST_F(Window_editing_3, EscapeTakesADragBack) {
  const auto start = balls();
  const QPoint from = pixel({-1, 0, 0});
  QTest::mousePress(&viewer(), Qt::LeftButton, {}, from);
  move(from + QPoint(50, 50), Qt::LeftButton);
  ASSERT_NE(balls(), start);
  use("escape");
  EXPECT_EQ(balls(), start);
  move(from + QPoint(80, 80), Qt::LeftButton);
  QTest::mouseRelease(&viewer(), Qt::LeftButton, {}, from + QPoint(80, 80));
  EXPECT_EQ(balls(), start);
  EXPECT_EQ(history().count(), 0);
}

TEST_F(Window_editing_3, HandlesAndWheelResize) {
  click(pixel({1, 0, 0}));
  const QPoint handle = pixel({1.75, 0, 0});
  drag(handle, handle + QPoint(20, 0));
  EXPECT_NEAR(balls()[1].radius, 0.75 + 20 * unit(), 1e-4);
  EXPECT_EQ(history().text(0), "Resize 1 ball");
  const double before = balls()[1].radius;
  const QPointF at(pixel({1, 0, 0}));
  const View_3 view = viewer().view();
  QWheelEvent wheel(at, viewer().mapToGlobal(at), {}, QPoint(0, 120), Qt::NoButton, Qt::ShiftModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&viewer(), &wheel);
  EXPECT_NEAR(balls()[1].radius / before, 1.06, 0.01);
  EXPECT_EQ(viewer().view(), view);
  EXPECT_EQ(history().count(), 2);
}

TEST_F(Window_editing_3, ClicksAddOnWhatIsThereAndElseInTheMiddle) {
  use("tool-balls");
  click(pixel({1, 0, 0}));
  ASSERT_EQ(balls().size(), 3U);
  EXPECT_LT(distance(balls()[2].center, {1, 0, 0.75}), 2 * unit());
  EXPECT_EQ(history().text(0), "Add a ball");
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {2}}));
  ASSERT_TRUE(wait_until_drawn());
  click({10, 10});
  ASSERT_EQ(balls().size(), 4U);
  EXPECT_NEAR(balls()[3].center.z, viewer().view().camera.target.z, 1e-9);
  EXPECT_EQ(balls()[3].radius, balls()[2].radius);
  use("tool-points");
  drag({10, 10}, {80, 10});
  EXPECT_EQ(inputs().get(cloud_input), nullptr);
  click({10, 10});
  ASSERT_NE(inputs().get(cloud_input), nullptr);
  EXPECT_EQ(editor().selection(), (Selection_3{{0}, {}}));
  EXPECT_TRUE(find_entry(window_->document().layers(), "points")->style.visible);
  EXPECT_EQ(history().count(), 3);
  use("undo");
  EXPECT_EQ(inputs().get(cloud_input), nullptr);
  EXPECT_FALSE(find_entry(window_->document().layers(), "points")->style.visible);
}

TEST_F(Window_editing_3, ClicksAddOnTheCuttingPlane) {
  View_3 view = viewer().view();
  view.cutting_plane = Cutting_plane_3{{0, 0, -2}, {0, 0, 1}, {}};
  viewer().set_view(view);
  viewer().grab_picture();
  use("tool-points");
  click(pixel({1, 0, -2}));
  ASSERT_NE(inputs().get(cloud_input), nullptr);
  EXPECT_LT(distance(inputs().get(cloud_input)->front(), {1, 0, -2}), 2 * unit());
}

TEST_F(Window_editing_3, DeletesAndDuplicates) {
  click(pixel({1, 0, 0}));
  use("duplicate");
  ASSERT_EQ(balls().size(), 3U);
  EXPECT_EQ(balls()[2].radius, 0.75);
  EXPECT_EQ(editor().selection(), (Selection_3{{}, {2}}));
  use("delete");
  EXPECT_EQ(balls().size(), 2U);
  EXPECT_FALSE(window_->actions()["delete"]->isEnabled());
  use("undo");
  use("undo");
  EXPECT_EQ(balls().size(), 2U);
  EXPECT_FALSE(window_->document().is_modified());
}

TEST_F(Window_editing_3, AnEditIsComputedWhileItIsDragged) {
  ASSERT_TRUE(wait_until_drawn());
  const QPoint from = pixel({-1, 0, 0});
  QTest::mousePress(&viewer(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 3; ++i) {
    move(from + QPoint(10 * i, 0), Qt::LeftButton);
    EXPECT_TRUE(wait_until_drawn()) << i;
  }
  QTest::mouseRelease(&viewer(), Qt::LeftButton, {}, from + QPoint(30, 0));
  EXPECT_EQ(history().count(), 1);
}

Number_field* field(const Popover& popover, const char* name) {
  for (auto* candidate : popover.findChildren<Number_field*>())
    if (candidate->accessibleName() == QLatin1String(name)) return candidate;
  return nullptr;
}

void type(Number_field& field, const char* text) {
  field.setFocus();
  field.selectAll();
  QTest::keyClicks(&field, QLatin1String(text));
  QTest::keyClick(&field, Qt::Key_Return);
}

TEST_F(Window_editing_3, ExactCoordinatesAreTyped) {
  click(pixel({1, 0, 0}));
  use("coordinates");
  ASSERT_NE(window_->popover(), nullptr);
  const auto line = [&](const char* name) {
    for (auto* candidate : window_->popover()->findChildren<QLineEdit*>())
      if (candidate->accessibleName() == QLatin1String(name)) return candidate;
    return static_cast<QLineEdit*>(nullptr);
  };
  const auto type_line = [&](const char* name, const char* text) {
    line(name)->setFocus();
    line(name)->selectAll();
    QTest::keyClicks(line(name), QLatin1String(text));
    QTest::keyClick(line(name), Qt::Key_Return);
  };
  type_line("z", "0.1");
  type_line("radius", "0.3");
  EXPECT_EQ(balls()[1], (Ball_3{{1, 0, 0.1}, 0.3}));
  type_line("radius", "-1");
  EXPECT_EQ(balls()[1].radius, 0.3);
  EXPECT_EQ(line("radius")->text(), "0.3");
  EXPECT_EQ(window_->messages().lines().size(), 1);
  EXPECT_EQ(history().count(), 1);
  EXPECT_EQ(history().text(0), "Set numbers of ball 1");
}

TEST_F(Window_editing_3, TransformsAreOneStepAndSavedExactly) {
  use("transform");
  ASSERT_NE(window_->popover(), nullptr);
  type(*field(*window_->popover(), "Move along x"), "0.1");
  type(*field(*window_->popover(), "Turn about z, in degrees"), "90");
  type(*field(*window_->popover(), "Times as large"), "2");
  EXPECT_EQ(history().count(), 1);
  const Point_3 middle{0.125, 0, 0};
  EXPECT_EQ(balls()[0], (Ball_3{{middle.x + 0.1, -2 - 2 * middle.x, 0}, 1}));
  window_->popover()->dismiss();
  const QString path = folder_.filePath("saved.woff");
  ASSERT_TRUE(window_->files().save_to(path));
  ASSERT_TRUE(window_->files().finish_saving(std::chrono::seconds(10)));
  EXPECT_FALSE(window_->document().is_modified());
  const auto saved = balls();
  open({{path.toStdString()}, {"given-balls"}, {}});
  ASSERT_TRUE(wait_until_drawn());
  EXPECT_EQ(balls(), saved);
}

TEST_F(Window_editing_3, AMeshIsMirroredAndCentered) {
  open({{write("corner.off", "OFF\n3 1 0\n1 1 1\n3 1 1\n1 2 1\n3 0 1 2\n")}, {"mesh"}, {}});
  ASSERT_TRUE(wait_until([&] { return inputs().get(mesh_input) != nullptr; }));
  use("transform");
  for (auto* box : window_->popover()->findChildren<QCheckBox*>())
    if (box->text() == "x") box->setChecked(true);
  EXPECT_EQ(inputs().get(mesh_input)->vertices[0], (Point_3{3, 1, 1}));
  EXPECT_EQ(inputs().get(mesh_input)->triangles[0], (std::array{0, 2, 1}));
  for (auto* button : window_->popover()->findChildren<QPushButton*>())
    if (button->text() == "Center") button->click();
  EXPECT_EQ(inputs().get(mesh_input)->vertices[0], (Point_3{1, -0.5, 0}));
  EXPECT_EQ(history().count(), 1);
  use("undo");
  EXPECT_EQ(inputs().get(mesh_input)->vertices[0], (Point_3{1, 1, 1}));
  EXPECT_EQ(window_->popover(), nullptr);
}

TEST_F(Window_editing_3, GeneratorsStartFromNothing) {
  use("new");
  EXPECT_TRUE(inputs().is_empty());
  EXPECT_FALSE(window_->document().is_modified());
  for (const Generator_3& generator : generators_3()) {
    use(("insert-" + generator.id).c_str());
    EXPECT_FALSE(inputs().is_empty()) << generator.id;
    ASSERT_NE(window_->popover(), nullptr);
    EXPECT_EQ(history().undoText(), "Insert: " + QString(generator.label));
    use("undo");
    EXPECT_TRUE(inputs().is_empty()) << generator.id;
    EXPECT_EQ(window_->popover(), nullptr);
  }
}

TEST_F(Window_editing_3, TheLookFollowsWhatIsDrawn) {
  open({});
  ASSERT_TRUE(wait_until_idle());
  use("new");
  use("tool-balls");
  click(viewer().rect().center());
  ASSERT_EQ(balls().size(), 1U);
  EXPECT_TRUE(find_entry(window_->document().layers(), "given-balls")->style.visible);
  EXPECT_FALSE(find_entry(window_->document().layers(), "mesh")->style.visible);
  use("undo");
  EXPECT_TRUE(inputs().is_empty());
}

/// What the issue of the window tells: one sitting, from opening to closing.
TEST_F(Window_editing_3, ASittingFromOpeningToClosing) {
  // A cube, whose medial axis has faces at its bisectors.
  open({});
  ASSERT_TRUE(wait_until_idle());
  const auto key = [&](Qt::Key code, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&viewer(), code, modifiers);
  };
  viewer().setFocus();
  window_->activateWindow();
  key(Qt::Key_N, Qt::ControlModifier);
  use("insert-cube");
  window_->popover()->dismiss();
  ASSERT_TRUE(wait_until([&] { return !window_->computation().is_busy(); }));
  const QPoint middle = viewer().rect().center();

  const View_3 front = viewer().view();
  drag(middle, middle + QPoint(80, 30));
  EXPECT_GT(distance(viewer().view().camera.position, front.camera.position), 0.1);

  // Cut open, the surface being translucent, the axis is seen.
  key(Qt::Key_C);
  ASSERT_TRUE(viewer().view().cutting_plane);
  const QImage cut = viewer().grab_picture();
  key(Qt::Key_C);
  ASSERT_FALSE(viewer().view().cutting_plane);
  EXPECT_NE(viewer().grab_picture(), cut);

  // Nothing but the axis, so that a face of it is under the mouse.
  window_->layer_panel().select({"scale-axis"});
  key(Qt::Key_S);
  ASSERT_FALSE(find_entry(window_->document().layers(), "mesh")->style.visible);
  viewer().grab_picture();
  hover(middle + QPoint(7, 11));
  ASSERT_TRUE(wait_until([&] { return window_->hover()->hovered().has_value(); }));
  ASSERT_TRUE(wait_until([&] { return window_->hover()->text().contains("angle"); }))
      << window_->hover()->text().toStdString();
  const auto hovered = *window_->hover()->hovered();
  EXPECT_EQ(hovered.layer, "scale-axis");
  key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(QApplication::clipboard()->text(), window_->hover()->text());

  // A threshold above all angles leaves nothing there.
  auto* minimum = [&]() -> Number_field* {
    for (auto* candidate : window_->layer_panel().findChildren<Number_field*>())
      if (candidate->accessibleName() == "Shown: minimum") return candidate;
    return nullptr;
  }();
  ASSERT_NE(minimum, nullptr);
  type(*minimum, "181");
  EXPECT_EQ(find_entry(window_->document().layers(), "scale-axis")->style.threshold_minimum, 181);
  viewer().grab_picture();
  EXPECT_FALSE(viewer().pick(middle + QPoint(7, 11), 0));
  viewer().setFocus();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(viewer().pick(middle + QPoint(7, 11), 0));
  key(Qt::Key_H);
  EXPECT_FALSE(find_entry(window_->document().layers(), "scale-axis")->style.visible);
  key(Qt::Key_Z, Qt::ControlModifier);

  // A ball is added, moved and taken back.
  key(Qt::Key_B);
  click(middle);
  ASSERT_EQ(balls().size(), 1U);
  ASSERT_TRUE(wait_until_drawn());
  const Ball_3 added = balls().front();
  key(Qt::Key_V);
  const QPoint at = pixel(added.center);
  drag(at, at + QPoint(50, 0));
  EXPECT_GT(distance(balls().front().center, added.center), 10 * unit());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(balls().front(), added);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(balls().empty());

  window_->document().edit_settings(Settings().with("delta", 0.002), "Sampling distance");
  ASSERT_TRUE(window_->computation().is_busy());
  QElapsedTimer time;
  time.start();
  key(Qt::Key_Q, Qt::ControlModifier);
  EXPECT_FALSE(window_->isVisible());
  window_.reset();
  EXPECT_LT(time.elapsed(), 3000);
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QAction>
#include <QMainWindow>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <cmath>

#include "example_scenes.h"
#include "layers/canvas_2.h"

namespace mesecina {
namespace {

class Recording_tool : public Canvas_tool {
 public:
  bool press(const Canvas_event& event) override { return record("press", event); }
  bool move(const Canvas_event& event) override { return record("move", event); }
  bool release(const Canvas_event& event) override { return record("release", event); }
  bool double_click(const Canvas_event& event) override { return record("double", event); }
  void leave() override { names.emplace_back("leave"); }

  std::vector<std::string> names;
  Canvas_event last;

 private:
  bool record(const char* name, const Canvas_event& event) {
    names.emplace_back(name);
    last = event;
    return true;
  }
};

void turn_wheel(QWidget& widget, const QPointF& place, QPoint angle, Qt::KeyboardModifiers modifiers = {}) {
  QWheelEvent event(place, widget.mapToGlobal(place), {}, angle, Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

void send_mouse(QWidget& widget, QEvent::Type type, const QPointF& place, Qt::MouseButton button,
                Qt::MouseButtons buttons) {
  QMouseEvent event(type, place, widget.mapToGlobal(place), button, buttons, Qt::NoModifier);
  QApplication::sendEvent(&widget, &event);
}

class Canvas_events : public testing::Test {
 protected:
  void SetUp() override {
    canvas_.resize(400, 300);
    canvas_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&canvas_));
    canvas_.set_scene(example_scene());
    canvas_.set_view(start_);
    canvas_.set_tool(&tool_);
    tool_.names.clear();
  }
  ~Canvas_events() override { canvas_.set_tool(nullptr); }

  Point_2 under(const QPointF& pixel) const {
    return canvas_.view().to_plane({pixel.x(), pixel.y()}, canvas_.width(), canvas_.height());
  }

  const View_2 start_{{50, 40}, 3};
  Recording_tool tool_;
  Canvas_2 canvas_;
};

TEST_F(Canvas_events, WheelZoomsToTheCursor) {
  const QPointF cursor(310.5, 42.25);
  const Point_2 before = under(cursor);
  turn_wheel(canvas_, cursor, {0, 120});
  EXPECT_NEAR(canvas_.view().scale, 3 * std::pow(1.0015, 120), 1e-9);
  EXPECT_NEAR(distance(under(cursor), before), 0, 1e-9);
  for (int i = 0; i < 60; ++i) turn_wheel(canvas_, cursor, {0, 120});
  EXPECT_NEAR(distance(under(cursor), before) * canvas_.view().scale, 0, 0.5) << "pixels";
}

TEST_F(Canvas_events, HorizontalScrollPans) {
  turn_wheel(canvas_, {200, 150}, {-120, 0});
  EXPECT_EQ(canvas_.view().scale, start_.scale);
  EXPECT_GT(canvas_.view().center.x, start_.center.x);
  EXPECT_EQ(canvas_.view().center.y, start_.center.y);
}

TEST_F(Canvas_events, AltWheelIsLeftToOthers) {
  turn_wheel(canvas_, {200, 150}, {0, 120}, Qt::AltModifier);
  EXPECT_EQ(canvas_.view(), start_);
}

TEST_F(Canvas_events, MiddleDragPansAndIsOneEntryOfTheHistory) {
  QSignalSpy changes(&canvas_, &Canvas_2::view_changed);
  const Point_2 grabbed = under({100, 100});
  send_mouse(canvas_, QEvent::MouseButtonPress, {100, 100}, Qt::MiddleButton, Qt::MiddleButton);
  EXPECT_EQ(canvas_.cursor().shape(), Qt::ClosedHandCursor);
  for (int i = 1; i <= 10; ++i) {
    send_mouse(canvas_, QEvent::MouseMove, QPointF(100 + 9 * i, 100 - 4 * i), Qt::NoButton, Qt::MiddleButton);
    canvas_.set_scene(example_scene());
  }
  send_mouse(canvas_, QEvent::MouseButtonRelease, {190, 60}, Qt::MiddleButton, Qt::NoButton);
  EXPECT_NEAR(distance(under({190, 60}), grabbed), 0, 1e-9);
  EXPECT_EQ(changes.count(), 10);
  EXPECT_NE(canvas_.cursor().shape(), Qt::ClosedHandCursor);
  EXPECT_TRUE(tool_.names.empty());
  canvas_.previous_view();
  EXPECT_EQ(canvas_.view(), start_);
}

TEST_F(Canvas_events, SpaceAndLeftDragPans) {
  canvas_.setCursor(Qt::CrossCursor);
  QTest::keyPress(&canvas_, Qt::Key_Space);
  EXPECT_EQ(canvas_.cursor().shape(), Qt::OpenHandCursor);
  send_mouse(canvas_, QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
  send_mouse(canvas_, QEvent::MouseMove, {130, 100}, Qt::NoButton, Qt::LeftButton);
  send_mouse(canvas_, QEvent::MouseButtonRelease, {130, 100}, Qt::LeftButton, Qt::NoButton);
  QTest::keyRelease(&canvas_, Qt::Key_Space);
  EXPECT_NEAR(canvas_.view().center.x, 40, 1e-9);
  EXPECT_TRUE(tool_.names.empty());
  EXPECT_EQ(canvas_.cursor().shape(), Qt::CrossCursor);
}

TEST_F(Canvas_events, ATapOnSpaceTriggersTheShortcutOfTheWindow) {
  QAction play(&canvas_);
  play.setShortcut(Qt::Key_Space);
  QSignalSpy played(&play, &QAction::triggered);
  QTest::keyClick(&canvas_, Qt::Key_Space);
  EXPECT_EQ(played.count(), 1);
  QTest::keyPress(&canvas_, Qt::Key_Space);
  send_mouse(canvas_, QEvent::MouseButtonPress, {100, 100}, Qt::LeftButton, Qt::LeftButton);
  send_mouse(canvas_, QEvent::MouseButtonRelease, {100, 100}, Qt::LeftButton, Qt::NoButton);
  QTest::keyRelease(&canvas_, Qt::Key_Space);
  EXPECT_EQ(played.count(), 1) << "Space was used to pan";
}

TEST_F(Canvas_events, TheToolGetsTheRest) {
  send_mouse(canvas_, QEvent::MouseButtonPress, {250, 120}, Qt::LeftButton, Qt::LeftButton);
  EXPECT_EQ(tool_.last.button, Qt::LeftButton);
  EXPECT_NEAR(tool_.last.position.x, 50 + 50.0 / 3, 1e-9);
  EXPECT_NEAR(tool_.last.position.y, 50, 1e-9);
  send_mouse(canvas_, QEvent::MouseMove, {260, 120}, Qt::NoButton, Qt::LeftButton);
  send_mouse(canvas_, QEvent::MouseButtonRelease, {260, 120}, Qt::LeftButton, Qt::NoButton);
  send_mouse(canvas_, QEvent::MouseButtonDblClick, {260, 120}, Qt::RightButton, Qt::RightButton);
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(&canvas_, &leave);
  EXPECT_EQ(tool_.names, (std::vector<std::string>{"press", "move", "release", "double", "leave"}));
  EXPECT_EQ(canvas_.view(), start_);
}

TEST_F(Canvas_events, PreviousViewGoesBackGestureByGesture) {
  for (int i = 0; i < 5; ++i) turn_wheel(canvas_, {200, 150}, {0, 120});
  const View_2 zoomed = canvas_.view();
  canvas_.fit(every_kind()->bounding_box());
  const View_2 fitted = canvas_.view();
  EXPECT_NE(fitted, zoomed);
  canvas_.previous_view();
  EXPECT_EQ(canvas_.view(), zoomed);
  canvas_.previous_view();
  EXPECT_EQ(canvas_.view(), start_);
}

TEST_F(Canvas_events, ZoomKeepsTheMiddleAndStopsAtTheLimits) {
  canvas_.zoom(2);
  EXPECT_EQ(canvas_.view().center, start_.center);
  EXPECT_EQ(canvas_.view().scale, 6);
  for (int i = 0; i < 3000; ++i) canvas_.zoom(2);
  const double scale = canvas_.view().scale;
  EXPECT_TRUE(std::isfinite(scale));
  EXPECT_LT(scale * (std::nextafter(50.0, 51.0) - 50), 1) << "doubles still tell pixels apart";
  for (int i = 0; i < 3000; ++i) canvas_.zoom(0.5);
  EXPECT_GT(canvas_.view().scale, 0);
  EXPECT_TRUE(std::isfinite(1 / canvas_.view().scale));
}

TEST_F(Canvas_events, ImpossibleViewsAreRefused) {
  for (const View_2& view : {View_2{{NAN, 0}, 1}, View_2{{0, 0}, 0}, View_2{{0, 0}, -1}, View_2{{0, INFINITY}, 1},
                             View_2{{0, 0}, INFINITY}}) {
    canvas_.set_view(view);
    EXPECT_EQ(canvas_.view(), start_);
  }
}

TEST_F(Canvas_events, FitBeforeShowingFitsTheSizeOnScreen) {
  QMainWindow window;
  auto* canvas = new Canvas_2(Canvas_2::Backend::automatic, &window);
  window.setCentralWidget(canvas);
  const Box box = every_kind()->bounding_box();
  canvas->fit(box);
  window.resize(700, 200);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  EXPECT_EQ(canvas->view(), fit_view(box, canvas->width(), canvas->height()));
}

TEST_F(Canvas_events, AFittedViewFollowsTheSizeUntilItIsMoved) {
  const Box box = every_kind()->bounding_box();
  canvas_.fit(box);
  // Longer than a window takes to appear.
  QTest::qWait(400);
  canvas_.resize(300, 200);
  EXPECT_EQ(canvas_.view(), fit_view(box, 300, 200));
  canvas_.zoom(2);
  const View_2 zoomed = canvas_.view();
  canvas_.resize(400, 300);
  EXPECT_EQ(canvas_.view(), zoomed);
}

TEST_F(Canvas_events, HintIsShownOnAnEmptyCanvasOnly) {
  canvas_.set_scene({});
  const QImage blank = canvas_.grab_picture();
  canvas_.set_hint("Drop a file here or double-click to add points");
  const QImage hinted = canvas_.grab_picture();
  EXPECT_NE(hinted, blank);
  QRect ink;
  for (int y = 0; y < hinted.height(); ++y)
    for (int x = 0; x < hinted.width(); ++x)
      if (hinted.pixel(x, y) != blank.pixel(x, y)) ink |= QRect(x, y, 1, 1);
  EXPECT_LE(std::abs(ink.center().x() - hinted.width() / 2), 8);
  EXPECT_LE(std::abs(ink.center().y() - hinted.height() / 2), 8);
  canvas_.set_scene(example_scene());
  const QImage with_hint = canvas_.grab_picture();
  canvas_.set_hint({});
  EXPECT_EQ(canvas_.grab_picture(), with_hint);
}

TEST_F(Canvas_events, RubberBandIsDrawnAndGoes) {
  const QImage without = canvas_.grab_picture();
  canvas_.set_rubber_band(QRectF(50, 60, 100, 80));
  const QImage with = canvas_.grab_picture();
  EXPECT_NE(with, without);
  EXPECT_EQ(with.copy(0, 0, 45, 300), without.copy(0, 0, 45, 300));
  canvas_.set_rubber_band(std::nullopt);
  EXPECT_EQ(canvas_.grab_picture(), without);
}

TEST_F(Canvas_events, ItCanBeFocusedAndHasAName) {
  EXPECT_EQ(canvas_.focusPolicy(), Qt::StrongFocus);
  EXPECT_FALSE(canvas_.accessibleName().isEmpty());
}

}  // namespace
}  // namespace mesecina

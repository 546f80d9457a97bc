// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QSpinBox>

#include "shell/evolution_bar.h"
#include "tests/app3d/window_fixture_3.h"

namespace mesecina {
namespace {

class Window_evolution_3 : public Window_3 {
 protected:
  void SetUp() override {
    Window_3::SetUp();
    open_ball();
    trigger("evolve-grow-balls");
    // Keys of a widget are heard in the active window only.
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    viewer().setFocus();
  }
  Evolution_control& control() { return window_->evolution(); }
  Document& document() { return window_->document(); }
  void trigger(const char* action) { window_->actions()[QLatin1String(action)]->trigger(); }
  double radius() { return document().inputs().get(balls_input)->front().radius; }
  bool wait_for_steps(std::size_t count) {
    return wait_until([&] { return document().step_count() == count && !control().evolver().is_busy(); });
  }
  double shown_radius() {
    const auto set = window_->computation().primitives("given-balls");
    return set && !set->balls.empty() ? set->balls.front().radius : 0;
  }
};

TEST_F(Window_evolution_3, StepsAreMadeShownAndUndone) {
  EXPECT_TRUE(window_->findChild<Evolution_bar*>("evolution-bar")->isVisible());
  control().set_steps_ahead(4);
  trigger("evolution-make-steps");
  ASSERT_TRUE(wait_for_steps(4));
  ASSERT_TRUE(wait_until_idle());
  const double grown = radius();
  EXPECT_GT(grown, 1);
  EXPECT_EQ(shown_radius(), grown);
  trigger("evolution-first");
  EXPECT_EQ(radius(), 1);
  ASSERT_TRUE(wait_until_idle());
  const auto requests = window_->computation().requests();
  trigger("evolution-last");
  EXPECT_EQ(shown_radius(), grown);
  trigger("evolution-first");
  EXPECT_EQ(shown_radius(), 1);
  EXPECT_EQ(window_->computation().requests(), requests);
  trigger("undo");
  EXPECT_EQ(document().step_count(), 0u);
  EXPECT_EQ(radius(), 1);
}

TEST_F(Window_evolution_3, KeysOfTheCanvasPlayAndGoThroughTheSteps) {
  const View_3 view = viewer().view();
  control().set_steps_ahead(3);
  control().set_steps_per_second(50);
  QTest::keyClick(&viewer(), Qt::Key_Space);
  EXPECT_TRUE(control().is_playing());
  ASSERT_TRUE(wait_until([&] { return !control().is_playing(); }));
  ASSERT_TRUE(wait_for_steps(3));
  EXPECT_EQ(document().position(), 3u);
  QTest::keyClick(&viewer(), Qt::Key_Left);
  EXPECT_EQ(document().position(), 2u);
  QTest::keyClick(&viewer(), Qt::Key_Home);
  EXPECT_EQ(document().position(), 0u);
  QTest::keyClick(&viewer(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(document().position(), 1u);
  QTest::keyClick(&viewer(), Qt::Key_End);
  EXPECT_EQ(document().position(), 3u);
  // The view stays where it is.
  EXPECT_EQ(viewer().view().camera.position.x, view.camera.position.x);
  EXPECT_EQ(document().step_count(), 3u);
}

TEST_F(Window_evolution_3, TheWindowStartsWithSteps) {
  Startup startup{{write("two.cin", "0 0 0 1\n3 0 0 1\n")}, {"given-balls"}, {}};
  startup.evolutions = {{"grow-balls", 2}, {"shrink-balls", 1}};
  open(startup);
  ASSERT_TRUE(wait_for_steps(3));
  EXPECT_EQ(document().track()->places[1].evolution, "grow-balls");
  EXPECT_EQ(document().track()->places[3].evolution, "shrink-balls");
  EXPECT_GT(document().track()->places[2].inputs.get(balls_input)->front().radius, radius());
}

}  // namespace
}  // namespace mesecina

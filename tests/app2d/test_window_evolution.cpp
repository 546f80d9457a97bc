// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLineEdit>
#include <QSettings>
#include <QSpinBox>
#include <QtTest>
#include <algorithm>

#include "shell/evolution_bar.h"
#include "shell/preferences.h"
#include "shell/step_slider.h"
#include "window_fixture.h"

namespace mesecina {
namespace {

class Window_evolution : public Window_fixture {
 protected:
  void SetUp() override {
    Preferences("mesecina2d").set_value("evolution-bar", false);
    open_window();
  }
  void TearDown() override { Preferences("mesecina2d").set_value("evolution-bar", false); }
  Evolution_control& control() { return window().evolution(); }
  Evolution_bar& bar() { return *window().findChild<Evolution_bar*>("evolution-bar"); }
  template <class Field>
  Field& field(const char* accessible_name) {
    for (Field* each : bar().findChildren<Field*>())
      if (each->accessibleName() == QLatin1String(accessible_name)) return *each;
    throw std::out_of_range(accessible_name);
  }
  Step_slider& slider() { return *bar().findChild<Step_slider*>(); }
  QSpinBox& number() { return field<QSpinBox>("Number of the step"); }
  bool is_enabled(const char* action) { return window().actions()[QLatin1String(action)]->isEnabled(); }
  bool wait_for_steps(std::size_t count) {
    return wait_until([&] { return document().step_count() == count && !control().evolver().is_busy(); });
  }
  void make_steps(int count) {
    control().set_steps_ahead(count);
    trigger("evolution-make-steps");
    ASSERT_TRUE(wait_for_steps(static_cast<std::size_t>(count)));
  }
};

TEST_F(Window_evolution, WhatDoesNotSuitTheDataIsDimmedWithTheReason) {
  trigger("evolution-bar");
  auto& combo = field<QComboBox>("Evolution");
  const auto item = [&](const char* id, int role) { return combo.itemData(combo.findData(id), role); };
  EXPECT_EQ(control().chosen(), "laplacian-smoothing");
  EXPECT_FALSE(item("laplacian-smoothing", Qt::ForegroundRole).isValid());
  const std::vector<Disk_2> disks{{{0, 0}, 2}, {{3, 0}, 2}};
  document().replace_inputs(Inputs().with(disks_input, disks), "Disks");
  EXPECT_EQ(control().chosen(), "noise") << "the first that suits disks";
  EXPECT_EQ(combo.currentData().toString(), "noise");
  EXPECT_TRUE(item("laplacian-smoothing", Qt::ForegroundRole).isValid());
  EXPECT_TRUE(item("laplacian-smoothing", Qt::ToolTipRole).toString().contains("there is no curve"));
  EXPECT_FALSE(item("grow-balls", Qt::ForegroundRole).isValid());
  QPalette other = bar().palette();
  other.setBrush(QPalette::PlaceholderText, Qt::magenta);
  bar().setPalette(other);
  EXPECT_EQ(item("laplacian-smoothing", Qt::ForegroundRole).value<QBrush>().color(), QColor(Qt::magenta))
      << "the theme was changed";
  document().history().undo();
  EXPECT_EQ(control().chosen(), "laplacian-smoothing");
  EXPECT_FALSE(item("laplacian-smoothing", Qt::ForegroundRole).isValid());
  EXPECT_FALSE(item("laplacian-smoothing", Qt::ToolTipRole).toString().contains("there is no curve"));
  // Whoever has chosen keeps the choice, and is told when it is tried.
  trigger("evolve-lloyd");
  document().replace_inputs(Inputs().with(disks_input, disks), "Disks");
  EXPECT_EQ(control().chosen(), "lloyd");
  QSignalSpy told(&control(), &Evolution_control::told);
  trigger("evolution-make-steps");
  ASSERT_TRUE(wait_until([&] { return !told.isEmpty(); }));
  EXPECT_TRUE(told[0][0].toString().contains("no points to move")) << told[0][0].toString().toStdString();
}

TEST_F(Window_evolution, TheBarIsThereWhenItIsWanted) {
  EXPECT_TRUE(bar().isHidden());
  trigger("evolution-bar");
  EXPECT_TRUE(bar().isVisible());
  trigger("evolution-bar");
  EXPECT_TRUE(bar().isHidden());
  trigger("evolve-laplacian-smoothing");
  EXPECT_TRUE(bar().isVisible());
  EXPECT_TRUE(window().actions()["evolution-bar"]->isChecked());
  EXPECT_EQ(control().chosen(), "laplacian-smoothing");
  // The next window shows it at once.
  open_window();
  EXPECT_TRUE(bar().isVisible());
  trigger("evolution-bar");
  open_window();
  EXPECT_TRUE(bar().isHidden());
}

TEST_F(Window_evolution, EveryEvolutionCanBeChosenAndIsExplained) {
  auto& evolutions = field<QComboBox>("Evolution");
  ASSERT_GT(evolutions.count(), 0);
  for (int i = 0; i < evolutions.count(); ++i) {
    EXPECT_FALSE(evolutions.itemData(i, Qt::ToolTipRole).toString().isEmpty());
    const QString id = evolutions.itemData(i).toString();
    trigger(("evolve-" + id.toStdString()).c_str());
    EXPECT_EQ(evolutions.currentIndex(), i);
  }
  EXPECT_TRUE(window().actions().faults().isEmpty()) << window().actions().faults().join("\n").toStdString();
}

TEST_F(Window_evolution, KeysGoThroughTheSteps) {
  const auto before = points();
  EXPECT_FALSE(is_enabled("evolution-back"));
  press(Qt::Key_Right, Qt::ControlModifier);
  ASSERT_TRUE(wait_for_steps(1));
  EXPECT_NE(points(), before);
  press(Qt::Key_Right, Qt::ControlModifier);
  ASSERT_TRUE(wait_for_steps(2));
  const auto last = points();
  EXPECT_TRUE(is_enabled("evolution-back"));
  EXPECT_FALSE(is_enabled("evolution-last"));
  press(Qt::Key_Left, Qt::ControlModifier);
  EXPECT_EQ(document().position(), 1u);
  press(Qt::Key_Home);
  EXPECT_EQ(points(), before);
  press(Qt::Key_End);
  EXPECT_EQ(points(), last);
  EXPECT_EQ(document().history().count(), 1);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(points(), before);
  EXPECT_EQ(document().step_count(), 0u);
}

TEST_F(Window_evolution, ArrowsMoveTheSelectionOrGoThroughTheSteps) {
  make_steps(12);
  press(Qt::Key_Left);
  EXPECT_EQ(document().position(), 11u);
  press(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(document().position(), 1u);
  press(Qt::Key_Right);
  EXPECT_EQ(document().position(), 2u);
  press(Qt::Key_Up);
  EXPECT_EQ(document().position(), 2u);
  EXPECT_EQ(document().step_count(), 12u);
  const auto before = points();
  window().editor().select({{3}, {}});
  press(Qt::Key_Right);
  EXPECT_GT(points()[3].x, before[3].x);
  EXPECT_EQ(document().position(), 2u);
  EXPECT_EQ(document().step_count(), 2u);
  press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().step_count(), 12u);
}

TEST_F(Window_evolution, SpacePlaysAndPausesUnlessItMovesTheView) {
  control().set_steps_ahead(5);
  control().set_steps_per_second(50);
  press(Qt::Key_Space);
  EXPECT_TRUE(control().is_playing());
  press(Qt::Key_Space);
  EXPECT_FALSE(control().is_playing());
  press(Qt::Key_Space);
  ASSERT_TRUE(wait_until([&] { return !control().is_playing(); }));
  ASSERT_TRUE(wait_for_steps(5));
  press(Qt::Key_Space, Qt::ShiftModifier);
  EXPECT_EQ(control().motion(), Evolution_control::Motion::backward);
  ASSERT_TRUE(wait_until([&] { return !control().is_playing(); }));
  EXPECT_EQ(document().position(), 0u);

  const View_2 view = canvas().view();
  QTest::keyPress(&canvas(), Qt::Key_Space);
  drag({200, 200}, {260, 240});
  QTest::keyRelease(&canvas(), Qt::Key_Space);
  EXPECT_NE(canvas().view().center.x, view.center.x);
  EXPECT_FALSE(control().is_playing());
}

TEST_F(Window_evolution, TheViewIsMovedWhileItPlays) {
  make_steps(8);
  control().set_repeat(Evolution_control::Repeat::ping_pong);
  control().set_steps_per_second(50);
  control().play(Evolution_control::Motion::forward);
  const double scale = canvas().view().scale;
  trigger("zoom-in");
  EXPECT_GT(canvas().view().scale, scale);
  const double zoomed = canvas().view().scale;
  const std::size_t here = document().position();
  ASSERT_TRUE(wait_until([&] { return document().position() + 2 < here || document().position() > here + 2; }));
  EXPECT_TRUE(control().is_playing());
  EXPECT_EQ(canvas().view().scale, zoomed);
  press(Qt::Key_Escape);
  EXPECT_FALSE(control().is_playing());
}

TEST_F(Window_evolution, SliderAndFieldShowTheStepAndGoToOthers) {
  make_steps(10);
  EXPECT_EQ(slider().maximum(), 10);
  EXPECT_EQ(slider().value(), 10);
  EXPECT_EQ(number().text(), "10 of 10");
  slider().setValue(4);
  EXPECT_EQ(document().position(), 4u);
  EXPECT_EQ(number().value(), 4);
  number().setFocus();
  number().selectAll();
  QTest::keyClicks(&number(), "7");
  EXPECT_EQ(number().text(), "7 of 10");
  QTest::keyClick(&number(), Qt::Key_Return);
  EXPECT_EQ(document().position(), 7u);
  EXPECT_EQ(slider().value(), 7);
  // A click on the slider goes there.
  QTest::mouseClick(&slider(), Qt::LeftButton, {}, QPoint(3, slider().height() / 2));
  EXPECT_EQ(document().position(), 0u);
  EXPECT_EQ(document().history().count(), 1);
  document().history().undo();
  EXPECT_EQ(slider().maximum(), 0);
  EXPECT_FALSE(slider().isEnabled());
}

TEST_F(Window_evolution, TheMemoryOfPicturesIsShownAndRemembered) {
  auto& memory = field<QSpinBox>("Memory for pictures of steps, in megabytes");
  EXPECT_EQ(memory.value(), 512);
  EXPECT_TRUE(memory.text().startsWith("0 of 512"));
  make_steps(3);
  ASSERT_TRUE(wait_until([&] { return window().computation().kept_bytes() > 0; }));
  EXPECT_TRUE(memory.text().startsWith("1 of 512")) << memory.text().toStdString();
  memory.setValue(64);
  EXPECT_EQ(window().computation().kept_bytes_budget(), std::size_t{64} << 20);
  open_window();
  EXPECT_EQ(window().computation().kept_bytes_budget(), std::size_t{64} << 20);
  field<QSpinBox>("Memory for pictures of steps, in megabytes").setValue(512);
}

TEST_F(Window_evolution, RepeatsBetweenSteps) {
  make_steps(10);
  auto& begin = field<QSpinBox>("First step that is repeated");
  auto& end = field<QSpinBox>("Last step that is repeated");
  EXPECT_FALSE(begin.isVisible());
  trigger("evolution-wrap");
  EXPECT_TRUE(begin.isVisible());
  EXPECT_EQ(field<QComboBox>("What comes after the last step").currentText(), "Again and again");
  control().go_to(3);
  trigger("evolution-range-begin");
  EXPECT_EQ(begin.value(), 3);
  EXPECT_EQ(end.value(), 10);
  end.setValue(6);
  EXPECT_EQ(control().range_end(), 6u);
  trigger("evolution-whole-range");
  EXPECT_EQ(begin.value(), 0);
  EXPECT_EQ(end.value(), 10);
}

TEST_F(Window_evolution, SettingsOfTheEvolutionAreListed) {
  trigger("evolve-laplacian-smoothing");
  trigger("evolution-settings");
  const auto listed = window().settings_panel().listed();
  EXPECT_NE(std::ranges::find(listed, "smoothing-factor"), listed.end());
  EXPECT_EQ(std::ranges::find(listed, "sampling-step"), listed.end());
}

TEST_F(Window_evolution, AnOpenedFileHasNoSteps) {
  make_steps(3);
  window().files().open({write("three.xy", "0 0\n1 0\n0 1\n")}, false);
  ASSERT_TRUE(wait_until([&] { return points().size() == 3; }));
  EXPECT_EQ(document().step_count(), 0u);
  document().history().undo();
  EXPECT_EQ(document().step_count(), 3u);
}

TEST_F(Window_evolution, WhatEvolutionsKeepBesideTheDataIsNotSaved) {
  const auto ids = document().inputs().ids();
  trigger("evolve-lloyd");
  make_steps(2);
  // The domain of the first step goes on with the points.
  ASSERT_GT(document().inputs().ids().size(), ids.size());
  EXPECT_TRUE(document().is_modified());
  EXPECT_TRUE(window().files().save_to(folder_.filePath("spread.xy")));
  ASSERT_TRUE(wait_until_saved());
  EXPECT_FALSE(document().is_modified());
  EXPECT_EQ(window().messages().lines(), QStringList());
}

TEST_F(Window_evolution, TheWindowStartsWithSteps) {
  Startup startup;
  startup.evolutions = {{"laplacian-smoothing", 4}};
  open_window(startup);
  ASSERT_TRUE(wait_for_steps(4));
  EXPECT_EQ(document().position(), 4u);
  EXPECT_TRUE(bar().isVisible());
  startup.files = {write("curve.xy", "0 0\n10 0\n11 5\n10 10\n0 10\n-1 5\n").toStdString()};
  startup.evolutions = {{"laplacian-smoothing", 2}};
  open_window(startup);
  ASSERT_TRUE(wait_for_steps(2));
  EXPECT_EQ(points().size(), 6u);
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "shell/document.h"

namespace mesecina {
namespace {

Inputs one_point(double x) { return Inputs().with(points_input, std::vector<Point_2>{{x, 0}}); }
double first_x(const Inputs& inputs) { return inputs.get(points_input)->front().x; }

/// A document with a point at 0, which evolutions move.
class Track : public testing::Test {
 protected:
  Evolution_spec spec(const char* label, std::vector<std::string> settings = {}) {
    return {label, label, "Moves.", std::move(settings), {}, {}};
  }
  Evolution_state state() const { return {document_.inputs(), document_.settings()}; }
  /// So many steps by 1 from the end of the track.
  void walk(int steps, const char* label = "Walk", bool follows = true) {
    for (int i = 0; i < steps; ++i) {
      document_.go_to(document_.step_count());
      const Evolution_state before = state();
      document_.add_step(spec(label, {"pace"}), document_.position(), before,
                         {one_point(first_x(before.inputs) + 1), before.settings}, follows);
    }
  }
  std::vector<double> places() const {
    std::vector<double> result;
    if (document_.track())
      for (const auto& place : document_.track()->places) result.push_back(first_x(place.inputs));
    return result;
  }
  double x() const { return first_x(document_.inputs()); }
  void undo() { document_.history().undo(); }
  void redo() { document_.history().redo(); }
  int undo_steps() { return document_.history().count(); }

  Document document_{{one_point(0), {}, {{"points", {}}}}};
};

TEST_F(Track, StepsThatFollowEachOtherAreOneStepOfUndoInWords) {
  EXPECT_EQ(document_.step_count(), 0u);
  walk(1);
  EXPECT_EQ(document_.history().undoText(), "Walk: 1 step");
  walk(11);
  EXPECT_EQ(document_.history().undoText(), "Walk: 12 steps");
  EXPECT_EQ(undo_steps(), 1);
  EXPECT_EQ(document_.step_count(), 12u);
  EXPECT_EQ(document_.position(), 12u);
  EXPECT_EQ(x(), 12);
  undo();
  EXPECT_EQ(document_.track(), nullptr);
  EXPECT_EQ(x(), 0);
  redo();
  EXPECT_EQ(x(), 12);
  EXPECT_EQ(document_.step_count(), 12u);
}

TEST_F(Track, GoingToAnotherStepIsNoStepOfUndo) {
  walk(12);
  const void* third = document_.track()->places[3].inputs.identity("points");
  document_.go_to(3);
  EXPECT_EQ(undo_steps(), 1);
  EXPECT_EQ(document_.inputs().identity("points"), third);
  EXPECT_EQ(document_.step_count(), 12u);
  document_.go_to(99);
  EXPECT_EQ(document_.position(), 12u);
  document_.go_to(0);
  EXPECT_EQ(x(), 0);
  undo();
  redo();
  EXPECT_EQ(document_.position(), 12u);
}

TEST_F(Track, AnEditInTheMiddleBranchesAndUndoBringsTheOldBranchBack) {
  walk(12);
  const Track_pointer whole = document_.track();
  document_.go_to(4);
  document_.edit_inputs(one_point(40), "Move 1 point");
  EXPECT_EQ(places(), (std::vector<double>{0, 1, 2, 3, 40}));
  EXPECT_EQ(document_.position(), 4u);
  walk(2);
  EXPECT_EQ(places(), (std::vector<double>{0, 1, 2, 3, 40, 41, 42}));
  EXPECT_EQ(document_.track()->places.back().number, 6u);
  EXPECT_EQ(document_.history().undoText(), "Walk: 2 steps");
  undo();
  undo();
  EXPECT_EQ(document_.track(), whole);
  EXPECT_EQ(document_.position(), 4u);
  EXPECT_EQ(x(), 4);
  redo();
  EXPECT_EQ(x(), 40);
  EXPECT_EQ(document_.step_count(), 4u);
}

TEST_F(Track, AnEditOfTheStartLeavesNoTrack) {
  walk(3);
  document_.go_to(0);
  document_.edit_inputs(one_point(-5), "Move 1 point");
  EXPECT_EQ(document_.track(), nullptr);
  EXPECT_EQ(document_.position(), 0u);
  undo();
  EXPECT_EQ(document_.step_count(), 3u);
  EXPECT_EQ(document_.position(), 0u);
}

TEST_F(Track, ADragBackToWhereItBeganKeepsTheBranch) {
  walk(5);
  const Track_pointer whole = document_.track();
  document_.go_to(2);
  document_.edit_inputs(one_point(20), "Move", "drag/1");
  EXPECT_EQ(document_.step_count(), 2u);
  document_.edit_inputs(one_point(2), "Move", "drag/1");
  EXPECT_EQ(document_.track(), whole);
  EXPECT_EQ(undo_steps(), 1);
}

TEST_F(Track, StepsFromTheMiddleStartABranchOfTheirOwn) {
  walk(5);
  document_.go_to(2);
  const Evolution_state before = state();
  document_.add_step(spec("Jump"), 2, before, {one_point(100), before.settings}, true);
  EXPECT_EQ(places(), (std::vector<double>{0, 1, 2, 100}));
  EXPECT_EQ(document_.track()->places.back().evolution, "Jump");
  EXPECT_EQ(document_.track()->places.back().number, 1u);
  undo();
  EXPECT_EQ(places(), (std::vector<double>{0, 1, 2, 3, 4, 5}));
  // The same evolution once more is not merged with what it cuts off.
  document_.go_to(3);
  document_.add_step(spec("Walk"), 3, state(), {one_point(50), {}}, true);
  EXPECT_EQ(undo_steps(), 2);
  undo();
  EXPECT_EQ(document_.step_count(), 5u);
}

TEST_F(Track, StepsAreAddedWhileAnotherIsLookedAt) {
  walk(3);
  document_.go_to(1);
  const Evolution_state before{document_.track()->places.back().inputs, {}};
  document_.add_step(spec("Walk"), 3, before, {one_point(4), {}}, false);
  EXPECT_EQ(document_.position(), 1u);
  EXPECT_EQ(x(), 1);
  EXPECT_EQ(document_.step_count(), 4u);
}

TEST_F(Track, ChangedLooksAndOtherSettingsKeepAllSteps) {
  walk(5);
  const Track_pointer whole = document_.track();
  document_.go_to(2);
  Layer_list layers = document_.layers();
  layers[0].style.opacity = 0.5;
  document_.edit_layers(layers, "Opacity");
  document_.edit_settings(Settings().with("limit", 2.0), "Limit");
  EXPECT_EQ(document_.track(), whole);
  document_.go_to(5);
  EXPECT_NE(document_.settings().find("limit"), nullptr);
}

TEST_F(Track, AChangedSettingOfTheEvolutionDropsLaterSteps) {
  walk(5);
  document_.go_to(2);
  document_.edit_settings(Settings().with("pace", 3.0), "Pace");
  EXPECT_EQ(document_.step_count(), 2u);
  undo();
  EXPECT_EQ(document_.step_count(), 5u);
}

TEST_F(Track, SettingsThatStepsChangeBelongToSteps) {
  const Evolution_spec zoom = spec("Zoom");
  for (int i = 1; i <= 3; ++i) {
    const Evolution_state before = state();
    document_.add_step(zoom, document_.position(), before, {before.inputs, before.settings.with("scale", 1.0 + i)},
                       true);
  }
  EXPECT_EQ(*document_.settings().find("scale"), Setting_value(4.0));
  document_.edit_settings(document_.settings().with("limit", 2.0), "Limit");
  EXPECT_EQ(document_.step_count(), 3u);
  document_.go_to(0);
  EXPECT_EQ(document_.settings().find("scale"), nullptr);
  EXPECT_EQ(*document_.settings().find("limit"), Setting_value(2.0));
  document_.go_to(1);
  EXPECT_EQ(*document_.settings().find("scale"), Setting_value(2.0));
  document_.edit_settings(document_.settings().with("scale", 7.0), "Scale");
  EXPECT_EQ(document_.step_count(), 1u);
  document_.go_to(0);
  document_.go_to(1);
  EXPECT_EQ(*document_.settings().find("scale"), Setting_value(7.0));
}

TEST_F(Track, IsModifiedByTheStepThatIsShown) {
  walk(3);
  EXPECT_TRUE(document_.is_modified());
  document_.go_to(0);
  EXPECT_FALSE(document_.is_modified());
  document_.go_to(2);
  document_.mark_saved({"points"});
  EXPECT_FALSE(document_.is_modified());
  document_.go_to(3);
  EXPECT_TRUE(document_.is_modified());
  document_.go_to(2);
  EXPECT_FALSE(document_.is_modified());
  EXPECT_EQ(document_.step_count(), 3u);
}

TEST_F(Track, OtherDataHasNoTrack) {
  walk(3);
  document_.go_to(1);
  document_.replace_inputs(one_point(9), "Open nine.xy");
  EXPECT_EQ(document_.track(), nullptr);
  EXPECT_EQ(document_.position(), 0u);
  undo();
  EXPECT_EQ(document_.step_count(), 3u);
  EXPECT_EQ(document_.position(), 1u);
}

TEST_F(Track, TellsOfStepsThatAreAdded) {
  walk(1);
  document_.go_to(0);
  Document_change seen;
  QObject::connect(&document_, &Document::changed, [&](const Document_change& change) { seen = change; });
  document_.add_step(spec("Walk"), 1, {document_.track()->places.back().inputs, {}}, {one_point(2), {}}, false);
  EXPECT_TRUE(seen.track && !seen.inputs && !seen.settings && !seen.layers);
  document_.go_to(1);
  EXPECT_TRUE(seen.track && seen.inputs);
}

}  // namespace
}  // namespace mesecina

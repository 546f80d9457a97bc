// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QtTest>
#include <chrono>
#include <thread>

#include "shell/evolution_control.h"

namespace mesecina {
namespace {

using Motion = Evolution_control::Motion;
using Repeat = Evolution_control::Repeat;

double x_of(const Inputs& inputs) { return inputs.get(points_input)->front().x; }

/// Waits for so many milliseconds as the setting says; can be cancelled.
void rest(Context& context, Setting<std::int64_t> duration) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(context.setting(duration));
  while (std::chrono::steady_clock::now() < end) {
    context.progress().report(0.5);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

Evolution_spec moving(const char* id, const char* label, double step) {
  return {
      id,
      label,
      "Moves the point.",
      {"pace"},
      {},
      [step](Context& context, const Evolution_state& before, std::uint64_t) {
        rest(context, {"pace"});
        const double x = x_of(before.inputs);
        if (x >= 30) throw Unavailable("the wall is in the way");
        return Evolution_state{before.inputs.with(points_input, std::vector<Point_2>{{x + step, 0}}), before.settings};
      }};
}

/// Layers "place" and "other", which show where the point is; evolutions "walk" and "jump", which move it by 1 and 10.
std::shared_ptr<const Registry> make_registry() {
  auto registry = std::make_shared<Registry>();
  registry->begin_module({"module", "Module", ""});
  for (const char* id : {"pace", "slowness"}) {
    Setting_spec setting;
    setting.id = id;
    setting.default_value = std::int64_t{0};
    registry->add_setting(setting);
  }
  Setting_spec limit;
  limit.id = "limit";
  limit.default_value = 0.0;
  registry->add_setting(limit);
  for (const char* id : {"place", "other"}) {
    Layer_spec layer;
    layer.id = id;
    layer.label = id;
    layer.cut_value = "x";
    layer.cut_setting = "limit";
    layer.build = [](Context& context) {
      rest(context, {"slowness"});
      Primitive_set set;
      set.vertices = {{x_of({Inputs().with(points_input, context.input(points_input))}), 0, 0}};
      set.points = {0};
      return set;
    };
    registry->add_layer(layer);
  }
  registry->add_evolution(moving("walk", "Walk", 1));
  registry->add_evolution(moving("jump", "Jump", 10));
  return registry;
}

class Control : public testing::Test {
 protected:
  static Document_state start() {
    Document_state state{Inputs().with(points_input, std::vector<Point_2>{{0, 0}}), {}, {{"place", {}}, {"other", {}}}};
    state.layers[0].style.visible = true;
    state.layers[1].style.visible = false;
    return state;
  }
  static bool wait_until(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, 10000); }
  bool wait_for_steps(std::size_t count) {
    return wait_until([&] { return document_.step_count() == count && !control_.evolver().is_busy(); });
  }
  bool wait_for_pictures() {
    return wait_until([&] { return !computation_.is_busy(); });
  }
  void make_steps(int count) {
    control_.set_steps_ahead(count);
    control_.make_steps();
  }
  void set(const char* setting, std::int64_t value) {
    document_.edit_settings(document_.settings().with(setting, value), setting);
  }
  void show_other() {
    Layer_list layers = document_.layers();
    layers[1].style.visible = true;
    document_.edit_layers(layers, "Show");
  }
  double x() const { return x_of(document_.inputs()); }
  double shown(const char* layer) const {
    const auto set = computation_.primitives(layer);
    return set ? set->vertices[0].x : -1;
  }
  /// Every place is looked at until it is shown.
  void see_all() {
    for (std::size_t i = 0; i <= document_.step_count(); ++i) {
      control_.go_to(i);
      ASSERT_TRUE(wait_for_pictures());
    }
  }

  std::shared_ptr<const Registry> registry_ = make_registry();
  Document document_{start()};
  Computation computation_{registry_, document_};
  Evolution_control control_{registry_, document_, computation_};
};

TEST_F(Control, MakesStepsInTheBackgroundAndGoesAlong) {
  make_steps(5);
  EXPECT_TRUE(control_.evolver().is_busy());
  EXPECT_EQ(document_.step_count(), 0u);
  ASSERT_TRUE(wait_for_steps(5));
  EXPECT_EQ(x(), 5);
  EXPECT_EQ(document_.history().count(), 1);
  EXPECT_EQ(document_.history().undoText(), "Walk: 5 steps");
  make_steps(3);
  ASSERT_TRUE(wait_for_steps(8));
  EXPECT_EQ(document_.history().undoText(), "Walk: 8 steps");
}

TEST_F(Control, ForwardShowsTheNextStepAndMakesItAtTheEnd) {
  control_.forward();
  ASSERT_TRUE(wait_for_steps(1));
  EXPECT_EQ(document_.position(), 1u);
  control_.back();
  control_.back();
  EXPECT_EQ(document_.position(), 0u);
  control_.forward();
  EXPECT_FALSE(control_.evolver().is_busy());
  EXPECT_EQ(document_.position(), 1u);
  control_.go_by(-10);
  EXPECT_EQ(document_.position(), 0u);
  control_.go_by(10);
  EXPECT_EQ(document_.position(), 1u);
}

TEST_F(Control, SeenStepsAreShownAtOnceWithoutTheWorker) {
  make_steps(6);
  ASSERT_TRUE(wait_for_steps(6));
  see_all();
  const auto requests = computation_.requests();
  for (const std::size_t position : {0u, 5u, 2u, 6u, 1u}) {
    control_.go_to(position);
    EXPECT_EQ(shown("place"), static_cast<double>(position));
    EXPECT_EQ(computation_.status("place").state, Layer_status::State::current);
    EXPECT_FALSE(computation_.is_busy());
  }
  // Limits are no other data.
  document_.edit_settings(document_.settings().with("limit", 2.0), "Limit");
  control_.go_to(3);
  EXPECT_EQ(shown("place"), 3);
  EXPECT_EQ(computation_.requests(), requests);
  set("slowness", 1);
  EXPECT_GT(computation_.requests(), requests);
}

TEST_F(Control, TheStartIsSeenBeforeThereAreSteps) {
  ASSERT_TRUE(wait_for_pictures());
  make_steps(2);
  ASSERT_TRUE(wait_for_steps(2));
  ASSERT_TRUE(wait_for_pictures());
  const auto requests = computation_.requests();
  control_.first();
  EXPECT_EQ(shown("place"), 0);
  EXPECT_EQ(computation_.requests(), requests);
}

TEST_F(Control, ALayerSwitchedOnLaterIsComputedForTheStepThatIsShown) {
  make_steps(4);
  ASSERT_TRUE(wait_for_steps(4));
  see_all();
  control_.go_to(2);
  EXPECT_EQ(shown("other"), -1);
  show_other();
  ASSERT_TRUE(wait_for_pictures());
  EXPECT_EQ(shown("other"), 2);
  control_.go_to(3);
  EXPECT_EQ(computation_.status("other").state, Layer_status::State::stale);
  ASSERT_TRUE(wait_for_pictures());
  EXPECT_EQ(shown("other"), 3);
  const auto requests = computation_.requests();
  control_.go_to(2);
  EXPECT_EQ(shown("other"), 2);
  EXPECT_EQ(computation_.requests(), requests);
}

TEST_F(Control, PicturesKeepToTheBudget) {
  make_steps(10);
  ASSERT_TRUE(wait_for_steps(10));
  see_all();
  const std::size_t all = computation_.kept_bytes();
  ASSERT_GT(all, 0u);
  EXPECT_LE(all, computation_.kept_bytes_budget());
  computation_.set_kept_bytes_budget(all / 2);
  EXPECT_LE(computation_.kept_bytes(), all / 2);
  EXPECT_GT(computation_.kept_bytes(), all / 4);
  // The last ones that were seen are there, the first ones are computed again.
  auto requests = computation_.requests();
  control_.go_to(9);
  EXPECT_EQ(computation_.requests(), requests);
  control_.go_to(0);
  EXPECT_EQ(computation_.requests(), requests + 1);
  ASSERT_TRUE(wait_for_pictures());
  EXPECT_EQ(shown("place"), 0);
  EXPECT_LE(computation_.kept_bytes(), all / 2);
}

TEST_F(Control, CancelKeepsTheStepsThatAreThere) {
  set("pace", 30);
  make_steps(1000);
  ASSERT_TRUE(wait_until([&] { return document_.step_count() >= 2; }));
  EXPECT_TRUE(control_.stop());
  EXPECT_FALSE(control_.evolver().is_busy());
  const std::size_t there = document_.step_count();
  EXPECT_LT(there, 100u);
  QTest::qWait(150);
  EXPECT_EQ(document_.step_count(), there);
  EXPECT_FALSE(control_.stop());
  // What comes next begins where that ended.
  set("pace", 0);
  make_steps(1);
  ASSERT_TRUE(wait_for_steps(there + 1));
  EXPECT_EQ(x(), static_cast<double>(there + 1));
}

TEST_F(Control, AnEditStopsTheStepsThatAreBeingMade) {
  set("pace", 20);
  make_steps(1000);
  ASSERT_TRUE(wait_until([&] { return document_.step_count() >= 3; }));
  control_.go_to(1);
  document_.edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{100, 0}}), "Move");
  EXPECT_FALSE(control_.evolver().is_busy());
  QTest::qWait(100);
  EXPECT_EQ(document_.step_count(), 1u);
  EXPECT_EQ(x(), 100);
  document_.history().undo();
  EXPECT_GE(document_.step_count(), 3u);
  EXPECT_EQ(document_.position(), 1u);
}

TEST_F(Control, UndoStopsTheStepsThatAreBeingMade) {
  set("pace", 20);
  make_steps(1000);
  ASSERT_TRUE(wait_until([&] { return document_.step_count() >= 3; }));
  document_.history().undo();
  EXPECT_FALSE(control_.evolver().is_busy());
  QTest::qWait(100);
  EXPECT_EQ(document_.step_count(), 0u);
}

TEST_F(Control, StepsAreMadeWhileOthersAreLookedAt) {
  set("pace", 5);
  make_steps(30);
  ASSERT_TRUE(wait_until([&] { return document_.step_count() >= 4; }));
  control_.go_to(2);
  ASSERT_TRUE(wait_for_steps(30));
  EXPECT_EQ(document_.position(), 2u);
  ASSERT_TRUE(wait_for_pictures());
  EXPECT_EQ(shown("place"), 2);
}

TEST_F(Control, ANewlyChosenEvolutionGoesOnFromTheStepThatIsShown) {
  make_steps(5);
  ASSERT_TRUE(wait_for_steps(5));
  control_.go_to(2);
  control_.choose("jump");
  control_.forward();
  ASSERT_TRUE(wait_for_steps(3));
  EXPECT_EQ(x(), 12);
  // It is not new any more: forward goes through the steps that there are.
  control_.go_to(0);
  control_.forward();
  EXPECT_EQ(document_.position(), 1u);
  EXPECT_EQ(document_.step_count(), 3u);
  control_.make_steps();
  ASSERT_TRUE(wait_until([&] { return !control_.evolver().is_busy(); }));
  EXPECT_EQ(x_of(document_.track()->places[4].inputs), 22);
  document_.history().undo();
  EXPECT_EQ(x_of(document_.track()->places[5].inputs), 5);
  EXPECT_EQ(control_.chosen(), "walk");
}

TEST_F(Control, TellsWhyStepsEnd) {
  QString note;
  QObject::connect(&control_, &Evolution_control::told, [&](const QString& text) { note = text; });
  control_.choose("jump");
  make_steps(7);
  ASSERT_TRUE(wait_for_steps(3));
  EXPECT_TRUE(note.contains("Jump")) << note.toStdString();
  EXPECT_TRUE(note.contains("the wall is in the way")) << note.toStdString();
  EXPECT_TRUE(note.contains("3")) << note.toStdString();
}

TEST_F(Control, GoingToAStepPauses) {
  make_steps(5);
  ASSERT_TRUE(wait_for_steps(5));
  control_.first();
  control_.set_steps_per_second(100);
  control_.set_repeat(Evolution_control::Repeat::wrap);
  control_.play(Evolution_control::Motion::forward);
  ASSERT_TRUE(wait_until([&] { return document_.position() > 1; }));
  control_.go_to(1);
  EXPECT_FALSE(control_.is_playing());
  QTest::qWait(50);
  EXPECT_EQ(document_.position(), 1u);
}

TEST_F(Control, PlayingShowsEveryStepAndEndsAtTheLast) {
  set("slowness", 10);
  make_steps(4);
  ASSERT_TRUE(wait_for_steps(4));
  control_.first();
  control_.set_steps_per_second(1000);
  std::vector<double> seen;
  QObject::connect(&document_, &Document::changed, [&] {
    // The pictures of the step before were waited for.
    if (document_.position() > 1) {
      EXPECT_EQ(shown("place"), static_cast<double>(document_.position() - 1));
    }
    seen.push_back(x());
  });
  control_.play(Motion::forward);
  EXPECT_TRUE(control_.is_playing());
  ASSERT_TRUE(wait_until([&] { return !control_.is_playing(); }));
  EXPECT_EQ(seen, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(document_.history().count(), 2);
}

TEST_F(Control, PlayingAtTheEndMakesMoreStepsAndShowsThem) {
  control_.set_steps_ahead(3);
  control_.set_steps_per_second(1000);
  control_.play(Motion::forward);
  ASSERT_TRUE(wait_until([&] { return !control_.is_playing(); }));
  EXPECT_EQ(document_.step_count(), 3u);
  EXPECT_EQ(document_.position(), 3u);
  control_.play(Motion::backward);
  ASSERT_TRUE(wait_until([&] { return !control_.is_playing(); }));
  EXPECT_EQ(document_.position(), 0u);
  EXPECT_EQ(document_.step_count(), 3u);
}

TEST_F(Control, RepeatsARangeAgainAndAgainOrBackAndForth) {
  make_steps(6);
  ASSERT_TRUE(wait_for_steps(6));
  see_all();
  control_.set_steps_per_second(1000);
  control_.set_range(4, 2);
  control_.set_repeat(Repeat::wrap);
  control_.go_to(0);
  std::vector<double> seen;
  QObject::connect(&document_, &Document::changed, [&] {
    seen.push_back(x());
    if (seen.size() == 7) control_.pause();
  });
  control_.play(Motion::forward);
  ASSERT_TRUE(wait_until([&] { return seen.size() == 7; }));
  EXPECT_EQ(seen, (std::vector<double>{2, 3, 4, 2, 3, 4, 2}));
  seen.clear();
  control_.set_repeat(Repeat::ping_pong);
  control_.play(Motion::forward);
  ASSERT_TRUE(wait_until([&] { return seen.size() == 7; }));
  EXPECT_EQ(seen, (std::vector<double>{3, 4, 3, 2, 3, 4, 3}));
  EXPECT_FALSE(control_.is_playing());
}

TEST_F(Control, AnEditWhilePlayingPauses) {
  make_steps(6);
  ASSERT_TRUE(wait_for_steps(6));
  see_all();
  control_.set_repeat(Repeat::wrap);
  control_.set_steps_per_second(1000);
  control_.go_to(0);
  control_.play(Motion::forward);
  ASSERT_TRUE(wait_until([&] { return document_.position() == 3; }));
  document_.edit_inputs(Inputs().with(points_input, std::vector<Point_2>{{50, 0}}), "Move");
  EXPECT_FALSE(control_.is_playing());
  QTest::qWait(50);
  EXPECT_EQ(x(), 50);
  EXPECT_EQ(document_.step_count(), 3u);
}

TEST_F(Control, LooksAreEditedWhilePlaying) {
  make_steps(6);
  ASSERT_TRUE(wait_for_steps(6));
  control_.set_repeat(Repeat::wrap);
  control_.play(Motion::forward);
  Layer_list layers = document_.layers();
  layers[0].style.opacity = 0.5;
  document_.edit_layers(layers, "Opacity");
  EXPECT_TRUE(control_.is_playing());
  control_.pause();
  EXPECT_EQ(document_.step_count(), 6u);
}

TEST_F(Control, RunsOneEvolutionAfterTheOther) {
  control_.run({{"walk", 3}, {"jump", 2}, {"none", 4}, {"walk", 1}});
  ASSERT_TRUE(wait_until([&] { return document_.step_count() == 6 && !control_.evolver().is_busy(); }));
  EXPECT_EQ(x(), 24);
  EXPECT_EQ(document_.position(), 6u);
}

}  // namespace
}  // namespace mesecina

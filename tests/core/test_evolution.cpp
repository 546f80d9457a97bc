// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolution.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <variant>

#include "core/batch/command_line.h"

namespace mesecina {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Points = std::vector<Point_2>;

/// Walks one to the right per step, says of 10 that it is the end, and of 100 that it cannot.
Evolution_state walk(Context&, const Evolution_state& before, std::uint64_t step) {
  const auto points = before.inputs.get(points_input);
  if (!points) throw Unavailable("there is nobody to walk");
  const double x = points->front().x;
  if (x == 10) return before;
  if (x == 100) throw Unavailable("a wall");
  Evolution_state after = before;
  after.inputs = before.inputs.with(points_input, Points{{x + 1, static_cast<double>(step)}});
  return after;
}

Evolution_state count_down(Context& context, const Evolution_state& before, std::uint64_t) {
  Evolution_state after = before;
  after.settings = before.settings.with("left", context.setting(Setting<std::int64_t>{"left"}) - 1);
  return after;
}

std::shared_ptr<const Registry> registry() {
  auto result = std::make_shared<Registry>();
  result->begin_module({"module", "Module", ""});
  for (const auto& [id, value] : {std::pair<std::string, std::int64_t>{"left", 5}, {"evolution-seed", 0}}) {
    Setting_spec setting;
    setting.id = id;
    setting.default_value = value;
    result->add_setting(std::move(setting));
  }
  result->add_evolution({"walk", "Walk", "Goes one to the right.", {}, {}, walk});
  result->add_evolution({"count-down", "Count down", "Lowers a setting.", {"left"}, {}, count_down});
  return result;
}

Inputs at(double x) { return Inputs().with(points_input, Points{{x, 0}}); }
double place(const Graph& graph) { return graph.inputs().get(points_input)->front().x; }

TEST(Evolution, GoesTheStepsAskedForAndLeavesTheGraphAtTheLast) {
  Graph graph(registry());
  graph.set_inputs(at(0));
  Progress progress;
  std::vector<double> seen;
  const Evolution_result result = evolve(graph, "walk", 4, progress, [&](std::uint64_t step) {
    EXPECT_EQ(step, seen.size() + 1);
    EXPECT_EQ(graph.inputs().get(points_input)->front().y, static_cast<double>(step));
    seen.push_back(place(graph));
  });
  EXPECT_EQ(result.steps_done, 4u);
  EXPECT_EQ(result.end_reason, "");
  EXPECT_THAT(seen, ElementsAre(1, 2, 3, 4));
  EXPECT_EQ(place(graph), 4);
}

TEST(Evolution, ChangesSettingsToo) {
  Graph graph(registry());
  Progress progress;
  EXPECT_EQ(evolve(graph, "count-down", 3, progress).steps_done, 3u);
  EXPECT_EQ(std::get<std::int64_t>(*graph.settings().find("left")), 2);
}

TEST(Evolution, EndsWhereNothingChangesOrNothingCanBeDone) {
  Graph graph(registry());
  Progress progress;
  graph.set_inputs(at(8));
  const Evolution_result still = evolve(graph, "walk", 20, progress);
  EXPECT_EQ(still.steps_done, 2u);
  EXPECT_EQ(still.end_reason, "nothing changes any more");
  graph.set_inputs(at(98));
  const Evolution_result stopped = evolve(graph, "walk", 20, progress);
  EXPECT_EQ(stopped.steps_done, 2u);
  EXPECT_EQ(stopped.end_reason, "a wall");
  EXPECT_EQ(place(graph), 100);
  graph.set_inputs({});
  EXPECT_EQ(evolve(graph, "walk", 20, progress).end_reason, "there is nobody to walk");
  EXPECT_THROW(evolve(graph, "run", 1, progress), std::out_of_range);
}

TEST(Evolution, LoopGoesOnFromASteppedState) {
  Graph graph(registry());
  graph.set_inputs(at(5));
  Evolution_loop loop(graph, "walk", 5);
  Progress progress;
  ASSERT_TRUE(loop.advance(progress));
  EXPECT_EQ(loop.steps_done(), 6u);
  EXPECT_EQ(graph.inputs().get(points_input)->front().y, 6);
  graph.set_inputs(at(10));
  EXPECT_FALSE(loop.advance(progress));
  EXPECT_NE(loop.end_reason(), "");
  graph.set_inputs(at(11));
  EXPECT_TRUE(loop.advance(progress));
  EXPECT_EQ(loop.end_reason(), "");
  EXPECT_THROW(Evolution_loop(graph, "run"), std::out_of_range);
}

TEST(Evolution, CancellingLeavesTheGraphInTheLastStateThatWasReached) {
  Graph graph(registry());
  graph.set_inputs(at(0));
  std::stop_source stop;
  Progress progress(stop.get_token());
  EXPECT_THROW(evolve(graph, "walk", 9, progress,
                      [&](std::uint64_t step) {
                        if (step == 3) stop.request_stop();
                      }),
               Cancelled);
  EXPECT_EQ(place(graph), 3);
}

std::variant<Command_line, Early_exit> parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "program");
  return parse_command_line(static_cast<int>(arguments.size()), arguments.data(), "program", *registry(),
                            planar_formats(), {});
}

TEST(Evolution, CommandLineTellsWhichInWhichOrder) {
  const auto parsed = parse({"a.xy", "--evolve", "walk=3", "--evolve", "count-down=2", "--evolve", "walk=1"});
  ASSERT_TRUE(std::holds_alternative<Command_line>(parsed)) << std::get<Early_exit>(parsed).text;
  EXPECT_THAT(std::get<Command_line>(parsed).evolutions,
              ElementsAre(Evolution_order{"walk", 3}, Evolution_order{"count-down", 2}, Evolution_order{"walk", 1}));
}

TEST(Evolution, CommandLineRefusesWhatIsNone) {
  const auto refusal = [](const char* order) {
    const auto parsed = parse({"a.xy", "--evolve", order});
    EXPECT_TRUE(std::holds_alternative<Early_exit>(parsed)) << order;
    if (!std::holds_alternative<Early_exit>(parsed)) return std::string();
    EXPECT_EQ(std::get<Early_exit>(parsed).code, exit_wrong_usage);
    return std::get<Early_exit>(parsed).text;
  };
  EXPECT_THAT(refusal("walk"), HasSubstr("expected ID=STEPS"));
  EXPECT_THAT(refusal("wlak=3"), HasSubstr("unknown evolution 'wlak'; did you mean 'walk'?"));
  EXPECT_THAT(refusal("something-else=3"), HasSubstr("--list evolutions"));
  for (const char* order : {"walk=0", "walk=-1", "walk=1.5", "walk=many", "walk=", "walk=1e10"})
    EXPECT_THAT(refusal(order), HasSubstr("expected a number of steps")) << order;
}

TEST(Evolution, SeedOfTheCommandLineIsThatOfEvolutionsUnlessOneIsSet) {
  const auto seed = [](std::vector<const char*> arguments) {
    arguments.push_back("a.xy");
    const auto parsed = parse(std::move(arguments));
    const Setting_value* value = std::get<Command_line>(parsed).settings.find("evolution-seed");
    return value ? std::get<std::int64_t>(*value) : -1;
  };
  EXPECT_EQ(seed({"--seed", "7"}), 7);
  EXPECT_EQ(seed({"--seed", "7", "--set", "evolution-seed=8"}), 8);
  EXPECT_EQ(seed({}), -1);
}

}  // namespace
}  // namespace mesecina

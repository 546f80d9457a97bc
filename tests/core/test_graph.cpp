// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "core/graph.h"

namespace mesecina {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Points = std::vector<Point_2>;

constexpr Key<double> sum_key{"sum"};
constexpr Key<double> product_key{"product"};
constexpr Key<int> choice_key{"choice"};
constexpr Key<Points> copy_key{"copy"};
constexpr Setting<bool> use_factor{"use-factor"};
constexpr Setting<double> factor{"factor"};

Setting_spec setting(std::string id, Setting_value value) {
  Setting_spec spec;
  spec.id = std::move(id);
  spec.default_value = std::move(value);
  return spec;
}

Layer_spec layer(std::string id, std::function<Primitive_set(Context&)> build) {
  Layer_spec spec;
  spec.id = std::move(id);
  spec.build = std::move(build);
  return spec;
}

Primitive_set one_point(double x) {
  Primitive_set set;
  set.vertices = {{x, 0, 0}};
  set.points = {0};
  return set;
}

Inputs with_points(Points points) { return Inputs{}.with(points_input, std::move(points)); }

/// A registry that a test fills, and then the graph over it.
class Graph_test : public testing::Test {
 protected:
  Graph_test() {
    registry_->begin_module({"module", "Module", ""});
    registry_->add_setting(setting("use-factor", false));
    registry_->add_setting(setting("factor", 2.0));
  }
  Graph& graph() {
    if (!graph_) graph_ = std::make_unique<Graph>(registry_);
    return *graph_;
  }
  template <class T>
  Outcome<T> get(Key<T> key) {
    Progress progress;
    return graph().structure(key, progress);
  }
  Outcome<Primitive_set> get_layer(std::string_view id) {
    Progress progress;
    return graph().layer(id, progress);
  }
  /// The sum of the x of all points, and the product of that with a factor where it is switched on.
  void add_sum_and_product() {
    registry_->add_structure<double>(sum_key, [](Context& context) {
      const auto points = context.input(points_input);
      if (!points) throw Unavailable("needs points");
      return std::accumulate(points->begin(), points->end(), 0.0,
                             [](double sum, const Point_2& p) { return sum + p.x; });
    });
    registry_->add_structure<double>(product_key, [](Context& context) {
      const double sum = *context.get(sum_key);
      return context.setting(use_factor) ? sum * context.setting(factor) : sum;
    });
    registry_->add_layer(layer("view", [](Context& context) { return one_point(*context.get(product_key)); }));
  }

  std::shared_ptr<Registry> registry_ = std::make_shared<Registry>();
  std::unique_ptr<Graph> graph_;
};

TEST_F(Graph_test, computes_nothing_until_asked) {
  add_sum_and_product();
  graph().set_inputs(with_points({{1, 0}, {2, 0}}));
  EXPECT_EQ(graph().computations("sum"), 0U);
  EXPECT_FALSE(graph().is_current("view"));
  EXPECT_EQ(*get(sum_key).value, 3);
  EXPECT_EQ(graph().computations("sum"), 1U);
  EXPECT_EQ(graph().computations("product"), 0U);
  EXPECT_EQ(get_layer("view").value->vertices[0].x, 3);
  EXPECT_TRUE(graph().is_current("view"));
  EXPECT_EQ(get_layer("view").value->vertices[0].x, 3);
  EXPECT_EQ(graph().computations("sum"), 1U);
  EXPECT_EQ(graph().computations("product"), 1U);
  EXPECT_EQ(graph().computations("view"), 1U);
}

TEST_F(Graph_test, setting_matters_only_where_it_was_read) {
  add_sum_and_product();
  graph().set_inputs(with_points({{1, 0}, {2, 0}}));
  EXPECT_EQ(*get(product_key).value, 3);
  // Not read while the switch is off.
  graph().set_settings(Settings{}.with("factor", 5.0));
  EXPECT_EQ(*get(product_key).value, 3);
  EXPECT_EQ(graph().computations("product"), 1U);
  graph().set_settings(Settings{}.with("factor", 5.0).with("use-factor", true));
  EXPECT_EQ(*get(product_key).value, 15);
  EXPECT_EQ(graph().computations("product"), 2U);
  graph().set_settings(Settings{}.with("factor", 7.0).with("use-factor", true));
  EXPECT_EQ(*get(product_key).value, 21);
  graph().set_settings(Settings{}.with("factor", 7.0));
  EXPECT_EQ(*get(product_key).value, 3);
  graph().set_settings(Settings{}.with("factor", 8.0));
  EXPECT_EQ(*get(product_key).value, 3);
  EXPECT_EQ(graph().computations("product"), 4U);
  EXPECT_EQ(graph().computations("sum"), 1U);
}

TEST_F(Graph_test, setting_equal_to_its_default_changes_nothing) {
  add_sum_and_product();
  graph().set_inputs(with_points({{1, 0}}));
  graph().set_settings(Settings{}.with("use-factor", true));
  EXPECT_EQ(*get(product_key).value, 2);
  graph().set_settings(Settings{}.with("use-factor", true).with("factor", 2.0));
  EXPECT_EQ(*get(product_key).value, 2);
  graph().set_settings(Settings{}.with("use-factor", true));
  EXPECT_EQ(*get(product_key).value, 2);
  EXPECT_EQ(graph().computations("product"), 1U);
}

TEST_F(Graph_test, only_changed_inputs_count) {
  registry_->add_structure<double>(sum_key, [](Context& context) {
    const auto points = context.input(points_input);
    return points ? static_cast<double>(points->size()) : -1;
  });
  EXPECT_EQ(*get(sum_key).value, -1);
  graph().set_inputs(Inputs{}.with(disks_input, std::vector<Disk_2>{{}}));
  EXPECT_EQ(*get(sum_key).value, -1);
  EXPECT_EQ(graph().computations("sum"), 1U);
  const Inputs two = graph().inputs().with(points_input, Points(2));
  graph().set_inputs(two);
  EXPECT_EQ(*get(sum_key).value, 2);
  graph().set_inputs(two.with(disks_input, std::shared_ptr<const std::vector<Disk_2>>{}));
  EXPECT_EQ(*get(sum_key).value, 2);
  EXPECT_EQ(graph().computations("sum"), 2U);
  graph().set_inputs({});
  EXPECT_EQ(*get(sum_key).value, -1);
  EXPECT_EQ(graph().computations("sum"), 3U);
}

TEST_F(Graph_test, structure_that_is_no_longer_read_does_not_matter) {
  registry_->add_structure<double>(sum_key, [](Context& context) {
    const auto points = context.input(points_input);
    return static_cast<double>(points ? points->size() : 0);
  });
  registry_->add_structure<int>(choice_key, [](Context& context) {
    return context.setting(use_factor) ? static_cast<int>(*context.get(sum_key)) : 77;
  });
  graph().set_settings(Settings{}.with("use-factor", true));
  EXPECT_EQ(*get(choice_key).value, 0);
  graph().set_settings({});
  graph().set_inputs(with_points(Points(3)));
  EXPECT_EQ(*get(choice_key).value, 77);
  // The setting was read first and has changed, so the sum is not even looked at.
  EXPECT_EQ(graph().computations("sum"), 1U);
  graph().set_inputs(with_points(Points(4)));
  EXPECT_EQ(*get(choice_key).value, 77);
  EXPECT_EQ(graph().computations("choice"), 2U);
  EXPECT_EQ(graph().computations("sum"), 1U);
}

TEST_F(Graph_test, failure_is_kept_with_its_reason_and_reaches_dependents) {
  add_sum_and_product();
  const Outcome<Primitive_set> first = get_layer("view");
  EXPECT_FALSE(first);
  EXPECT_EQ(first.value, nullptr);
  EXPECT_EQ(first.reason, "needs points");
  EXPECT_EQ(get(sum_key).reason, "needs points");
  EXPECT_EQ(get(product_key).reason, "needs points");
  graph().set_settings(Settings{}.with("factor", 9.0));
  EXPECT_EQ(get_layer("view").reason, "needs points");
  for (const char* id : {"sum", "product", "view"}) EXPECT_EQ(graph().computations(id), 1U) << id;
  EXPECT_TRUE(graph().is_current("view"));
  graph().set_inputs(with_points({{4, 0}}));
  EXPECT_FALSE(graph().is_current("view"));
  const Outcome<Primitive_set> second = get_layer("view");
  ASSERT_TRUE(second);
  EXPECT_TRUE(second.reason.empty());
  EXPECT_EQ(second.value->vertices[0].x, 4);
  graph().set_inputs({});
  EXPECT_EQ(get_layer("view").reason, "needs points");
}

TEST_F(Graph_test, other_exceptions_become_reasons) {
  registry_->add_structure<double>(sum_key, [](Context&) -> double { throw std::runtime_error("index 7"); });
  registry_->add_structure<double>(product_key, [](Context&) -> double { throw std::bad_alloc(); });
  EXPECT_THAT(get(sum_key).reason, HasSubstr("index 7"));
  EXPECT_FALSE(get(product_key).reason.empty());
}

TEST_F(Graph_test, dependent_may_go_without_what_is_unavailable) {
  add_sum_and_product();
  registry_->add_structure<int>(choice_key, [](Context& context) {
    try {
      return static_cast<int>(*context.get(sum_key));
    } catch (const Unavailable&) {
      return -1;
    }
  });
  EXPECT_EQ(*get(choice_key).value, -1);
  graph().set_inputs(with_points({{5, 0}}));
  EXPECT_EQ(*get(choice_key).value, 5);
}

TEST_F(Graph_test, circle_of_structures_has_a_reason) {
  registry_->add_structure<double>(sum_key, [](Context& context) { return *context.get(product_key) + 1; });
  registry_->add_structure<double>(product_key, [](Context& context) { return *context.get(sum_key) * 2; });
  registry_->add_structure<int>(choice_key, [](Context& context) { return *context.get(choice_key); });
  for (int round = 0; round < 3; ++round) {
    EXPECT_FALSE(get(sum_key).reason.empty());
    EXPECT_FALSE(get(product_key).reason.empty());
    EXPECT_FALSE(get(choice_key).reason.empty());
    graph().set_inputs(with_points(Points(round)));
    graph().set_settings(Settings{}.with("factor", 1.0 * round));
  }
}

TEST_F(Graph_test, circle_may_open_when_a_setting_changes) {
  registry_->add_structure<double>(sum_key, [](Context& context) { return *context.get(product_key) + 1; });
  registry_->add_structure<double>(
      product_key, [](Context& context) { return context.setting(use_factor) ? 5.0 : *context.get(sum_key); });
  EXPECT_FALSE(get(sum_key).reason.empty());
  graph().set_settings(Settings{}.with("use-factor", true));
  ASSERT_TRUE(get(sum_key));
  EXPECT_EQ(*get(sum_key).value, 6);
  graph().set_settings({});
  EXPECT_FALSE(get(sum_key).reason.empty());
}

TEST_F(Graph_test, unknown_names) {
  EXPECT_THROW(get_layer("nothing"), std::out_of_range);
  Progress progress;
  EXPECT_THROW(graph().describe("nothing", 0, progress), std::out_of_range);
  EXPECT_EQ(graph().computations("nothing"), 0U);
  EXPECT_TRUE(graph().warnings("nothing").empty());
  EXPECT_FALSE(graph().is_current("nothing"));
  registry_->add_structure<double>(sum_key, [](Context& context) { return *context.get(product_key); });
  EXPECT_THAT(get(sum_key).reason, HasSubstr("product"));
}

TEST_F(Graph_test, structure_asked_for_under_another_type_has_a_reason) {
  registry_->add_structure<double>(sum_key, [](Context&) { return 1.0; });
  registry_->add_structure<int>(choice_key, [](Context& context) { return *context.get(Key<int>{"sum"}); });
  EXPECT_THAT(get(choice_key).reason, HasSubstr("sum"));
}

TEST_F(Graph_test, cancelling_is_quick_and_keeps_what_is_complete) {
  bool slow = true;
  registry_->add_structure<double>(sum_key, [](Context&) { return 1.0; });
  registry_->add_structure<double>(product_key, [&](Context& context) {
    const double sum = *context.get(sum_key);
    while (slow) {
      context.progress().report(0.5);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return sum;
  });
  registry_->add_layer(layer("view", [](Context& context) { return one_point(*context.get(product_key)); }));
  graph();
  std::stop_source source;
  std::chrono::steady_clock::time_point stopped;
  std::jthread stopper([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stopped = std::chrono::steady_clock::now();
    source.request_stop();
  });
  Progress progress(source.get_token());
  EXPECT_THROW(graph().layer("view", progress), Cancelled);
  const auto ended = std::chrono::steady_clock::now();
  stopper.join();
  EXPECT_LT(std::chrono::duration<double>(ended - stopped).count(), 0.1);
  EXPECT_EQ(graph().computations("sum"), 1U);
  EXPECT_EQ(graph().computations("product"), 0U);
  EXPECT_FALSE(graph().is_current("view"));
  slow = false;
  EXPECT_EQ(get_layer("view").value->vertices[0].x, 1);
  EXPECT_EQ(graph().computations("sum"), 1U);
}

TEST_F(Graph_test, cancelled_update_starts_afresh) {
  registry_->add_structure<Points>(
      copy_key, [](Context& context) { return *context.input(points_input); },
      [](Context& context, std::shared_ptr<Points> previous) {
        *previous = {{-1, -1}};  // half way
        context.progress().check();
        *previous = *context.input(points_input);
        return previous;
      });
  graph().set_inputs(with_points({{1, 1}}));
  EXPECT_EQ(*get(copy_key).value, (Points{{1, 1}}));
  graph().set_inputs(with_points({{2, 2}}));
  std::stop_source source;
  source.request_stop();
  Progress progress(source.get_token());
  EXPECT_THROW(graph().structure(copy_key, progress), Cancelled);
  EXPECT_EQ(*get(copy_key).value, (Points{{2, 2}}));
  graph().set_inputs(with_points({{3, 3}}));
  EXPECT_EQ(*get(copy_key).value, (Points{{3, 3}}));
}

TEST_F(Graph_test, update_gets_the_only_reference_to_the_previous_value) {
  std::vector<long> references;
  std::vector<Points> previous_values;
  registry_->add_structure<Points>(
      copy_key, [](Context& context) { return *context.input(points_input); },
      [&](Context& context, std::shared_ptr<Points> previous) {
        references.push_back(previous.use_count());
        previous_values.push_back(*previous);
        return std::make_shared<Points>(*context.input(points_input));
      });
  registry_->add_layer(layer("view", [](Context& context) { return one_point(context.get(copy_key)->front().x); }));
  graph().set_inputs(with_points({{1, 0}}));
  EXPECT_EQ(get_layer("view").value->vertices[0].x, 1);
  graph().set_inputs(with_points({{2, 0}}));
  EXPECT_EQ(get_layer("view").value->vertices[0].x, 2);
  EXPECT_THAT(references, ElementsAre(1));
  EXPECT_THAT(previous_values, ElementsAre(Points{{1, 0}}));
  // Somebody else holds the value: he keeps it.
  const Outcome<Points> held = get(copy_key);
  graph().set_inputs(with_points({{3, 0}}));
  EXPECT_EQ(get_layer("view").value->vertices[0].x, 3);
  EXPECT_EQ(*held.value, (Points{{2, 0}}));
  EXPECT_THAT(references, ElementsAre(1, 2));
  std::vector<bool> updated;
  for (const Graph::Stage& stage : graph().stages())
    if (stage.id == "copy") updated.push_back(stage.updated);
  EXPECT_THAT(updated, ElementsAre(false, true, true));
  EXPECT_EQ(graph().computations("copy"), 3U);
}

TEST_F(Graph_test, update_is_not_used_after_a_failure) {
  int updates = 0;
  registry_->add_structure<Points>(
      copy_key,
      [](Context& context) {
        const auto points = context.input(points_input);
        if (!points) throw Unavailable("needs points");
        return *points;
      },
      [&](Context& context, std::shared_ptr<Points> previous) {
        ++updates;
        const auto points = context.input(points_input);
        if (!points) throw Unavailable("needs points");
        *previous = *points;
        return previous;
      });
  graph().set_inputs(with_points({{1, 0}}));
  EXPECT_TRUE(get(copy_key));
  graph().set_inputs({});
  EXPECT_EQ(get(copy_key).reason, "needs points");
  EXPECT_EQ(updates, 1);
  graph().set_inputs(with_points({{2, 0}}));
  EXPECT_EQ(*get(copy_key).value, (Points{{2, 0}}));
  EXPECT_EQ(updates, 1);
}

TEST_F(Graph_test, stages_tell_what_ran_in_which_order_and_for_how_long) {
  registry_->add_structure<double>(sum_key, [](Context&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    return 1.0;
  });
  registry_->add_structure<double>(product_key, [](Context& context) { return *context.get(sum_key); });
  get(product_key);
  ASSERT_EQ(graph().stages().size(), 2U);
  EXPECT_EQ(graph().stages()[0].id, "sum");
  EXPECT_EQ(graph().stages()[1].id, "product");
  EXPECT_GE(graph().stages()[0].seconds, 0.05);
  EXPECT_LT(graph().stages()[1].seconds, 0.05);
  graph().clear_stages();
  get(product_key);
  EXPECT_TRUE(graph().stages().empty());
}

TEST_F(Graph_test, progress_names_the_stage) {
  add_sum_and_product();
  graph().set_inputs(with_points({{1, 0}}));
  std::vector<std::string> stages;
  Progress progress({}, [&](std::string_view stage, double) { stages.emplace_back(stage); });
  graph().layer("view", progress);
  // Once it has what it asked for, it is again the one that works.
  EXPECT_THAT(stages, ElementsAre("layer:view", "product", "sum", "product", "layer:view"));
}

TEST_F(Graph_test, warnings_of_everything_below_are_collected_once) {
  registry_->add_structure<double>(sum_key, [](Context& context) {
    context.warn("low");
    return 1.0;
  });
  registry_->add_structure<double>(product_key, [](Context& context) {
    context.warn("middle");
    context.warn("low");
    if (context.setting(use_factor)) context.warn("factor");
    return *context.get(sum_key);
  });
  registry_->add_layer(layer("view", [](Context& context) {
    context.warn("high");
    return one_point(*context.get(sum_key) + *context.get(product_key));
  }));
  registry_->add_layer(layer("other", [](Context& context) { return one_point(*context.get(sum_key)); }));
  EXPECT_THAT(graph().warnings("view"), IsEmpty());
  get_layer("view");
  get_layer("other");
  EXPECT_THAT(graph().warnings("view"), testing::UnorderedElementsAre("low", "middle", "high"));
  EXPECT_THAT(graph().warnings("other"), ElementsAre("low"));
  graph().set_settings(Settings{}.with("use-factor", true));
  get_layer("view");
  EXPECT_THAT(graph().warnings("view"), testing::UnorderedElementsAre("low", "middle", "high", "factor"));
  graph().set_settings({});
  get_layer("view");
  EXPECT_THAT(graph().warnings("view"), testing::UnorderedElementsAre("low", "middle", "high"));
}

TEST_F(Graph_test, describe_reads_structures) {
  add_sum_and_product();
  Layer_spec spec = layer("described", [](Context&) { return one_point(1); });
  spec.describe = [](Context& context, std::size_t element) {
    return Element_description{{{"sum", std::to_string(static_cast<int>(*context.get(sum_key) + element))}},
                               one_point(8)};
  };
  registry_->add_layer(spec);
  Progress progress;
  EXPECT_THAT(graph().describe("described", 0, progress).facts, IsEmpty());
  graph().set_inputs(with_points({{5, 0}}));
  const Element_description description = graph().describe("described", 2, progress);
  ASSERT_EQ(description.facts.size(), 1U);
  EXPECT_EQ(description.facts[0].text, "7");
  EXPECT_EQ(description.dual.vertices.at(0).x, 8);
}

TEST_F(Graph_test, describing_does_not_change_what_a_layer_depends_on) {
  add_sum_and_product();
  Layer_spec spec = layer("described", [](Context&) { return one_point(1); });
  spec.describe = [](Context& context, std::size_t) {
    return Element_description{{{"factor", std::to_string(context.setting(factor))}}, {}};
  };
  registry_->add_layer(spec);
  get_layer("described");
  Progress progress;
  graph().describe("described", 0, progress);
  graph().set_settings(Settings{}.with("factor", 3.0));
  EXPECT_TRUE(graph().is_current("described"));
}

TEST_F(Graph_test, change_while_nobody_asked_is_noticed_later) {
  add_sum_and_product();
  graph().set_inputs(with_points({{1, 0}}));
  get_layer("view");
  graph().set_inputs(with_points({{2, 0}}));
  graph().set_settings(Settings{}.with("use-factor", true));
  // Only a part of what the layer rests on is refreshed in between.
  EXPECT_EQ(*get(sum_key).value, 2);
  EXPECT_FALSE(graph().is_current("view"));
  graph().set_settings({});
  EXPECT_EQ(get_layer("view").value->vertices[0].x, 2);
  EXPECT_EQ(graph().computations("sum"), 2U);
}

TEST_F(Graph_test, a_step_of_an_evolution_reads_structures_and_changes_nothing) {
  add_sum_and_product();
  registry_->add_evolution(
      {"shift", "Shift", "", {"factor"}, {}, [](Context& context, const Evolution_state& before, std::uint64_t step) {
         const double sum = *context.get(sum_key);
         Evolution_state after = before;
         after.inputs = before.inputs.with(points_input, Points{{sum + double(step), 0}});
         after.settings = before.settings.with("factor", context.setting(factor) + 1);
         return after;
       }});
  graph().set_inputs(with_points({{1, 0}, {2, 0}}));
  Progress progress;
  const auto after = graph().evolve("shift", 4, progress);
  ASSERT_TRUE(after);
  EXPECT_EQ(after.value->inputs.get(points_input)->front().x, 7);
  EXPECT_EQ(std::get<double>(*after.value->settings.find("factor")), 3);
  EXPECT_EQ(graph().inputs().get(points_input)->size(), 2U);
  EXPECT_TRUE(graph().settings().changed().empty());
}

TEST_F(Graph_test, a_step_that_cannot_be_done_says_why) {
  registry_->add_evolution(
      {"none", "None", "", {}, {}, [](Context&, const Evolution_state&, std::uint64_t) -> Evolution_state {
         throw Unavailable("there are no points");
       }});
  registry_->add_evolution(
      {"broken", "Broken", "", {}, {}, [](Context&, const Evolution_state&, std::uint64_t) -> Evolution_state {
         throw std::runtime_error("oops");
       }});
  Progress progress;
  EXPECT_EQ(graph().evolve("none", 1, progress).reason, "there are no points");
  EXPECT_EQ(graph().evolve("broken", 1, progress).reason, "internal error in 'broken': oops");
  Evolution_spec choosy = *registry_->find_evolution("broken");
  choosy.id = "choosy";
  choosy.needs = {"points", [](const Evolution_state& state) {
                    return state.inputs.get(points_input) ? "" : "draw some points first";
                  }};
  registry_->add_evolution(choosy);
  EXPECT_EQ(graph().evolve("choosy", 1, progress).reason, "draw some points first");
  graph().set_inputs(with_points({{1, 0}}));
  EXPECT_EQ(graph().evolve("choosy", 1, progress).reason, "internal error in 'choosy': oops");
  EXPECT_THROW(graph().evolve("missing", 1, progress), std::out_of_range);
  EXPECT_EQ(registry_->module_of("none")->id, "module");
}

}  // namespace
}  // namespace mesecina

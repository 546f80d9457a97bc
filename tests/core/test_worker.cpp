// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "core/worker.h"

namespace mesecina {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr Setting<std::int64_t> duration{"duration"};

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Layers that take as many milliseconds as the setting says.
std::shared_ptr<const Registry> slow_registry() {
  auto registry = std::make_shared<Registry>();
  registry->begin_module({"module", "Module", ""});
  Setting_spec setting;
  setting.id = "duration";
  setting.default_value = std::int64_t{0};
  registry->add_setting(setting);
  for (const char* id : {"slow", "second"}) {
    Layer_spec layer;
    layer.id = id;
    layer.build = [](Context& context) {
      const auto points = context.input(points_input);
      const auto start = Clock::now();
      while (seconds_since(start) < 1e-3 * static_cast<double>(context.setting(duration))) {
        context.progress().report(0.5);
        std::this_thread::sleep_for(milliseconds(1));
      }
      Primitive_set set;
      set.vertices = {{points ? points->at(0).x : -1, 0, 0}};
      set.points = {0};
      context.warn("slept");
      return set;
    };
    layer.describe = [](Context& context, std::size_t element) {
      const auto points = context.input(points_input);
      return Element_description{{{"x", std::to_string(points->at(element).x)}}, {}};
    };
    registry->add_layer(layer);
  }
  Layer_spec failing;
  failing.id = "failing";
  failing.build = [](Context&) -> Primitive_set { throw Unavailable("never there"); };
  registry->add_layer(failing);
  Evolution_spec walk;
  walk.id = "walk";
  walk.step = [](Context& context, const Evolution_state& before, std::uint64_t step) {
    const auto start = Clock::now();
    while (seconds_since(start) < 1e-3 * static_cast<double>(context.setting(duration))) {
      context.progress().report(0.5);
      std::this_thread::sleep_for(milliseconds(1));
    }
    const double x = before.inputs.get(points_input)->at(0).x;
    if (x >= 10) throw Unavailable("the wall");
    if (x >= 5 && x < 6) return before;
    const std::vector<Point_2> there{{x + 1, static_cast<double>(step)}};
    return Evolution_state{before.inputs.with(points_input, there), before.settings};
  };
  registry->add_evolution(walk);
  return registry;
}

/// The owner's thread is the test's: closures wait in a queue until the test runs them.
class Worker_test : public testing::Test {
 protected:
  void start(double patience = 0.1) {
    Worker::Listener listener;
    listener.started = [this](std::uint64_t, const std::string& layer) {
      EXPECT_EQ(std::this_thread::get_id(), owner_);
      started_.push_back(layer);
    };
    listener.progressed = [this](std::uint64_t, const std::string&, double) { ++progressed_; };
    listener.finished_layer = [this](Worker::Layer_result result) { results_.push_back(std::move(result)); };
    listener.finished_step = [this](Worker::Step_result result) { steps_.push_back(std::move(result)); };
    listener.finished = [this](std::uint64_t ticket, bool completed) { finished_.push_back({ticket, completed}); };
    worker_ = std::make_unique<Worker>(
        slow_registry(), 1, listener,
        [this](std::function<void()> closure) {
          const std::lock_guard lock(mutex_);
          queue_.push_back(std::move(closure));
          wake_.notify_all();
        },
        patience);
  }
  void request(std::uint64_t ticket, int duration_in_milliseconds, std::vector<std::string> layers = {"slow"}) {
    const double x = static_cast<double>(ticket);
    worker_->request({ticket, Inputs{}.with(points_input, std::vector<Point_2>{{x, 0}}),
                      Settings{}.with("duration", std::int64_t{duration_in_milliseconds}), std::move(layers)});
  }
  void evolve(std::uint64_t ticket, double x, std::uint64_t steps, int duration_in_milliseconds = 0,
              const std::string& evolution = "walk") {
    worker_->evolve({ticket,
                     {Inputs{}.with(points_input, std::vector<Point_2>{{x, 0}}),
                      Settings{}.with("duration", std::int64_t{duration_in_milliseconds})},
                     evolution,
                     2,
                     steps});
  }
  /// Runs closures until the condition holds; false after `limit` seconds.
  bool run_until(const std::function<bool()>& condition, double limit = 5) {
    const auto begin = Clock::now();
    while (!condition()) {
      std::function<void()> closure;
      {
        std::unique_lock lock(mutex_);
        if (seconds_since(begin) > limit) return false;
        if (!wake_.wait_for(lock, milliseconds(20), [&] { return !queue_.empty(); })) continue;
        closure = std::move(queue_.front());
        queue_.pop_front();
      }
      closure();
    }
    return true;
  }
  bool run_until_finished(std::uint64_t ticket, double limit = 5) {
    return run_until([&] { return std::ranges::find(finished_, ticket, &Finished::ticket) != finished_.end(); }, limit);
  }
  void run_for(double seconds) {
    run_until([] { return false; }, seconds);
  }

  struct Finished {
    std::uint64_t ticket;
    bool completed;
  };
  const std::thread::id owner_ = std::this_thread::get_id();
  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> queue_;
  std::vector<std::string> started_;
  std::vector<Worker::Layer_result> results_;
  std::vector<Worker::Step_result> steps_;
  std::vector<Finished> finished_;
  int progressed_ = 0;
  std::unique_ptr<Worker> worker_;
};

TEST_F(Worker_test, delivers_every_layer_in_order_with_its_outcome) {
  start();
  request(7, 60, {"second", "failing", "slow"});
  ASSERT_TRUE(run_until_finished(7));
  EXPECT_THAT(started_, testing::ElementsAre("second", "failing", "slow"));
  ASSERT_EQ(results_.size(), 3U);
  EXPECT_EQ(results_[0].layer, "second");
  EXPECT_EQ(results_[0].ticket, 7U);
  ASSERT_TRUE(results_[0].outcome);
  EXPECT_EQ(results_[0].outcome.value->vertices[0].x, 7);
  EXPECT_THAT(results_[0].remarks, testing::ElementsAre(Remark{"slept"}));
  EXPECT_GE(results_[0].seconds, 0.05);
  EXPECT_EQ(results_[1].outcome.reason, "never there");
  EXPECT_TRUE(finished_[0].completed);
  EXPECT_GT(progressed_, 0);
}

TEST_F(Worker_test, last_of_many_quick_requests_is_delivered) {
  start();
  for (int round = 0; round < 5; ++round) {
    finished_.clear();
    results_.clear();
    for (std::uint64_t ticket = 1; ticket <= 100; ++ticket) request(100 * round + ticket, ticket % 3 ? 0 : 3);
    const std::uint64_t last = 100 * round + 100;
    ASSERT_TRUE(run_until_finished(last));
    EXPECT_TRUE(finished_.back().completed);
    ASSERT_FALSE(results_.empty());
    EXPECT_EQ(results_.back().ticket, last);
    EXPECT_EQ(results_.back().outcome.value->vertices[0].x, static_cast<double>(last));
    for (std::size_t i = 1; i < results_.size(); ++i) EXPECT_LT(results_[i - 1].ticket, results_[i].ticket);
  }
}

TEST_F(Worker_test, newest_waiting_request_replaces_older_ones) {
  start(10);
  request(1, 200);
  run_for(0.05);
  for (std::uint64_t ticket = 2; ticket <= 9; ++ticket) request(ticket, 0);
  ASSERT_TRUE(run_until_finished(9));
  std::vector<std::uint64_t> computed;
  for (const auto& result : results_) computed.push_back(result.ticket);
  EXPECT_THAT(computed, testing::ElementsAre(1, 9));
}

TEST_F(Worker_test, steady_stream_of_edits_shows_results) {
  start(0.1);
  // Each computation takes longer than the time between edits, and longer than the patience.
  std::uint64_t ticket = 0;
  const auto begin = Clock::now();
  while (seconds_since(begin) < 3) {
    request(++ticket, 250);
    run_for(0.02);
  }
  EXPECT_GE(results_.size(), 2U);
  ASSERT_TRUE(run_until_finished(ticket));
  EXPECT_EQ(results_.back().ticket, ticket);
}

TEST_F(Worker_test, steady_stream_of_quick_computations_shows_most_of_them) {
  start(0.1);
  std::uint64_t ticket = 0;
  const auto begin = Clock::now();
  while (seconds_since(begin) < 1) {
    request(++ticket, 10);
    run_for(0.03);
  }
  EXPECT_GE(results_.size(), ticket / 2);
}

TEST_F(Worker_test, long_computation_gives_way_to_a_later_request) {
  start(0.1);
  request(1, 20000);
  run_for(0.3);
  request(2, 0);
  ASSERT_TRUE(run_until_finished(2, 1));
  ASSERT_EQ(finished_.size(), 2U);
  EXPECT_EQ(finished_[0].ticket, 1U);
  EXPECT_FALSE(finished_[0].completed);
  EXPECT_TRUE(finished_[1].completed);
}

TEST_F(Worker_test, long_computation_gives_way_even_to_a_request_made_at_once) {
  start(0.1);
  request(1, 20000);
  run_for(0.03);
  request(2, 0);
  // Nobody asks again: the patience alone must end the first one.
  EXPECT_TRUE(run_until_finished(2, 2));
}

TEST_F(Worker_test, cancel_drops_the_running_and_the_waiting_request) {
  start(10);
  request(1, 20000);
  run_for(0.05);
  request(2, 0);
  const auto begin = Clock::now();
  worker_->cancel();
  ASSERT_TRUE(run_until_finished(1, 1));
  EXPECT_LT(seconds_since(begin), 0.1);
  EXPECT_FALSE(finished_[0].completed);
  run_for(0.1);
  EXPECT_TRUE(results_.empty());
  EXPECT_EQ(finished_.size(), 1U);
  request(3, 0);
  ASSERT_TRUE(run_until_finished(3));
  EXPECT_EQ(results_.back().outcome.value->vertices[0].x, 3);
}

TEST_F(Worker_test, is_destroyed_quickly_while_it_computes) {
  for (int round = 0; round < 20; ++round) {
    start();
    request(1, 20000);
    if (round % 2) std::this_thread::sleep_for(milliseconds(10));
    if (round % 3 == 0) request(2, 20000);
    const auto begin = Clock::now();
    worker_.reset();
    EXPECT_LT(seconds_since(begin), 0.1) << round;
    const std::lock_guard lock(mutex_);
    queue_.clear();
  }
  start();
  const auto begin = Clock::now();
  worker_.reset();
  EXPECT_LT(seconds_since(begin), 0.1);
}

TEST_F(Worker_test, describes_elements_of_the_last_request) {
  start();
  request(5, 20);
  std::vector<std::string> answers;
  const auto keep = [&](const Element_description& description) { answers.push_back(description.facts.back().text); };
  worker_->describe("slow", 0, keep);
  ASSERT_TRUE(run_until([&] { return !answers.empty(); }));
  EXPECT_EQ(answers.back(), std::to_string(5.0));
  // While a request runs only the newest question waits.
  request(6, 100);
  run_for(0.02);
  int first = 0;
  worker_->describe("slow", 0, [&](const Element_description&) { ++first; });
  worker_->describe("slow", 0, keep);
  ASSERT_TRUE(run_until([&] { return answers.size() == 2; }));
  EXPECT_EQ(first, 0);
  EXPECT_EQ(answers.back(), std::to_string(6.0));
}

TEST_F(Worker_test, unknown_layer_does_no_harm) {
  start();
  request(1, 0, {"nothing", "slow"});
  ASSERT_TRUE(run_until_finished(1));
  request(2, 0);
  ASSERT_TRUE(run_until_finished(2));
  EXPECT_EQ(results_.back().ticket, 2U);
  worker_->describe("nothing", 0, [](const Element_description&) {});
  request(3, 0);
  ASSERT_TRUE(run_until_finished(3));
}

TEST_F(Worker_test, what_is_kept_is_not_computed_again) {
  start();
  request(1, 100);
  ASSERT_TRUE(run_until_finished(1));
  const Inputs same = Inputs{}.with(points_input, std::vector<Point_2>{{4, 0}});
  for (std::uint64_t ticket = 2; ticket <= 4; ++ticket) {
    const auto begin = Clock::now();
    worker_->request({ticket, same, Settings{}.with("duration", std::int64_t{100}), {"slow"}});
    ASSERT_TRUE(run_until_finished(ticket));
    if (ticket > 2) {
      EXPECT_LT(seconds_since(begin), 0.08);
    }
    EXPECT_EQ(results_.back().outcome.value->vertices[0].x, 4);
  }
}

TEST_F(Worker_test, makes_steps_one_of_the_other) {
  start();
  evolve(3, 0, 4);
  ASSERT_TRUE(run_until_finished(3));
  ASSERT_EQ(steps_.size(), 4U);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    EXPECT_EQ(steps_[i].ticket, 3U);
    ASSERT_TRUE(steps_[i].outcome);
    const Point_2 p = steps_[i].outcome.value->inputs.get(points_input)->at(0);
    EXPECT_EQ(p.x, static_cast<double>(i + 1));
    // The numbers of steps go on from those that were done.
    EXPECT_EQ(p.y, static_cast<double>(i + 3));
  }
  EXPECT_TRUE(finished_[0].completed);
}

TEST_F(Worker_test, steps_end_with_a_reason) {
  start();
  evolve(1, 8, 5);
  ASSERT_TRUE(run_until_finished(1));
  ASSERT_EQ(steps_.size(), 3U);
  EXPECT_FALSE(steps_[2].outcome);
  EXPECT_EQ(steps_[2].outcome.reason, "the wall");
  steps_.clear();
  evolve(2, 5, 5);
  ASSERT_TRUE(run_until_finished(2));
  ASSERT_EQ(steps_.size(), 1U);
  EXPECT_FALSE(steps_[0].outcome);
  EXPECT_FALSE(steps_[0].outcome.reason.empty());
  steps_.clear();
  evolve(3, 0, 1, 0, "none");
  ASSERT_TRUE(run_until_finished(3));
  ASSERT_EQ(steps_.size(), 1U);
  EXPECT_NE(steps_[0].outcome.reason.find("none"), std::string::npos);
}

TEST_F(Worker_test, steps_are_cancelled_at_once) {
  start();
  evolve(1, 0, 1000, 50);
  ASSERT_TRUE(run_until([&] { return steps_.size() == 2; }));
  worker_->cancel();
  ASSERT_TRUE(run_until_finished(1, 1));
  EXPECT_FALSE(finished_[0].completed);
  EXPECT_LT(steps_.size(), 5U);
  EXPECT_GT(progressed_, 0);
  // What comes next is served as ever.
  request(2, 0);
  ASSERT_TRUE(run_until_finished(2));
  EXPECT_TRUE(finished_[1].completed);
}

}  // namespace
}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/worker.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <variant>

#include "core/evolution.h"

namespace mesecina {

namespace {
using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }
}  // namespace

struct Worker::State {
  struct Question {
    std::string layer;
    std::size_t element = 0;
    std::function<void(Element_description)> answer;
  };

  State(std::shared_ptr<const Registry> registry, int threads_, Listener listener_, Deliver deliver_, double patience_)
      : graph(std::move(registry)),
        threads(threads_),
        listener(std::move(listener_)),
        deliver(std::move(deliver_)),
        patience(patience_) {}

  void run(const std::stop_token& stop);
  void watch(const std::stop_token& stop);
  void serve(Request request);
  void serve(const Steps_request& request);
  Progress progress_of(std::uint64_t ticket);
  void end(std::uint64_t ticket, bool completed);
  void answer(Question question);

  Graph graph;  // the worker's thread only
  int threads;
  Listener listener;
  Deliver deliver;
  double patience;

  std::mutex mutex;
  std::condition_variable_any wake;
  std::optional<std::variant<Request, Steps_request>> waiting;
  std::optional<Question> question;
  std::stop_source running;  ///< of the request or question being computed
  bool is_running = false;
  Clock::time_point running_since;
  bool replaced_last = false;  ///< the previous request was stopped in favour of the running one
  std::jthread thread;
  std::jthread watcher;  ///< stops what has run for too long while a newer request waits
};

Worker::Worker(std::shared_ptr<const Registry> registry, int threads, Listener listener, Deliver deliver,
               double patience)
    : state_(std::make_unique<State>(std::move(registry), threads, std::move(listener), std::move(deliver), patience)) {
  state_->thread = std::jthread([state = state_.get()](const std::stop_token& stop) { state->run(stop); });
  state_->watcher = std::jthread([state = state_.get()](const std::stop_token& stop) { state->watch(stop); });
}

Worker::~Worker() {
  state_->thread.request_stop();
  cancel();
  state_->wake.notify_all();
  state_->thread.join();
}

void Worker::request(Request request) {
  const std::lock_guard lock(state_->mutex);
  state_->waiting = std::move(request);
  state_->wake.notify_all();
}

void Worker::evolve(Steps_request request) {
  const std::lock_guard lock(state_->mutex);
  state_->waiting = std::move(request);
  state_->wake.notify_all();
}

void Worker::cancel() {
  const std::lock_guard lock(state_->mutex);
  state_->waiting.reset();
  state_->question.reset();
  if (state_->is_running) state_->running.request_stop();
}

void Worker::describe(std::string layer, std::size_t element, std::function<void(Element_description)> answer) {
  const std::lock_guard lock(state_->mutex);
  state_->question = State::Question{std::move(layer), element, std::move(answer)};
  state_->wake.notify_all();
}

void Worker::State::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    std::optional<std::variant<Request, Steps_request>> request;
    std::optional<Question> asked;
    {
      std::unique_lock lock(mutex);
      wake.wait(lock, stop, [&] { return waiting.has_value() || question.has_value(); });
      if (stop.stop_requested()) return;
      if (waiting) {
        request = std::exchange(waiting, std::nullopt);
      } else {
        asked = std::exchange(question, std::nullopt);
      }
      running = std::stop_source();
      is_running = true;
      running_since = Clock::now();
    }
    if (request) {
      std::visit([this](auto& order) { serve(std::move(order)); }, *request);
    } else if (asked) {
      answer(std::move(*asked));
    }
  }
}

void Worker::State::watch(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  const auto is_contested = [&] { return is_running && waiting && !running.stop_requested(); };
  while (!stop.stop_requested()) {
    if (!is_contested()) {
      wake.wait(lock, stop, is_contested);
      continue;
    }
    const std::chrono::duration<double> allowed(replaced_last ? 10 * patience : patience);
    const auto deadline = running_since + std::chrono::duration_cast<Clock::duration>(allowed);
    if (Clock::now() < deadline) {
      wake.wait_until(lock, stop, deadline, [&] { return !is_contested(); });
    } else {
      running.request_stop();
      replaced_last = true;
    }
  }
}

Progress Worker::State::progress_of(std::uint64_t ticket) {
  const auto report = [this, ticket, last = Clock::time_point()](std::string_view stage, double fraction) mutable {
    constexpr double interval = 0.03;
    if (seconds_since(last) < interval) return;
    last = Clock::now();
    deliver([this_listener = listener.progressed, ticket, text = std::string(stage), fraction] {
      if (this_listener) this_listener(ticket, text, fraction);
    });
  };
  return Progress(running.get_token(), report, threads);
}

void Worker::State::end(std::uint64_t ticket, bool completed) {
  graph.clear_stages();
  {
    const std::lock_guard lock(mutex);
    is_running = false;
    if (completed) replaced_last = false;
  }
  deliver([call = listener.finished, ticket, completed] {
    if (call) call(ticket, completed);
  });
}

void Worker::State::serve(Request request) {
  const std::uint64_t ticket = request.ticket;
  Progress progress = progress_of(ticket);
  bool completed = true;
  const auto begin = Clock::now();
  try {
    graph.set_inputs(std::move(request.inputs));
    graph.set_settings(std::move(request.settings));
    for (const std::string& layer : request.layers) {
      deliver([call = listener.started, ticket, layer] {
        if (call) call(ticket, layer);
      });
      const auto start = Clock::now();
      Layer_result result{ticket, layer, {}, {}, 0};
      if (graph.registry().find_layer(layer)) {
        result.outcome = graph.layer(layer, progress);
        result.remarks = graph.remarks(layer);
      } else {
        result.outcome.reason = "no layer '" + layer + "'";
      }
      result.seconds = seconds_since(start);
      deliver([call = listener.finished_layer, result = std::move(result)]() mutable {
        if (call) call(std::move(result));
      });
    }
  } catch (const Cancelled&) {
    completed = false;
  }
  if (completed && listener.reported) {
    Report told{ticket, graph.stages(), graph.measures(), graph.notes(), seconds_since(begin)};
    deliver([call = listener.reported, told = std::move(told)]() mutable { call(std::move(told)); });
  }
  end(ticket, completed);
}

void Worker::State::serve(const Steps_request& request) {
  const std::uint64_t ticket = request.ticket;
  Progress progress = progress_of(ticket);
  const auto tell = [&](Outcome<Evolution_state> outcome) {
    deliver([call = listener.finished_step, result = Step_result{ticket, std::move(outcome)}]() mutable {
      if (call) call(std::move(result));
    });
  };
  bool completed = true;
  try {
    if (!graph.registry().find_evolution(request.evolution)) {
      tell({nullptr, "no evolution '" + request.evolution + "'"});
      return end(ticket, true);
    }
    graph.set_inputs(request.from.inputs);
    graph.set_settings(request.from.settings);
    Evolution_loop loop(graph, request.evolution, request.steps_done);
    for (std::uint64_t step = 0; step < request.steps; ++step) {
      if (!loop.advance(progress)) {
        tell({nullptr, loop.end_reason()});
        break;
      }
      tell({std::make_shared<const Evolution_state>(Evolution_state{graph.inputs(), graph.settings()}), {}});
    }
  } catch (const Cancelled&) {
    completed = false;
  }
  end(ticket, completed);
}

void Worker::State::answer(Question asked) {
  Progress progress(running.get_token(), {}, threads);
  std::optional<Element_description> description;
  try {
    description = graph.describe(asked.layer, asked.element, progress);
  } catch (const std::exception&) {
    description.reset();
  }
  {
    const std::lock_guard lock(mutex);
    is_running = false;
  }
  if (description) {
    deliver([call = std::move(asked.answer), text = std::move(*description)]() mutable { call(std::move(text)); });
  }
}

}  // namespace mesecina

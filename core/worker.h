// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/graph.h"

namespace mesecina {

/// A graph on a thread of its own, for windows. One request is computed at a time and only the newest waits.
///
/// A newer request replaces a waiting one. It stops the running one only when that has run longer than
/// `patience` seconds, so that a steady stream of edits (a drag) still shows results; the one that follows a stopped
/// request is always run to its end or for ten times the patience, so that long computations do not starve.
class Worker {
 public:
  struct Request {
    std::uint64_t ticket = 0;  ///< chosen by the caller, comes back with every answer
    Inputs inputs;
    Settings settings;
    std::vector<std::string> layers;  ///< in the order they are wanted
  };
  struct Layer_result {
    std::uint64_t ticket = 0;
    std::string layer;
    Outcome<Primitive_set> outcome;
    std::vector<Remark> remarks;
    double seconds = 0;
  };
  /// Steps of an evolution, one after the other, each from the state before.
  struct Steps_request {
    std::uint64_t ticket = 0;
    Evolution_state from;
    std::string evolution;
    std::uint64_t steps_done = 0;  ///< of the same evolution, that led to `from`
    std::uint64_t steps = 1;
  };
  struct Step_result {
    std::uint64_t ticket = 0;
    Outcome<Evolution_state> outcome;  ///< without a value this was the last: why there is no such step
  };
  /// What a request has cost and found out, for statistics.
  struct Report {
    std::uint64_t ticket = 0;
    std::vector<Graph::Stage> stages;        ///< in the order they ended; none when everything was there
    std::map<std::string, double> measures;  ///< of all that the graph holds
    std::map<std::string, std::string> notes;
    double seconds = 0;
  };
  /// Called on the worker's thread; `deliver` (below) brings them to the owner's.
  struct Listener {
    std::function<void(std::uint64_t ticket, const std::string& layer)> started;
    std::function<void(std::uint64_t ticket, const std::string& stage, double fraction)> progressed;
    std::function<void(Layer_result)> finished_layer;
    std::function<void(Step_result)> finished_step = {};
    /// Optional; before `finished`, of a request that was completed.
    std::function<void(Report)> reported = {};
    /// `completed` is false when the request was cancelled or replaced while it ran.
    std::function<void(std::uint64_t ticket, bool completed)> finished;
  };
  /// Runs a closure on the owner's thread (QMetaObject::invokeMethod with a queued connection, say). Must not block.
  using Deliver = std::function<void(std::function<void()>)>;

  Worker(std::shared_ptr<const Registry> registry, int threads, Listener listener, Deliver deliver,
         double patience = 0.25);
  /// Cancels and joins; closures that were delivered but have not run are the owner's business.
  ~Worker();

  void request(Request request);
  /// A request as the others: the newest one wins, whatever it asks for.
  void evolve(Steps_request request);
  /// Drops the running and the waiting request.
  void cancel();
  /// Answers, between requests, what an element of a layer is, for the inputs and settings of the last request that
  /// ran. Only the newest waiting question is answered.
  void describe(std::string layer, std::size_t element, std::function<void(Element_description)> answer);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/graph.h"

namespace mesecina {

/// What every evolution that draws random numbers reads; --seed sets it where --set does not.
inline constexpr Setting<std::int64_t> evolution_seed_setting{"evolution-seed"};

/// Makes one step of an evolution after the other, on a graph, which has the inputs and settings of the last state that
/// was reached. The graph must outlive it.
class Evolution_loop {
 public:
  /// `steps_done`: those that led to the present state of the graph. Throws std::out_of_range for an unknown id.
  Evolution_loop(Graph& graph, std::string_view evolution_id, std::uint64_t steps_done = 0);

  /// Goes one step. False, and the graph stays as it is, when there is none: see end_reason. Throws Cancelled, and then
  /// the graph stays as it is too.
  bool advance(Progress& progress);
  std::uint64_t steps_done() const { return steps_done_; }
  /// Why the last `advance` did not go on; empty when it did.
  const std::string& end_reason() const { return end_reason_; }

 private:
  Graph& graph_;
  std::string evolution_id_;
  std::uint64_t steps_done_;
  std::string end_reason_;
};

/// How far an evolution came.
struct Evolution_result {
  std::uint64_t steps_done = 0;
  std::string end_reason;  ///< why there were fewer steps than asked for; empty if there were not
};

/// Up to `steps` steps from the present state of the graph, which has the last state then. `visit` (optional) is called
/// after each step with its number, 1 for the first, while the graph has its state: it may take inputs, settings and
/// layers from it, but not change them. Throws std::out_of_range for an unknown id; Cancelled, with the graph in the
/// last state that was reached; and what `visit` throws.
Evolution_result evolve(Graph& graph, std::string_view evolution_id, std::uint64_t steps, Progress& progress,
                        const std::function<void(std::uint64_t step)>& visit = {});

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evolution.h"

#include <stdexcept>

namespace mesecina {

Evolution_loop::Evolution_loop(Graph& graph, std::string_view evolution_id, std::uint64_t steps_done)
    : graph_(graph), evolution_id_(evolution_id), steps_done_(steps_done) {
  if (!graph.registry().find_evolution(evolution_id)) throw std::out_of_range("no evolution '" + evolution_id_ + "'");
}

bool Evolution_loop::advance(Progress& progress) {
  const Outcome<Evolution_state> next = graph_.evolve(evolution_id_, steps_done_ + 1, progress);
  if (!next) {
    end_reason_ = next.reason;
    return false;
  }
  if (next.value->inputs == graph_.inputs() && next.value->settings == graph_.settings()) {
    end_reason_ = "nothing changes any more";
    return false;
  }
  graph_.set_inputs(next.value->inputs);
  graph_.set_settings(next.value->settings);
  ++steps_done_;
  end_reason_.clear();
  return true;
}

Evolution_result evolve(Graph& graph, std::string_view evolution_id, std::uint64_t steps, Progress& progress,
                        const std::function<void(std::uint64_t step)>& visit) {
  Evolution_loop loop(graph, evolution_id);
  while (loop.steps_done() < steps && loop.advance(progress))
    if (visit) visit(loop.steps_done());
  return {loop.steps_done(), loop.end_reason()};
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/layer_order.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace mesecina {

namespace {

const Shown_stage* find_stage(const std::vector<Shown_stage>& stages, std::string_view name) {
  const auto it =
      std::find_if(stages.begin(), stages.end(), [&](const Shown_stage& stage) { return stage.name == name; });
  return it == stages.end() ? nullptr : &*it;
}

/// The list with the entries of `stage` together, the topmost of them in the place before index `top` of the old list.
Layer_list gather_below(const Layer_list& layers, const Shown_stage& stage, std::size_t top) {
  std::vector<bool> is_moved(layers.size(), false);
  for (const std::size_t index : stage.entries) is_moved[index] = true;
  Layer_list result;
  result.reserve(layers.size());
  const auto append_stage = [&] {
    for (auto it = stage.entries.rbegin(); it != stage.entries.rend(); ++it) result.push_back(layers[*it]);
  };
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (i == top) append_stage();
    if (!is_moved[i]) result.push_back(layers[i]);
  }
  if (top >= layers.size()) append_stage();
  return result;
}

}  // namespace

std::vector<Shown_stage> shown_stages(const Registry& registry, const Layer_list& layers) {
  std::vector<Shown_stage> stages;
  std::vector<std::size_t> known_above;  // per stage, the number of known layers when its last one was met
  std::size_t known = 0;
  for (std::size_t i = layers.size(); i-- > 0;) {
    const Layer_spec* spec = registry.find_layer(layers[i].id);
    if (!spec) continue;
    auto it = std::find_if(stages.begin(), stages.end(), [&](const Shown_stage& s) { return s.name == spec->stage; });
    if (it == stages.end()) {
      stages.push_back({spec->stage, {}, false});
      known_above.push_back(known);
      it = std::prev(stages.end());
    }
    std::size_t& last = known_above[static_cast<std::size_t>(it - stages.begin())];
    if (!it->entries.empty() && last + 1 != known) it->is_interleaved = true;
    it->entries.push_back(i);
    last = known++;
  }
  return stages;
}

Layer_list move_within_stage(const Registry& registry, const Layer_list& layers, std::string_view stage,
                             const std::vector<std::string>& moved, std::size_t position) {
  const std::vector<Shown_stage> stages = shown_stages(registry, layers);
  const Shown_stage* shown = find_stage(stages, stage);
  if (!shown) return layers;
  const auto is_moved = [&](std::size_t index) {
    return std::find(moved.begin(), moved.end(), layers[index].id) != moved.end();
  };
  const auto& rows = shown->entries;
  const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(std::min(position, rows.size()));
  std::vector<std::size_t> order;
  std::copy_if(rows.begin(), middle, std::back_inserter(order), [&](std::size_t i) { return !is_moved(i); });
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(order), is_moved);
  std::copy_if(middle, rows.end(), std::back_inserter(order), [&](std::size_t i) { return !is_moved(i); });
  Layer_list result = layers;
  for (std::size_t row = 0; row < rows.size(); ++row) result[rows[row]] = layers[order[row]];
  return result;
}

Layer_list move_stage_above(const Registry& registry, const Layer_list& layers, std::string_view stage,
                            std::string_view target) {
  const std::vector<Shown_stage> stages = shown_stages(registry, layers);
  const Shown_stage* moved = find_stage(stages, stage);
  const Shown_stage* below = find_stage(stages, target);
  if (!moved || !below || moved == below) return layers;
  return gather_below(layers, *moved, below->entries.front() + 1);
}

Layer_list gather_stage(const Registry& registry, const Layer_list& layers, std::string_view stage) {
  const std::vector<Shown_stage> stages = shown_stages(registry, layers);
  const Shown_stage* gathered = find_stage(stages, stage);
  return gathered ? gather_below(layers, *gathered, gathered->entries.front() + 1) : layers;
}

}  // namespace mesecina

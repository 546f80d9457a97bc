// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "layers/layer_list.h"

namespace mesecina {

/// The layers of one stage as a panel lists them.
struct Shown_stage {
  std::string name;
  std::vector<std::size_t> entries;  ///< indices in the Layer_list, topmost first
  /// Layers of other stages are drawn between those of this one, so that its rows do not tell the whole order.
  bool is_interleaved = false;
  bool operator==(const Shown_stage&) const = default;
};

/// The layers that the registry knows, grouped by stage; the stage with the topmost layer comes first. O(n log n).
std::vector<Shown_stage> shown_stages(const Registry& registry, const Layer_list& layers);

/// The list with the layers `moved` put, in their present order, before the row `position` of their stage (its number
/// of rows: at the end). Only layers of the stage change places among themselves, all others stay where they are. Ids
/// that are not of this stage are ignored.
Layer_list move_within_stage(const Registry& registry, const Layer_list& layers, std::string_view stage,
                             const std::vector<std::string>& moved, std::size_t position);

/// The list with all layers of the stage drawn together, right above the topmost layer of the stage `target`.
/// The same list when a name is unknown or both are equal.
Layer_list move_stage_above(const Registry& registry, const Layer_list& layers, std::string_view stage,
                            std::string_view target);

/// The list with all layers of the stage drawn together, right below its topmost one.
Layer_list gather_stage(const Registry& registry, const Layer_list& layers, std::string_view stage);

}  // namespace mesecina

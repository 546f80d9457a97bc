// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "layers/layer_list.h"

namespace mesecina {

using Layer_ids = std::vector<std::string>;

/// Ids of the visible layers, from bottom to top.
Layer_ids visible_layers(const Layer_list& layers);
/// The list with these layers shown or hidden, the others as they are.
Layer_list with_visibility(Layer_list layers, const Layer_ids& ids, bool is_visible);
/// The list with these layers visible and no others.
Layer_list with_only_visible(Layer_list layers, const Layer_ids& ids);

/// What was visible before things were hidden, to bring just that back.
class Visibility_memory {
 public:
  /// Only these layers visible; when they already are, by an earlier call, what was visible before that.
  Layer_list toggle_solo(const Layer_list& layers, const Layer_ids& ids);
  /// Hides all layers of a group when one is visible; else shows those that were hidden so, or all.
  Layer_list toggle_group(const Layer_list& layers, const std::string& group, const Layer_ids& ids);

 private:
  Layer_ids before_solo_;
  Layer_ids solo_;
  std::map<std::string, Layer_ids> hidden_;
};

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/layer_visibility.h"

#include <algorithm>
#include <iterator>

namespace mesecina {

namespace {

bool contains(const Layer_ids& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool has_same_members(Layer_ids a, Layer_ids b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

}  // namespace

Layer_ids visible_layers(const Layer_list& layers) {
  Layer_ids result;
  for (const Layer_entry& entry : layers) {
    if (entry.style.visible) result.push_back(entry.id);
  }
  return result;
}

Layer_list with_visibility(Layer_list layers, const Layer_ids& ids, bool is_visible) {
  for (Layer_entry& entry : layers) {
    if (contains(ids, entry.id)) entry.style.visible = is_visible;
  }
  return layers;
}

Layer_list with_only_visible(Layer_list layers, const Layer_ids& ids) {
  for (Layer_entry& entry : layers) entry.style.visible = contains(ids, entry.id);
  return layers;
}

Layer_list Visibility_memory::toggle_solo(const Layer_list& layers, const Layer_ids& ids) {
  const Layer_ids visible = visible_layers(layers);
  const bool is_solo = !solo_.empty() && has_same_members(visible, solo_);
  if (is_solo && has_same_members(ids, solo_)) {
    solo_.clear();
    return with_only_visible(layers, before_solo_);
  }
  // From one solo to the next, what was visible before the first is what to go back to.
  if (!is_solo) before_solo_ = visible;
  solo_ = ids;
  return with_only_visible(layers, ids);
}

Layer_list Visibility_memory::toggle_group(const Layer_list& layers, const std::string& group, const Layer_ids& ids) {
  Layer_ids visible;
  const Layer_ids all_visible = visible_layers(layers);
  std::copy_if(ids.begin(), ids.end(), std::back_inserter(visible),
               [&](const std::string& id) { return contains(all_visible, id); });
  if (!visible.empty()) {
    hidden_[group] = visible;
    return with_visibility(layers, ids, false);
  }
  const auto it = hidden_.find(group);
  return with_visibility(layers, it == hidden_.end() ? ids : it->second, true);
}

}  // namespace mesecina

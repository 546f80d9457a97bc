// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/registry.h"
#include "core/style.h"

namespace mesecina {

/// A layer's place in the picture and its look.
struct Layer_entry {
  std::string id;
  Style style;
  bool operator==(const Layer_entry&) const = default;
};

/// All layers of a program, bottom to top: a value, so that undo keeps copies.
using Layer_list = std::vector<Layer_entry>;

/// Every layer of the registry in its default order and look.
Layer_list default_layers(const Registry& registry);

/// The layers of `listed` in their order, and those of the registry that it lacks, switched off: each above the layer
/// that it follows in the registry.
Layer_list with_missing_layers(Layer_list listed, const Registry& registry);

Layer_entry* find_entry(Layer_list& layers, std::string_view id);
const Layer_entry* find_entry(const Layer_list& layers, std::string_view id);

}  // namespace mesecina

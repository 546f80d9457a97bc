// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/bundle.h"

namespace mesecina {

/// What a `.bnd` file of the programs before this one holds, for the registry's dimension: big-endian data streams of
/// names and layer states. Both layouts are read: whole states, and shorter ones that end after `active` or any field
/// behind it; numbers may have 4 or 8 bytes, as the streams of different times have. Layers get their looks as they
/// were; those that this program does not have are named in the notes. Throws std::invalid_argument with the position
/// of the byte, what was expected and what was found; never reads past the end.
std::vector<Bundle> parse_historical_bundles(std::string_view bytes, const Registry& registry);

/// The id of the layer that had this name; empty when there is none.
std::string_view layer_of_historical_name(std::string_view name, int dimension);

}  // namespace mesecina

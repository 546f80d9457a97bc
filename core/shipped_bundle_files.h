// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

namespace mesecina {

/// The files of resources/bundles for this dimension, as texts in the order of their names; none for another number.
std::span<const std::string_view> shipped_bundle_files(int dimension);

}  // namespace mesecina

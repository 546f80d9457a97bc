// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace mesecina {

class Registry;

/// Layers of what the user gave: points, outline, image.
void register_inputs_2(Registry& registry);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/batch/command_line.h"

namespace mesecina {

/// The layers of the command line or, where it has neither layers nor a session, those visible by default.
std::vector<std::string> shown_layers(const Registry& registry, const Command_line& command_line);

/// The layers that a picture shows: shown_layers, each once, in the order that the command line asks for and with the
/// looks that it gives them. The limits of layers are those of `settings`.
Scene make_scene(const Registry& registry, const Command_line& command_line, const Settings& settings,
                 const std::function<std::shared_ptr<const Primitive_set>(const std::string&)>& primitives);

}  // namespace mesecina

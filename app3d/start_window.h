// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/batch/command_line.h"

namespace mesecina {

/// Opens the window and runs the program until it is closed. Returns the exit code.
int start_window(int argc, char** argv, const Command_line& command_line,
                 const std::shared_ptr<const Registry>& registry, const Formats& formats);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/batch/command_line.h"

namespace mesecina {

/// Opens the window with the files, layers and settings of the command line and runs it until it is closed. Returns the
/// exit code; without a display, exit_wrong_usage with one line that says how to compute without a window.
int start_window(int argc, char** argv, const Command_line& command_line,
                 const std::shared_ptr<const Registry>& registry, const Formats& formats);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <memory>

#include "core/batch/command_line.h"

namespace mesecina {

/// Computes the layers of every input and writes them, without a window. Returns the exit code. `is_terminal`: somebody
/// looks at `errors` on a terminal, where progress is shown in one line.
///
/// Files are DIR/<input stem>.<layer>.<extension>, pictures DIR/<input stem>.<extension>. Their bytes depend on the
/// input and the settings only, not on --jobs and --threads. A failed input is reported with one line on `errors` and
/// never stops the others. The files of an input appear together, when all are complete. An input that needs more
/// memory than there is beside others is tried again at the end, alone; so are, with --resume, those that an earlier
/// run was computing when it was killed.
///
/// Inputs are computed in --jobs child processes, so one that crashes fails like any other. They are copies of this
/// process (Worker_pool has the details): it should have no other threads, and no contexts of graphics yet.
///
/// SIGINT or SIGTERM stops the run: inputs that are not complete leave nothing, and --resume goes on. Statistics and
/// summary have what is complete. A computation that does not stop within a second is ended. Throws std::system_error
/// when no process can be started.
int run_batch(const Command_line& command_line, const std::string& program,
              const std::shared_ptr<const Registry>& registry, const Formats& formats, std::ostream& errors,
              bool is_terminal);

}  // namespace mesecina

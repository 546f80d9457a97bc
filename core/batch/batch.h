// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <memory>

#include "core/batch/command_line.h"

namespace mesecina {

/// Computes the layers of every input and writes them, without a window. Returns the exit code.
///
/// Files are DIR/<input stem>.<layer>.<extension>, pictures DIR/<input stem>.<extension>. Their bytes depend on the
/// input and the settings only, not on --jobs and --threads. A failed input is reported with one line on `errors` and
/// never stops the others; every file is complete or not there.
int run_batch(const Command_line& command_line, const std::string& program, std::shared_ptr<const Registry> registry,
              const Formats& formats, std::ostream& errors);

/// The layers that a picture shows: those of the command line or, where it has none, those visible by default; each
/// once, in the order that it asks for and with the looks that it gives them.
Scene make_scene(const Registry& registry, const Command_line& command_line,
                 const std::function<std::shared_ptr<const Primitive_set>(const std::string&)>& primitives);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shell/commands.h"
#include "shell/computation.h"
#include "shell/document.h"
#include "shell/files.h"

namespace mesecina {

/// What the commands of every program act on.
struct Command_targets {
  const Registry& registry;
  const Formats& formats;
  Document& document;
  Computation& computation;
  Files& files;
  QWidget& window;
};

/// Commands with arguments that every program has: files, layers, styles, settings, history, waiting.
void add_window_commands(Commands& commands, const Command_targets& targets);

/// Sets a setting from "ID=VALUE": one step that can be undone. Throws Command_error.
void set_setting(const Command_targets& targets, const QString& assignment);

}  // namespace mesecina

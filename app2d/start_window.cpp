// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/start_window.h"

#include "app2d/main_window_2.h"
#include "shell/run_window.h"

namespace mesecina {

int start_window(int argc, char** argv, const Command_line& command_line,
                 const std::shared_ptr<const Registry>& registry, const Formats& formats) {
  const Program_identity identity{QStringLiteral("mesecina2d"), QStringLiteral(MESECINA_VERSION)};
  const auto make_window = [&]() -> std::unique_ptr<Program_window> {
    Startup startup{command_line.files, command_line.layers, command_line.settings, command_line.styles,
                    command_line.as_listed};
    startup.evolutions = command_line.evolutions;
    if (command_line.view) startup.seen = Seen_2{*command_line.view, command_line.width, command_line.height};
    return std::make_unique<Main_window_2>(registry, formats, startup);
  };
  if (command_line.list) {
    return use_hidden_window(argc, argv, identity, make_window, [&](const Program_window& window) {
      return list_commands(window, command_line.list_as_json);
    });
  }
  return run_window(argc, argv, identity, {command_line.script}, make_window);
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/start_window.h"

#include "app3d/main_window_3.h"
#include "shell/run_window.h"

namespace mesecina {

int start_window(int argc, char** argv, const Command_line& command_line,
                 const std::shared_ptr<const Registry>& registry, const Formats& formats) {
  const Program_identity identity{QStringLiteral("mesecina3d"), QStringLiteral(MESECINA_VERSION),
                                  QSurfaceFormat::CompatibilityProfile, argc == 1};
  const auto make_window = [&]() -> std::unique_ptr<Program_window> {
    return std::make_unique<Main_window_3>(registry, formats, startup_of(command_line));
  };
  if (command_line.list) {
    return use_hidden_window(argc, argv, identity, make_window, [&](const Program_window& window) {
      return list_commands(window, command_line.list_as_json);
    });
  }
  if (command_line.manual) {
    return write_manual_folder(
        argc, argv, identity, registry, formats, *command_line.manual, make_window,
        [&](const QString& name, const QString& folder) { Files_3::write_example(formats, name, folder); });
  }
  return run_window(argc, argv, identity, {command_line.script}, make_window);
}

}  // namespace mesecina

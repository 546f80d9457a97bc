// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/formats/format.h"

namespace mesecina {

class Program_window;
class Registry;

struct Program_identity {
  QString name;                                                                ///< of the file ("mesecina2d")
  QString version;                                                             ///< "0.1.0"
  QSurfaceFormat::OpenGLContextProfile profile = QSurfaceFormat::CoreProfile;  ///< that the canvas needs
  bool is_plain_start = false;  ///< nothing was asked for on the command line: the last scene may come back
};

/// What a window is asked to do besides being there.
struct Window_order {
  std::optional<std::string> script = {};  ///< file of commands; "-": standard input
};

/// Makes the application and its window, and runs it until the window is closed. Returns the exit code; without a
/// display it says so on stderr and returns exit_wrong_usage. With MESECINA_FIRST_PICTURE set it ends by itself when
/// everything visible was drawn, saves the window under that name unless it is "-", and says after how long.
///
/// SIGTERM, SIGINT and SIGHUP end it as soon as possible, without a question; the next start goes on where it was. The
/// exit code is then exit_success; with a script, which has not come to its end, exit_interrupted.
///
/// A script begins when the window is there. Its error is told on stderr, and ends the program with exit_some_failed.
int run_window(int argc, char** argv, const Program_identity& identity, const Window_order& order,
               const std::function<std::unique_ptr<Program_window>()>& make_window);

/// Makes a window that is never shown, without a display, as it is for somebody who never used the program, and returns
/// what `use` makes of it.
int use_hidden_window(int argc, char** argv, const Program_identity& identity,
                      const std::function<std::unique_ptr<Program_window>()>& make_window,
                      const std::function<int(Program_window&)>& use);

/// The manual of a program, with pictures, into a folder, without a display. `write_example` as for
/// make_manual_pictures. Returns exit_success, or exit_some_failed when pictures are missing.
int write_manual_folder(int argc, char** argv, const Program_identity& identity,
                        const std::shared_ptr<const Registry>& registry, const Formats& formats,
                        const std::filesystem::path& folder,
                        const std::function<std::unique_ptr<Program_window>()>& make_window,
                        const std::function<void(const QString& name, const QString& folder)>& write_example);

/// Prints what the window can do, as --list commands says. Returns exit_success.
int list_commands(const Program_window& window, bool as_json);

}  // namespace mesecina

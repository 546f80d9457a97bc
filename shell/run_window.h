// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>
#include <functional>
#include <memory>

namespace mesecina {

class Program_window;

struct Program_identity {
  QString name;                                                                ///< of the file ("mesecina2d")
  QString version;                                                             ///< "0.1.0"
  QSurfaceFormat::OpenGLContextProfile profile = QSurfaceFormat::CoreProfile;  ///< that the canvas needs
};

/// Makes the application and its window, and runs it until the window is closed. Returns the exit code; without a
/// display it says so on stderr and returns exit_wrong_usage. With MESECINA_FIRST_PICTURE set it ends by itself when
/// everything visible was drawn, saves the window under that name unless it is "-", and says after how long.
int run_window(int argc, char** argv, const Program_identity& identity,
               const std::function<std::unique_ptr<Program_window>()>& make_window);

}  // namespace mesecina

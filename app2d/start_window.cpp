// SPDX-License-Identifier: GPL-3.0-or-later
#include "app2d/start_window.h"

#include <QApplication>
#include <QLocale>
#include <QSurfaceFormat>
#include <iostream>

#include "app2d/main_window_2.h"

namespace mesecina {

int start_window(int argc, char** argv, const Command_line& command_line, std::shared_ptr<const Registry> registry,
                 Formats formats) {
  const auto is_set = [](const char* variable) { return !qEnvironmentVariableIsEmpty(variable); };
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY") && !is_set("QT_QPA_PLATFORM")) {
    std::cerr << "mesecina2d: expected a display to open a window on, found none; use --nogui to compute without one\n";
    return exit_wrong_usage;
  }
  // Files hold numbers with a decimal point everywhere, and so do the controls.
  QLocale::setDefault(QLocale::c());
  QSurfaceFormat format;
  constexpr int major = 3;
  constexpr int minor = 3;
  format.setVersion(major, minor);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QSurfaceFormat::setDefaultFormat(format);
  QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  QApplication application(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("mesecina"));
  QCoreApplication::setApplicationName(QStringLiteral("mesecina2d"));
  QCoreApplication::setApplicationVersion(QStringLiteral(MESECINA_VERSION));
  QGuiApplication::setApplicationDisplayName(QString());
  Main_window_2 window(std::move(registry), std::move(formats),
                       {command_line.files, command_line.layers, command_line.settings});
  window.show();
  return QApplication::exec();
}

}  // namespace mesecina

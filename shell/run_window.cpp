// SPDX-License-Identifier: GPL-3.0-or-later
#include "shell/run_window.h"

#include <unistd.h>

#include <QApplication>
#include <QLocale>
#include <QPixmap>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <system_error>

#include "core/batch/command_line.h"
#include "shell/ending_signals.h"
#include "shell/manual.h"
#include "shell/program_window.h"
#include "shell/script_runner.h"

namespace mesecina {

namespace {

/// Seconds since this process was started, to a hundredth; negative where the system does not say.
double seconds_since_start() {
  std::ifstream stat("/proc/self/stat");
  std::string line;
  std::getline(stat, line);
  // The second field is the program's name in parentheses; the 22nd is the start in clock ticks since boot.
  const auto after_name = line.rfind(')');
  if (after_name == std::string::npos) return -1;
  std::istringstream fields(line.substr(after_name + 1));
  std::string field;
  constexpr int start_field = 20;
  for (int i = 0; i < start_field; ++i) fields >> field;
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9 -
         std::stod(field) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Where a program keeps scenes that nobody had to save.
std::filesystem::path scenes_folder() {
  return (QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/scenes")).toStdString();
}

/// With MESECINA_FIRST_PICTURE set, for scripts that measure or document the program: when everything visible is
/// computed and drawn, says after how long on stderr, saves the window to the file named by the variable unless that
/// is
/// "-", and quits.
void report_first_picture(Program_window& window) {
  const QString file = qEnvironmentVariable("MESECINA_FIRST_PICTURE");
  if (file.isEmpty()) return;
  auto* poll = new QTimer(&window);
  constexpr int poll_interval = 10;
  QObject::connect(poll, &QTimer::timeout, &window, [&window, poll, file] {
    if (window.document().inputs().is_empty() || window.is_busy()) return;
    poll->stop();
    window.finish_drawing();
    std::cerr << "first picture after " << seconds_since_start() << " s" << std::endl;
    constexpr int time_to_settle = 500;
    QTimer::singleShot(time_to_settle, &window, [&window, file] {
      const bool saved = file == QLatin1String("-") || window.grab().save(file);
      QCoreApplication::exit(saved ? exit_success : exit_some_failed);
    });
  });
  poll->start(poll_interval);
}

void play_script(Program_window& window, const std::string& file) {
  const QString name = QString::fromStdString(file);
  auto* runner = new Script_runner(window, name == QLatin1String("-") ? QStringLiteral("standard input") : name,
                                   read_script(name));
  QObject::connect(runner, &Script_runner::finished, &window, [](const QString& error, bool is_quitting) {
    if (!error.isEmpty()) std::cerr << error.toStdString() << std::endl;
    if (!error.isEmpty() || is_quitting) QCoreApplication::exit(error.isEmpty() ? exit_success : exit_some_failed);
  });
  runner->start();
}

/// What Qt says of a platform without a display is nothing that a user could change.
void be_quiet_without_display() {
  if (!qEnvironmentVariable("QT_QPA_PLATFORM").startsWith(QLatin1String("offscreen"))) return;
  qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type == QtCriticalMsg || type == QtFatalMsg) std::cerr << text.toStdString() << std::endl;
  });
}

void name_application(const Program_identity& identity) {
  QCoreApplication::setOrganizationName(QStringLiteral("mesecina"));
  QCoreApplication::setApplicationName(identity.name);
  QCoreApplication::setApplicationVersion(identity.version);
  QGuiApplication::setApplicationDisplayName(QString());
}

}  // namespace

int run_window(int argc, char** argv, const Program_identity& identity, const Window_order& order,
               const std::function<std::unique_ptr<Program_window>()>& make_window) {
  const auto is_set = [](const char* variable) { return !qEnvironmentVariableIsEmpty(variable); };
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY") && !is_set("QT_QPA_PLATFORM")) {
    std::cerr << identity.name.toStdString()
              << ": expected a display to open a window on, found none; use --nogui to compute without one\n";
    return exit_wrong_usage;
  }
  be_quiet_without_display();
  // Files hold numbers with a decimal point everywhere, and so do the controls.
  QLocale::setDefault(QLocale::c());
  QSurfaceFormat format;
  constexpr int major = 3;
  constexpr int minor = 3;
  format.setVersion(major, minor);
  format.setProfile(identity.profile);
  // Without this one gets no compatibility, whatever the profile.
  format.setOption(QSurfaceFormat::DeprecatedFunctions, identity.profile == QSurfaceFormat::CompatibilityProfile);
  QSurfaceFormat::setDefaultFormat(format);
  QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
  QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
  // Qt would take --style for its own.
  int own_count = std::min(argc, 1);
  QApplication application(own_count, argv);
  name_application(identity);
  const std::unique_ptr<Program_window> window = make_window();
  const Ending_signals signals;
  QObject::connect(&signals, &Ending_signals::received, window.get(), [&] {
    // Other windows, like the manual, would go on.
    const int code = order.script ? exit_interrupted : exit_success;
    QObject::connect(window.get(), &Program_window::closed, qApp, [code] { QCoreApplication::exit(code); });
    window->end();
  });
  // Pictures of windows for documents, and scripts, depend on nothing that was before and leave nothing behind.
  if (!is_set("MESECINA_FIRST_PICTURE") && !order.script) window->keep_scenes(scenes_folder(), identity.is_plain_start);
  report_first_picture(*window);
  if (order.script) play_script(*window, *order.script);
  window->show();
  return QApplication::exec();
}

int use_hidden_window(int argc, char** argv, const Program_identity& identity,
                      const std::function<std::unique_ptr<Program_window>()>& make_window,
                      const std::function<int(Program_window&)>& use) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  be_quiet_without_display();
  QLocale::setDefault(QLocale::c());
  int own_count = std::min(argc, 1);
  QApplication application(own_count, argv);
  name_application(identity);
  const QTemporaryDir preferences;
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, preferences.path());
  const std::unique_ptr<Program_window> window = make_window();
  return use(*window);
}

int write_manual_folder(int argc, char** argv, const Program_identity& identity,
                        const std::shared_ptr<const Registry>& registry, const Formats& formats,
                        const std::filesystem::path& folder,
                        const std::function<std::unique_ptr<Program_window>()>& make_window,
                        const std::function<void(const QString& name, const QString& folder)>& write_example) {
  std::error_code error;
  std::filesystem::create_directories(folder / "pictures", error);
  if (error) {
    std::cerr << identity.name.toStdString() << ": --manual " << folder.string() << ": cannot be made a directory ("
              << error.message() << ")" << std::endl;
    return exit_wrong_usage;
  }
  bool is_complete = true;
  const auto make_pictures_first = [&] {
    // Windows have threads, and what computes pictures must not be a copy of a process that has.
    is_complete = make_manual_pictures({identity.name, *registry, formats, nullptr}, registry, folder, write_example);
    return make_window();
  };
  return use_hidden_window(argc, argv, identity, make_pictures_first, [&](const Program_window& window) {
    write_manual(Manual({identity.name, *registry, formats, &window.commands()}), folder);
    return is_complete ? exit_success : exit_some_failed;
  });
}

int list_commands(const Program_window& window, bool as_json) {
  std::cout << commands_text(window.commands(), as_json);
  return exit_success;
}

}  // namespace mesecina

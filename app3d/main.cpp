// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include "core/batch/batch.h"
#include "core/batch/command_line.h"
#include "core/session_formats.h"
#include "geometries/modules_3.h"
#ifdef MESECINA_WITH_WINDOW
#include "app3d/start_window.h"
#include "core/batch/worker_pool.h"
#include "layers/color_map.h"
#include "layers/space_pictures.h"
#endif

namespace {

constexpr const char* program = "mesecina3d";

#ifdef MESECINA_WITH_WINDOW

void add_pictures(mesecina::Formats& formats, std::vector<std::string>& color_maps) {
  mesecina::add_space_picture_formats(formats);
  for (const mesecina::Color_map& map : mesecina::color_maps()) color_maps.push_back(map.name());
}

/// Why there can be no pictures here; empty when there can. Found out by another process: contexts of graphics have
/// threads, and the workers of a batch are copies of this process, which must have none.
std::string reason_against_pictures() {
  mesecina::Worker_pool asked(
      1, {[](std::size_t, const std::stop_token&) { return mesecina::reason_against_space_pictures(); }, [] {}});
  asked.give(0);
  constexpr int nothing_else = -1;
  const auto done = asked.wait(nothing_else);
  return done && done->answer ? *done->answer : "OpenGL ends the process that uses it";
}

/// Without what pictures need, everything else is computed and written all the same.
int run_without_window(mesecina::Command_line command_line, const std::shared_ptr<const mesecina::Registry>& registry,
                       const mesecina::Formats& formats) {
  const auto png = std::ranges::find(command_line.formats, "png");
  std::string reason;
  if (png != command_line.formats.end() || command_line.recording) reason = reason_against_pictures();
  if (!reason.empty()) {
    std::cerr << program << ": no pictures: " << reason << '\n';
    if (png != command_line.formats.end()) command_line.formats.erase(png);
    const bool was_all = command_line.formats.empty() && command_line.recording;
    command_line.recording.reset();
    if (was_all) return mesecina::exit_some_failed;
  }
  const int code = mesecina::run_batch(command_line, program, registry, formats, std::cerr, isatty(STDERR_FILENO) != 0);
  return reason.empty() || code != mesecina::exit_success ? code : mesecina::exit_some_failed;
}

int open_window(int argc, char** argv, const mesecina::Command_line& command_line,
                const std::shared_ptr<const mesecina::Registry>& registry, const mesecina::Formats& formats) {
  return mesecina::start_window(argc, argv, command_line, registry, formats);
}

#else

void add_pictures(mesecina::Formats&, std::vector<std::string>&) {}

int run_without_window(const mesecina::Command_line& command_line,
                       const std::shared_ptr<const mesecina::Registry>& registry, const mesecina::Formats& formats) {
  return mesecina::run_batch(command_line, program, registry, formats, std::cerr, isatty(STDERR_FILENO) != 0);
}

int open_window(int, char**, const mesecina::Command_line&, const std::shared_ptr<const mesecina::Registry>&,
                const mesecina::Formats&) {
  std::cerr << program << ": this was built without windows; compute and write files with --nogui. Try --help.\n";
  return mesecina::exit_wrong_usage;
}

#endif

int run(int argc, char** argv) {
  const auto registry = mesecina::make_registry_3();
  mesecina::Formats formats = mesecina::spatial_formats();
  std::vector<std::string> color_maps;
  add_pictures(formats, color_maps);
  mesecina::add_session_formats(formats, registry);
  const auto parsed = mesecina::parse_command_line(argc, argv, program, *registry, formats, color_maps);
  if (const auto* exit = std::get_if<mesecina::Early_exit>(&parsed)) {
    (exit->code == mesecina::exit_success ? std::cout : std::cerr) << exit->text;
    return exit->code;
  }
  const auto& command_line = std::get<mesecina::Command_line>(parsed);
  if (command_line.nogui) return run_without_window(command_line, registry, formats);
  return open_window(argc, argv, command_line, registry, formats);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << program << ": " << error.what() << std::endl;
    return mesecina::exit_some_failed;
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "app2d/start_window.h"
#include "core/batch/batch.h"
#include "core/batch/command_line.h"
#include "core/session_formats.h"
#include "geometries/modules_2.h"
#include "layers/color_map.h"
#include "layers/picture_formats.h"

namespace {

constexpr const char* program = "mesecina2d";

int run_without_window(const mesecina::Command_line& command_line,
                       const std::shared_ptr<const mesecina::Registry>& registry, const mesecina::Formats& formats) {
  const auto wants = [&](const char* format) {
    return std::ranges::find(command_line.formats, format) != command_line.formats.end();
  };
  // Only these need fonts, and starting the application takes longer than most computations.
  std::optional<mesecina::Picture_application> application;
  if (wants("png") || wants("pdf") || command_line.recording) application.emplace();
  return mesecina::run_batch(command_line, program, registry, formats, std::cerr, isatty(STDERR_FILENO) != 0);
}

int run(int argc, char** argv) {
  const auto registry = mesecina::make_registry_2();
  mesecina::Formats formats = mesecina::planar_formats();
  mesecina::add_picture_formats(formats);
  mesecina::add_session_formats(formats, registry);

  std::vector<std::string> color_maps;
  for (const mesecina::Color_map& map : mesecina::color_maps()) color_maps.push_back(map.name());

  const auto parsed = mesecina::parse_command_line(argc, argv, program, *registry, formats, color_maps);
  if (const auto* exit = std::get_if<mesecina::Early_exit>(&parsed)) {
    (exit->code == mesecina::exit_success ? std::cout : std::cerr) << exit->text;
    return exit->code;
  }
  const auto& command_line = std::get<mesecina::Command_line>(parsed);
  if (command_line.nogui) return run_without_window(command_line, registry, formats);
  return mesecina::start_window(argc, argv, command_line, registry, formats);
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

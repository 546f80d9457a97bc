// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <iostream>

#include "core/batch/batch.h"
#include "core/batch/command_line.h"
#include "geometries/modules_3.h"

namespace {

constexpr const char* program = "mesecina3d";

int run(int argc, char** argv) {
  const auto registry = mesecina::make_registry_3();
  const mesecina::Formats formats = mesecina::spatial_formats();
  const auto parsed = mesecina::parse_command_line(argc, argv, program, *registry, formats, {});
  if (const auto* exit = std::get_if<mesecina::Early_exit>(&parsed)) {
    (exit->code == mesecina::exit_success ? std::cout : std::cerr) << exit->text;
    return exit->code;
  }
  const auto& command_line = std::get<mesecina::Command_line>(parsed);
  if (command_line.nogui)
    return mesecina::run_batch(command_line, program, registry, formats, std::cerr, isatty(STDERR_FILENO) != 0);
  std::cerr << program << ": there is no window yet; compute and write files with --nogui. Try --help.\n";
  return mesecina::exit_wrong_usage;
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

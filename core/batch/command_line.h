// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/batch/recording.h"
#include "core/canvas_background.h"
#include "core/formats/format.h"
#include "core/registry.h"
#include "core/session.h"
#include "core/style.h"

namespace mesecina {

enum class Log_level { error, warning, info };

/// Exit codes of the programs; scripts rely on them.
inline constexpr int exit_success = 0;
inline constexpr int exit_some_failed = 1;
inline constexpr int exit_wrong_usage = 2;
inline constexpr int exit_interrupted = 130;  ///< by SIGINT or SIGTERM

/// An evolution and how many of its steps.
struct Evolution_order {
  std::string id;
  std::uint64_t steps = 1;
  bool operator==(const Evolution_order&) const = default;
};

struct Command_line {
  bool nogui = false;
  std::vector<std::filesystem::path> files;
  std::vector<std::string> layers;  ///< known ids; empty: those visible by default
  Settings settings;
  /// What becomes of the inputs, one after the other, before layers are computed.
  std::vector<Evolution_order> evolutions;
  std::map<std::string, Style> styles;     ///< by layer: the looks in pictures that were changed from their defaults
  std::vector<std::string> style_changes;  ///< as they were given: LAYER.PROPERTY=VALUE
  std::optional<std::filesystem::path> session_file;
  std::shared_ptr<const Session> session;  ///< of that file; what it says is in the other members already
  bool as_listed = false;                  ///< pictures: `layers` from bottom to top, not in the order of the registry
  std::optional<std::string> bundle;       ///< as it was given
  std::vector<std::string> bundle_needs;   ///< Bundle::needs of it
  std::vector<std::string> warnings;       ///< of what was read with it
  std::filesystem::path output = "out";
  std::vector<std::string> formats = {"json"};  ///< none where only a film is wanted
  int width = 1200;                             ///< of pictures, in pixels
  int height = 900;
  std::optional<View_2> view;                        ///< in the plane, of a picture of that size; absent: fit
  std::optional<View_3> view_3;                      ///< in space; absent: fit
  std::vector<Camera_3> key_frames;                  ///< in space: the camera path that came with the view
  std::optional<Canvas_background> background = {};  ///< of pictures and the window; absent: paper, or the user's usual
  bool transparent_background = false;               ///< of pictures, whatever `background` is
  std::optional<Recording> recording;                ///< a film of each input
  std::optional<std::filesystem::path> stats;
  int jobs = 1;
  bool resume = false;
  /// "commands": what a window can do is to be listed, which needs what makes windows. All other lists are given by
  /// parse_command_line itself.
  std::optional<std::string> list;
  bool list_as_json = false;
  std::optional<std::string> script;            ///< file of commands for the window; "-": standard input
  std::optional<std::filesystem::path> manual;  ///< folder that the manual is to be written into
  std::uint64_t seed = 0;
  int threads = 0;  ///< 0: as many as there are cores, divided among the jobs
  Log_level log = Log_level::warning;
};

/// What to print and with which exit code, instead of running.
struct Early_exit {
  int code = 0;
  std::string text;  ///< to stdout if the code is 0, else to stderr
};

/// Reads the command line. Unknown layers, settings, evolutions, formats, properties of styles and colour maps (known
/// are those named by `color_maps`) give exit_wrong_usage with the nearest known name.
std::variant<Command_line, Early_exit> parse_command_line(int argc, const char* const* argv, const std::string& program,
                                                          const Registry& registry, const Formats& formats,
                                                          const std::vector<std::string>& color_maps);

/// Text of --list WHAT: layers, settings, evolutions, bundles or formats. `user_bundles`: the file of the user's list.
std::string list_text(const std::string& what, bool as_json, const Registry& registry, const Formats& formats,
                      const std::filesystem::path& user_bundles);

}  // namespace mesecina

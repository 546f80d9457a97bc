// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/canvas_background.h"
#include "core/film_wish.h"
#include "core/formats/scene_json.h"
#include "core/inputs.h"
#include "core/registry.h"
#include "core/settings.h"
#include "core/style.h"
#include "core/view_3.h"

namespace mesecina {

/// Extension of the files that hold a session.
inline constexpr std::string_view session_extension = "mesecina";

/// Everything that a user sees in a window of a program: a value.
struct Session {
  int dimension = 2;
  std::string title;         ///< of the data ("giraffe.wkt"); empty for data without a name
  std::string file;          ///< absolute path of the file of the data or the session; empty for none
  bool is_modified = false;  ///< the data is not in that file as it is here
  Inputs inputs;
  Settings settings;
  Layer_list layers;
  std::optional<View_2> view_2;
  /// Of the canvas that view_2 was seen in, in logical pixels: elsewhere as much of the plane is shown as fits.
  double width = 0;
  double height = 0;
  std::optional<View_3> view_3;
  std::vector<Camera_3> camera_path;
  /// The bundle that was shown last.
  struct Bundle_name {
    std::string name;
    bool is_changed = false;  ///< layers, looks or settings are not as it has them
    bool operator==(const Bundle_name&) const = default;
  };
  std::optional<Bundle_name> bundle;
  std::optional<Canvas_background> background;  ///< none: the user's usual one
  std::optional<Film_wish> film;                ///< that was to be recorded next
  /// What evolutions went through, from where the first one began; none for data that no evolution has changed.
  struct Step {
    Inputs inputs;
    std::map<std::string, std::optional<Setting_value>> settings;  ///< that steps change; nullopt: the default
    std::string evolution;                                         ///< that led here; empty for the start
    std::uint64_t number = 0;                                      ///< of the step in its evolution
  };
  std::vector<Step> steps;
  std::size_t position = 0;                ///< the step that is shown
  std::vector<std::string> step_settings;  ///< that the steps were made by
  /// What this version does not know of a file that it read: written again as it was.
  struct Unknown {
    Unknown_parts parts;                         ///< with the notes of reading, one line each
    std::map<std::string, std::string> inputs;   ///< by id, as JSON
    std::map<std::string, std::string> members;  ///< of the whole, by name, as JSON
    Film_wish::Unknown film;
  };
  Unknown unknown;
};

/// The view that shows in a picture of this size what `view_2` showed.
std::optional<View_2> view_for(const Session& session, double width, double height);

/// The JSON of an input, or of a reference to it: as append_input_json by default.
using Input_text = std::function<std::string(const Inputs& inputs, std::string_view id)>;
/// What is in the file that an input refers to: JSON, or bytes of write_input_bytes. Throws File_error.
using Input_source = std::function<std::string(const std::string& file)>;

/// The text of a session: JSON, in ASCII. Numbers read back as they were. Inputs that have no form in JSON are left
/// out; without_form names them. O(size).
std::string to_json(const Session& session, const Input_text& input_text = {});
/// The ids of inputs that a session cannot hold.
std::vector<std::string> without_form(const Inputs& inputs);

/// Reads it. What this version does not know (layers, settings, inputs, members) is kept in `unknown`, with a note.
/// Throws std::invalid_argument, with the place within the JSON or the line, what was expected and what was found, for
/// anything else: other JSON, other programs' dimension, newer versions, wrong values. `source`: for texts that refer
/// to files.
Session parse_session(std::string_view text, const Registry& registry, const Input_source& source = {});

}  // namespace mesecina

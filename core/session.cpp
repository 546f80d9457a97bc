// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "core/formats/input_bytes.h"
#include "core/formats/input_json.h"
#include "core/formats/json_text.h"
#include "core/formats/text_file.h"

namespace mesecina {

namespace {

using Json = nlohmann::json;

constexpr const char* format_name = "mesecina-session";
constexpr int newest_version = 1;

/// Makes JSON of one version from that of the version before.
using Migration = void (*)(Json&);
/// Number i makes version i + 2.
constexpr std::array<Migration, newest_version - 1> migrations{};

std::string describe_json(const Json& json) { return quote(json.dump(-1, ' ', true, Json::error_handler_t::replace)); }

[[noreturn]] void refuse(const std::string& expected, const std::string& found) {
  throw std::invalid_argument("expected " + expected + ", found " + found);
}

std::string dumped(const Json& json) {
  constexpr int indent = 1;
  return json.dump(indent, ' ', true, Json::error_handler_t::replace);
}

/// Appends a member of the outermost object.
void append_member(std::string& text, const std::string& name, const std::string& value) {
  text += text.size() > 1 ? ",\n" : "\n";
  text += Json(name).dump(-1, ' ', true, Json::error_handler_t::replace) + ": " + value;
}

Json view_of(const Session& session) {
  Json json;
  if (session.view_2) {
    json = view_to_json(*session.view_2);
    json["size"] = {session.width, session.height};
  } else if (session.view_3) {
    json = Json::parse(to_json(*session.view_3, session.camera_path));
  }
  return json;
}

/// Takes the member out of the object; null where there is none.
Json take(Json& json, const char* name) {
  const auto it = json.find(name);
  if (it == json.end()) return nullptr;
  Json value = std::move(*it);
  json.erase(it);
  return value;
}

std::string take_text(Json& json, const char* name) {
  const Json value = take(json, name);
  if (value.is_null()) return {};
  if (!value.is_string()) refuse("a text \"" + std::string(name) + "\"", describe_json(value));
  return value.get<std::string>();
}

void check_format(Json& json) {
  if (!json.is_object() || json.value("format", Json()) != format_name)
    refuse("a session, which begins with \"format\": \"" + std::string(format_name) + "\"",
           json.is_object() && json.contains("format") ? describe_json(json["format"]) : "other JSON");
  const Json version = json.value("version", Json());
  if (!version.is_number_integer() || version < 1) refuse("a \"version\" from 1", describe_json(version));
  if (version > newest_version)
    refuse("a session of version " + std::to_string(newest_version) + " or older",
           "version " + version.dump() + "; open it with a newer Mesecina");
  for (auto i = version.get<std::size_t>() - 1; i < migrations.size(); ++i) migrations[i](json);
  json.erase("format");
  json.erase("version");
}

/// Of the step with this number, or of what is shown.
using Known_inputs = std::function<const Inputs&(const Json& reference, const std::string& where)>;

/// What is not known goes into `unknown`, or is refused where that is null.
Inputs inputs_of(const Json& json, const std::string& where, const Input_source& source, const Known_inputs& known,
                 Session::Unknown* unknown) {
  if (!json.is_object()) refuse_json(json, where, "an object with inputs");
  Inputs inputs;
  for (const auto& entry : json.items()) {
    const std::string& id = entry.key();
    const Json& value = entry.value();
    const std::string here = where + "." + id;
    if (value.is_object() && value.contains("same-as")) {
      const Inputs& other = known(value["same-as"], here);
      if (!has_input_json(other, id)) refuse_json(value, here, "a reference to an input that there is");
      inputs = with_input_of(inputs, id, other);
    } else if (value.is_object() && value.contains("file") && source) {
      if (!value["file"].is_string()) refuse_json(value["file"], here, "the name of a file");
      const std::string text = source(value["file"].get<std::string>());
      inputs =
          is_input_bytes(text) ? with_input_bytes(inputs, id, text) : with_input_json(inputs, id, parse_json(text));
    } else if (is_input_json(id, value) || !unknown) {
      inputs = with_input_json(inputs, id, value);
    } else {
      unknown->parts.notes.push_back(where + ": there is no input '" + id + "'; it is kept, not shown");
      unknown->inputs[id] = value.dump();
    }
  }
  return inputs;
}

/// Where the values of inputs stand that were written already.
using Written = std::map<const void*, std::string>;

/// Inputs as an object; those in `written` by reference. Others are added there, as being at `reference`.
std::string inputs_text(const Inputs& inputs, const Input_text& input_text, const std::string& reference,
                        Written& written) {
  std::string text = "{";
  for (const std::string& id : inputs.ids()) {
    if (!has_input_json(inputs, id)) continue;
    const auto [known, is_new] = written.emplace(inputs.identity(id), reference);
    std::string value;
    if (!is_new && known->second != reference) {
      value = "{\"same-as\": " + known->second + "}";
    } else if (input_text) {
      value = input_text(inputs, id);
    } else {
      append_input_json(value, inputs, id);
    }
    append_member(text, id, value);
  }
  return text;
}

Json step_settings_json(const Session::Step& step) {
  Settings changed;
  Json json = Json::object();
  for (const auto& [id, value] : step.settings) {
    if (value) {
      changed = changed.with(id, *value);
    } else {
      json[id] = nullptr;
    }
  }
  json.update(settings_to_json(changed));
  return json;
}

std::string evolution_text(const Session& session, const Input_text& input_text, Written& written) {
  std::string text = "{";
  append_member(text, "position", std::to_string(session.position));
  append_member(text, "made-by", Json(session.step_settings).dump());
  std::string steps;
  for (std::size_t i = 0; i < session.steps.size(); ++i) {
    const Session::Step& step = session.steps[i];
    std::string entry = "{";
    append_member(entry, "evolution", dumped(step.evolution));
    append_member(entry, "number", std::to_string(step.number));
    append_member(entry, "settings", dumped(step_settings_json(step)));
    append_member(entry, "inputs", inputs_text(step.inputs, input_text, std::to_string(i), written) + "}");
    steps += (i == 0 ? "" : ",\n") + entry + "}";
  }
  append_member(text, "steps", "[" + steps + "]");
  return text + "}";
}

Session::Step step_of(const Json& json, const std::string& where, const Registry& registry, const Input_source& source,
                      const Known_inputs& known) {
  if (!json.is_object()) refuse_json(json, where, "an object with a step");
  Session::Step step;
  const Json evolution = json.value("evolution", Json());
  if (!evolution.is_string()) refuse_json(evolution, where + ".evolution", "the name of an evolution");
  step.evolution = evolution.get<std::string>();
  const Json number = json.value("number", Json());
  if (!number.is_number_unsigned()) refuse_json(number, where + ".number", "a whole number from 0");
  step.number = number.get<std::uint64_t>();
  Json settings = json.value("settings", Json::object());
  if (!settings.is_object()) refuse_json(settings, where + ".settings", "an object with values of settings");
  for (auto it = settings.begin(); it != settings.end();) {
    if (it->is_null()) step.settings[it.key()] = std::nullopt;
    it = it->is_null() ? settings.erase(it) : std::next(it);
  }
  Unknown_parts ignored;
  const Settings changed = settings_from_json(settings, registry, where + ".settings", ignored);
  for (const auto& [id, value] : changed.changed()) step.settings[id] = value;
  step.inputs = inputs_of(json.value("inputs", Json()), where + ".inputs", source, known, nullptr);
  return step;
}

void read_evolution(Session& session, const Json& json, const Registry& registry, const Input_source& source) {
  if (json.is_null()) return;
  const Json steps = json.is_object() ? json.value("steps", Json()) : Json();
  if (!steps.is_array()) refuse_json(json, "evolution", "an object with a list of \"steps\"");
  const Known_inputs known = [&](const Json& reference, const std::string& where) -> const Inputs& {
    if (reference == "inputs") return session.inputs;
    if (!reference.is_number_unsigned() || reference.get<std::size_t>() >= session.steps.size())
      refuse_json(reference, where, "a reference to an earlier step");
    return session.steps[reference.get<std::size_t>()].inputs;
  };
  for (std::size_t i = 0; i < steps.size(); ++i)
    session.steps.push_back(step_of(steps[i], "evolution.steps[" + std::to_string(i) + "]", registry, source, known));
  const Json position = json.value("position", Json());
  if (!position.is_number_unsigned() || position.get<std::size_t>() >= std::max<std::size_t>(1, steps.size()))
    refuse_json(position, "evolution.position", "the number of a step");
  session.position = position.get<std::size_t>();
  for (const Json& id : json.value("made-by", Json::array())) {
    if (!id.is_string()) refuse_json(id, "evolution.made-by", "names of settings");
    session.step_settings.push_back(id.get<std::string>());
  }
}

void read_view(Session& session, const Json& json) {
  if (json.is_null()) return;
  if (session.dimension == 3) {
    const std::string text = json.dump();
    session.view_3 = parse_view_3(text);
    session.camera_path = parse_camera_path_3(text);
    return;
  }
  session.view_2 = view_2_from_json(json, "view");
  const auto size = json.find("size");
  if (size == json.end()) return;
  const auto is_size = [](const Json& n) { return n.is_number() && n.get<double>() >= 0; };
  if (!size->is_array() || size->size() != 2 || !std::ranges::all_of(*size, is_size))
    refuse("two numbers \"size\" of the view", describe_json(*size));
  session.width = (*size)[0].get<double>();
  session.height = (*size)[1].get<double>();
}

std::optional<Session::Bundle_name> bundle_of(const Json& json) {
  if (json.is_null()) return std::nullopt;
  const Json name = json.is_object() ? json.value("name", Json()) : Json();
  if (!name.is_string()) refuse_json(json, "bundle", "an object with the \"name\" of a bundle");
  const Json changed = json.value("changed", Json(false));
  if (!changed.is_boolean()) refuse_json(changed, "bundle.changed", "true or false");
  return Session::Bundle_name{name.get<std::string>(), changed.get<bool>()};
}

std::optional<Canvas_background> background_of(const Json& json) {
  if (json.is_null()) return std::nullopt;
  const auto background = json.is_string() ? background_named(json.get<std::string>()) : std::nullopt;
  if (!background) refuse_json(json, "background", "\"paper\", \"dark\", \"window\" or \"none\"");
  return background;
}

}  // namespace

std::optional<View_2> view_for(const Session& session, double width, double height) {
  std::optional<View_2> view = session.view_2;
  const bool has_sizes = session.width > 0 && session.height > 0 && width > 0 && height > 0;
  if (view && has_sizes) view->scale *= std::min(width / session.width, height / session.height);
  return view;
}

std::vector<std::string> without_form(const Inputs& inputs) {
  std::vector<std::string> ids;
  for (const std::string& id : inputs.ids())
    if (!has_input_json(inputs, id)) ids.push_back(id);
  return ids;
}

std::string to_json(const Session& session, const Input_text& input_text) {
  std::string text = "{";
  append_member(text, "format", Json(format_name).dump());
  append_member(text, "version", std::to_string(newest_version));
  append_member(text, "dimension", std::to_string(session.dimension));
  if (!session.title.empty()) append_member(text, "title", dumped(session.title));
  if (!session.file.empty()) append_member(text, "file", dumped(session.file));
  if (session.is_modified) append_member(text, "modified", "true");
  const Unknown_parts& parts = session.unknown.parts;
  append_member(text, "settings", dumped(settings_to_json(session.settings, parts.settings)));
  append_member(text, "layers", dumped(layers_to_json(session.layers, parts.layers)));
  if (const Json view = view_of(session); !view.is_null()) append_member(text, "view", dumped(view));
  if (session.bundle)
    append_member(text, "bundle", dumped({{"name", session.bundle->name}, {"changed", session.bundle->is_changed}}));
  if (session.background) append_member(text, "background", dumped(name_of(*session.background)));
  if (session.film) append_member(text, "recording", dumped(film_wish_to_json(*session.film, session.unknown.film)));
  for (const auto& [name, json] : session.unknown.members) append_member(text, name, dumped(Json::parse(json)));
  Written written;
  std::string inputs = inputs_text(session.inputs, input_text, "\"inputs\"", written);
  for (const auto& [id, json] : session.unknown.inputs) append_member(inputs, id, dumped(Json::parse(json)));
  append_member(text, "inputs", inputs + "}");
  if (!session.steps.empty()) append_member(text, "evolution", evolution_text(session, input_text, written));
  return text + "\n}\n";
}

Session parse_session(std::string_view text, const Registry& registry, const Input_source& source) {
  Json json = parse_json(text);
  check_format(json);
  Session session;
  const Json dimension = take(json, "dimension");
  if (dimension != registry.dimension()) {
    const bool is_of_the_other_program = dimension == (registry.dimension() == 2 ? 3 : 2);
    refuse("a session of mesecina" + std::to_string(registry.dimension()) + "d",
           is_of_the_other_program ? "one of mesecina" + dimension.dump() + "d; open it with that program"
                                   : "\"dimension\": " + describe_json(dimension));
  }
  session.dimension = registry.dimension();
  session.title = take_text(json, "title");
  session.file = take_text(json, "file");
  const Json modified = take(json, "modified");
  session.is_modified = modified.is_boolean() && modified.get<bool>();
  Unknown_parts& unknown = session.unknown.parts;
  if (const Json settings = take(json, "settings"); !settings.is_null())
    session.settings = settings_from_json(settings, registry, "settings", unknown);
  if (const Json layers = take(json, "layers"); !layers.is_null())
    session.layers = layers_from_json(layers, registry, "layers", unknown);
  read_view(session, take(json, "view"));
  session.bundle = bundle_of(take(json, "bundle"));
  session.background = background_of(take(json, "background"));
  if (const Json film = take(json, "recording"); !film.is_null())
    session.film = film_wish_from_json(film, registry, "recording", session.unknown.film, unknown.notes);
  const Known_inputs none = [](const Json& reference, const std::string& where) -> const Inputs& {
    refuse_json(reference, where, "an input itself");
  };
  if (const Json inputs = take(json, "inputs"); !inputs.is_null())
    session.inputs = inputs_of(inputs, "inputs", source, none, &session.unknown);
  read_evolution(session, take(json, "evolution"), registry, source);
  for (const auto& [name, value] : json.items()) {
    unknown.notes.push_back("'" + name + "' means nothing to this version; it is kept");
    session.unknown.members[name] = value.dump();
  }
  return session;
}

}  // namespace mesecina

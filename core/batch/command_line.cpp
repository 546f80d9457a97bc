// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/command_line.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "core/batch/bundle_library.h"
#include "core/batch/bundle_option.h"
#include "core/batch/style_option.h"
#include "core/evolution.h"
#include "core/formats/film.h"
#include "core/formats/json_text.h"
#include "core/formats/number.h"
#include "core/formats/scene_json.h"
#include "core/session_formats.h"

namespace mesecina {

namespace {

/// Wrong usage, in one line.
class Usage_error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void refuse_unknown(const std::string& kind, const std::string& name,
                                 const std::vector<std::string>& known) {
  const std::string suggestion = nearest_name(name, known);
  throw Usage_error(
      "unknown " + kind + " '" + name + "'" +
      (suggestion.empty() ? "; --list " + kind + "s shows them all" : "; did you mean '" + suggestion + "'?"));
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<std::string> layer_ids(const Registry& registry) {
  std::vector<std::string> ids;
  for (const Layer_spec& layer : registry.layers()) ids.push_back(layer.id);
  return ids;
}

std::vector<std::string> setting_ids(const Registry& registry) {
  std::vector<std::string> ids;
  for (const Setting_spec& setting : registry.settings()) ids.push_back(setting.id);
  return ids;
}

std::vector<std::string> evolution_ids(const Registry& registry) {
  std::vector<std::string> ids;
  for (const Evolution_spec& evolution : registry.evolutions()) ids.push_back(evolution.id);
  return ids;
}

std::vector<std::string> output_formats(const Formats& formats) {
  std::vector<std::string> names;
  for (const Layer_writer& writer : formats.layer_writers) names.push_back(writer.name);
  for (const Picture_writer& writer : formats.picture_writers) names.push_back(writer.name);
  return names;
}

void check_names(const std::string& kind, const std::vector<std::string>& names,
                 const std::vector<std::string>& known) {
  for (const std::string& name : names)
    if (std::ranges::find(known, name) == known.end()) refuse_unknown(kind, name, known);
}

/// `settings` with the values assigned.
Settings read_settings(const std::vector<std::string>& assignments, const Registry& registry, Settings settings) {
  for (const std::string& assignment : assignments) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos)
      throw Usage_error("--set " + assignment + ": expected ID=VALUE; --list settings shows the ids");
    const std::string id = assignment.substr(0, equals);
    const Setting_spec* spec = registry.find_setting(id);
    if (!spec) refuse_unknown("setting", id, setting_ids(registry));
    try {
      settings = settings.with(id, parse_setting(*spec, assignment.substr(equals + 1)));
    } catch (const std::invalid_argument& error) {
      throw Usage_error(error.what());
    }
  }
  return settings;
}

std::vector<Evolution_order> read_evolutions(const std::vector<std::string>& orders, const Registry& registry) {
  constexpr double most_steps = 1e9;
  std::vector<Evolution_order> evolutions;
  for (const std::string& order : orders) {
    const auto equals = order.find('=');
    if (equals == std::string::npos)
      throw Usage_error("--evolve " + order + ": expected ID=STEPS; --list evolutions shows the ids");
    const std::string id = order.substr(0, equals);
    if (!registry.find_evolution(id)) refuse_unknown("evolution", id, evolution_ids(registry));
    const double steps = parse_number(order.substr(equals + 1)).value_or(0);
    if (!(steps >= 1 && steps <= most_steps) || steps != std::floor(steps))
      throw Usage_error("--evolve " + id + ": expected a number of steps from 1 to 1000000000, found '" +
                        order.substr(equals + 1) + "'");
    evolutions.push_back({id, static_cast<std::uint64_t>(steps)});
  }
  return evolutions;
}

/// By layer, the look in `styles`, or else the default one, with the changes made to it, in their order.
std::map<std::string, Style> read_styles(const std::vector<std::string>& changes, const Registry& registry,
                                         const std::vector<std::string>& color_maps,
                                         std::map<std::string, Style> styles) {
  for (const std::string& change : changes) {
    const auto equals = change.find('=');
    const auto dot = change.find('.');
    if (equals == std::string::npos || dot > equals)
      throw Usage_error("--style " + change + ": expected LAYER.PROPERTY=VALUE; --list layers shows the layers");
    const std::string id = change.substr(0, dot);
    const Layer_spec* layer = registry.find_layer(id);
    if (!layer) refuse_unknown("layer", id, layer_ids(registry));
    try {
      set_style_property(styles.try_emplace(id, layer->style).first->second, change.substr(dot + 1, equals - dot - 1),
                         change.substr(equals + 1), color_maps);
    } catch (const std::invalid_argument& error) {
      throw Usage_error("--style " + change + ": " + error.what());
    }
  }
  return styles;
}

/// Explicit layers win over the bundle's.
void use_bundle(Command_line& line, const Registry& registry, const std::filesystem::path& user_bundles,
                bool has_layers) {
  const std::vector<std::string> layers = line.layers;
  const bool as_listed = line.as_listed;
  try {
    take_bundle(line, read_bundle_option(*line.bundle, registry, user_bundles, line.warnings), registry);
  } catch (const std::exception& error) {
    throw Usage_error("--bundle: " + std::string(error.what()));
  }
  if (!has_layers) return;
  line.layers = layers;
  line.as_listed = as_listed;
}

std::pair<int, int> read_size(const std::string& text) {
  const auto cross = text.find('x');
  const double width = parse_number(text.substr(0, cross)).value_or(0);
  const double height = cross == std::string::npos ? 0 : parse_number(text.substr(cross + 1)).value_or(0);
  constexpr double most_pixels = 32768;
  const auto is_good = [](double n) { return n >= 1 && n <= most_pixels && n == std::floor(n); };
  if (!is_good(width) || !is_good(height))
    throw Usage_error("--size: expected WIDTHxHEIGHT with numbers from 1 to 32768, found '" + text + "'");
  return {static_cast<int>(width), static_cast<int>(height)};
}

/// What was given to --view, and how errors call it.
struct View_source {
  std::string name;
  std::string text;
};

/// A view itself begins with a brace or, in the plane, is four numbers; all else is the name of a file.
View_source read_view_source(const std::string& given, int dimension) {
  const auto start = given.find_first_not_of(" \t\r\n");
  const bool is_json = start != std::string::npos && given[start] == '{';
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
  const bool is_numbers = dimension == 2 && start != std::string::npos &&
                          given.find_first_not_of("+-.0123456789eE \t\r\n") == std::string::npos &&
                          std::ranges::any_of(given.substr(start), is_space);
  if (is_json || is_numbers) return {"--view", given};
  std::ifstream stream(given);
  if (!stream) throw Usage_error("--view " + given + ": cannot be read; give a view file, its text or 'fit'");
  std::stringstream buffer;
  buffer << stream.rdbuf();
  return {"--view " + given, buffer.str()};
}

void read_view_3(const View_source& source, Command_line& result) {
  try {
    result.view_3 = parse_view_3(source.text);
    result.key_frames = parse_camera_path_3(source.text);
  } catch (const std::invalid_argument& error) {
    throw Usage_error(source.name + ": " + error.what());
  }
}

/// What is given of --record and its companions.
struct Recording_words {
  std::string file;
  std::vector<std::string> sweeps;
  double frames_per_second = 30;
  int turntable = 0;
  int flight = 0;
  bool has_session_steps = false;

  bool moves() const { return !sweeps.empty() || turntable > 0 || flight > 0 || has_session_steps; }
};

/// What the session says of films, where the command line says nothing. `is_given` knows options.
void complete_by_session(Recording_words& words, Command_line& line, std::string& size,
                         const std::function<bool(const char*)>& is_given) {
  if (words.file.empty() || !line.session || !line.session->film) return;
  const Film_wish& wish = *line.session->film;
  if (!is_given("--fps")) words.frames_per_second = wish.frames_per_second;
  if (!is_given("--size")) size = std::to_string(wish.width) + "x" + std::to_string(wish.height);
  line.transparent_background = line.transparent_background || wish.is_transparent;
  if (words.moves() || is_given("--evolve")) return;
  if (wish.source == Film_wish::Source::turntable) words.turntable = wish.turntable;
  if (wish.source == Film_wish::Source::animation)
    for (const Sweep& sweep : wish.sweeps) words.sweeps.push_back(to_text(sweep));
  // Steps belong to the data that they were made of.
  const bool has_its_data = line.files == std::vector{*line.session_file};
  words.has_session_steps =
      wish.source == Film_wish::Source::evolution && has_its_data && line.session->steps.size() > 1;
}

std::optional<Recording> read_recording(const Recording_words& words, const Command_line& line,
                                        const Registry& registry, const Formats& formats) {
  if (words.file.empty()) {
    if (words.moves()) throw Usage_error("--sweep, --turntable and --camera-path are for films: add --record FILE");
    return std::nullopt;
  }
  if (!line.nogui) throw Usage_error("--record needs --nogui; in the window, recording is in the menu File");
  if (!formats.make_film) throw Usage_error("--record: this was built without pictures");
  if (!words.moves() && line.evolutions.empty())
    throw Usage_error("--record " + words.file + ": nothing moves; add --sweep ID=FROM:TO:STEPS, --evolve ID=STEPS" +
                      (registry.dimension() == 3 ? ", --turntable FRAMES or --camera-path FRAMES" : ""));
  Recording recording;
  recording.file = words.file;
  recording.frames_per_second = words.frames_per_second;
  recording.turntable = words.turntable;
  recording.flight = words.flight;
  recording.has_session_steps = words.has_session_steps;
  for (const std::string& sweep : words.sweeps) {
    try {
      recording.sweeps.push_back(parse_sweep(registry, sweep));
    } catch (const std::invalid_argument& error) {
      throw Usage_error("--sweep " + sweep + ": " + error.what());
    }
    const std::string& setting = recording.sweeps.back().setting;
    if (std::ranges::count(recording.sweeps, setting, &Sweep::setting) > 1)
      throw Usage_error("--sweep " + sweep + ": " + setting + " moves already; give it one --sweep");
  }
  if (words.flight > 0) {
    recording.camera_path = line.key_frames;
    if (recording.camera_path.size() < 2)
      throw Usage_error("--camera-path: expected --view FILE with at least two cameras in its \"camera-path\", found " +
                        std::to_string(recording.camera_path.size()));
  }
  const std::string reason = reason_against(
      {recording.file, line.width, line.height, recording.frames_per_second, line.transparent_background});
  if (!reason.empty()) throw Usage_error("--record " + reason);
  for (const std::filesystem::path& file : line.files) {
    std::error_code error;
    if (std::filesystem::equivalent(file, recording.file, error))
      throw Usage_error("--record " + words.file + ": this is an input and would be overwritten");
  }
  return recording;
}

/// JSON {"center": [x, y], "scale": pixels per unit}, or the text "xmin xmax ymin ymax" of older programs.
View_2 read_view(const View_source& source, int width, int height) {
  const std::string& text = source.text;
  View_2 view;
  if (const auto start = text.find_first_not_of(" \t\r\n"); start != std::string::npos && text[start] == '{') {
    try {
      return view_2_from_json(parse_json(text), "the view");
    } catch (const std::invalid_argument& error) {
      throw Usage_error(source.name + ": " + error.what());
    }
  } else {
    std::vector<double> numbers;
    std::istringstream words(text);
    for (std::string word; words >> word;) {
      const auto number = parse_number(word);
      if (!number) throw Usage_error(source.name + ": expected a number, found '" + word + "'");
      numbers.push_back(*number);
    }
    if (numbers.size() != 4 || !(numbers[1] > numbers[0]) || !(numbers[3] > numbers[2]))
      throw Usage_error(source.name + ": expected xmin xmax ymin ymax or a JSON view");
    view.center = {(numbers[0] + numbers[1]) / 2, (numbers[2] + numbers[3]) / 2};
    view.scale = std::min(width / (numbers[1] - numbers[0]), height / (numbers[3] - numbers[2]));
  }
  if (!(view.scale > 0) || !std::isfinite(view.scale))
    throw Usage_error(source.name + ": expected a positive scale, found " + format_number(view.scale));
  return view;
}

/// What a session says, as if it had been spelled out.
void take_session(Command_line& result, const std::filesystem::path& file, const Registry& registry) {
  try {
    result.session = std::make_shared<const Session>(read_session_file(file, registry));
  } catch (const File_error& error) {
    throw Usage_error("--session " + std::string(error.what()));
  }
  result.session_file = file;
  if (result.files.empty()) {
    // Its reader tells what is not understood.
    result.files.push_back(file);
  } else {
    for (const std::string& note : result.session->unknown.parts.notes)
      result.warnings.push_back("--session " + file.string() + ": " + note);
  }
  result.settings = result.session->settings;
  result.background = result.session->background;
  for (const auto& [id, style] : result.session->layers) {
    if (!registry.find_layer(id)) continue;
    result.styles[id] = style;
    result.styles[id].visible = true;
  }
  if (!result.layers.empty()) return;
  result.as_listed = true;
  for (const auto& [id, style] : result.session->layers)
    if (style.visible && registry.find_layer(id)) result.layers.push_back(id);
}

}  // namespace

std::variant<Command_line, Early_exit> parse_command_line(int argc, const char* const* argv, const std::string& program,
                                                          const Registry& registry, const Formats& formats,
                                                          const std::vector<std::string>& color_maps) {
  Command_line result;
  CLI::App app(
      (registry.dimension() == 3
           ? std::string(
                 "Explore geometric structures in space: unions of balls, medial axes, scale axes and surfaces.\n")
           : std::string("Explore geometric structures in the plane: Voronoi diagrams, crusts, medial axes and their "
                         "filtrations.\n")) +
          "With files, opens them in a window; with --nogui, computes and writes without one.\n"
          "Exit codes: 0 all written, 1 some input or picture failed (all else is written), 2 wrong usage, 130 stopped "
          "by "
          "SIGINT or SIGTERM (--resume goes on).",
      program);
  app.set_version_flag("--version", program + " " MESECINA_VERSION);
  std::vector<std::string> files;
  std::vector<std::string> assignments;
  std::vector<std::string> evolutions;
  std::string size = "1200x900";
  std::string view = "fit";
  std::string stats;
  std::string output = "out";
  std::string list;
  Recording_words recording;
  std::string session;
  app.add_option("FILE", files, "Points, outlines or pictures to read (--list formats)");
  app.add_option(
      "--session", session,
      "A session, or a picture with one within: its data where no FILE is given, its layers, styles, "
      "settings, view and background and, with --record, what it records; other options come after it and win");
  app.add_flag("--nogui", result.nogui, "Compute and write, open no window; needs no display");
  app.add_option("--layers", result.layers, "Layers to compute: ID,ID,... (--list layers)")
      ->delimiter(',')
      ->allow_extra_args(false);
  app.add_option("--bundle", result.bundle,
                 "Layers, looks, settings, view and background of a bundle: NAME (--list bundles), FILE or FILE#NAME; "
                 "shipped:NAME as it "
                 "came with the program, where yours has that name too. --layers, --set, --style and --view change "
                 "them")
      ->allow_extra_args(false);
  app.add_option("--set", assignments, "A setting: ID=VALUE, repeatable (--list settings)")->allow_extra_args(false);
  app.add_option("--evolve", evolutions,
                 "First goes steps of an evolution: ID=STEPS, repeatable, in order (--list evolutions)")
      ->allow_extra_args(false);
  app.add_option("--style", result.style_changes,
                 "With --nogui, the look of a layer in pictures: LAYER.PROPERTY=VALUE, repeatable. Properties: " +
                     joined(style_properties()))
      ->allow_extra_args(false);
  app.add_flag("--as-listed", result.as_listed,
               "With --nogui, pictures show the layers in the order of --layers, the first below all others");
  app.add_option("--output", output, "Directory for the results")->capture_default_str();
  app.add_option("--formats", result.formats, "What to write: NAME,NAME,... (--list formats)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  app.add_option("--size", size, "Size of pictures in pixels, WIDTHxHEIGHT")->capture_default_str();
  app.add_option("--view", view, "What pictures and the window show: a view file or its text, or 'fit'")
      ->capture_default_str();
  std::string background;
  app.add_option("--background", background,
                 "Of pictures and the window: paper, dark, window (its colour; in pictures the light one) or none. "
                 "On dark ones dark colours are lightened")
      ->check(CLI::IsMember({"paper", "dark", "window", "none"}))
      ->default_str("paper");
  app.add_flag("--transparent", result.transparent_background, "Pictures have no background, as --background none");
  app.add_option(
      "--record", recording.file,
      "With --nogui, a film: NAME.mp4, NAME.webm, NAME.gif or numbered pictures, NAME-%05d.png. Frames are the "
      "steps of --evolve and --sweep" +
          std::string(registry.dimension() == 3 ? ", --turntable and --camera-path" : "") +
          ". With several inputs, their stems come before NAME. Other files are written only where --formats "
          "asks for them");
  app.add_option("--sweep", recording.sweeps,
                 "With --record, a number that moves: ID=FROM:TO:STEPS, repeatable; with :smooth it starts and ends "
                 "slowly, with :ping-pong it comes back")
      ->allow_extra_args(false);
  if (registry.dimension() == 3) {
    app.add_option("--turntable", recording.turntable, "With --record, the camera goes round once in so many frames")
        ->check(CLI::Range(1, most_sweep_steps));
    app.add_option("--camera-path", recording.flight,
                   "With --record, the camera goes through the key frames of the file of --view in so many frames")
        ->check(CLI::Range(1, most_sweep_steps));
  }
  app.add_option("--fps", recording.frames_per_second, "With --record, frames per second")->capture_default_str();
  app.add_option("--stats", stats,
                 "Write one JSON object per input and line: counts, seconds per stage, memory, warnings. Without a "
                 "file: DIRECTORY OF --output/stats.jsonl. And a table, summary.csv, in that directory")
      ->expected(0, 1);
  app.add_option("--jobs", result.jobs, "Inputs computed at the same time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_flag("--resume", result.resume, "Skip inputs whose results are complete");
  app.add_option("--list", list,
                 "List layers, settings, evolutions, bundles, formats, or the commands of the window and of scripts")
      ->check(CLI::IsMember({"layers", "settings", "evolutions", "bundles", "formats", "commands"}));
  app.add_flag("--json", result.list_as_json, "With --list: as JSON");
  app.add_option("--script", result.script,
                 "Carry out commands in the window, one a line; -: from the standard input (--list commands)");
  app.add_option("--manual", result.manual, "Write the manual into this directory, as HTML with pictures");
  app.add_option("--seed", result.seed, "Seed of everything random")->capture_default_str();
  app.add_option("--threads", result.threads,
                 "Threads per input; 0: all cores, shared by the jobs. Results never depend on it")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--log", result.log, "What is reported on stderr: error, warning or info")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, Log_level>{
              {"error", Log_level::error}, {"warning", Log_level::warning}, {"info", Log_level::info}},
          CLI::ignore_case))
      ->default_str("warning");
  try {
    app.parse(argc, argv);
    result.files.assign(files.begin(), files.end());
    result.output = output;
    if (app.count("--stats") > 0)
      result.stats = stats.empty() ? result.output / "stats.jsonl" : std::filesystem::path(stats);
    // .json may hold an outline, but is also what a file of statistics is likely to be called.
    if (result.stats && result.stats->extension() != ".json" && formats.reader_for(*result.stats))
      throw Usage_error("--stats " + stats +
                        ": this looks like an input and would be overwritten; put --stats last, or " +
                        "give it a name like stats.jsonl");
    if (list == "commands") {
      result.list = list;
      return result;
    }
    if (!list.empty())
      return Early_exit{exit_success,
                        list_text(list, result.list_as_json, registry, formats, user_bundle_file(program))};
    check_names("layer", result.layers, layer_ids(registry));
    check_names("format", result.formats, output_formats(formats));
    const bool has_layers = !result.layers.empty();
    if (app.count("--record") > 0 && recording.file.empty())
      throw Usage_error("--record: expected the name of a file, found nothing");
    if (app.count("--manual") > 0 && result.manual->empty())
      throw Usage_error("--manual: expected the name of a directory, found nothing");
    if (app.count("--session") > 0) take_session(result, session, registry);
    if (result.bundle) use_bundle(result, registry, user_bundle_file(program), has_layers);
    result.settings = read_settings(assignments, registry, result.settings);
    if (app.count("--seed") > 0 && registry.find_setting(evolution_seed_setting.id) &&
        !result.settings.find(evolution_seed_setting.id))
      result.settings = result.settings.with(evolution_seed_setting.id, static_cast<std::int64_t>(result.seed));
    if (!background.empty()) result.background = background_named(background);
    if (result.background == Canvas_background::none) result.transparent_background = true;
    result.evolutions = read_evolutions(evolutions, registry);
    result.styles = read_styles(result.style_changes, registry, color_maps, result.styles);
    if (result.as_listed && result.layers.empty() && !result.session) throw Usage_error("--as-listed needs --layers");
    complete_by_session(recording, result, size,
                        [&](const char* option) { return app.get_option_no_throw(option) && app.count(option) > 0; });
    std::tie(result.width, result.height) = read_size(size);
    if (result.session && app.count("--view") == 0) {
      result.view = view_for(*result.session, result.width, result.height);
      result.view_3 = result.session->view_3;
      result.key_frames = result.session->camera_path;
    }
    if (view != "fit") {
      const View_source source = read_view_source(view, registry.dimension());
      if (registry.dimension() == 3) {
        read_view_3(source, result);
      } else {
        result.view = read_view(source, result.width, result.height);
      }
    }
    result.recording = read_recording(recording, result, registry, formats);
    if (result.recording && app.count("--formats") == 0) result.formats.clear();
    if (result.nogui && result.session && result.layers.empty()) {
      const std::string nothing = "--session " + session +
                                  ": no layer is visible there, so there is nothing to write; add --layers ID,ID "
                                  "(--list layers) or --bundle NAME";
      if (!result.stats) throw Usage_error(nothing);
      result.warnings.push_back(nothing);
    }
    if (result.nogui && result.script) throw Usage_error("--script needs the window; leave out --nogui");
    if (result.nogui && result.files.empty()) throw Usage_error("--nogui needs at least one input file");
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    const int code = app.exit(error, out, err);
    return Early_exit{code == 0 ? exit_success : exit_wrong_usage,
                      code == 0 ? out.str() : program + ": " + error.what() + "\nTry --help.\n"};
  } catch (const Usage_error& error) {
    return Early_exit{exit_wrong_usage, program + ": " + std::string(error.what()) + "\n"};
  }
  return result;
}

}  // namespace mesecina

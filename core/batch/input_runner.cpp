// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/input_runner.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/batch/scene.h"
#include "core/bundle.h"
#include "core/evolution.h"
#include "core/formats/scene_json.h"
#include "core/help_text.h"

namespace mesecina {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::map<std::string, Setting_value> all_settings(const Registry& registry, const Settings& settings) {
  std::map<std::string, Setting_value> values;
  for (const Setting_spec& spec : registry.settings()) values[spec.id] = registry.value(settings, spec.id);
  return values;
}

std::string layer_suffix(const std::string& layer, const std::string& extension) {
  return "." + layer + "." + extension;
}
std::string picture_suffix(const std::string& extension) { return "." + extension; }

/// What the steps of a session are, seen with these settings: those that steps change are as they were.
std::vector<Evolution_state> states_of(const Session& session, const Settings& settings) {
  std::vector<Evolution_state> states;
  for (const Session::Step& step : session.steps) {
    Evolution_state state{step.inputs, settings};
    for (const auto& [id, value] : step.settings)
      state.settings = value ? state.settings.with(id, *value) : state.settings.without(id);
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace

Input_runner::Input_runner(const Command_line& command_line, std::shared_ptr<const Registry> registry,
                           const Formats& formats, Output_folder& folder)
    : command_line_(command_line),
      registry_(std::move(registry)),
      formats_(formats),
      folder_(folder),
      layers_(shown_layers(*registry_, command_line)) {}

/// What the results depend on, in one line: with the same text they need not be computed again.
std::string Input_runner::fingerprint(const fs::path& file) const {
  nlohmann::ordered_json json;
  std::error_code error;
  json["version"] = MESECINA_VERSION;
  json["input"] = fs::weakly_canonical(file, error).string();
  json["bytes"] = fs::file_size(file, error);
  json["changed"] = fs::last_write_time(file, error).time_since_epoch().count();
  json["layers"] = layers_;
  json["formats"] = command_line_.formats;
  json["size"] = {command_line_.width, command_line_.height};
  if (command_line_.view)
    json["view"] = {command_line_.view->center.x, command_line_.view->center.y, command_line_.view->scale};
  if (command_line_.view_3) json["view"] = to_json(*command_line_.view_3);
  json["transparent"] = command_line_.transparent_background;
  if (command_line_.background) json["background"] = name_of(*command_line_.background);
  for (const auto& [id, value] : all_settings(*registry_, command_line_.settings))
    json["settings"][id] = to_text(value);
  for (const Evolution_order& order : command_line_.evolutions) json["evolutions"].push_back({order.id, order.steps});
  for (const auto& [id, style] : command_line_.styles) json["styles"][id] = style_to_json(style);
  json["as-listed"] = command_line_.as_listed;
  json["seed"] = command_line_.seed;
  if (const auto& recording = command_line_.recording) {
    json["film"] = {fs::absolute(recording->file, error).string(),
                    recording->frames_per_second,
                    recording->turntable,
                    recording->flight,
                    recording->has_session_steps,
                    to_json({}, recording->camera_path)};
    for (const Sweep& sweep : recording->sweeps) json["sweeps"].push_back(to_text(sweep));
  }
  // The name of a file need not be UTF-8.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::vector<std::string> Input_runner::result_names() const {
  std::vector<std::string> names;
  for (const std::string& format : command_line_.formats) {
    if (const Layer_writer* writer = formats_.find_layer_writer(format)) {
      for (const std::string& layer : layers_) names.push_back(layer_suffix(layer, writer->extension));
    } else if (const Picture_writer* picture = formats_.find_picture_writer(format)) {
      names.push_back(picture_suffix(picture->extension));
    }
  }
  return names;
}

std::optional<std::string> Input_runner::find_complete(const fs::path& file) const {
  std::optional<std::string> record = folder_.find_complete(file, fingerprint(file), result_names());
  std::error_code error;
  if (const auto film = film_of(file); film && record)
    if (film_kind_of(*film) != Film_kind::frames && !fs::is_regular_file(*film, error)) record.reset();
  // A run without statistics leaves none.
  if (record && command_line_.stats && !nlohmann::json::accept(*record)) return std::nullopt;
  return record;
}

void Input_runner::write_layers(const fs::path& file, Graph& graph, Progress& progress, Input_statistics& statistics) {
  const auto settings = all_settings(*registry_, graph.settings());
  double write_seconds = 0;
  const bool wants_pictures = std::ranges::any_of(
      command_line_.formats, [&](const std::string& name) { return formats_.find_picture_writer(name) != nullptr; });
  std::map<std::string, std::shared_ptr<const Primitive_set>> kept;
  for (const std::string& id : layers_) {
    const Outcome<Primitive_set> outcome = graph.layer(id, progress);
    if (outcome.reason == out_of_memory_reason) throw std::bad_alloc();
    const std::string reason = with_ids(outcome.reason);
    std::shared_ptr<const Primitive_set> primitives = outcome.value;
    const auto cut = registry_->cut(*registry_->find_layer(id), graph.settings());
    if (primitives && cut) primitives = std::make_shared<const Primitive_set>(apply_cut(*primitives, *cut));
    for (const Remark& remark : graph.remarks(id)) {
      const std::string warning = with_ids(remark.text);
      if (std::ranges::find(statistics.warnings, warning) == statistics.warnings.end())
        statistics.warnings.push_back(warning);
    }
    // A bundle names what may be drawn over: the inputs of all kinds.
    const bool is_asked_for = !command_line_.bundle || registry_->find_layer(id)->stage != "Input";
    if (!primitives && !command_line_.layers.empty() && is_asked_for)
      statistics.warnings.push_back("layer " + id + ": " + reason);
    if (primitives && wants_pictures) warn_of_missing_value(id, *primitives, statistics);
    const auto start = Clock::now();
    for (const std::string& name : command_line_.formats) {
      const Layer_writer* writer = formats_.find_layer_writer(name);
      if (!writer) continue;
      if (const std::string text = empty_file_text(*writer, primitives.get()); !text.empty())
        statistics.warnings.push_back("layer " + id + ": " + text);
      const Layer_document document{id,     file.filename().string(), settings, primitives.get(),
                                    reason, registry_->dimension()};
      write_file(folder_.unfinished(file, layer_suffix(id, writer->extension)),
                 [&](std::ostream& stream) { writer->write(stream, document); });
    }
    write_seconds += seconds_since(start);
    if (command_line_.stats) statistics.layers.emplace_back(id, layer_statistics(primitives.get(), reason));
    if (wants_pictures) kept[id] = std::move(primitives);
  }
  const auto start = Clock::now();
  const auto find_kept = [&](const std::string& id) { return kept[id]; };
  write_pictures(file, make_scene(*registry_, command_line_, graph.settings(), find_kept), bounding_box(graph.inputs()),
                 statistics);
  statistics.seconds["write"] = write_seconds + seconds_since(start);
}

/// The names of values are known when a layer is there, not before.
void Input_runner::warn_of_missing_value(const std::string& layer, const Primitive_set& primitives,
                                         Input_statistics& statistics) const {
  const auto style = command_line_.styles.find(layer);
  if (style == command_line_.styles.end() || style->second.value.empty()) return;
  std::string known;
  for (const Values& values : primitives.values) {
    if (values.name == style->second.value) return;
    known += (known.empty() ? "; it has " : ", ") + values.name;
  }
  statistics.warnings.push_back("layer " + layer + ": no values '" + style->second.value + "' to color it by" + known);
}

void Input_runner::write_pictures(const fs::path& file, const Scene& scene, const Box& box,
                                  Input_statistics& statistics) {
  for (const std::string& name : command_line_.formats) {
    const Picture_writer* writer = formats_.find_picture_writer(name);
    if (!writer) continue;
    const std::string suffix = picture_suffix(writer->extension);
    const fs::path path = folder_.unfinished(file, suffix);
    try {
      write_picture(path, *writer, scene, box);
    } catch (const File_error& error) {
      std::string reason = error.what();
      if (reason.starts_with(path.string()))
        reason.replace(0, path.string().size(), folder_.place(file, suffix).string());
      statistics.refused[name] = reason;
    }
  }
}

Evolution_state Input_runner::evolved(Evolution_state state, Progress& progress, Input_statistics& statistics,
                                      const std::function<void(const Evolution_state&)>& visit) const {
  // A graph of its own: what is left of earlier steps must not be found in the order of results.
  Graph graph(registry_);
  graph.set_inputs(std::move(state.inputs));
  graph.set_settings(std::move(state.settings));
  for (const auto& [id, steps] : command_line_.evolutions) {
    const auto start = Clock::now();
    Evolution_result result = evolve(graph, id, steps, progress, [&](std::uint64_t) {
      visit({graph.inputs(), graph.settings()});
    });
    if (result.end_reason == out_of_memory_reason) throw std::bad_alloc();
    result.end_reason = with_ids(result.end_reason);
    if (result.steps_done < steps)
      statistics.warnings.push_back("evolution " + id + ": " + std::to_string(result.steps_done) + " of " +
                                    std::to_string(steps) + " steps: " + result.end_reason);
    statistics.evolutions.push_back({id, result.steps_done, std::move(result.end_reason), seconds_since(start)});
  }
  return {graph.inputs(), graph.settings()};
}

void Input_runner::write_picture(const fs::path& path, const Picture_writer& writer, const Scene& scene,
                                 const Box& box) const {
  const int width = command_line_.width;
  const int height = command_line_.height;
  if (writer.write_3) {
    writer.write_3(path, scene, command_line_.view_3.value_or(View_3{fit_camera(box, width, height), {}}), width,
                   height);
  } else {
    writer.write(path, scene, command_line_.view.value_or(fit_view(box, width, height)), width, height);
  }
}

bool Input_runner::uses_folder() const {
  return !command_line_.formats.empty() || command_line_.stats || command_line_.resume;
}

std::optional<fs::path> Input_runner::film_of(const fs::path& file) const {
  if (!command_line_.recording) return std::nullopt;
  return film_name(*command_line_.recording, file, command_line_.files.size() == 1);
}

void Input_runner::discard(const fs::path& file) const {
  if (uses_folder()) folder_.discard(file);
  std::error_code error;
  if (const auto film = film_of(file)) fs::remove_all(unfinished_film(*film), error);
}

Input_statistics Input_runner::compute(const fs::path& file, int threads, const std::stop_token& stop,
                                       const Film_maker::Listener& listener) {
  Input_statistics statistics;
  statistics.input = file.string();
  const auto start = Clock::now();
  forget_peak_memory();
  try {
    const std::string fingerprint_before = fingerprint(file);
    File_contents contents = read_file(formats_, file);
    statistics.seconds["read"] = seconds_since(start);
    statistics.warnings = std::move(contents.warnings);
    statistics.counts = count_inputs(contents.inputs);
    if (const std::string reason = missing_input_text(command_line_.bundle_needs, contents.inputs); !reason.empty())
      statistics.warnings.push_back("bundle " + *command_line_.bundle + ": " + reason);
    Progress progress(stop, {}, threads);
    if (uses_folder()) folder_.begin(file);
    Evolution_state state{std::move(contents.inputs), command_line_.settings};
    std::vector<Evolution_state> states{state};
    if (command_line_.recording && command_line_.recording->has_session_steps && contents.session)
      states = states_of(*contents.session, state.settings);
    if (!command_line_.evolutions.empty())
      state = evolved(std::move(state), progress, statistics, [&](const Evolution_state& step) {
        if (command_line_.recording) states.push_back(step);
      });
    std::string missing_film;
    if (const auto film = film_of(file)) {
      const auto start_of_film = Clock::now();
      missing_film = Film_maker(command_line_, registry_, formats_, listener)
                         .make(*film, states, threads, stop, statistics.warnings);
      statistics.seconds["film"] = seconds_since(start_of_film);
    }
    Graph graph(registry_);
    graph.set_inputs(std::move(state.inputs));
    graph.set_settings(std::move(state.settings));
    if (uses_folder()) write_layers(file, graph, progress, statistics);
    for (const Graph::Stage& stage : graph.stages()) statistics.seconds[stage.id] += stage.seconds;
    statistics.errors = graph.measures();
    statistics.notes = graph.notes();
    statistics.seconds["total"] = seconds_since(start);
    std::string record = command_line_.stats ? to_json_line(statistics) : std::string();
    if (record.ends_with('\n')) record.pop_back();
    progress.check();
    std::vector<std::string> refused;
    for (const auto& [format, reason] : statistics.refused)
      refused.push_back(picture_suffix(formats_.find_picture_writer(format)->extension));
    if (uses_folder()) folder_.publish(file, fingerprint_before, record, refused);
    statistics.failed = !missing_film.empty();
    statistics.reason = std::move(missing_film);
  } catch (const std::bad_alloc&) {
    discard(file);
    throw;
  } catch (const Cancelled&) {
    discard(file);
    throw;
  } catch (const File_error& error) {
    statistics.failed = true;
    statistics.reason = error.what();
  } catch (const std::exception& error) {
    statistics.failed = true;
    statistics.reason = file.string() + ": " + error.what();
  }
  if (statistics.failed) {
    discard(file);
    statistics.seconds["total"] = seconds_since(start);
  }
  return statistics;
}

}  // namespace mesecina

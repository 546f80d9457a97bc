// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/batch.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>
#include <thread>

#include "core/batch/statistics.h"
#include "core/graph.h"

namespace mesecina {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::vector<std::string> shown_layers(const Registry& registry, const Command_line& command_line) {
  if (!command_line.layers.empty()) return command_line.layers;
  std::vector<std::string> ids;
  for (const Layer_spec& layer : registry.layers())
    if (layer.style.visible) ids.push_back(layer.id);
  return ids;
}

std::map<std::string, std::uint64_t> count_inputs(const Inputs& inputs) {
  std::map<std::string, std::uint64_t> counts;
  if (const auto points = inputs.get(points_input)) counts["points"] = points->size();
  if (const auto disks = inputs.get(disks_input)) counts["disks"] = disks->size();
  if (const auto outline = inputs.get(outline_input)) {
    counts["rings"] = outline->rings.size();
    std::uint64_t vertices = 0;
    for (const Ring_2& ring : outline->rings) vertices += ring.size();
    counts["outline-vertices"] = vertices;
  }
  if (const auto image = inputs.get(image_input))
    counts["pixels"] = static_cast<std::uint64_t>(image->width) * static_cast<std::uint64_t>(image->height);
  if (const auto mesh = inputs.get(mesh_input)) {
    counts["mesh-vertices"] = mesh->vertices.size();
    counts["triangles"] = mesh->triangles.size();
  }
  if (const auto balls = inputs.get(balls_input)) counts["balls"] = balls->size();
  if (const auto cloud = inputs.get(cloud_input)) counts["points"] = cloud->size();
  return counts;
}

std::map<std::string, Setting_value> all_settings(const Registry& registry, const Settings& settings) {
  std::map<std::string, Setting_value> values;
  for (const Setting_spec& spec : registry.settings()) values[spec.id] = registry.value(settings, spec.id);
  return values;
}

/// One run of the batch: what is the same for all inputs.
class Batch {
 public:
  Batch(const Command_line& command_line, const std::string& program, std::shared_ptr<const Registry> registry,
        const Formats& formats, std::ostream& errors)
      : command_line_(command_line),
        program_(program),
        registry_(std::move(registry)),
        formats_(formats),
        errors_(errors) {
    layers_ = shown_layers(*registry_, command_line);
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    threads_ = command_line.threads > 0 ? command_line.threads : std::max(1, cores / std::max(1, command_line.jobs));
  }

  int run();

 private:
  void process(std::size_t index);
  Input_statistics compute(const fs::path& file);
  void write_layers(const fs::path& file, Graph& graph, Input_statistics& statistics);
  void warn_of_missing_value(const std::string& layer, const Primitive_set& primitives,
                             Input_statistics& statistics) const;
  void write_pictures(const fs::path& file, const Scene& scene, const Box& box);
  void finish(std::size_t index, const Input_statistics& statistics);
  void say(Log_level level, const std::string& text);

  fs::path target(const fs::path& file, const std::string& suffix) const {
    return command_line_.output / (file.stem().string() + suffix);
  }
  fs::path record_of(const fs::path& file) const {
    return command_line_.output / ".mesecina" / (file.stem().string() + ".json");
  }
  std::string fingerprint(const fs::path& file) const;
  bool is_complete(const fs::path& file) const;

  const Command_line& command_line_;
  std::string program_;
  std::shared_ptr<const Registry> registry_;
  const Formats& formats_;
  std::ostream& errors_;
  std::vector<std::string> layers_;
  int threads_ = 1;

  std::mutex picture_mutex_;
  std::mutex mutex_;  ///< of all below
  std::vector<std::string> lines_;
  std::vector<bool> is_done_;
  std::size_t next_line_ = 0;
  std::ofstream stats_;
  std::size_t done_ = 0;
  bool any_failed_ = false;
  Clock::time_point start_ = Clock::now();
};

void Batch::say(Log_level level, const std::string& text) {
  if (level > command_line_.log) return;
  const std::lock_guard lock(mutex_);
  errors_ << program_ << ": " << text << std::endl;
}

/// What the results depend on: with the same text they need not be computed again.
std::string Batch::fingerprint(const fs::path& file) const {
  nlohmann::ordered_json json;
  std::error_code error;
  json["version"] = MESECINA_VERSION;
  json["input"] = file.filename().string();
  json["input"] = fs::weakly_canonical(file, error).string();
  json["bytes"] = fs::file_size(file, error);
  json["changed"] = fs::last_write_time(file, error).time_since_epoch().count();
  json["layers"] = layers_;
  json["formats"] = command_line_.formats;
  json["size"] = {command_line_.width, command_line_.height};
  if (command_line_.view)
    json["view"] = {command_line_.view->center.x, command_line_.view->center.y, command_line_.view->scale};
  for (const auto& [id, value] : all_settings(*registry_, command_line_.settings))
    json["settings"][id] = to_text(value);
  json["styles"] = command_line_.style_changes;
  json["as-listed"] = command_line_.as_listed;
  json["seed"] = command_line_.seed;
  // The name of a file need not be UTF-8.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

bool Batch::is_complete(const fs::path& file) const {
  std::ifstream stream(record_of(file));
  if (!stream) return false;
  std::stringstream text;
  text << stream.rdbuf();
  if (text.str() != fingerprint(file)) return false;
  const auto exists = [](const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
  };
  for (const std::string& name : command_line_.formats) {
    if (const Layer_writer* writer = formats_.find_layer_writer(name)) {
      for (const std::string& layer : layers_)
        if (!exists(target(file, "." + layer + "." + writer->extension))) return false;
    } else if (const Picture_writer* picture = formats_.find_picture_writer(name)) {
      if (!exists(target(file, "." + picture->extension))) return false;
    }
  }
  return true;
}

void Batch::write_layers(const fs::path& file, Graph& graph, Input_statistics& statistics) {
  Progress progress({}, {}, threads_);
  const auto settings = all_settings(*registry_, command_line_.settings);
  double write_seconds = 0;
  const bool wants_pictures = std::ranges::any_of(
      command_line_.formats, [&](const std::string& name) { return formats_.find_picture_writer(name) != nullptr; });
  std::map<std::string, std::shared_ptr<const Primitive_set>> kept;
  for (const std::string& id : layers_) {
    const Outcome<Primitive_set> outcome = graph.layer(id, progress);
    std::shared_ptr<const Primitive_set> primitives = outcome.value;
    const auto cut = registry_->cut(*registry_->find_layer(id), command_line_.settings);
    if (primitives && cut) primitives = std::make_shared<const Primitive_set>(apply_cut(*primitives, *cut));
    for (const std::string& warning : graph.warnings(id))
      if (std::ranges::find(statistics.warnings, warning) == statistics.warnings.end())
        statistics.warnings.push_back(warning);
    if (!primitives && !command_line_.layers.empty())
      statistics.warnings.push_back("layer " + id + ": " + outcome.reason);
    if (primitives && wants_pictures) warn_of_missing_value(id, *primitives, statistics);
    const auto start = Clock::now();
    for (const std::string& name : command_line_.formats) {
      const Layer_writer* writer = formats_.find_layer_writer(name);
      if (!writer) continue;
      const Layer_document document{
          id, file.filename().string(), settings, primitives.get(), outcome.reason, registry_->dimension()};
      write_file(target(file, "." + id + "." + writer->extension),
                 [&](std::ostream& stream) { writer->write(stream, document); });
    }
    write_seconds += seconds_since(start);
    if (command_line_.stats) statistics.layers.emplace_back(id, layer_statistics(primitives.get(), outcome.reason));
    if (wants_pictures) kept[id] = std::move(primitives);
  }
  const auto start = Clock::now();
  write_pictures(file, make_scene(*registry_, command_line_, [&](const std::string& id) { return kept[id]; }),
                 bounding_box(graph.inputs()));
  statistics.seconds["write"] = write_seconds + seconds_since(start);
}

/// The names of values are known when a layer is there, not before.
void Batch::warn_of_missing_value(const std::string& layer, const Primitive_set& primitives,
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

void Batch::write_pictures(const fs::path& file, const Scene& scene, const Box& box) {
  for (const std::string& name : command_line_.formats) {
    const Picture_writer* writer = formats_.find_picture_writer(name);
    if (!writer) continue;
    const View_2 view =
        command_line_.view ? *command_line_.view : fit_view(box, command_line_.width, command_line_.height);
    // Picture formats share one application's fonts and need not be safe for several threads.
    const std::lock_guard lock(picture_mutex_);
    writer->write(target(file, "." + writer->extension), scene, view, command_line_.width, command_line_.height);
  }
}

Input_statistics Batch::compute(const fs::path& file) {
  Input_statistics statistics;
  statistics.input = file.string();
  const auto start = Clock::now();
  try {
    File_contents contents = read_file(formats_, file);
    statistics.seconds["read"] = seconds_since(start);
    statistics.warnings = std::move(contents.warnings);
    statistics.counts = count_inputs(contents.inputs);
    Graph graph(registry_);
    graph.set_inputs(std::move(contents.inputs));
    graph.set_settings(command_line_.settings);
    // From here on what lies there is a mixture, should this run not come to its end.
    fs::remove(record_of(file));
    write_layers(file, graph, statistics);
    for (const Graph::Stage& stage : graph.stages()) statistics.seconds[stage.id] += stage.seconds;
    statistics.errors = graph.measures();
    statistics.notes = graph.notes();
    write_file(record_of(file), [&](std::ostream& stream) { stream << fingerprint(file); });
  } catch (const File_error& error) {
    statistics.failed = true;
    statistics.reason = error.what();
  } catch (const std::bad_alloc&) {
    statistics.failed = true;
    statistics.reason = file.string() + ": not enough memory";
  } catch (const std::exception& error) {
    statistics.failed = true;
    statistics.reason = file.string() + ": " + error.what();
  }
  statistics.seconds["total"] = seconds_since(start);
  return statistics;
}

void Batch::finish(std::size_t index, const Input_statistics& statistics) {
  if (statistics.failed) {
    say(Log_level::error, statistics.reason);
  } else {
    // A reader's warning names its file already.
    for (const std::string& warning : statistics.warnings)
      say(Log_level::warning, (warning.starts_with(statistics.input) ? "" : statistics.input + ": ") + warning);
  }
  std::string progress;
  {
    const std::lock_guard lock(mutex_);
    any_failed_ = any_failed_ || statistics.failed;
    ++done_;
    const double elapsed = seconds_since(start_);
    const double left = elapsed / static_cast<double>(done_) * static_cast<double>(command_line_.files.size() - done_);
    std::ostringstream text;
    text.precision(3);
    text << done_ << " of " << command_line_.files.size() << " done, about " << left << " s left";
    progress = text.str();
    // Lines come in the order of the inputs, each as soon as those before it are there.
    lines_[index] = command_line_.stats ? to_json_line(statistics) : std::string();
    is_done_[index] = true;
    while (next_line_ < lines_.size() && is_done_[next_line_]) {
      stats_ << lines_[next_line_];
      lines_[next_line_++].clear();
    }
    stats_.flush();
  }
  say(Log_level::info, progress);
}

void Batch::process(std::size_t index) {
  const fs::path& file = command_line_.files[index];
  if (command_line_.resume && is_complete(file)) {
    Input_statistics statistics;
    statistics.input = file.string();
    statistics.warnings.emplace_back("results are complete; skipped");
    finish(index, statistics);
    return;
  }
  finish(index, compute(file));
}

int Batch::run() {
  std::map<std::string, fs::path> stems;
  for (const fs::path& file : command_line_.files) {
    const auto [it, is_new] = stems.emplace(file.stem().string(), file);
    if (!is_new) {
      errors_ << program_ << ": " << it->second.string() << " and " << file.string() << " would both write '"
              << it->first << ".*'; give one of them another --output" << std::endl;
      return exit_wrong_usage;
    }
  }
  std::error_code error;
  fs::create_directories(command_line_.output / ".mesecina", error);
  if (error) {
    errors_ << program_ << ": --output " << command_line_.output.string() << ": cannot be made a directory ("
            << error.message() << ")" << std::endl;
    return exit_wrong_usage;
  }
  if (command_line_.stats) {
    stats_.open(*command_line_.stats);
    if (!stats_) {
      errors_ << program_ << ": --stats " << command_line_.stats->string() << ": cannot be written" << std::endl;
      return exit_wrong_usage;
    }
  }
  lines_.resize(command_line_.files.size());
  is_done_.resize(command_line_.files.size());

  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < command_line_.files.size(); i = next++) process(i);
  };
  {
    std::vector<std::jthread> helpers;
    const std::size_t jobs =
        std::min<std::size_t>(static_cast<std::size_t>(command_line_.jobs), command_line_.files.size());
    for (std::size_t j = 1; j < jobs; ++j) helpers.emplace_back(work);
    work();
  }
  if (command_line_.stats && !stats_.flush()) {
    errors_ << program_ << ": --stats " << command_line_.stats->string() << ": could not be written to its end"
            << std::endl;
    return exit_some_failed;
  }
  return any_failed_ ? exit_some_failed : exit_success;
}

}  // namespace

Scene make_scene(const Registry& registry, const Command_line& command_line,
                 const std::function<std::shared_ptr<const Primitive_set>(const std::string&)>& primitives) {
  const std::vector<std::string> ids = shown_layers(registry, command_line);
  std::vector<const Layer_spec*> layers;
  const auto add = [&](const Layer_spec& layer) {
    if (std::ranges::find(layers, &layer) == layers.end()) layers.push_back(&layer);
  };
  if (command_line.as_listed) {
    for (const std::string& id : ids) add(*registry.find_layer(id));
  } else {
    for (const Layer_spec& layer : registry.layers())
      if (std::ranges::find(ids, layer.id) != ids.end()) add(layer);
  }
  Scene scene;
  for (const Layer_spec* layer : layers) {
    const auto changed = command_line.styles.find(layer->id);
    Scene_layer entry{layer->id, layer->label, primitives(layer->id), registry.cut(*layer, command_line.settings),
                      changed == command_line.styles.end() ? layer->style : changed->second};
    entry.style.visible = true;
    scene.layers.push_back(std::move(entry));
  }
  return scene;
}

int run_batch(const Command_line& command_line, const std::string& program, std::shared_ptr<const Registry> registry,
              const Formats& formats, std::ostream& errors) {
  return Batch(command_line, program, std::move(registry), formats, errors).run();
}

}  // namespace mesecina

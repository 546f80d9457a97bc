// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/film_maker.h"

#include <algorithm>
#include <new>
#include <utility>

#include "core/batch/scene.h"
#include "core/camera_path_3.h"
#include "core/film_ranges.h"
#include "core/help_text.h"
#include "core/turntable_3.h"

namespace mesecina {

namespace fs = std::filesystem;

fs::path film_name(const Recording& recording, const fs::path& input, bool is_only_input) {
  if (is_only_input) return recording.file;
  std::string stem = input.stem().string();
  // In a name with a place for the number there is one %.
  if (film_kind_of(recording.file) == Film_kind::frames) std::ranges::replace(stem, '%', '_');
  return recording.file.parent_path() / (stem + "." + recording.file.filename().string());
}

Film_maker::Film_maker(const Command_line& command_line, std::shared_ptr<const Registry> registry,
                       const Formats& formats, Listener listener)
    : command_line_(command_line),
      recording_(*command_line.recording),
      registry_(std::move(registry)),
      formats_(formats),
      listener_(std::move(listener)) {}

int Film_maker::frames(int states) const {
  return std::max({1, states, frames_of(recording_.sweeps), recording_.turntable, recording_.flight});
}

Settings Film_maker::settings(const Evolution_state& state, int frame) const {
  return swept(*registry_, state.settings, recording_.sweeps, frame);
}

Scene Film_maker::scene(Graph& graph, int frame, Progress& progress, std::vector<std::string>& warnings) {
  return make_scene(*registry_, command_line_, graph.settings(), [&](const std::string& id) {
    const Outcome<Primitive_set> outcome = graph.layer(id, progress);
    if (outcome.reason == out_of_memory_reason) throw std::bad_alloc();
    const auto warn = [&](const std::string& text) {
      if (std::ranges::find(warnings, text) == warnings.end()) warnings.push_back(text);
    };
    for (const Remark& remark : graph.remarks(id)) warn(with_ids(remark.text));
    // The same reason in many frames is told once.
    const std::string start = "layer " + id + ": " + with_ids(outcome.reason) + " (frame ";
    const auto is_known = [&](const std::string& warning) { return warning.starts_with(start); };
    if (!outcome.value && !command_line_.layers.empty() && std::ranges::none_of(warnings, is_known))
      warn(start + std::to_string(frame + 1) + ")");
    return outcome.value;
  });
}

bool Film_maker::has_automatic_ranges() const {
  return Film_ranges::are_wanted_by(
      make_scene(*registry_, command_line_, command_line_.settings,
                 [](const std::string&) { return std::shared_ptr<const Primitive_set>(); }));
}

View_3 Film_maker::view_3(const View_3& start, int frame) const {
  View_3 view = start;
  if (recording_.flight > 0) {
    const double whole = static_cast<double>(recording_.camera_path.size()) - 1;
    const double part = recording_.flight > 1 ? static_cast<double>(frame) / (recording_.flight - 1) : 0;
    view.camera = camera_on_path(recording_.camera_path, whole * part);
  }
  if (recording_.turntable > 0)
    view.camera =
        turned_on_table(view.camera, static_cast<double>(frame % recording_.turntable) / recording_.turntable);
  return view;
}

std::string Film_maker::make(const fs::path& file, const std::vector<Evolution_state>& states, int threads,
                             const std::stop_token& stop, std::vector<std::string>& warnings) {
  const int width = command_line_.width;
  const int height = command_line_.height;
  const int count = frames(static_cast<int>(states.size()));
  const std::unique_ptr<Film> film = formats_.make_film(
      {file, width, height, recording_.frames_per_second, command_line_.transparent_background,
       canvas_color(command_line_.background.value_or(Canvas_background::paper), light_window_color)});
  Box box;
  for (const Evolution_state& state : states) box.add(bounding_box(state.inputs));
  const View_2 view = command_line_.view.value_or(fit_view(box, width, height));
  const View_3 start = command_line_.view_3.value_or(View_3{fit_camera(box, width, height), {}});

  Progress progress(stop, {}, threads);
  // Kept for all frames, so that only what changes is computed.
  Graph graph(registry_);
  const int passes = has_automatic_ranges() ? 2 : 1;
  Film_ranges ranges;
  int done = 0;
  for (int pass = 1; pass <= passes; ++pass) {
    for (int frame = 0; frame < count; ++frame) {
      const Evolution_state& state = states[std::min(static_cast<std::size_t>(frame), states.size() - 1)];
      graph.set_inputs(state.inputs);
      graph.set_settings(settings(state, frame));
      Scene now = scene(graph, frame, progress, warnings);
      graph.clear_stages();
      if (pass == passes) {
        ranges.apply_to(now);
        film->add({std::move(now), view, view_3(start, frame)}, stop);
      } else {
        ranges.widen(now);
      }
      if (listener_) listener_(++done, passes * count);
    }
  }
  return film->finish(stop);
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "core/batch/command_line.h"
#include "core/batch/film_maker.h"
#include "core/batch/output_folder.h"
#include "core/batch/statistics.h"
#include "core/graph.h"

namespace mesecina {

/// Computes what a command line asks for, one input at a time, and writes it.
class Input_runner {
 public:
  Input_runner(const Command_line& command_line, std::shared_ptr<const Registry> registry, const Formats& formats,
               Output_folder& folder);

  /// The layers that are computed: those asked for, or those visible by default.
  const std::vector<std::string>& layers() const { return layers_; }

  /// The statistics of results that are complete and need not be computed again: one line, as of to_json_line.
  std::optional<std::string> find_complete(const std::filesystem::path& file) const;

  /// Whether there are results beside films, which come into the folder.
  bool uses_folder() const;
  /// The film of an input, where one is wanted.
  std::optional<std::filesystem::path> film_of(const std::filesystem::path& file) const;
  /// Removes what a process that ended by force has left of the results of the file.
  void discard(const std::filesystem::path& file) const;

  /// Computes and publishes all results of the file, or none; but a picture that its format refuses (too much for SVG,
  /// too large for PNG) is left out alone. What is wrong with the file is told in what it returns.
  /// Throws Cancelled, and std::bad_alloc where memory is short, also for a single layer. `listener`: of a film.
  Input_statistics compute(const std::filesystem::path& file, int threads, const std::stop_token& stop,
                           const Film_maker::Listener& listener);

 private:
  /// What the evolutions of the command line make of a state.
  Evolution_state evolved(Evolution_state state, Progress& progress, Input_statistics& statistics,
                          const std::function<void(const Evolution_state&)>& visit) const;
  void write_layers(const std::filesystem::path& file, Graph& graph, Progress& progress, Input_statistics& statistics);
  void warn_of_missing_value(const std::string& layer, const Primitive_set& primitives,
                             Input_statistics& statistics) const;
  void write_pictures(const std::filesystem::path& file, const Scene& scene, const Box& box,
                      Input_statistics& statistics);
  void write_picture(const std::filesystem::path& path, const Picture_writer& writer, const Scene& scene,
                     const Box& box) const;
  std::string fingerprint(const std::filesystem::path& file) const;
  std::vector<std::string> result_names() const;

  const Command_line& command_line_;
  std::shared_ptr<const Registry> registry_;
  const Formats& formats_;
  Output_folder& folder_;
  std::vector<std::string> layers_;
};

}  // namespace mesecina

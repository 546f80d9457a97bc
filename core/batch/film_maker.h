// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/batch/command_line.h"
#include "core/formats/film.h"
#include "core/graph.h"

namespace mesecina {

/// Makes the films that the recording of a command line asks for. Its clock are frames: the pictures depend on input
/// and command line only, however long they take.
class Film_maker {
 public:
  /// Told between frames, of the work of all of them.
  using Listener = std::function<void(int done, int all)>;

  /// `command_line` must have a recording, and outlive this like the others.
  Film_maker(const Command_line& command_line, std::shared_ptr<const Registry> registry, const Formats& formats,
             Listener listener = {});

  /// `states`: those of the data, one per frame from the first on; at least one. Adds to `warnings` what layers could
  /// not show. Returns what Film::finish says, and throws as Film does; also Cancelled, std::bad_alloc.
  ///
  /// One view for all frames: that of the command line, or the one that shows the data of all states. Ranges of colour
  /// maps that find themselves are those of all frames together, for which layers are computed twice.
  std::string make(const std::filesystem::path& file, const std::vector<Evolution_state>& states, int threads,
                   const std::stop_token& stop, std::vector<std::string>& warnings);

  /// Of a film of so many states.
  int frames(int states) const;

 private:
  Settings settings(const Evolution_state& state, int frame) const;
  Scene scene(Graph& graph, int frame, Progress& progress, std::vector<std::string>& warnings);
  bool has_automatic_ranges() const;
  View_3 view_3(const View_3& start, int frame) const;

  const Command_line& command_line_;
  const Recording& recording_;
  std::shared_ptr<const Registry> registry_;
  const Formats& formats_;
  Listener listener_;
};

}  // namespace mesecina

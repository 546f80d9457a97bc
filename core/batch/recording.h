// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/animation.h"
#include "core/view_3.h"

namespace mesecina {

/// What --record and its companions ask for. Everything that moves moves together, from the first frame on; what comes
/// to its end before the others stays there, but a turntable goes on turning.
struct Recording {
  std::filesystem::path file;
  double frames_per_second = 30;
  std::vector<Sweep> sweeps;
  int turntable = 0;                  ///< frames of one turn of the camera; 0: it does not turn
  int flight = 0;                     ///< frames of the way through `camera_path`; 0: none
  std::vector<Camera_3> camera_path;  ///< key frames
  bool has_session_steps = false;     ///< the film goes through the steps that the session has
};

/// The name of the film of one input: `file` itself if it is the only input, else with the stem of the input before its
/// own name ("giraffe.scale.mp4").
std::filesystem::path film_name(const Recording& recording, const std::filesystem::path& input, bool is_only_input);

}  // namespace mesecina

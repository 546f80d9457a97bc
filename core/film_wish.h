// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/animation.h"
#include "core/registry.h"

namespace mesecina {

/// What somebody wants to record: which changes make the frames of a film, and of which kind the film is. A value, as
/// the panel of films shows it.
struct Film_wish {
  enum class Source { changes, animation, evolution, turntable };

  Source source = Source::changes;
  std::string file;  ///< its name says what the film is (film_kind_of); empty: not chosen yet
  int width = 1280;  ///< in pixels
  int height = 720;
  double frames_per_second = 30;
  bool is_transparent = false;
  std::vector<Sweep> sweeps;  ///< that an animation consists of
  int turntable = 120;        ///< frames of one turn of the camera

  /// What was read without being understood; written again as it was.
  struct Unknown {
    std::vector<std::string> sweeps;
    std::map<std::string, std::string> members;  ///< by name, as JSON
    bool operator==(const Unknown&) const = default;
  };
  bool operator==(const Film_wish&) const = default;
};

/// {"source": "animation", "file": ..., "size": [1280, 720], "frames-per-second": 30.0, "transparent": false, "sweeps":
/// ["scale=1:2:100:smooth"], "turntable": 120}; sweeps as for --sweep.
nlohmann::json film_wish_to_json(const Film_wish& wish, const Film_wish::Unknown& unknown);

/// Reads it; what the object lacks is as usual. Sweeps of settings that there are none of, and other members, go to
/// `unknown`, with a line each in `notes`. Throws std::invalid_argument, with the place within the JSON, what was
/// expected and what was found, for values that no film can have.
Film_wish film_wish_from_json(const nlohmann::json& json, const Registry& registry, const std::string& path,
                              Film_wish::Unknown& unknown, std::vector<std::string>& notes);

}  // namespace mesecina

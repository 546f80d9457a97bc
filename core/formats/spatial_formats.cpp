// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {

Formats spatial_formats() {
  Formats formats;
  formats.readers = {
      {"OFF meshes and points", {"off"}, read_off},
      {"Wavefront meshes and points", {"obj"}, read_obj},
      {"PLY meshes, points and balls", {"ply"}, read_ply},
      {"STL meshes", {"stl"}, read_stl},
      {"Points and balls in space, one per line", {"xyz", "pts", "pwn", "csv", "txt"}, read_spatial_table},
      {"Weighted points", {"cin"}, read_cin},
      {"WOFF balls", {"woff"}, read_woff},
      {"MOFF medial axes, of which the balls are read", {"moff"}, read_moff},
      {"MA medial meshes, of which the balls are read", {"ma"}, read_ma},
  };
  return formats;
}

}  // namespace mesecina

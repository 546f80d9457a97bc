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
  };
  return formats;
}

}  // namespace mesecina

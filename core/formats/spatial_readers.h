// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/formats/format.h"

namespace mesecina {

/// Meshes. Polygons are triangulated. Colours, normals and texture coordinates are dropped, and so are, with a warning,
/// faces of fewer than three corners. A file without faces holds a cloud of points.

/// OFF of text: "OFF" or, with further columns, "COFF", "NOFF", "STOFF" and their combinations; the numbers of vertices
/// and faces; then each of them on a line of its own. 1.4 million triangles take about half a second.
File_contents read_off(const std::filesystem::path& path);

/// Wavefront OBJ: the statements v and f, whose numbers may be negative. Lines, curves and surfaces are left out with a
/// warning.
File_contents read_obj(const std::filesystem::path& path);

/// PLY, of text or binary of either byte order: the properties x, y, z of `vertex`, in any type and order, and the list
/// vertex_indices (or vertex_index) of `face`. Without faces, a property `radius` of the vertices makes them balls.
/// Other elements are left out with a warning.
File_contents read_ply(const std::filesystem::path& path);

/// STL, of text or binary. Equal points become one vertex.
File_contents read_stl(const std::filesystem::path& path);

}  // namespace mesecina

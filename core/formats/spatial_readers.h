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

/// A volume of numbers, INRIMAGE-4: the closed surface around those that reach Otsu's threshold, which a warning names.
/// One number per place, floats or integers of either byte order; sizes VX, VY, VZ of the cells, and TX, TY, TZ the
/// place of the first number. Refuses what would give more than 20 million triangles. 16 million numbers take seconds.
File_contents read_inr(const std::filesystem::path& path);

/// One point or ball per line, in columns separated by blanks, tabs, commas or semicolons; "#" and "//" start comments;
/// the first line may name the columns. Three columns x y z are points. Four are balls x y z radius in a `.csv` or
/// `.txt` file, unless the name of the fourth says otherwise. Further columns, such as normals, are dropped with a
/// warning. A first line with one integer is the number of points; there may be as many lines of normals after them.
File_contents read_spatial_table(const std::filesystem::path& path);

/// Weighted points, one x y z weight per line, as CGAL's skin surfaces read them: the weight is the *square* of the
/// radius. (In the caffeine molecule of CGAL's demo the weights of H, O, N and C are 0.3 times the squares of the radii
/// 1.25, 1.35, 1.5 and 1.65 of these atoms.)
File_contents read_cin(const std::filesystem::path& path);

/// "WOFF n 0 0" and n lines x y z radius.
File_contents read_woff(const std::filesystem::path& path);

/// A medial axis of a union of balls grown by a factor s: "MOFF n f s", n lines x y z radius, and f lines with the
/// faces "k v1 ... vk angle lambda px py pz". Gives the balls shrunk back, with radius / s; the faces are left out with
/// a warning.
File_contents read_moff(const std::filesystem::path& path);

/// A medial mesh as Q-MAT and MATFP write it: "n e f", n lines "v x y z radius", e lines "e i j", f lines "f i j k".
/// Gives the balls; the edges and faces are left out with a warning.
File_contents read_ma(const std::filesystem::path& path);

}  // namespace mesecina

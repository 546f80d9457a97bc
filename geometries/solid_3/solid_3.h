// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "core/primitives.h"
#include "core/progress.h"

namespace mesecina {

/// What is done with a mesh that does not bound a solid as it is.
enum class Repair {
  automatic,  ///< the mildest of the below that gives a solid
  off,  ///< nothing: the mesh must be closed, oriented consistently up to flips of whole components, without crossings
  wrap  ///< always an offset surface around it
};

/// Answers questions about a surface; safe to ask from several threads.
class Surface_locator_3;

/// A solid and the surface that bounds it.
struct Solid_3 {
  /// Closed, without crossings up to rounding, oriented with its normals out of the solid. Vertices at the same place
  /// are one, every vertex is used, every triangle has area.
  Triangle_mesh_3 surface;
  /// What was done, for statistics: "none", or of "stitched" (open edges joined with others at the same place),
  /// "trimmed" (fins and inner walls left out), "oriented", "filled" (holes), "united" (cut where it crosses itself)
  /// those that apply, in this order and with commas, or "wrapped".
  std::string treatment;
  std::vector<std::string> remarks;  ///< a sentence each, with numbers, on what was found and what was done about it
  int components = 0;                ///< of the surface, joined by edges
  /// Of the closed solid: for a handlebody of genus g the Euler characteristic is 1 - g; the Betti numbers are those of
  /// components, tunnels and cavities. None where the surface is no manifold, because it touches itself.
  std::optional<Topology> topology;
  std::shared_ptr<const Surface_locator_3> locator;
};

/// The solid that a mesh means. Throws Unavailable with a reason and what to do where there is none (no triangles with
/// area; repair off and the mesh open ...).
Solid_3 make_solid(const std::shared_ptr<const Triangle_mesh_3>& mesh, Repair repair, Progress& progress);

/// Per point: it lies in the solid, or on its surface. Exact for the surface as it is. O(log n) per point, on as many
/// threads as `progress` allows.
std::vector<std::uint8_t> are_inside(const Solid_3& solid, std::span<const Point_3> points, Progress& progress);

/// Per point the distance to the surface. O(log n) per point near the surface, on as many threads as `progress` allows.
std::vector<double> distances_to_surface(const Solid_3& solid, std::span<const Point_3> points, Progress& progress);

}  // namespace mesecina

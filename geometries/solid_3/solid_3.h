// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/inputs.h"
#include "core/progress.h"

namespace mesecina {

/// What is done with a mesh that does not bound a solid as it is.
enum class Repair {
  automatic,  ///< the mildest of the below that gives a solid
  off,        ///< nothing: the mesh must be closed, oriented consistently up to flips of whole components, without crossings
  wrap        ///< always an offset surface around it
};

/// Answers questions about a surface; safe to ask from several threads.
class Surface_locator_3;

/// A solid and the surface that bounds it.
struct Solid_3 {
  /// Closed, oriented with its normals outward, without crossings, except where `treatment` says otherwise. Vertices at
  /// the same place are one.
  Triangle_mesh_3 surface;
  std::string treatment;             ///< what was done, for statistics: "none", "oriented", "wrapped", ...
  std::vector<std::string> remarks;  ///< a sentence each, with numbers, on what was found and what was done about it
  int components = 0;                ///< connected components of the surface
  /// Of the closed solid. For a handlebody of genus g: 1 - g.
  std::int64_t euler = 0;
  std::array<std::int64_t, 3> betti{};  ///< components, tunnels, cavities of the solid
  std::shared_ptr<const Surface_locator_3> locator;
};

/// The solid that a mesh means. Throws Unavailable with a reason and what to do where there is none (no triangles with
/// area; repair off and the mesh open ...).
Solid_3 make_solid(std::shared_ptr<const Triangle_mesh_3> mesh, Repair repair, Progress& progress);

/// Per point: it lies in the solid, or on its surface (to rounding). On as many threads as `progress` allows.
std::vector<std::uint8_t> are_inside(const Solid_3& solid, std::span<const Point_3> points, Progress& progress);

/// Per point the distance to the surface.
std::vector<double> distances_to_surface(const Solid_3& solid, std::span<const Point_3> points, Progress& progress);

}  // namespace mesecina

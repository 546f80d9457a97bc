// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"
#include "geometries/surface_error_3/surface_error_3.h"

namespace mesecina {

/// How far the union of the balls of a mesh is from the mesh, as statistics tell it. Unavailable for given balls.
inline constexpr Key<Surface_error_3> surface_error_3_key{"surface-error-3"};

void register_surface_error_3(Registry& registry);

}  // namespace mesecina

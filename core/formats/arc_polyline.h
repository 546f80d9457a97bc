// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/primitives.h"

namespace mesecina {

/// The points between the ends of an arc, ends excluded, of a polyline of equal segments of at most one degree. For a
/// whole circle, from vertex `from` back to it.
std::vector<Point_3> points_inside_arc(const Primitive_set& set, const Arc& arc);

}  // namespace mesecina

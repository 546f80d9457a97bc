// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/registry.h"
#include "geometries/union_3/regular_3.h"

namespace mesecina {

/// What is known of a simplex of the regular triangulation, given by its one to three balls: these, and as its dual the
/// part of the power diagram that belongs to it, if that is bounded: of an edge a face, of a triangle an edge. Of a
/// ball its neighbours in the triangulation are counted. Empty where the triangulation has no such simplex. O(cells
/// around the first ball).
Element_description describe_simplex(const Regular_3& regular, std::span<const int> balls);

/// In words, for what an element is in the dual complex.
const char* kind_in_words(Simplex_kind_3 kind);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/primitives.h"
#include "layers/clip_2.h"

namespace mesecina {

/// An arc of a Primitive_set as part of a walk.
struct Arc_step {
  int arc = 0;
  bool is_backward = false;  ///< walked from `to` to `from`
};

/// Closed walks along arcs.
struct Arc_loops {
  std::vector<Arc_step> steps;
  std::vector<std::size_t> ends;  ///< one past the last step of each loop

  std::size_t size() const { return ends.size(); }
  std::span<const Arc_step> loop(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : ends[i - 1];
    return std::span(steps).subspan(begin, ends[i] - begin);
  }
};

/// Loops that together walk once along every arc that bounds an area, by the even-odd rule, among the arcs with
/// drawn[element] (empty: all). What merely hangs on the others bounds nothing; then a connected set of arcs bounds an
/// area iff an even number of ends meets at each of its vertices. Arcs without a positive finite radius or with
/// coordinates that are not finite are left out. In the order of the arcs; O(n α(n)).
Arc_loops closed_loops(const Primitive_set& set, const std::vector<bool>& drawn);

/// The circle as it is in the plane, where counterclockwise is with growing angles.
Pixel_arc planar_arc(const Primitive_set& set, const Arc_step& step);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/view_3.h"

namespace mesecina {

/// Where a camera is on its way through key frames: exactly at number i when `place` is i, and in between on a smooth
/// curve, on which directions turn evenly and sizes change by even factors. A loop goes on from the last key frame to
/// the first: its places are periodic; else those beyond the ends are the ends. Where projections change, that of the
/// key frame ahead counts. A default camera where there are no key frames. O(1).
Camera_3 camera_on_path(std::span<const Camera_3> key_frames, double place, bool is_loop = false);

/// Whether pictures of the two cannot be told apart: they differ by rounding at most.
bool is_nearly_equal(const Camera_3& one, const Camera_3& other);

}  // namespace mesecina

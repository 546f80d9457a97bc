// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/view_3.h"

namespace mesecina {

/// The axis of coordinates, in either direction, that goes upwards in the picture most nearly; of two alike, y rather
/// than z rather than x.
Point_3 up_axis(const Camera_3& camera);

/// The camera moved around its target, about up_axis(camera), by this part of a whole turn, to the right: counter to
/// the clock seen from above. What it sees of the elevation and the distance stays.
Camera_3 turned_on_table(const Camera_3& camera, double turns);

}  // namespace mesecina

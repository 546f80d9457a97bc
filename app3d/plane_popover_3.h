// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app3d/plane_handle_3.h"
#include "shell/actions.h"
#include "shell/popover.h"

namespace mesecina {

/// The cutting plane by numbers: how far it is along its normal from the middle of what is shown, its normal, and the
/// thickness of the slab that is left, if it is one. Follows the plane and the actions on it; closes when there is none
/// any more.
Popover* make_plane_popover(Plane_handle_3& plane, Viewer_3& viewer, const Actions& actions);

}  // namespace mesecina

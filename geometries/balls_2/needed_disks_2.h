// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace mesecina {

/// What evolutions need that take the disks that ball-source says: given ones, or points or an outline.
Evolution_needs needed_disks_2();

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/layer_list.h"  // IWYU pragma: export

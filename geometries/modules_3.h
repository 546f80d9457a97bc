// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/registry.h"

namespace mesecina {

/// Every geometry module of space, in the order of the panel.
std::shared_ptr<const Registry> make_registry_3();

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <cstddef>
#include <functional>
#include <vector>

#include "shell/commands.h"

namespace mesecina {

// Commands that every program has for its own kinds of data and its own canvas.

/// A number in units of the data.
Parameter coordinate_parameter(const char* name);
Parameter radius_parameter();

/// Selects by numbers, of which there are `count()`, or everything: `select` is given them ascending, each once. Throws
/// Command_error when run with a number that is too large.
Command selection_command(const QString& id, const QString& name, const QString& help,
                          std::function<std::size_t()> count, std::function<void(std::vector<std::size_t>)> select);

/// Writes the picture of what is in view: `write` is given the file, the size in pixels (`usual()` if none was said),
/// and whether it is without a background.
Command picture_command(std::function<QSize()> usual,
                        std::function<void(const QString& file, const QSize& size, bool is_transparent)> write);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app3d/editor_3.h"
#include "app3d/generators_3.h"
#include "shell/popover.h"

namespace mesecina {

/// Data appears as soon as it opens and follows its numbers; all of that is one step of undo. It closes when something
/// else changes the inputs. The center and size are of a cube within which the data should lie.
Popover* open_generator_popover_3(const Generator_3& generator, Editor_3& editor, const Point_3& center, double size,
                                  QWidget* over);

/// Exact coordinates of the first selected point, or center and radius of the first selected ball. Null when nothing is
/// selected.
Popover* open_coordinates_popover_3(Editor_3& editor, QWidget* over);

/// Moves, turns, scales and mirrors everything while its numbers are changed; all of that is one step of undo. It
/// closes when something else changes the inputs. Null, with a message, when there is nothing to transform.
Popover* open_transform_popover_3(Editor_3& editor, QWidget* over);

}  // namespace mesecina

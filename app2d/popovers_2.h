// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <functional>
#include <string>
#include <vector>

#include "app2d/editor_2.h"
#include "app2d/generators_2.h"
#include "core/formats/format.h"
#include "shell/popover.h"

class QSize;

namespace mesecina {

/// What a generator makes where the user has not said otherwise.
Generator_order_2 usual_order(const Generator_2& generator, const Inputs& inputs, const Canvas_2& canvas);

/// Points or disks appear as soon as it opens and follow its numbers; all of that is one step of undo. It closes when
/// something else changes the inputs. Null, with a message, when the generator finds nothing to start from.
Popover* open_generator_popover(const Generator_2& generator, Editor_2& editor, QWidget* over);

/// Exact coordinates of the first selected point or vertex, or center and radius of the first selected disk. Null when
/// nothing is selected.
Popover* open_coordinates_popover(Editor_2& editor, QWidget* over);

/// Asks for formats of layers; `write` is called with their names.
Popover* open_layers_popover(const Formats& formats, QWidget* over,
                             std::function<void(const std::vector<std::string>&)> write);

/// Where a generator puts its points or centers: what is in view less a margin, or a box of its own while there is no
/// data.
Box generator_box(const Inputs& inputs, const Canvas_2& canvas);

}  // namespace mesecina

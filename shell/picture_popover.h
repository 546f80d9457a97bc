// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <functional>

#include "shell/popover.h"

namespace mesecina {

/// How a picture is wanted.
struct Picture_wish {
  QSize size;  ///< in pixels
  bool is_transparent = false;
};

/// Asks for the size of a picture. `formats`: what it may be saved as, in words ("PNG, SVG or PDF").
Popover* open_picture_popover(const Picture_wish& start, const QString& formats, QWidget* over,
                              std::function<void(const Picture_wish&)> save,
                              std::function<void(const Picture_wish&)> copy);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace mesecina {

/// Icons of the tool bar, drawn in the colour of the palette's text at every size.
enum class Tool_icon { turn, select, insert, spray, outline, disk, pan, undo, redo, fit };
QIcon tool_icon(Tool_icon icon);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace mesecina {

/// Gives the keyboard to the canvas where a control of a panel of the same window has it, so that keys act on the
/// canvas again. False, and nothing done, where no panel has it.
bool leave_panel(QWidget& canvas);

}  // namespace mesecina

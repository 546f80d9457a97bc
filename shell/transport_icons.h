// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>

namespace mesecina {

/// Icons of what plays steps, drawn in the colour of the palette's text at every size.
enum class Transport_icon { first, back, play_backward, pause, play, forward, last, more, settings };
QIcon transport_icon(Transport_icon icon);

}  // namespace mesecina

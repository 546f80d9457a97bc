// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <utility>
#include <vector>

#include "shell/actions.h"

class QWidget;

namespace mesecina {

/// A row of the sheet that is no action: ("Wheel", "Zoom to the cursor").
using Gesture = std::pair<QString, QString>;

/// A window with every key of the actions and the gestures of the mouse; deletes itself when closed.
QWidget* make_key_sheet(const Actions& actions, const std::vector<Gesture>& gestures, QWidget* parent);

/// A window that says what this program is and which libraries it uses; deletes itself when closed. `details` are lines
/// of plain text ("Canvas: OpenGL 4.5").
QWidget* make_about(const QString& program, const QStringList& details, QWidget* parent);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <Qt>
#include <vector>

#include "shell/key_sheet.h"

namespace mesecina {

/// Habits from which hands come.
enum class Mouse_preset { standard, blender, cad };

enum class Camera_drag { turn, move, zoom };

struct Mouse_binding {
  Qt::KeyboardModifiers modifiers;
  Qt::MouseButton button = Qt::NoButton;
  Camera_drag drag = Camera_drag::turn;
};

/// What dragging does to the camera, where the tool leaves it the button.
std::vector<Mouse_binding> mouse_bindings(Mouse_preset preset);
/// Whether the left button, which turns the scene with the other tools, draws a rectangle with the tool that selects:
/// hands that come from there turn with another button.
bool selects_by_drag(Mouse_preset preset);
/// What dragging does in words, for the sheet of keys.
std::vector<Gesture> camera_gestures(Mouse_preset preset);
/// kebab-case, as preferences keep it.
QString preset_name(Mouse_preset preset);
/// standard for an unknown name.
Mouse_preset preset_named(const QString& name);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/formats/format.h"
#include "layers/gl_renderer_3.h"

class QImage;

namespace mesecina {

/// Why there can be no pictures without a window here: what OpenGL misses; empty when there can. Takes some
/// milliseconds.
std::string reason_against_space_pictures();

/// Adds the picture writers png, svg and pdf for scenes in space, and films. png and films make their OpenGL context at
/// first use, and throw File_error where there is none; svg and pdf do for more than most_space_shapes elements. Scenes
/// with colour bars also need a QGuiApplication, which png and pdf start unless there is one. Any thread may
/// write and film.
void add_space_picture_formats(Formats& formats);

/// A picture of any size, drawn in tiles, with smooth edges and colour bars, transparent where the scene asks for it.
/// The context of the renderer must be current. Throws std::bad_alloc when there is no memory for it.
QImage paint_space_picture(Gl_renderer_3& renderer, const Scene& scene, const View_3& view, int width, int height);

}  // namespace mesecina

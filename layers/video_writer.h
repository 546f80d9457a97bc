// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <functional>
#include <memory>

#include "core/formats/film.h"

namespace mesecina {

/// Paints a frame in this size in pixels; a null image when there is no memory for it.
using Frame_painter = std::function<QImage(const Film_frame& frame, int width, int height)>;

/// Begins a film of what `paint` paints: mp4 (H.264), webm (VP9, with alpha) and gif (one palette, endless) by the
/// program ffmpeg, numbered pictures without it. Throws File_error where reason_against(request) says so, and where
/// the file's folder takes no files.
///
/// Films have exactly the size asked for; only that of mp4 and webm, which must be even, is made so by a row or column
/// of background. Where there is no ffmpeg, numbered pictures come beside the file: film-00001.png for film.mp4.
std::unique_ptr<Film> make_video(const Film_request& request, Frame_painter paint);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "core/style.h"

class QPainter;

namespace mesecina {

/// The scene with its colour bars as a PDF file of one page, `width` x `height` pixels of 1/96 inch, all in vectors.
/// The bytes depend only on the arguments and on the installed font: the file bears no date and no random name.
/// Needs a QGuiApplication.
std::string pdf_bytes(const Scene& scene, const View_2& view, int width, int height);

/// The same of whatever is painted, in pixels.
std::string pdf_page(int width, int height, const std::function<void(QPainter&)>& paint);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <string>

namespace mesecina {

/// Whether two pictures show the same up to antialiasing: every pixel of one must lie, in each channel and within
/// `tolerance`, among the pixels of the other around the same place; `allowed` is the part of the pixels that need not.
/// On failure writes NAME.out.png, NAME.expected.png and NAME.diff.png beside the test program.
testing::AssertionResult same_picture(const QImage& out, const QImage& expected, const std::string& name,
                                      int tolerance = 40, double allowed = 0.0005);

}  // namespace mesecina

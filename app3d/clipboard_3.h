// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/inputs.h"

namespace mesecina {

/// A row "x y z" per point, then a row "x y z radius" per ball, between tabs, so that spreadsheets know columns.
/// Numbers read back exactly.
std::string to_rows(const std::vector<Point_3>& points, const std::vector<Ball_3>& balls);

/// Such a text in parts that a reader of tables takes one by one: a new one begins where rows of three follow rows of
/// four, or the other way round, or where names of columns come. Each has as many empty lines before it as there were
/// lines of other parts, so that numbers of lines stay true.
std::vector<std::string> parts_of_rows(const std::string& text);

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app3d/clipboard_3.h"

#include <algorithm>
#include <initializer_list>
#include <sstream>

#include "core/formats/column_names.h"
#include "core/formats/number.h"
#include "core/formats/text_file.h"

namespace mesecina {

namespace {

void append_row(std::string& text, std::initializer_list<double> numbers) {
  for (const double& number : numbers) {
    append_number(text, number);
    text += &number + 1 == numbers.end() ? '\n' : '\t';
  }
}

bool are_names_of_ours(const std::vector<std::string>& names) {
  return names.size() >= 3 && names[0] == "x" && names[1] == "y" && names[2] == "z";
}

bool is_blank(const std::string& line) { return line.find_first_not_of(" \t\r") == std::string::npos; }

}  // namespace

std::string to_rows(const std::vector<Point_3>& points, const std::vector<Ball_3>& balls) {
  std::string text;
  for (const Point_3& p : points) append_row(text, {p.x, p.y, p.z});
  for (const auto& [center, radius] : balls) append_row(text, {center.x, center.y, center.z, radius});
  return text;
}

std::vector<std::string> parts_of_rows(const std::string& text) {
  constexpr std::size_t of_point = 3;
  constexpr std::size_t of_ball = 4;
  std::vector<std::string> parts(1);
  std::vector<std::string_view> fields;
  std::size_t lines = 0;
  std::size_t columns = 0;  // of the last row
  bool are_names = false;   // what came last
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line); ++lines) {
    if (line.ends_with('\r')) line.pop_back();
    if (!is_blank(line)) {
      split_fields(line, fields);
      const bool has_names = are_names_of_ours(column_names(fields));
      const bool is_other_kind =
          (columns == of_point && fields.size() == of_ball) || (columns == of_ball && fields.size() == of_point);
      if (columns > 0 && !are_names && (has_names || is_other_kind)) parts.emplace_back(lines, '\n');
      columns = fields.size();
      are_names = has_names;
    }
    (parts.back() += line) += '\n';
  }
  return parts;
}

}  // namespace mesecina

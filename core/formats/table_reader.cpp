// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "core/formats/column_names.h"
#include "core/formats/number.h"
#include "core/formats/readers.h"
#include "core/formats/text_file.h"

namespace mesecina {
namespace {

using Row = std::array<double, 3>;

/// Reads fields as finite numbers, radius last if there are three.
Row read_row(const Text_file& file, std::size_t line, const std::vector<std::string_view>& fields) {
  static constexpr std::array<const char*, 3> names = {"x", "y", "a radius"};
  Row row{};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::optional<double> number = parse_number(fields[i]);
    if (!number || !std::isfinite(*number)) {
      throw File_error(file.path, line,
                       std::string("expected a finite number for ") + names[i] + ", found " + quote(fields[i]) +
                           "; correct or delete this line");
    }
    row[i] = *number;
  }
  return row;
}

[[noreturn]] void fail_on_radius(const Text_file& file, std::size_t line, double radius, const char* expected) {
  throw File_error(file.path, line,
                   std::string("expected ") + expected + ", found " + quote(format_number(radius)) +
                       "; correct the radius or delete this line");
}

/// Disks or points, as they come.
struct Table {
  std::size_t columns = 0;  ///< 2 or 3; 0 until known
  std::vector<Point_2> points;
  std::vector<Disk_2> disks;

  void add(const Row& row) {
    if (columns == 3)
      disks.push_back({{row[0], row[1]}, row[2]});
    else
      points.push_back({row[0], row[1]});
  }
  File_contents contents() && {
    File_contents contents;
    if (columns == 3)
      contents.inputs = contents.inputs.with(disks_input, std::move(disks));
    else
      contents.inputs = contents.inputs.with(points_input, std::move(points));
    return contents;
  }
};

/// Whether the names can be those of x y [radius]: unknown words can, "id x y" and "x y z" cannot.
bool can_be_ours(const std::vector<std::string>& names, bool third_may_be_height) {
  if (names.size() != 2 && names.size() != 3) return false;
  for (std::size_t i = 0; i < names.size(); ++i)
    if ((names[i] == "x" && i != 0) || (names[i] == "y" && i != 1)) return false;
  return names.size() == 2 || names[2] != "z" || third_may_be_height;
}

/// What a `.xyz` file needs to know of its third column.
struct Third_column {
  bool all_zero = true;
  std::size_t not_positive_line = 0;  ///< of the first that is zero or negative; 0: none
  double not_positive = 0;

  void add(double value, std::size_t line) {
    all_zero = all_zero && value == 0;
    if (value <= 0 && not_positive_line == 0) {
      not_positive_line = line;
      not_positive = value;
    }
  }
};

std::vector<Point_2> centers(const std::vector<Disk_2>& disks) {
  std::vector<Point_2> points;
  points.reserve(disks.size());
  for (const Disk_2& disk : disks) points.push_back(disk.center);
  return points;
}

}  // namespace

File_contents read_table(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  const bool third_may_be_height = lower_case(path.extension().string()) == ".xyz";
  Table table;
  Third_column third;
  std::size_t rows = 0;
  std::vector<std::string> names;
  std::vector<std::string_view> fields;
  Line_scanner lines(file.text);
  while (lines.next()) {
    split_fields(lines.line(), fields);
    const bool is_first = table.columns == 0;
    if (is_first) names = column_names(fields);
    const bool is_header = is_first && !names.empty();
    if (is_header && !can_be_ours(names, third_may_be_height)) {
      throw File_error(path, lines.number(),
                       "expected the columns x y or x y radius, found " + quote(lines.line()) +
                           "; export these columns only, in this order");
    }
    if (is_first) {
      if (fields.size() != 2 && fields.size() != 3) {
        throw File_error(path, lines.number(),
                         "expected 2 columns x y or 3 columns x y radius, found " + count_of_columns(fields.size()) +
                             " in " + quote(lines.line()) + "; keep only these columns, with points as decimal marks");
      }
      table.columns = fields.size();
    }
    if (fields.size() != table.columns) {
      throw File_error(path, lines.number(),
                       "expected " + count_of_columns(table.columns) + " as on the lines before, found " +
                           count_of_columns(fields.size()) + " in " + quote(lines.line()) +
                           "; correct or delete this line");
    }
    if (is_header) continue;
    const Row row = read_row(file, lines.number(), fields);
    if (table.columns == 3) {
      third.add(row[2], lines.number());
      if (!third_may_be_height && row[2] < 0) fail_on_radius(file, lines.number(), row[2], "a radius of at least 0");
    }
    table.add(row);
    ++rows;
  }
  if (rows == 0 && (names.size() < 2 || names[0] != "x" || names[1] != "y"))
    throw File_error(path, lines.number(), "expected lines x y or x y radius, found no numbers; add data");
  if (third_may_be_height && !table.disks.empty()) {
    if (third.all_zero) {
      table.columns = 2;
      table.points = centers(table.disks);
    } else if (third.not_positive_line != 0) {
      fail_on_radius(file, third.not_positive_line, third.not_positive,
                     "a third column of only zeros (points of the plane) or of only positive radii");
    }
  }
  return std::move(table).contents();
}

File_contents read_poff(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  Line_scanner lines(file.text);
  std::vector<std::string_view> header;
  std::vector<std::string_view> fields;
  while (header.size() < 4 && lines.next()) {
    split_fields(lines.line(), fields);
    header.insert(header.end(), fields.begin(), fields.end());
    if (header[0] != "POFF" && header[0] != "WPOFF") break;
  }
  if (header.empty() || (header[0] != "POFF" && header[0] != "WPOFF")) {
    throw File_error(
        path, lines.number(),
        "expected 'POFF n 0 0' or 'WPOFF n 0 0', found " + quote(lines.line()) + "; write this as the first line");
  }
  std::uint64_t expected = 0;
  const std::string_view count = header.size() == 4 ? header[1] : std::string_view();
  const auto parsed = std::from_chars(count.data(), count.data() + count.size(), expected);
  if (header.size() != 4 || parsed.ec != std::errc() || parsed.ptr != count.data() + count.size() || header[2] != "0" ||
      header[3] != "0") {
    throw File_error(path, lines.number(),
                     "expected '" + std::string(header[0]) + " n 0 0' with the number n of lines, " + "found " +
                         quote(lines.line()) + "; correct the first line");
  }
  Table table;
  table.columns = header[0] == "WPOFF" ? 3 : 2;
  std::uint64_t found = 0;
  while (lines.next()) {
    split_fields(lines.line(), fields);
    if (fields.size() != table.columns) {
      throw File_error(path, lines.number(),
                       "expected " + count_of_columns(table.columns) + (table.columns == 3 ? " x y radius" : " x y") +
                           ", found " + count_of_columns(fields.size()) + " in " + quote(lines.line()) +
                           "; correct or delete this line");
    }
    const Row row = read_row(file, lines.number(), fields);
    if (row[2] < 0) fail_on_radius(file, lines.number(), row[2], "a radius of at least 0");
    table.add(row);
    ++found;
  }
  if (found != expected) {
    const char* what = table.columns == 3 ? " disks" : " points";
    throw File_error(path, lines.number(),
                     "expected " + std::to_string(expected) + what + ", found " + std::to_string(found) +
                         "; the file is cut off or its first line has the wrong number");
  }
  return std::move(table).contents();
}

}  // namespace mesecina

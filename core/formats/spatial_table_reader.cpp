// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "core/formats/column_names.h"
#include "core/formats/field_scanner.h"
#include "core/formats/number.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {
namespace {

/// Unknown words can be the names of x y z ..., "id x y" cannot.
bool can_be_ours(const std::vector<std::string>& names) {
  constexpr std::string_view axes = "xyz";
  if (names.size() < axes.size()) return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_axis = names[i].size() == 1 && axes.find(names[i][0]) != std::string_view::npos;
    if (is_axis && (i >= axes.size() || names[i][0] != axes[i])) return false;
  }
  return names[2] != "r" && names[2] != "radius";
}

class Spatial_table_reader {
 public:
  Spatial_table_reader(const Text_file& file, bool may_hold_balls)
      : fields_(file, Field_scanner::Comments::hash_or_slashes), may_hold_balls_(may_hold_balls) {}

  File_contents read() {
    bool has_line = fields_.next_line();
    if (has_line && read_count()) has_line = fields_.next_line();
    if (has_line) has_line = !read_names() || fields_.next_line();
    if (has_line && columns_ == 0) find_columns();
    for (; has_line; has_line = fields_.next_line()) read_row();
    if (rows() == 0 && names_.empty() && count_ != 0)
      fields_.fail("lines x y z or x y z radius", "no numbers", "add data");
    check_count();
    return contents();
  }

 private:
  std::size_t rows() const { return are_balls_ ? balls_.size() : points_.size(); }

  /// Whether the line is one integer, the number of points.
  bool read_count() {
    const std::string_view line = fields_.line();
    std::uint64_t count = 0;
    const auto parsed = std::from_chars(line.data(), line.data() + line.size(), count);
    if (parsed.ec != std::errc() || parsed.ptr != line.data() + line.size()) return false;
    count_ = count;
    return true;
  }

  bool read_names() {
    split_fields(fields_.line(), words_);
    names_ = column_names(words_);
    if (names_.empty()) return false;
    if (!can_be_ours(names_)) {
      fields_.fail("the columns x y z or x y z radius", quote(fields_.line()),
                   "export these columns only, in this order");
    }
    find_columns();
    return true;
  }

  void find_columns() {
    split_fields(fields_.line(), words_);
    columns_ = words_.size();
    if (columns_ < 3) {
      fields_.fail("3 columns x y z or 4 columns x y z radius",
                   count_of_columns(columns_) + " in " + quote(fields_.line()),
                   "points in space have three coordinates, with points as decimal marks");
    }
    const bool fourth_may_be_radius = names_.empty() || (columns_ > 3 && (names_[3] == "r" || names_[3] == "radius"));
    are_balls_ = may_hold_balls_ && columns_ == 4 && fourth_may_be_radius;
  }

  void read_row() {
    const double x = fields_.number("x");
    const double y = fields_.number("y");
    const Point_3 point{x, y, fields_.number("z")};
    std::size_t found = 3;
    if (are_balls_) {
      const double radius = fields_.number("a radius");
      if (radius < 0) fields_.fail("a radius of at least 0", quote(format_number(radius)));
      balls_.push_back({point, radius});
      ++found;
    } else {
      points_.push_back(point);
    }
    for (; fields_.has_field(); ++found) fields_.field();
    if (found != columns_) {
      fields_.fail(count_of_columns(columns_) + " as on the lines before",
                   count_of_columns(found) + " in " + quote(fields_.line()));
    }
  }

  void check_count() {
    if (!count_ || rows() == *count_) return;
    if (columns_ == 3 && rows() % 2 == 0 && rows() / 2 == *count_) {
      points_.resize(*count_);
      warnings_.add("the " + std::to_string(*count_) + " normals after the points are not read");
      return;
    }
    fields_.fail(std::to_string(*count_) + (are_balls_ ? " balls" : " points"), std::to_string(rows()),
                 "the file is cut off or its first line has the wrong number");
  }

  File_contents contents() {
    const std::size_t read = are_balls_ ? 4 : 3;
    if (columns_ == read + 1) warnings_.add("column " + std::to_string(columns_) + " is not read");
    if (columns_ > read + 1) {
      warnings_.add("columns " + std::to_string(read + 1) + " to " + std::to_string(columns_) +
                    ", such as normals, are not read");
    }
    File_contents contents;
    if (are_balls_)
      contents.inputs = contents.inputs.with(balls_input, std::move(balls_));
    else
      contents.inputs = contents.inputs.with(cloud_input, std::move(points_));
    contents.warnings = warnings_.take();
    return contents;
  }

  Field_scanner fields_;
  bool may_hold_balls_;
  std::optional<std::uint64_t> count_;
  std::vector<std::string> names_;
  std::vector<std::string_view> words_;
  std::size_t columns_ = 0;
  bool are_balls_ = false;
  std::vector<Point_3> points_;
  std::vector<Ball_3> balls_;
  Warning_list warnings_;
};

}  // namespace

File_contents read_spatial_table(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  const std::string extension = lower_case(path.extension().string());
  return Spatial_table_reader(file, extension == ".csv" || extension == ".txt").read();
}

}  // namespace mesecina

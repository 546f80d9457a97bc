// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>
#include <system_error>
#include <utility>

#include "core/formats/field_scanner.h"
#include "core/formats/polygon_collector.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {
namespace {

/// Statements of OBJ that change neither vertices nor faces.
constexpr std::array ignored = {"vt", "vn", "vp", "g", "o", "s", "mg", "usemtl", "mtllib", "usemap", "maplib", "p"};

class Obj_reader {
 public:
  explicit Obj_reader(const Text_file& file) : file_(file), fields_(file) {}

  File_contents read() {
    while (fields_.next_line()) {
      const std::string_view statement = fields_.field();
      if (statement == "v")
        read_vertex();
      else if (statement == "f")
        read_face();
      else if (std::ranges::find(ignored, statement) == ignored.end())
        skip_statement(statement);
    }
    if (mesh_.vertices().empty())
      fields_.fail("lines 'v x y z' with vertices", "none", "add them, or convert the file to OBJ");
    if (largest_ >= static_cast<std::int64_t>(mesh_.vertices().size())) fail_on_largest();
    Warning_list warnings;
    if (skipped_ != 0) {
      warnings.add(std::to_string(skipped_) + (skipped_ == 1 ? " line is" : " lines are") +
                   " not read, as neither vertices nor faces; the first is line " + std::to_string(first_skipped_) +
                   ", " + quote(first_skipped_word_));
    }
    return std::move(mesh_).contents(file_.path, warnings);
  }

 private:
  void read_vertex() {
    const double x = fields_.number("x");
    const double y = fields_.number("y");
    mesh_.add_vertex({x, y, fields_.number("z")});
  }

  void read_face() {
    while (fields_.has_field()) {
      const std::string_view corner = fields_.field();
      if (corner == "\\") {
        if (!fields_.next_line()) fields_.fail("the rest of a face after '\\'", "nothing", "the file is cut off");
        continue;
      }
      mesh_.add_corner(vertex_of(corner));
    }
    mesh_.end_face();
  }

  /// Of "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal"; negative numbers count backwards from
  /// the last vertex so far. Larger numbers than that are checked at the end.
  int vertex_of(std::string_view corner) {
    int number = 0;
    const auto result = std::from_chars(corner.data(), corner.data() + corner.size(), number);
    const bool is_number = result.ec == std::errc() &&
                           (result.ptr == corner.data() + corner.size() || *result.ptr == '/') &&
                           number != std::numeric_limits<int>::min();
    const auto count = static_cast<std::int64_t>(mesh_.vertices().size());
    if (!is_number || number == 0 || -std::int64_t{number} > count) {
      fields_.fail("a vertex number from 1, or backwards from -1 to -" + std::to_string(count), quote(corner));
    }
    const std::int64_t vertex = number > 0 ? number - 1 : count + number;
    if (vertex > largest_) {
      largest_ = vertex;
      line_of_largest_ = fields_.line_number();
    }
    return static_cast<int>(vertex);
  }

  void skip_statement(std::string_view statement) {
    if (skipped_++ != 0) return;
    first_skipped_ = fields_.line_number();
    first_skipped_word_ = statement;
  }

  [[noreturn]] void fail_on_largest() const {
    throw File_error(file_.path, line_of_largest_,
                     "expected vertex numbers of at most " + std::to_string(mesh_.vertices().size()) + ", found " +
                         std::to_string(largest_ + 1) + "; correct the number or add the vertices that are missing");
  }

  const Text_file& file_;
  Field_scanner fields_;
  Polygon_collector mesh_;
  std::int64_t largest_ = -1;
  std::size_t line_of_largest_ = 0;
  std::size_t skipped_ = 0;
  std::size_t first_skipped_ = 0;
  std::string_view first_skipped_word_;
};

}  // namespace

File_contents read_obj(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  return Obj_reader(file).read();
}

}  // namespace mesecina

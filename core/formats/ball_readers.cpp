// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "core/formats/field_scanner.h"
#include "core/formats/number.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {
namespace {

constexpr std::size_t shortest_line = 8;  // "0 0 0 0" and its end

Ball_3 read_ball(Field_scanner& fields) {
  const double x = fields.number("x");
  const double y = fields.number("y");
  const Point_3 center{x, y, fields.number("z")};
  const double radius = fields.number("a radius");
  if (radius < 0) fields.fail("a radius of at least 0", quote(format_number(radius)));
  return {center, radius};
}

/// Moves to the next line if this one has no more fields.
void want_field(Field_scanner& fields, const std::string& expected) {
  if (!fields.has_field() && !fields.next_line()) fields.fail(expected, "nothing", "the file is cut off");
}

void read_keyword(Field_scanner& fields, std::string_view keyword, const std::string& header) {
  if (!fields.next_line() || fields.field() != keyword)
    fields.fail("'" + header + "'", quote(fields.line()), "write this as the first line");
}

std::uint64_t read_count(Field_scanner& fields, const std::string& name) {
  want_field(fields, name);
  return fields.count(name);
}

void want_line(Field_scanner& fields, std::uint64_t expected, const std::string& what, std::uint64_t found) {
  if (fields.next_line()) return;
  fields.fail(std::to_string(expected) + " " + what, std::to_string(found),
              "the file is cut off or its first line has the wrong number");
}

void want_end(Field_scanner& fields, const std::string& after) {
  if (!fields.next_line()) return;
  fields.fail("the end of the file after " + after, quote(fields.line()),
              "correct the numbers in the first line or delete what follows");
}

std::vector<Ball_3> read_balls(Field_scanner& fields, std::uint64_t count) {
  std::vector<Ball_3> balls;
  balls.reserve(std::min<std::uint64_t>(count, fields.size() / shortest_line + 1));
  for (std::uint64_t i = 0; i < count; ++i) {
    want_line(fields, count, "balls", i);
    balls.push_back(read_ball(fields));
  }
  return balls;
}

File_contents contents_of(std::vector<Ball_3> balls, Warning_list warnings = {}) {
  File_contents contents;
  contents.inputs = contents.inputs.with(balls_input, std::move(balls));
  contents.warnings = warnings.take();
  return contents;
}

std::string counted(std::uint64_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

File_contents read_cin(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  Field_scanner fields(file);
  std::vector<Ball_3> balls;
  while (fields.next_line()) {
    const double x = fields.number("x");
    const double y = fields.number("y");
    const Point_3 center{x, y, fields.number("z")};
    const double weight = fields.number("a weight");
    if (weight < 0) fields.fail("a squared radius of at least 0", quote(format_number(weight)));
    if (fields.has_field()) fields.fail("4 columns x y z weight", quote(fields.line()));
    balls.push_back({center, std::sqrt(weight)});
  }
  if (balls.empty()) fields.fail("lines x y z weight", "no numbers", "add data");
  return contents_of(std::move(balls));
}

File_contents read_woff(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  Field_scanner fields(file);
  read_keyword(fields, "WOFF", "WOFF n 0 0");
  const std::uint64_t count = read_count(fields, "the number of balls");
  const std::uint64_t faces = read_count(fields, "the number of faces");
  if (read_count(fields, "the number of edges") != 0 || faces != 0 || fields.has_field())
    fields.fail("'WOFF n 0 0' with the number n of lines", quote(fields.line()), "correct the first line");
  std::vector<Ball_3> balls = read_balls(fields, count);
  want_end(fields, counted(count, "ball"));
  return contents_of(std::move(balls));
}

File_contents read_moff(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  Field_scanner fields(file);
  read_keyword(fields, "MOFF", "MOFF n f s");
  const std::uint64_t count = read_count(fields, "the number of vertices");
  const std::uint64_t face_count = read_count(fields, "the number of faces");
  want_field(fields, "a factor of growth");
  const double growth = fields.number("a factor of growth");
  if (growth <= 0) fields.fail("a positive factor of growth", quote(format_number(growth)), "correct the first line");
  std::vector<Ball_3> balls = read_balls(fields, count);
  for (std::uint64_t i = 0; i < face_count; ++i) {
    want_line(fields, face_count, "faces", i);
    for (std::uint64_t left = fields.count("the number of corners"); left > 0; --left) fields.index(count);
  }
  want_end(fields, counted(count, "ball") + " and " + counted(face_count, "face"));
  for (Ball_3& ball : balls) {
    ball.radius /= growth;
    if (!std::isfinite(ball.radius))
      fields.fail("radii that are finite after division by the factor of growth", "one that is not",
                  "correct the factor");
  }
  Warning_list warnings;
  if (face_count != 0) warnings.add("the " + counted(face_count, "face") + " of the medial axis are not read");
  return contents_of(std::move(balls), std::move(warnings));
}

File_contents read_ma(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  Field_scanner fields(file);
  if (!fields.next_line()) fields.fail("the numbers of vertices, edges and faces", "nothing", "add data");
  const std::uint64_t count = fields.count("the number of vertices");
  const std::uint64_t edge_count = fields.count("the number of edges");
  const std::uint64_t face_count = fields.count("the number of faces");
  std::vector<Ball_3> balls;
  balls.reserve(std::min<std::uint64_t>(count, fields.size() / shortest_line + 1));
  std::uint64_t edges = 0;
  std::uint64_t faces = 0;
  while (fields.next_line()) {
    const std::string_view kind = fields.field();
    std::size_t corners = 0;
    if (kind == "v") {
      balls.push_back(read_ball(fields));
    } else if (kind == "e") {
      corners = 2;
      ++edges;
    } else if (kind == "f") {
      corners = 3;
      ++faces;
    } else {
      fields.fail("'v x y z radius', 'e i j' or 'f i j k'", quote(fields.line()));
    }
    for (; corners > 0; --corners) fields.index(count);
  }
  if (balls.size() != count || edges != edge_count || faces != face_count) {
    fields.fail(counted(count, "ball") + ", " + counted(edge_count, "edge") + " and " + counted(face_count, "face"),
                std::to_string(balls.size()) + ", " + std::to_string(edges) + " and " + std::to_string(faces),
                "the file is cut off or its first line has the wrong numbers");
  }
  Warning_list warnings;
  if (edges != 0 || faces != 0) {
    warnings.add("the " + counted(edges, "edge") + " and " + counted(faces, "face") +
                 " of the medial mesh are not read, only its balls");
  }
  return contents_of(std::move(balls), std::move(warnings));
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "core/formats/field_scanner.h"
#include "core/formats/number.h"
#include "core/formats/polygon_collector.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {
namespace {

constexpr std::size_t header_size = 84;
constexpr std::size_t facet_size = 50;

/// Gives equal points the same vertex of a mesh. Only looks up; vertices are in the order of their first use.
class Welder {
 public:
  explicit Welder(Polygon_collector& mesh) : mesh_(mesh), table_(1024, -1) {}

  void add_corner(Point_3 point) {
    point = {point.x + 0.0, point.y + 0.0, point.z + 0.0};  // -0 is 0
    const std::vector<Point_3>& vertices = mesh_.vertices();
    if (2 * vertices.size() >= table_.size()) grow();
    int& entry = table_[place_of(point)];
    if (entry < 0) {
      entry = static_cast<int>(vertices.size());
      mesh_.add_vertex(point);
    }
    mesh_.add_corner(entry);
  }

 private:
  std::size_t place_of(const Point_3& point) const {
    std::uint64_t hash = 0;
    for (const double coordinate : {point.x, point.y, point.z}) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 29;
    }
    std::size_t place = hash & (table_.size() - 1);
    while (table_[place] >= 0 && mesh_.vertices()[table_[place]] != point) place = (place + 1) & (table_.size() - 1);
    return place;
  }
  void grow() {
    table_.assign(2 * table_.size(), -1);
    for (std::size_t vertex = 0; vertex < mesh_.vertices().size(); ++vertex)
      table_[place_of(mesh_.vertices()[vertex])] = static_cast<int>(vertex);
  }

  Polygon_collector& mesh_;
  std::vector<int> table_;  ///< vertices, or -1; open addressing, at most half full
};

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return number;
}

/// The number of facets that a binary file says it has; its size must be at least that of a header.
std::uint64_t facet_count(const Text_file& file) { return little_endian(std::string_view(file.text).substr(80)); }

File_contents read_binary(const Text_file& file, Warning_list& warnings) {
  const std::uint64_t count = facet_count(file);
  Polygon_collector mesh;
  mesh.reserve(count / 2, count);
  Welder welder(mesh);
  for (std::uint64_t facet = 0; facet < count; ++facet) {
    // A normal, three corners, two bytes that mean nothing.
    const std::string_view corners = std::string_view(file.text).substr(header_size + facet_size * facet + 12, 36);
    std::array<double, 9> numbers{};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = std::bit_cast<float>(little_endian(corners.substr(4 * i)));
      if (!std::isfinite(numbers[i])) {
        throw File_error(file.path, 0,
                         "expected finite coordinates, found " + quote(format_number(numbers[i])) + " in triangle " +
                             std::to_string(facet + 1) + "; export the file anew");
      }
    }
    for (std::size_t i = 0; i < numbers.size(); i += 3) welder.add_corner({numbers[i], numbers[i + 1], numbers[i + 2]});
    mesh.end_face();
  }
  return std::move(mesh).contents(file.path, warnings);
}

/// STL of text; "solid NAME", then facets, each with the vertices of one loop, then "endsolid". Any number of solids.
class Stl_text_reader {
 public:
  explicit Stl_text_reader(const Text_file& file) : file_(file), fields_(file), welder_(mesh_) {}

  File_contents read(Warning_list& warnings) {
    while (fields_.next_line()) read_line(lower_case(fields_.field()));
    if (is_in_loop_ || is_in_solid_)
      fields_.fail(is_in_loop_ ? "'endloop'" : "'endsolid'", "the end of the file", "the file is cut off");
    return std::move(mesh_).contents(file_.path, warnings);
  }

 private:
  void read_line(const std::string& keyword) {
    if (keyword == "solid") {
      is_in_solid_ = true;
    } else if (keyword == "endsolid" && !is_in_loop_) {
      is_in_solid_ = false;
    } else if (keyword == "outer" && !is_in_loop_) {
      is_in_loop_ = true;
    } else if (keyword == "vertex" && is_in_loop_) {
      const double x = fields_.number("x");
      const double y = fields_.number("y");
      welder_.add_corner({x, y, fields_.number("z")});
    } else if (keyword == "endloop" && is_in_loop_) {
      mesh_.end_face();
      is_in_loop_ = false;
    } else if (is_in_loop_ || (keyword != "facet" && keyword != "endfacet" && keyword != "color")) {
      fields_.fail(is_in_loop_ ? "'vertex x y z' or 'endloop'" : "'facet', 'outer loop', 'endfacet' or 'endsolid'",
                   quote(fields_.line()));
    }
  }

  const Text_file& file_;
  Field_scanner fields_;
  Polygon_collector mesh_;
  Welder welder_;
  bool is_in_solid_ = false;
  bool is_in_loop_ = false;
};

}  // namespace

File_contents read_stl(const std::filesystem::path& path) {
  const Text_file file = load_bytes(path);
  Warning_list warnings;
  // Many binary files begin with "solid" too, so the size decides.
  const bool has_header = file.text.size() >= header_size;
  const std::size_t room = has_header ? (file.text.size() - header_size) / facet_size : 0;
  const bool has_exact_size =
      has_header && facet_count(file) == room && file.text.size() == header_size + facet_size * room;
  if (has_exact_size) return read_binary(file, warnings);
  if (file.text.find('\0') == std::string::npos) {
    const std::size_t word = file.text.find_first_not_of(" \t\r\n");
    if (word == std::string::npos || lower_case(std::string_view(file.text).substr(word, 5)) != "solid") {
      throw File_error(path, 1,
                       "expected 'solid' or a binary STL file, found " + quote(file.text.substr(0, 60)) +
                           "; export the file as STL");
    }
    return Stl_text_reader(file).read(warnings);
  }
  if (!has_header || facet_count(file) > room) {
    const std::string expected = has_header
                                     ? std::to_string(facet_count(file)) + " triangles in " +
                                           std::to_string(header_size + facet_size * facet_count(file)) + " bytes"
                                     : "a header of 84 bytes";
    throw File_error(path, 0,
                     "expected " + expected + ", found " + std::to_string(file.text.size()) +
                         " bytes; the file is cut off or damaged, export it anew");
  }
  warnings.add("what follows the last triangle of the header's " + std::to_string(facet_count(file)) + " is not read");
  return read_binary(file, warnings);
}

}  // namespace mesecina

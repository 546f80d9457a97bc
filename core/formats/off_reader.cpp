// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <utility>

#include "core/formats/field_scanner.h"
#include "core/formats/polygon_collector.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {
namespace {

/// "OFF" with marks that columns of texture coordinates, colours and normals follow the coordinates.
bool is_off_keyword(std::string_view word) {
  for (const std::string_view mark : {"ST", "C", "N"})
    if (word.starts_with(mark)) word.remove_prefix(mark.size());
  return word == "OFF";
}

[[noreturn]] void fail_on_count(const Field_scanner& fields, std::size_t expected, const char* what,
                                std::size_t found) {
  fields.fail(std::to_string(expected) + " " + what, std::to_string(found),
              "the file is cut off or its header has the wrong number");
}

}  // namespace

File_contents read_off(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  Field_scanner fields(file);
  if (!fields.next_line() || !is_off_keyword(fields.field()))
    fields.fail("'OFF' in the first line", quote(fields.line()), "write it there, or convert the file to OFF");
  if (!fields.has_field() && !fields.next_line())
    fields.fail("the numbers of vertices and faces", "nothing", "the file is cut off");
  if (fields.line().ends_with("BINARY")) fields.fail("an OFF file of text", "'BINARY'", "export it as text");
  const std::size_t vertex_count = fields.count("the number of vertices");
  const std::size_t face_count = fields.count("the number of faces");

  // No line of a vertex is shorter than "0 0 0", none of a face than "3 0 0 0".
  Polygon_collector mesh;
  mesh.reserve(std::min(vertex_count, fields.size() / 6), std::min(face_count, fields.size() / 8));
  for (std::size_t i = 0; i < vertex_count; ++i) {
    if (!fields.next_line()) fail_on_count(fields, vertex_count, "vertices", i);
    const double x = fields.number("x");
    const double y = fields.number("y");
    mesh.add_vertex({x, y, fields.number("z")});
  }
  for (std::size_t i = 0; i < face_count; ++i) {
    if (!fields.next_line()) fail_on_count(fields, face_count, "faces", i);
    for (std::uint64_t left = fields.count("the number of corners"); left > 0; --left)
      mesh.add_corner(fields.index(vertex_count));
    mesh.end_face();
  }
  if (fields.next_line()) {
    fields.fail("the end of the file after " + std::to_string(vertex_count) + " vertices and " +
                    std::to_string(face_count) + " faces",
                quote(fields.line()), "correct the numbers in the header or delete what follows");
  }
  Warning_list warnings;
  return std::move(mesh).contents(path, warnings);
}

}  // namespace mesecina

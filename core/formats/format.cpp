// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/format.h"

#include <algorithm>
#include <system_error>

#include "core/formats/readers.h"
#include "core/formats/text_file.h"
#include "core/formats/writers.h"

namespace mesecina {
namespace {

std::string one_line(const std::filesystem::path& file, std::size_t line, const std::string& message) {
  std::string text = file.string();
  if (line != 0) text.append(":").append(std::to_string(line));
  text += ": ";
  text += message;
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

std::string lower_extension(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  return lower_case(std::string_view(extension).substr(std::min<std::size_t>(1, extension.size())));
}

std::string known_extensions(const Formats& formats) {
  std::vector<std::string> extensions;
  for (const Reader& reader : formats.readers)
    extensions.insert(extensions.end(), reader.extensions.begin(), reader.extensions.end());
  std::ranges::sort(extensions);
  std::string text;
  for (const std::string& extension : extensions) text.append(text.empty() ? "." : " .").append(extension);
  return text;
}

}  // namespace

File_error::File_error(const std::filesystem::path& file, std::size_t line, const std::string& message)
    : std::runtime_error(one_line(file, line, message)) {}

const Reader* Formats::reader_for(const std::filesystem::path& file) const {
  const std::string extension = lower_extension(file);
  const auto it = std::ranges::find_if(
      readers, [&](const Reader& reader) { return std::ranges::count(reader.extensions, extension) != 0; });
  return it == readers.end() ? nullptr : &*it;
}

const Layer_writer* Formats::find_layer_writer(std::string_view name) const {
  const auto it = std::ranges::find(layer_writers, name, &Layer_writer::name);
  return it == layer_writers.end() ? nullptr : &*it;
}

const Picture_writer* Formats::find_picture_writer(std::string_view name) const {
  const auto it = std::ranges::find(picture_writers, name, &Picture_writer::name);
  return it == picture_writers.end() ? nullptr : &*it;
}

Formats planar_formats() {
  Formats formats;
  formats.readers = {
      {"Points and disks, one per line", {"xy", "xyz", "csv", "txt"}, read_table},
      {"POFF points and WPOFF disks", {"poff", "wpoff"}, read_poff},
      {"WKT outlines and points", {"wkt"}, read_wkt},
      {"SVG shapes", {"svg"}, read_svg},
      {"GeoJSON outlines and points", {"geojson", "json"}, read_geojson},
  };
  formats.layer_writers = {
      {"json", "json", "everything about a layer, losslessly; the default", write_json_layer},
      {"csv", "csv",
       "a table of elements: element, kind, id, coordinates x0 y0 x1 y1 (rays: start and direction; arcs: "
       "counterclockwise from, to and center x2 y2; triangles: three corners), radius, values; polygons as ring",
       write_csv_layer},
      {"obj", "obj",
       "Wavefront: points, polylines and triangles; disks as their centers, arcs as polylines, no rays, no values",
       write_obj_layer},
      {"ply", "ply",
       "binary: vertices with radius, edges and triangles with their values; arcs and polygons as edges, no rays",
       write_ply_layer},
  };
  formats.input_writers = {
      {"xy", "xy", std::string(points_input.id), write_xy_points},
      {"poff", "poff", std::string(points_input.id), write_poff_points},
      {"wpoff", "wpoff", std::string(disks_input.id), write_wpoff_disks},
      {"csv", "csv", std::string(disks_input.id), write_csv_disks},
      {"wkt", "wkt", std::string(outline_input.id), write_wkt_outline},
      {"geojson", "geojson", std::string(outline_input.id), write_geojson_outline},
  };
  return formats;
}

File_contents read_file(const Formats& formats, const std::filesystem::path& file) {
  std::error_code error;
  const Reader* reader = formats.reader_for(file);
  if (!reader) {
    if (!std::filesystem::is_regular_file(file, error)) load_text(file);
    throw File_error(file, 0,
                     "expected one of the extensions " + known_extensions(formats) + ", found " +
                         quote(file.extension().string()) + "; rename or convert the file");
  }
  return reader->read(file);
}

std::string empty_file_text(const Layer_writer& writer, const Primitive_set* primitives) {
  if (!primitives || !writer.holds_any || primitives->element_count() == 0 || writer.holds_any(*primitives)) return {};
  struct Kind {
    std::size_t count;
    const char* name;
  };
  const Kind kinds[] = {{primitives->points.size(), "point"},       {primitives->segments.size(), "segment"},
                        {primitives->rays.size(), "ray"},           {primitives->arcs.size(), "arc"},
                        {primitives->triangles.size(), "triangle"}, {primitives->polygon_count(), "polygon"},
                        {primitives->balls.size(), "ball"}};
  std::vector<std::string> there;
  for (const auto& [count, name] : kinds)
    if (count > 0) there.push_back(std::to_string(count) + " " + name + (count == 1 ? "" : "s"));
  std::string text =
      writer.name + " holds " + writer.holds + ", and there " + (there.front().starts_with("1 ") ? "is" : "are");
  for (std::size_t i = 0; i < there.size(); ++i)
    text += (i == 0 ? " " : i + 1 == there.size() ? " and " : ", ") + there[i];
  return text + ": the file is empty";
}

}  // namespace mesecina

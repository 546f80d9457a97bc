// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/picture_scene.h"

#include <zlib.h>

#include <cstdint>
#include <ostream>
#include <stdexcept>

#include "core/formats/format.h"
#include "core/formats/packed_bytes.h"
#include "core/formats/text_file.h"

namespace mesecina {

namespace {

constexpr std::size_t most_inflated = std::size_t{1} << 30;

constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view png_keyword{"Mesecina scene\0\0", 16};  // with its end and the method of compression
constexpr std::string_view svg_begin = "<metadata id=\"mesecina-scene\">";
constexpr std::string_view svg_end = "</metadata>";
constexpr std::string_view pdf_signature = "%PDF-";
constexpr std::string_view pdf_line = "%mesecina-scene ";

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 255U);
  return bytes;
}

std::uint32_t from_big_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char byte : bytes.substr(0, 4)) number = number << 8 | static_cast<std::uint8_t>(byte);
  return number;
}

std::string png_chunk(const std::string& type_and_data) {
  const auto checksum =
      crc32(0, reinterpret_cast<const Bytef*>(type_and_data.data()), static_cast<uInt>(type_and_data.size()));
  return big_endian(static_cast<std::uint32_t>(type_and_data.size() - 4)) + type_and_data +
         big_endian(static_cast<std::uint32_t>(checksum));
}

std::string png_with_scene(std::string_view picture, std::string_view scene) {
  constexpr std::size_t after_header = 33;  // signature and IHDR
  if (picture.size() < after_header) throw std::invalid_argument("expected a complete PNG, found less than its header");
  return std::string(picture.substr(0, after_header))
      .append(png_chunk("zTXt" + std::string(png_keyword) + deflated(scene)))
      .append(picture.substr(after_header));
}

std::optional<std::string> scene_of_png(std::string_view bytes) {
  constexpr std::size_t frame = 12;  // length, type and checksum of a chunk
  for (bytes.remove_prefix(png_signature.size()); bytes.size() >= frame;) {
    const std::size_t length = from_big_endian(bytes);
    if (length > bytes.size() - frame) return std::nullopt;
    const std::string_view data = bytes.substr(8, length);
    if (bytes.substr(4, 4) == "zTXt" && data.starts_with(png_keyword))
      return inflated(data.substr(png_keyword.size()), most_inflated);
    bytes.remove_prefix(frame + length);
  }
  return std::nullopt;
}

/// Behind the opening tag of the root; npos where there is none.
std::size_t svg_root_end(std::string_view text) {
  const std::size_t root = text.find("<svg");
  const std::size_t end = root == std::string_view::npos ? root : text.find('>', root);
  return end == std::string_view::npos ? end : end + 1;
}

std::string svg_with_scene(std::string_view picture, std::string_view scene) {
  const std::size_t end = svg_root_end(picture);
  return std::string(picture.substr(0, end))
      .append("\n")
      .append(svg_begin)
      .append(to_base64(deflated(scene)))
      .append(svg_end)
      .append(picture.substr(end));
}

std::optional<std::string> scene_of_svg(std::string_view text) {
  const std::size_t begin = text.find(svg_begin);
  if (begin == std::string_view::npos) return std::nullopt;
  text.remove_prefix(begin + svg_begin.size());
  const std::size_t end = text.find(svg_end);
  if (end == std::string_view::npos) throw std::invalid_argument("expected </metadata> after the scene, found none");
  return inflated(from_base64(text.substr(0, end)), most_inflated);
}

std::string pdf_with_scene(std::string_view picture, std::string_view scene) {
  constexpr std::string_view keyword = "startxref\n";
  const std::size_t start = picture.rfind(keyword);
  const std::size_t number = start == std::string_view::npos ? start : start + keyword.size();
  const std::size_t number_end =
      number == std::string_view::npos ? number : picture.find_first_not_of("0123456789", number);
  if (number_end == std::string_view::npos) throw std::invalid_argument("expected a PDF with its table, found none");
  std::size_t table = 0;
  for (const char digit : picture.substr(number, number_end - number))
    table = 10 * table + static_cast<std::size_t>(digit - '0');
  if (table > start || !picture.substr(table).starts_with("xref"))
    throw std::invalid_argument("expected the table of a PDF where it says, found none");
  // Lines of PDF shall not be longer than 255 characters.
  constexpr std::size_t most_per_line = 200;
  const std::string packed = to_base64(deflated(scene));
  std::string comments;
  for (std::size_t i = 0; i < packed.size(); i += most_per_line)
    comments.append(pdf_line).append(packed, i, most_per_line).append("\n");
  return std::string(picture.substr(0, table))
      .append(comments)
      .append(picture.substr(table, number - table))
      .append(std::to_string(table + comments.size()))
      .append(picture.substr(number_end));
}

std::optional<std::string> scene_of_pdf(std::string_view bytes) {
  std::string packed;
  const std::string line_start = "\n" + std::string(pdf_line);
  for (std::size_t at = bytes.find(line_start); at != std::string_view::npos;) {
    const std::size_t begin = at + line_start.size();
    const std::size_t end = bytes.find('\n', begin);
    packed += bytes.substr(begin, end == std::string_view::npos ? end : end - begin);
    at = end != std::string_view::npos && bytes.substr(end).starts_with(line_start) ? end : std::string_view::npos;
  }
  if (packed.empty()) return std::nullopt;
  return inflated(from_base64(packed), most_inflated);
}

}  // namespace

std::string picture_with_scene(std::string_view picture, std::string_view scene) {
  if (picture.starts_with(png_signature)) return png_with_scene(picture, scene);
  if (picture.starts_with(pdf_signature)) return pdf_with_scene(picture, scene);
  if (svg_root_end(picture) != std::string_view::npos) return svg_with_scene(picture, scene);
  throw std::invalid_argument("expected a PNG, SVG or PDF, found something else");
}

std::optional<std::string> scene_of_picture(std::string_view bytes) {
  if (bytes.starts_with(png_signature)) return scene_of_png(bytes);
  if (bytes.starts_with(pdf_signature)) return scene_of_pdf(bytes);
  return scene_of_svg(bytes);
}

void add_scene_to_picture(const std::filesystem::path& file, std::string_view scene) {
  try {
    const std::string bytes = picture_with_scene(load_bytes(file).text, scene);
    write_file(file,
               [&](std::ostream& stream) { stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); });
  } catch (const std::invalid_argument& error) {
    throw File_error(file, 0, std::string("the scene could not be put into the picture: ") + error.what());
  }
}

}  // namespace mesecina

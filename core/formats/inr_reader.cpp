// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "core/formats/level_surface.h"
#include "core/formats/number.h"
#include "core/formats/spatial_readers.h"
#include "core/formats/text_file.h"

namespace mesecina {
namespace {

constexpr std::string_view magic = "#INRIMAGE-4#{";
constexpr std::string_view end_of_header = "##}";
constexpr std::size_t header_block = 256;
constexpr std::size_t most_triangles = 20'000'000;

/// How the numbers of a volume are written.
struct Encoding {
  enum class Type { floating, with_sign, without_sign };
  Type type = Type::floating;
  std::size_t bytes = 4;
  bool is_big_endian = false;
};

double decoded(const char* bytes, const Encoding& encoding) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < encoding.bytes; ++i) {
    const std::size_t place = encoding.is_big_endian ? i : encoding.bytes - 1 - i;
    bits = bits << 8U | static_cast<unsigned char>(bytes[place]);
  }
  if (encoding.type == Encoding::Type::floating) {
    if (encoding.bytes == sizeof(float)) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    return std::bit_cast<double>(bits);
  }
  if (encoding.type == Encoding::Type::without_sign) return static_cast<double>(bits);
  const auto unused = static_cast<unsigned>(64 - 8 * encoding.bytes);
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

class Inr_reader {
 public:
  explicit Inr_reader(const Text_file& file) : file_(file) {}

  File_contents read() {
    read_header();
    volume_.counts = {count("XDIM"), count("YDIM"), count("ZDIM")};
    if (words_.contains("VDIM") && count("VDIM") != 1)
      fail("VDIM=1, one number per place", "VDIM=" + words_["VDIM"], "split the image");
    volume_.spacing = {size("VX"), size("VY"), size("VZ")};
    volume_.origin = {place("TX"), place("TY"), place("TZ")};
    read_values(encoding());
    return surface();
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found, const std::string& what_to_do) const {
    throw File_error(file_.path, 0, "expected " + expected + ", found " + found + "; " + what_to_do);
  }

  /// Lines KEY=VALUE, filled up to whole blocks.
  void read_header() {
    const std::string_view text = file_.text;
    if (!text.starts_with(magic))
      fail(quote(magic) + " at its start", quote(text.substr(0, 40)), "export it as INRIMAGE");
    const std::size_t end = text.find(end_of_header);
    if (end == std::string_view::npos) fail(quote(end_of_header) + " after the header", "none", "the file is cut off");
    header_size_ = (end + end_of_header.size() + header_block - 1) / header_block * header_block;
    Line_scanner lines(text.substr(magic.size(), end - magic.size()));
    while (lines.next()) {
      const std::string_view line = lines.line();
      const std::size_t equals = line.find('=');
      if (equals == std::string_view::npos) fail("lines KEY=VALUE in the header", quote(line), "mend that line");
      words_[std::string(line.substr(0, equals))] = std::string(line.substr(equals + 1));
    }
  }

  double number(const std::string& key) {
    const auto value = parse_number(words_[key]);
    if (!value || !std::isfinite(*value)) fail("a number as " + key, quote(words_[key]), "mend the header");
    return *value;
  }
  std::size_t count(const std::string& key) {
    if (!words_.contains(key)) fail(key + " in the header", "none", "add it");
    const double value = number(key);
    constexpr double most = 65535;
    if (!(value >= 1) || value > most || value != std::floor(value))
      fail("a whole number from 1 to 65535 as " + key, quote(words_[key]), "mend the header");
    return static_cast<std::size_t>(value);
  }
  double size(const std::string& key) {
    if (!words_.contains(key)) return 1;
    if (!(number(key) > 0)) fail("a size above 0 as " + key, quote(words_[key]), "mend the header");
    return number(key);
  }
  double place(const std::string& key) { return words_.contains(key) ? number(key) : 0; }

  Encoding encoding() {
    Encoding result;
    const std::string type = lower_case(words_["TYPE"]);
    if (type == "float") {
      result.type = Encoding::Type::floating;
    } else if (type == "unsigned fixed") {
      result.type = Encoding::Type::without_sign;
    } else if (type == "signed fixed") {
      result.type = Encoding::Type::with_sign;
    } else {
      fail("TYPE=float, unsigned fixed or signed fixed", quote(words_["TYPE"]), "convert the image");
    }
    const std::string bits = words_["PIXSIZE"].substr(0, words_["PIXSIZE"].find(' '));
    const std::map<std::string, std::size_t> sizes{{"8", 1}, {"16", 2}, {"32", 4}, {"64", 8}};
    const auto known = sizes.find(bits);
    const bool is_float = result.type == Encoding::Type::floating;
    if (known == sizes.end() || (is_float && known->second < sizeof(float)))
      fail(is_float ? "PIXSIZE=32 or 64 bits" : "PIXSIZE=8, 16, 32 or 64 bits", quote(words_["PIXSIZE"]),
           "convert the image");
    result.bytes = known->second;
    const std::string machine = lower_case(words_["CPU"]);
    result.is_big_endian = machine == "sun" || machine == "sgi";
    if (!result.is_big_endian && machine != "decm" && machine != "alpha" && machine != "pc" && result.bytes > 1)
      fail("CPU=decm, alpha, pc, sun or sgi", quote(words_["CPU"]), "mend the header");
    return result;
  }

  void read_values(const Encoding& encoding) {
    const std::size_t count = volume_.counts[0] * volume_.counts[1] * volume_.counts[2];
    const std::size_t there = file_.text.size() - std::min(file_.text.size(), header_size_);
    if (there < count * encoding.bytes)
      fail(std::to_string(count) + " numbers of " + std::to_string(encoding.bytes) + " bytes after the header",
           std::to_string(there) + " bytes", "the file is cut off");
    volume_.values.reserve(count);
    const char* next = file_.text.data() + header_size_;
    for (std::size_t i = 0; i < count; ++i, next += encoding.bytes) {
      const auto value = static_cast<float>(decoded(next, encoding));
      if (!std::isfinite(value))
        fail("finite numbers", format_number(value) + " as number " + std::to_string(i + 1), "mend the image");
      volume_.values.push_back(value);
    }
  }

  File_contents surface() const {
    const auto [least, greatest] = std::ranges::minmax(volume_.values);
    if (least == greatest)
      fail("numbers that differ", format_number(least) + " everywhere", "there is no surface in this image");
    const double level = otsu_threshold(volume_.values);
    File_contents contents;
    try {
      Level_surface_3 found = level_surface(volume_, level, most_triangles);
      contents.inputs = contents.inputs.with(mesh_input, std::move(found.mesh));
      contents.warnings.push_back(file_.path.string() + ": the surface is where the numbers, from " +
                                  format_number(least) + " to " + format_number(greatest) + ", reach " +
                                  format_number(level) + ", which parts them best (Otsu's threshold)");
      if (found.meets_border)
        contents.warnings.push_back(file_.path.string() +
                                    ": the surface meets the border of the image, and is closed there");
    } catch (const std::length_error&) {
      fail("a surface of at most " + std::to_string(most_triangles) + " triangles", "more", "make the image coarser");
    }
    return contents;
  }

  const Text_file& file_;
  std::map<std::string, std::string> words_;
  std::size_t header_size_ = 0;
  Volume_3 volume_;
};

}  // namespace

File_contents read_inr(const std::filesystem::path& path) {
  const Text_file file = load_bytes(path);
  return Inr_reader(file).read();
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/ply_header.h"

#include <charconv>
#include <string_view>
#include <system_error>

#include "core/formats/format.h"

namespace mesecina {
namespace {

struct Type_name {
  std::string_view name;
  Ply_type type;
};
constexpr Type_name type_names[] = {
    {"char", Ply_type::int8},       {"int8", Ply_type::int8},      {"uchar", Ply_type::uint8},
    {"uint8", Ply_type::uint8},     {"short", Ply_type::int16},    {"int16", Ply_type::int16},
    {"ushort", Ply_type::uint16},   {"uint16", Ply_type::uint16},  {"int", Ply_type::int32},
    {"int32", Ply_type::int32},     {"uint", Ply_type::uint32},    {"uint32", Ply_type::uint32},
    {"int64", Ply_type::int64},     {"uint64", Ply_type::uint64},  {"float", Ply_type::float32},
    {"float32", Ply_type::float32}, {"double", Ply_type::float64}, {"float64", Ply_type::float64},
};

/// The lines of a header, each split at blanks.
class Header_lines {
 public:
  explicit Header_lines(const Text_file& file) : file_(file) {}

  /// False at the end of the file, and for a line that is too long to be one of a header.
  bool next() {
    constexpr std::size_t longest = 10'000;
    const std::string_view rest = std::string_view(file_.text).substr(position_);
    const std::size_t end = rest.find('\n');
    if (end > longest) return false;  // npos is longer
    line_ = rest.substr(0, end);
    while (line_.ends_with('\r') || line_.ends_with(' ')) line_.remove_suffix(1);
    position_ += end + 1;
    ++number_;
    split_fields(line_, words_);
    return true;
  }
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i] : std::string_view(); }
  std::size_t word_count() const { return words_.size(); }
  std::string_view line() const { return line_; }
  std::size_t position() const { return position_; }

  [[noreturn]] void fail(const std::string& expected, const std::string& found, const std::string& remedy) const {
    std::string message = "expected ";
    message.append(expected).append(", found ").append(found).append("; ").append(remedy);
    throw File_error(file_.path, number_, message);
  }
  [[noreturn]] void fail(const std::string& expected) const { fail(expected, quote(line_), "correct this line"); }

 private:
  const Text_file& file_;
  std::size_t position_ = 0;
  std::size_t number_ = 0;
  std::string_view line_;
  std::vector<std::string_view> words_;
};

Ply_encoding encoding_of(const Header_lines& lines) {
  if (lines.word(0) == "format" && lines.word(2) == "1.0") {
    if (lines.word(1) == "ascii") return Ply_encoding::text;
    if (lines.word(1) == "binary_little_endian") return Ply_encoding::little_endian;
    if (lines.word(1) == "binary_big_endian") return Ply_encoding::big_endian;
  }
  lines.fail("'format ascii 1.0', 'format binary_little_endian 1.0' or 'format binary_big_endian 1.0'");
}

Ply_type type_of(const Header_lines& lines, std::string_view name) {
  for (const Type_name& known : type_names)
    if (known.name == name) return known.type;
  lines.fail("a type of PLY such as float, double, uchar or int", quote(name), "correct this line");
}

Ply_element element_of(const Header_lines& lines) {
  Ply_element element{std::string(lines.word(1)), 0, {}};
  const std::string_view count = lines.word(2);
  const auto parsed = std::from_chars(count.data(), count.data() + count.size(), element.count);
  if (lines.word_count() != 3 || parsed.ec != std::errc() || parsed.ptr != count.data() + count.size())
    lines.fail("'element NAME COUNT'");
  return element;
}

Ply_property property_of(const Header_lines& lines) {
  if (lines.word(1) == "list" && lines.word_count() == 5)
    return {std::string(lines.word(4)), type_of(lines, lines.word(3)), type_of(lines, lines.word(2))};
  if (lines.word_count() != 3) lines.fail("'property TYPE NAME' or 'property list TYPE TYPE NAME'");
  return {std::string(lines.word(2)), type_of(lines, lines.word(1)), std::nullopt};
}

}  // namespace

std::size_t size_of(Ply_type type) {
  switch (type) {
    case Ply_type::int8:
    case Ply_type::uint8:
      return 1;
    case Ply_type::int16:
    case Ply_type::uint16:
      return 2;
    case Ply_type::int32:
    case Ply_type::uint32:
    case Ply_type::float32:
      return 4;
    default:
      return 8;
  }
}

Ply_header parse_ply_header(const Text_file& file) {
  Header_lines lines(file);
  if (!lines.next() || lines.line() != "ply")
    lines.fail("'ply' in the first line", quote(lines.line()), "write it there, or convert the file to PLY");
  Ply_header header;
  bool has_format = false;
  while (lines.next()) {
    const std::string_view keyword = lines.word(0);
    if (keyword == "end_header") {
      if (!has_format) lines.fail("a line 'format ...' before the end of the header");
      header.size = lines.position();
      return header;
    }
    if (keyword == "format") {
      header.encoding = encoding_of(lines);
      has_format = true;
    } else if (keyword == "element") {
      header.elements.push_back(element_of(lines));
    } else if (keyword == "property") {
      if (header.elements.empty()) lines.fail("'element NAME COUNT' before its properties");
      header.elements.back().properties.push_back(property_of(lines));
    } else if (keyword != "comment" && keyword != "obj_info" && !lines.line().empty()) {
      lines.fail("format, element, property, comment or end_header");
    }
  }
  lines.fail("a header that ends with 'end_header'", "no such line", "the file is cut off or no PLY file");
}

}  // namespace mesecina

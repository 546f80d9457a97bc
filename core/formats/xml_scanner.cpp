// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/xml_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>

#include "core/formats/format.h"
#include "core/formats/text_file.h"

namespace mesecina {
namespace {

void append_utf8(std::string& text, std::uint32_t code) {
  const auto trail = [&](int shift) { text += static_cast<char>(0x80 | ((code >> shift) & 0x3F)); };
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xC0 | (code >> 6));
    trail(0);
  } else if (code < 0x10000) {
    text += static_cast<char>(0xE0 | (code >> 12));
    trail(6);
    trail(0);
  } else {
    text += static_cast<char>(0xF0 | (code >> 18));
    trail(12);
    trail(6);
    trail(0);
  }
}

/// The character that "#65" or "#x41" stands for.
std::optional<std::uint32_t> character_code(std::string_view entity) {
  if (!entity.starts_with('#')) return std::nullopt;
  entity.remove_prefix(1);
  const bool is_hexadecimal = entity.starts_with('x');
  if (is_hexadecimal) entity.remove_prefix(1);
  std::uint32_t code = 0;
  const auto parsed = std::from_chars(entity.data(), entity.data() + entity.size(), code, is_hexadecimal ? 16 : 10);
  constexpr std::uint32_t last_character = 0x10FFFF;
  if (parsed.ec != std::errc() || parsed.ptr != entity.data() + entity.size() || code == 0 || code > last_character)
    return std::nullopt;
  return code;
}

std::string replace_entities(std::string_view value) {
  static constexpr std::array<std::pair<std::string_view, char>, 5> named = {
      {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}}};
  std::string text;
  text.reserve(value.size());
  while (!value.empty()) {
    const std::size_t begin = std::min(value.find('&'), value.size());
    text += value.substr(0, begin);
    value.remove_prefix(begin);
    if (value.empty()) break;
    constexpr std::size_t longest_entity = 12;
    const std::size_t end = value.substr(0, longest_entity).find(';');
    const std::string_view entity = end == std::string_view::npos ? std::string_view() : value.substr(1, end - 1);
    const auto name = std::ranges::find(named, entity, [](const auto& pair) { return pair.first; });
    if (name != named.end()) {
      text += name->second;
      value.remove_prefix(end + 1);
    } else if (const auto code = character_code(entity)) {
      append_utf8(text, *code);
      value.remove_prefix(end + 1);
    } else {
      text += '&';
      value.remove_prefix(1);
    }
  }
  return text;
}

}  // namespace

const std::string* Xml_tag::find(std::string_view attribute) const {
  const auto it = std::ranges::find(attributes, attribute, [](const auto& pair) { return pair.first; });
  return it == attributes.end() ? nullptr : &it->second;
}

bool Xml_scanner::next(Xml_tag& tag) {
  while (true) {
    position_ = std::min(text_.find('<', position_), text_.size());
    if (position_ == text_.size()) return false;
    const std::string_view rest = text_.substr(position_);
    if (rest.starts_with("<!--")) {
      skip_past("-->", "the end '-->' of a comment");
    } else if (rest.starts_with("<![CDATA[")) {
      skip_past("]]>", "the end ']]>' of character data");
    } else if (rest.starts_with("<?")) {
      skip_past("?>", "the end '?>' of a processing instruction");
    } else if (rest.starts_with("<!")) {
      skip_doctype();
    } else {
      break;
    }
  }
  count_lines();
  tag.line = line_;
  tag.attributes.clear();
  ++position_;
  tag.opens = !text_.substr(position_).starts_with('/');
  tag.closes = !tag.opens;
  if (tag.closes) ++position_;
  tag.name = scan_name();
  scan_attributes(tag);
  return true;
}

void Xml_scanner::fail(const std::string& expected) {
  count_lines();
  const std::string_view rest = text_.substr(position_);
  const std::string found = rest.empty() ? "the end of the file" : quote(rest.substr(0, rest.find('\n')));
  throw File_error(file_.path, line_,
                   "expected " + expected + ", found " + found + "; the file is damaged or cut off, export it again");
}

void Xml_scanner::count_lines() {
  for (; counted_ < position_; ++counted_)
    if (text_[counted_] == '\n') ++line_;
}

void Xml_scanner::skip_blanks() { position_ = std::min(text_.find_first_not_of(blanks, position_), text_.size()); }

void Xml_scanner::skip_past(std::string_view end, const std::string& expected) {
  const std::size_t found = text_.find(end, position_);
  if (found == std::string_view::npos) fail(expected);
  position_ = found + end.size();
}

/// A DOCTYPE may hold declarations between square brackets, and these hold quoted texts.
void Xml_scanner::skip_doctype() {
  std::size_t end = position_;
  bool in_brackets = false;
  char quotation = 0;
  for (; end < text_.size(); ++end) {
    const char c = text_[end];
    if (quotation != 0) {
      if (c == quotation) quotation = 0;
    } else if (c == '"' || c == '\'') {
      quotation = c;
    } else if (c == '[' || c == ']') {
      in_brackets = c == '[';
    } else if (c == '>' && !in_brackets) {
      position_ = end + 1;
      return;
    }
  }
  fail("the end '>' of a declaration");
}

std::string_view Xml_scanner::scan_name() {
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n\v\f/>=<\"'", position_), text_.size());
  if (end == position_) fail("a name");
  const std::string_view name = text_.substr(position_, end - position_);
  position_ = end;
  return name;
}

void Xml_scanner::scan_attributes(Xml_tag& tag) {
  while (true) {
    skip_blanks();
    const std::string_view rest = text_.substr(position_);
    if (rest.starts_with('>')) {
      ++position_;
      return;
    }
    if (rest.starts_with("/>") && tag.opens) {
      position_ += 2;
      tag.closes = true;
      return;
    }
    if (rest.empty()) fail("the end '>' of the tag <" + std::string(tag.name));
    const std::string_view name = scan_name();
    skip_blanks();
    if (position_ == text_.size() || text_[position_] != '=') fail("'=' after " + std::string(name));
    ++position_;
    skip_blanks();
    const char quotation = position_ < text_.size() ? text_[position_] : '\0';
    if (quotation != '"' && quotation != '\'') fail("a value in quotes for " + std::string(name));
    const std::size_t end = text_.find(quotation, position_ + 1);
    if (end == std::string_view::npos) fail("the closing quote of the value of " + std::string(name));
    tag.attributes.emplace_back(name, replace_entities(text_.substr(position_ + 1, end - position_ - 1)));
    position_ = end + 1;
  }
}

}  // namespace mesecina

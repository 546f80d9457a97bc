// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/field_scanner.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "core/formats/format.h"

namespace mesecina {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }
bool is_comma(char c) { return c == ',' || c == ';'; }

std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace

Field_scanner::Field_scanner(const Text_file& file, Comments comments, std::size_t offset)
    : file_(file),
      comments_(comments),
      rest_(std::string_view(file.text).substr(offset)),
      number_(static_cast<std::size_t>(
          std::count(file.text.begin(), file.text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'))) {}

bool Field_scanner::next_line() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    line_ = line_.substr(0, line_.find('#'));
    if (comments_ == Comments::hash_or_slashes) line_ = line_.substr(0, line_.find("//"));
    line_ = trim(line_);
    next_ = line_.data();
    end_ = next_ + line_.size();
    is_owed_ = false;
    if (!line_.empty()) return true;
  }
  line_ = {};
  next_ = end_ = nullptr;
  is_owed_ = false;
  return false;
}

void Field_scanner::skip_to_field() {
  while (next_ != end_ && is_blank(*next_)) ++next_;
}

void Field_scanner::finish_field() {
  skip_to_field();
  is_owed_ = false;
  if (next_ != end_ && is_comma(*next_)) {
    ++next_;
    skip_to_field();
    is_owed_ = next_ == end_;
  }
}

bool Field_scanner::ends_field(const char* position) const {
  return position == end_ || is_blank(*position) || is_comma(*position);
}

std::string_view Field_scanner::field() {
  skip_to_field();
  const char* begin = next_;
  while (!ends_field(next_)) ++next_;
  const std::string_view result(begin, static_cast<std::size_t>(next_ - begin));
  finish_field();
  return result;
}

double Field_scanner::number(std::string_view name) {
  skip_to_field();
  const char* begin = next_;
  if (end_ - begin > 1 && *begin == '+' && begin[1] != '-') ++begin;
  double value = 0;
  const auto result = std::from_chars(begin, end_, value);
  if (result.ec != std::errc() || !std::isfinite(value) || !ends_field(result.ptr))
    fail("a finite number for " + std::string(name), quote(field()));
  next_ = result.ptr;
  finish_field();
  return value;
}

std::uint64_t Field_scanner::count(std::string_view name) {
  skip_to_field();
  std::uint64_t value = 0;
  const auto result = std::from_chars(next_, end_, value);
  if (result.ec != std::errc() || !ends_field(result.ptr)) {
    fail("an integer of at least 0 for " + std::string(name), quote(field()));
  }
  next_ = result.ptr;
  finish_field();
  return value;
}

int Field_scanner::index(std::size_t vertex_count) {
  skip_to_field();
  int value = -1;
  const auto result = std::from_chars(next_, end_, value);
  if (result.ec != std::errc() || !ends_field(result.ptr) || value < 0 ||
      static_cast<std::size_t>(value) >= vertex_count) {
    const std::string found = quote(field());
    if (vertex_count == 0) fail("no faces, as there are no vertices", found);
    fail("a vertex number from 0 to " + std::to_string(vertex_count - 1), found);
  }
  next_ = result.ptr;
  finish_field();
  return value;
}

void Field_scanner::fail(const std::string& expected, const std::string& found, const std::string& remedy) const {
  std::string message = "expected ";
  message.append(expected).append(", found ").append(found).append("; ").append(remedy);
  throw File_error(file_.path, number_, message);
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "core/formats/number.h"
#include "core/formats/readers.h"
#include "core/formats/ring_collector.h"
#include "core/formats/text_file.h"

namespace mesecina {
namespace {

constexpr std::string_view expected_geometry = "POLYGON, MULTIPOLYGON, closed LINESTRING, POINT or MULTIPOINT";

class Wkt_parser {
 public:
  explicit Wkt_parser(const Text_file& file) : file_(file), text_(file.text) {}

  File_contents parse() {
    skip_blanks();
    while (position_ < text_.size()) {
      skip_srid();
      parse_geometry(0);
      skip_blanks();
      if (position_ < text_.size() && text_[position_] == ';') ++position_;
      skip_blanks();
    }
    if (!has_points_ && !has_rings_)
      fail("at least one " + std::string(expected_geometry), "this file has only empty collections");
    File_contents contents;
    if (has_points_) contents.inputs = contents.inputs.with(points_input, std::move(points_));
    if (has_rings_) contents.inputs = contents.inputs.with(outline_input, rings_.finish());
    contents.warnings = warnings_.take();
    return contents;
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& advice) {
    skip_blanks();
    const std::string found = position_ < text_.size() ? quote(text_.substr(position_, 60)) : "the end of the file";
    throw File_error(file_.path, line(), "expected " + expected + ", found " + found + "; " + advice);
  }

  std::size_t line() {
    for (; counted_ < position_; ++counted_)
      if (text_[counted_] == '\n') ++line_;
    return line_;
  }

  void skip_blanks() { position_ = std::min(text_.find_first_not_of(" \t\r\n\v\f", position_), text_.size()); }

  bool accept(char c) {
    skip_blanks();
    if (position_ == text_.size() || text_[position_] != c) return false;
    ++position_;
    return true;
  }

  void expect(char c) {
    if (!accept(c)) fail(std::string("'") + c + "'", "the file is cut off or its brackets do not match");
  }

  std::string accept_word() {
    skip_blanks();
    const std::size_t begin = position_;
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    while (position_ < text_.size() && is_letter(text_[position_])) ++position_;
    return lower_case(text_.substr(begin, position_ - begin));
  }

  bool accept_keyword(std::string_view keyword) {
    skip_blanks();
    const std::size_t begin = position_;
    if (accept_word() == keyword) return true;
    position_ = begin;
    return false;
  }

  void skip_srid() {
    if (!accept_keyword("srid")) return;
    const std::size_t end = text_.find_first_of(";\n", position_);
    if (end == std::string_view::npos || text_[end] != ';') fail("'=number;' after SRID", "correct or delete the SRID");
    position_ = end + 1;
  }

  void parse_geometry(int depth) {
    constexpr int deepest = 100;
    if (depth > deepest) fail("at most 100 nested collections", "take the geometries out of their collections");
    skip_blanks();
    const std::size_t begin = position_;
    std::string type = accept_word();
    for (const std::string_view suffix : {"zm", "z", "m"}) {
      if (type.ends_with(suffix) && type.size() > suffix.size()) {
        type.resize(type.size() - suffix.size());
        break;
      }
    }
    if (!accept_keyword("zm") && !accept_keyword("z")) accept_keyword("m");

    const auto members = [&](auto&& member) { parse_list([&] { member(); }); };
    const auto ring = [&] { parse_ring(Ring_collector::End::repeats_first); };
    const auto closed_line = [&] { parse_closed_line(); };
    if (type == "polygon") {
      has_rings_ = true;
      members(ring);
    } else if (type == "multipolygon") {
      has_rings_ = true;
      members([&] { members(ring); });
    } else if (type == "linestring") {
      has_rings_ = true;
      if (!accept_keyword("empty")) closed_line();
    } else if (type == "multilinestring") {
      has_rings_ = true;
      members(closed_line);
    } else if (type == "point") {
      has_points_ = true;
      members([&] { points_.push_back(parse_point()); });
    } else if (type == "multipoint") {
      has_points_ = true;
      members([&] {
        const bool in_brackets = accept('(');
        points_.push_back(parse_point());
        if (in_brackets) expect(')');
      });
    } else if (type == "geometrycollection") {
      members([&] { parse_geometry(depth + 1); });
    } else {
      position_ = begin;
      fail(std::string(expected_geometry), "convert the geometry to one of these");
    }
  }

  /// EMPTY, or one or more members in brackets, with commas between them.
  template <class Member>
  void parse_list(const Member& member) {
    if (accept_keyword("empty")) return;
    expect('(');
    do member();
    while (accept(','));
    expect(')');
  }

  void parse_ring(Ring_collector::End end) {
    skip_blanks();
    const std::size_t ring_line = line();
    Ring_2 ring;
    parse_list([&] { ring.push_back(parse_point()); });
    rings_.add(std::move(ring), end, "line " + std::to_string(ring_line));
  }

  void parse_closed_line() {
    skip_blanks();
    const std::size_t begin = position_;
    const std::size_t begin_line = line();
    Ring_2 ring;
    parse_list([&] { ring.push_back(parse_point()); });
    if (ring.empty() || ring.front() != ring.back()) {
      throw File_error(file_.path, begin_line,
                       "expected a LINESTRING that ends where it starts, found " +
                           quote(text_.substr(begin, position_ - begin)) +
                           "; close it, or write POLYGON if it is meant to be closed");
    }
    rings_.add(std::move(ring), Ring_collector::End::repeats_first, "line " + std::to_string(begin_line));
  }

  Point_2 parse_point() {
    const double x = parse_coordinate();
    const double y = parse_coordinate();
    for (int more = 0; more < 2; ++more) {
      skip_blanks();
      if (position_ == text_.size() || text_[position_] == ',' || text_[position_] == ')') break;
      if (!has_heights_) warnings_.add("line " + std::to_string(line()) + ": Z and M coordinates are left out");
      has_heights_ = true;
      parse_coordinate();
    }
    return {x, y};
  }

  double parse_coordinate() {
    skip_blanks();
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n\v\f,();", position_), text_.size());
    const std::optional<double> number = parse_number(text_.substr(position_, end - position_));
    if (!number || !std::isfinite(*number)) fail("a finite coordinate", "correct the number or write the file again");
    position_ = end;
    return *number;
  }

  const Text_file& file_;
  std::string_view text_;
  std::size_t position_ = 0;
  std::size_t counted_ = 0;
  std::size_t line_ = 1;
  Warning_list warnings_;
  Ring_collector rings_{warnings_};
  std::vector<Point_2> points_;
  bool has_points_ = false;
  bool has_rings_ = false;
  bool has_heights_ = false;
};

}  // namespace

File_contents read_wkt(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  return Wkt_parser(file).parse();
}

}  // namespace mesecina

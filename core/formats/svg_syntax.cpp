// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/svg_syntax.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/formats/format.h"

namespace mesecina {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads the numbers of an attribute one after another. SVG allows much to be left out: "1.5.5-3" are three numbers.
class Number_scanner {
 public:
  explicit Number_scanner(const Svg_attribute& attribute) : attribute_(attribute), rest_(attribute.value) {}

  bool at_end() {
    skip_blanks();
    return rest_.empty();
  }
  /// What comes next; '\0' at the end.
  char peek() {
    skip_blanks();
    return rest_.empty() ? '\0' : rest_.front();
  }
  char take() {
    const char c = peek();
    rest_.remove_prefix(1);
    return c;
  }
  void skip_comma() {
    if (peek() == ',') take();
  }
  bool starts_number() {
    const char c = peek();
    return is_digit(c) || c == '.' || c == '+' || c == '-';
  }
  double take_number() {
    skip_blanks();
    std::string_view digits = rest_;
    if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
    const std::size_t first = digits.starts_with('-') ? 1 : 0;
    double number = 0;
    const auto parsed = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_number = digits.size() > first && (is_digit(digits[first]) || digits[first] == '.');
    if (!is_number || parsed.ec != std::errc()) fail("a number");
    rest_.remove_prefix(static_cast<std::size_t>(parsed.ptr - rest_.data()));
    skip_comma();
    return number;
  }
  bool take_flag() {
    const char c = peek();
    if (c != '0' && c != '1') fail("a flag 0 or 1");
    take();
    skip_comma();
    return c == '1';
  }
  std::string_view take_word() {
    skip_blanks();
    const auto end = std::ranges::find_if_not(
        rest_, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%'; });
    const std::string_view word = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
    rest_.remove_prefix(word.size());
    return word;
  }
  [[noreturn]] void fail(const std::string& expected) const { attribute_.fail(expected, rest_); }

 private:
  void skip_blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n\f"), rest_.size())); }

  const Svg_attribute& attribute_;
  std::string_view rest_;
};

class Path_parser {
 public:
  explicit Path_parser(const Svg_attribute& data) : numbers_(data) {}

  std::vector<Subpath> parse() && {
    if (!numbers_.at_end() && lower_case(numbers_.peek()) != 'm') numbers_.fail("a command M or m");
    while (!numbers_.at_end()) {
      const char letter = numbers_.peek();
      const char command = lower_case(letter);
      if (std::string_view("mlhvcsqtaz").find(command) == std::string_view::npos)
        numbers_.fail("one of the commands MLHVCSQTAZ");
      numbers_.take();
      is_relative_ = letter == command;
      if (command == 'z') {
        close();
      } else {
        run(command);
        while (numbers_.starts_number()) run(command == 'm' ? 'l' : command);
      }
    }
    finish_subpath();
    return std::move(subpaths_);
  }

 private:
  Point_2 origin() const { return is_relative_ ? subpath_.end() : Point_2{}; }
  Point_2 take_point() {
    const Point_2 base = origin();
    const double x = numbers_.take_number();
    return {base.x + x, base.y + numbers_.take_number()};
  }

  void run(char command) {
    const Point_2 start = subpath_.end();
    Point_2 control = start;
    switch (command) {
      case 'm': {
        const Point_2 to = take_point();
        finish_subpath();
        subpath_.start = to;
        break;
      }
      case 'l':
        subpath_.add_line(take_point());
        break;
      case 'h':
        subpath_.add_line({origin().x + numbers_.take_number(), start.y});
        break;
      case 'v':
        subpath_.add_line({start.x, origin().y + numbers_.take_number()});
        break;
      case 'c':
      case 's': {
        const Point_2 control_1 = command == 'c' ? take_point() : reflected("cs");
        control = take_point();
        subpath_.add_cubic(control_1, control, take_point());
        break;
      }
      case 'q':
      case 't':
        control = command == 'q' ? take_point() : reflected("qt");
        subpath_.add_quadratic(control, take_point());
        break;
      default:
        run_arc();
    }
    previous_ = command;
    previous_control_ = control;
  }

  void run_arc() {
    const double radius_x = numbers_.take_number();
    const double radius_y = numbers_.take_number();
    const double rotation = numbers_.take_number();
    const bool large = numbers_.take_flag();
    const bool positive_sweep = numbers_.take_flag();
    subpath_.add_svg_arc(radius_x, radius_y, rotation, large, positive_sweep, take_point());
  }

  /// The control point of a smooth curve, whose predecessor is one of `family` or has none.
  Point_2 reflected(std::string_view family) const {
    const Point_2 start = subpath_.end();
    if (family.find(previous_) == std::string_view::npos) return start;
    return {2 * start.x - previous_control_.x, 2 * start.y - previous_control_.y};
  }

  void close() {
    subpath_.is_closed = true;
    finish_subpath();
    previous_ = 'z';
  }

  /// What comes next starts where the finished subpath started, unless a move says otherwise.
  void finish_subpath() {
    const Point_2 start = subpath_.start;
    if (!subpath_.curves.empty()) subpaths_.push_back(std::move(subpath_));
    subpath_ = Subpath{start, {}, false};
  }

  Number_scanner numbers_;
  bool is_relative_ = false;
  char previous_ = 'm';
  Point_2 previous_control_;
  Subpath subpath_;
  std::vector<Subpath> subpaths_;
};

Affine_2 make_rotation(const std::vector<double>& numbers) {
  const double angle = numbers[0] * (std::numbers::pi / 180);
  const Affine_2 rotation{std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle), 0, 0};
  if (numbers.size() == 1) return rotation;
  return Affine_2{1, 0, 0, 1, numbers[1], numbers[2]} * rotation * Affine_2{1, 0, 0, 1, -numbers[1], -numbers[2]};
}

struct Transform_function {
  std::string_view name;
  std::array<std::size_t, 2> counts;  ///< of numbers that it may have
  Affine_2 (*make)(const std::vector<double>& numbers);
};

constexpr std::array<Transform_function, 6> transform_functions = {{
    {"matrix", {6, 6}, [](const std::vector<double>& n) { return Affine_2{n[0], n[1], n[2], n[3], n[4], n[5]}; }},
    {"translate",
     {1, 2},
     [](const std::vector<double>& n) { return Affine_2{1, 0, 0, 1, n[0], n.size() > 1 ? n[1] : 0}; }},
    {"scale", {1, 2}, [](const std::vector<double>& n) { return Affine_2{n[0], 0, 0, n.back(), 0, 0}; }},
    {"rotate", {1, 3}, make_rotation},
    {"skewX",
     {1, 1},
     [](const std::vector<double>& n) { return Affine_2{1, 0, std::tan(n[0] * (std::numbers::pi / 180)), 1, 0, 0}; }},
    {"skewY",
     {1, 1},
     [](const std::vector<double>& n) { return Affine_2{1, std::tan(n[0] * (std::numbers::pi / 180)), 0, 1, 0, 0}; }},
}};

}  // namespace

void Svg_attribute::fail(const std::string& expected, std::string_view rest) const {
  throw File_error(file.path, line,
                   "expected " + expected + " in <" + std::string(element) + " " + std::string(name) + "=...>, found " +
                       quote(rest) + "; correct this attribute");
}

std::vector<Subpath> parse_path(const Svg_attribute& data) {
  if (lower_case(data.value) == "none") return {};
  return Path_parser(data).parse();
}

std::vector<Point_2> parse_corners(const Svg_attribute& points) {
  Number_scanner numbers(points);
  std::vector<Point_2> corners;
  while (!numbers.at_end()) {
    const double x = numbers.take_number();
    corners.push_back({x, numbers.take_number()});
  }
  return corners;
}

Affine_2 parse_transform(const Svg_attribute& transform) {
  Number_scanner scanner(transform);
  Affine_2 result;
  if (lower_case(transform.value) == "none") return result;
  while (!scanner.at_end()) {
    const std::string_view name = scanner.take_word();
    const auto function = std::ranges::find(transform_functions, name, &Transform_function::name);
    if (function == transform_functions.end() || scanner.peek() != '(')
      scanner.fail("matrix(...), translate, scale, rotate, skewX or skewY");
    scanner.take();
    std::vector<double> numbers;
    constexpr std::size_t most_numbers = 6;
    while (scanner.peek() != ')' && numbers.size() <= most_numbers) numbers.push_back(scanner.take_number());
    if (std::ranges::count(function->counts, numbers.size()) == 0 || scanner.peek() != ')')
      scanner.fail("the right number of arguments of " + std::string(name));
    scanner.take();
    scanner.skip_comma();
    result = result * function->make(numbers);
  }
  return result;
}

std::optional<double> parse_length(const Svg_attribute& length) {
  static constexpr std::array<std::pair<std::string_view, double>, 7> units = {
      {{"", 1.}, {"px", 1.}, {"pt", 4. / 3}, {"pc", 16.}, {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"in", 96.}}};
  Number_scanner scanner(length);
  const double number = scanner.take_number();
  const std::string unit = lower_case(scanner.take_word());
  if (!scanner.at_end()) scanner.fail("a number and a unit");
  const auto it = std::ranges::find(units, unit, [](const auto& pair) { return pair.first; });
  if (it == units.end()) return std::nullopt;
  return number * it->second;
}

}  // namespace mesecina

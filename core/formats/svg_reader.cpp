// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include "core/formats/readers.h"
#include "core/formats/ring_collector.h"
#include "core/formats/svg_geometry.h"
#include "core/formats/svg_syntax.h"
#include "core/formats/text_file.h"
#include "core/formats/xml_scanner.h"

namespace mesecina {
namespace {

constexpr double relative_tolerance = 1. / 2000;

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

bool is_never_drawn(const Xml_tag& tag) {
  if (is_one_of(tag.name, {"defs", "symbol", "clipPath", "mask", "pattern", "marker", "foreignObject"})) return true;
  const std::string* display = tag.find("display");
  if (display && *display == "none") return true;
  const std::string* style = tag.find("style");
  if (!style) return false;
  std::string compact = *style;
  std::erase_if(compact, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  return (";" + compact).find(";display:none") != std::string::npos;
}

/// "<name>" or, with the opening "</", "</name>".
std::string in_brackets(std::string_view name, std::string_view opening = "<") {
  return std::string(opening).append(name).append(">");
}

class Svg_reader {
 public:
  explicit Svg_reader(const Text_file& file) : file_(file) {}

  File_contents read() {
    read_tags();
    if (!has_shapes_) {
      throw File_error(file_.path, 0,
                       "expected a path, rect, circle, ellipse, polygon or polyline that is drawn, found none" +
                           (skipped_.empty() ? "" : " but " + in_brackets(skipped_.begin()->first)) +
                           "; convert the objects to paths");
    }
    flatten_shapes();
    File_contents contents;
    contents.inputs = contents.inputs.with(outline_input, rings_.finish());
    for (const auto& [name, count] : skipped_) {
      warnings_.add(std::to_string(count) + " <" + name + (count == 1 ? "> is" : "> are") +
                    " not read; convert it to paths to get its outline");
    }
    contents.warnings = warnings_.take();
    return contents;
  }

 private:
  struct Group {
    std::string_view name;
    Affine_2 transform;
    bool is_drawn = true;
  };
  struct Shape {
    Subpath subpath;
    std::size_t line = 0;
  };

  void read_tags() {
    Xml_scanner scanner(file_);
    std::vector<Group> groups;
    Xml_tag tag;
    bool has_root = false;
    while (scanner.next(tag)) {
      constexpr std::string_view prefix = "svg:";
      if (tag.name.starts_with(prefix)) tag.name.remove_prefix(prefix.size());
      if (!has_root && (tag.name != "svg" || !tag.opens))
        fail(tag, "the first element <svg>", in_brackets(tag.name), "this is not an SVG file");
      if (!tag.opens) {
        const std::string open = groups.empty() ? "no end tag" : in_brackets(groups.back().name, "</");
        if (groups.empty() || groups.back().name != tag.name)
          fail(tag, open, in_brackets(tag.name, "</"), "the file is damaged, export it again");
        groups.pop_back();
        continue;
      }
      // SVG's y points down.
      Group group{tag.name, has_root ? Affine_2{} : Affine_2{1, 0, 0, -1, 0, 0}, true};
      if (!groups.empty()) group = {tag.name, groups.back().transform, groups.back().is_drawn};
      has_root = true;
      group.is_drawn = group.is_drawn && !is_never_drawn(tag);
      if (group.is_drawn) {
        if (tag.find("transform")) group.transform = group.transform * parse_transform(attribute(tag, "transform"));
        read_element(tag, group.transform);
      }
      if (!tag.closes) groups.push_back(group);
    }
    if (!has_root) throw File_error(file_.path, 1, "expected an <svg> element, found none; this is not an SVG file");
    if (!groups.empty()) {
      throw File_error(file_.path, file_.line_at(file_.text.size()),
                       "expected " + in_brackets(groups.back().name, "</") +
                           ", found the end of the file; the file is cut off, export it again");
    }
  }

  [[noreturn]] void fail(const Xml_tag& tag, const std::string& expected, const std::string& found,
                         const std::string& advice) const {
    throw File_error(file_.path, tag.line, "expected " + expected + ", found " + found + "; " + advice);
  }

  Svg_attribute attribute(const Xml_tag& tag, std::string_view name) const {
    const std::string* value = tag.find(name);
    return {file_, tag.line, tag.name, name, value ? std::string_view(*value) : std::string_view()};
  }

  void read_element(const Xml_tag& tag, const Affine_2& transform) {
    std::vector<Subpath> subpaths;
    if (tag.name == "path") {
      subpaths = parse_path(attribute(tag, "d"));
    } else if (is_one_of(tag.name, {"polygon", "polyline"})) {
      subpaths = polyline(tag);
    } else if (tag.name == "rect") {
      subpaths = rectangle(tag);
    } else if (is_one_of(tag.name, {"circle", "ellipse"})) {
      subpaths = ellipse(tag);
    } else {
      if (is_one_of(tag.name, {"use", "text", "image", "line"})) ++skipped_[std::string(tag.name)];
      return;
    }
    has_shapes_ = true;
    for (const Subpath& subpath : subpaths) {
      Shape shape{transformed(subpath, transform), tag.line};
      const Box box = bounding_box(shape.subpath);
      if (!is_finite(shape.subpath) || !std::isfinite(box.diagonal())) {
        fail(tag, "finite coordinates", "overflow in " + in_brackets(tag.name), "correct its numbers or its transform");
      }
      box_.add(box);
      shapes_.push_back(std::move(shape));
    }
  }

  /// Lengths of a shape; nothing when one depends on the page or the font. Absent ones are 0.
  template <std::size_t count>
  std::optional<std::array<double, count>> lengths(const Xml_tag& tag,
                                                   const std::array<std::string_view, count>& names) {
    std::array<double, count> result{};
    for (std::size_t i = 0; i < count; ++i) {
      const std::string* value = tag.find(names[i]);
      if (!value || *value == "auto") continue;
      const std::optional<double> length = parse_length(attribute(tag, names[i]));
      if (!length) {
        warnings_.add("line " + std::to_string(tag.line) + ": <" + std::string(tag.name) + " " + std::string(names[i]) +
                      "=" + quote(*value) + "> is left out, its unit is not known");
        return std::nullopt;
      }
      result[i] = *length;
    }
    return result;
  }

  std::vector<Subpath> polyline(const Xml_tag& tag) const {
    const std::vector<Point_2> corners = parse_corners(attribute(tag, "points"));
    if (corners.empty()) return {};
    Subpath subpath{corners.front(), {}, tag.name == "polygon"};
    for (std::size_t i = 1; i < corners.size(); ++i) subpath.add_line(corners[i]);
    return {subpath};
  }

  std::vector<Subpath> rectangle(const Xml_tag& tag) {
    const auto numbers = lengths<6>(tag, {"x", "y", "width", "height", "rx", "ry"});
    if (!numbers) return {};
    const auto [x, y, width, height, given_rx, given_ry] = *numbers;
    if (width <= 0 || height <= 0) return {};
    const bool has_rx = tag.find("rx") && *tag.find("rx") != "auto";
    const bool has_ry = tag.find("ry") && *tag.find("ry") != "auto";
    const double rx = std::clamp(has_rx ? given_rx : given_ry, 0., width / 2);
    const double ry = std::clamp(has_ry ? given_ry : given_rx, 0., height / 2);
    if (rx == 0 || ry == 0) {
      Subpath subpath{{x, y}, {}, true};
      subpath.add_line({x + width, y});
      subpath.add_line({x + width, y + height});
      subpath.add_line({x, y + height});
      return {subpath};
    }
    Subpath subpath{{x + rx, y}, {}, true};
    const auto add_corner = [&](double center_x, double center_y, double from, const Point_2& begin,
                                const Point_2& end) {
      subpath.add_line(begin);
      subpath.add_arc({rx, 0, 0, ry, center_x, center_y}, from, std::numbers::pi / 2, end);
    };
    const double right = x + width;
    const double bottom = y + height;
    constexpr double quarter = std::numbers::pi / 2;
    add_corner(right - rx, y + ry, -quarter, {right - rx, y}, {right, y + ry});
    add_corner(right - rx, bottom - ry, 0, {right, bottom - ry}, {right - rx, bottom});
    add_corner(x + rx, bottom - ry, quarter, {x + rx, bottom}, {x, bottom - ry});
    add_corner(x + rx, y + ry, 2 * quarter, {x, y + ry}, {x + rx, y});
    return {subpath};
  }

  std::vector<Subpath> ellipse(const Xml_tag& tag) {
    const auto numbers = lengths<5>(tag, {"cx", "cy", "r", "rx", "ry"});
    if (!numbers) return {};
    const auto [cx, cy, r, given_rx, given_ry] = *numbers;
    const double rx = tag.name == "circle" ? r : given_rx;
    const double ry = tag.name == "circle" ? r : given_ry;
    if (rx <= 0 || ry <= 0) return {};
    Subpath subpath{{cx + rx, cy}, {}, true};
    subpath.add_arc({rx, 0, 0, ry, cx, cy}, 0, 2 * std::numbers::pi, subpath.start);
    return {subpath};
  }

  void flatten_shapes() {
    const double tolerance = relative_tolerance * box_.diagonal();
    for (const Shape& shape : shapes_) {
      rings_.add(flatten(shape.subpath, tolerance),
                 shape.subpath.is_closed ? Ring_collector::End::is_implied : Ring_collector::End::repeats_first,
                 "line " + std::to_string(shape.line));
    }
  }

  const Text_file& file_;
  Warning_list warnings_;
  Ring_collector rings_{warnings_};
  std::vector<Shape> shapes_;
  Box box_;
  bool has_shapes_ = false;
  std::map<std::string, std::size_t> skipped_;  ///< elements that are drawn but not read
};

}  // namespace

File_contents read_svg(const std::filesystem::path& path) {
  const Text_file file = load_text(path);
  return Svg_reader(file).read();
}

}  // namespace mesecina

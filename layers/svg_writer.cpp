// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/svg_writer.h"

#include <array>
#include <cmath>
#include <numbers>
#include <ostream>
#include <set>
#include <string>
#include <string_view>

#include "core/formats/number.h"
#include "layers/scene_shapes.h"
#include "layers/svg_text.h"

namespace mesecina {
namespace {

/// Beyond it single-precision viewers are visibly wrong.
constexpr double reach = 1e5;
/// As in painter_canvas.cpp: closes the hairlines between neighbouring areas of different colour.
constexpr std::string_view seam_width = "0.6";

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) -> unsigned {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
    };
    const unsigned group = byte(0) << 16 | byte(1) << 8 | byte(2);
    result += digits[group >> 18];
    result += digits[group >> 12 & 63];
    result += i + 1 < bytes.size() ? digits[group >> 6 & 63] : '=';
    result += i + 2 < bytes.size() ? digits[group & 63] : '=';
  }
  return result;
}

class Svg_sink : public Shape_sink {
 public:
  Svg_sink(std::string& out, const Png_encoder& encode_png) : out_(out), encode_png_(encode_png) {}

  void begin_layer(const Scene_layer& layer, const Layer_colors& colors) override {
    style_ = &layer.style;
    uniform_ = colors.is_uniform();
    opaque_ = style_->opacity >= 1;
    out_ += "<g";
    append_attribute(out_, "id", unique_svg_id(layer.id, ids_));
    append_attribute(out_, "inkscape:groupmode", "layer");
    append_attribute(out_, "inkscape:label", svg_escaped(layer.label.empty() ? layer.id : layer.label));
    append_attribute(out_, "clip-path", "url(#page)");
    out_ += ">\n";
  }

  void end_layer() override {
    end_kind();
    out_ += "</g>\n";
  }

  void image(const Image& image, const Pixel_box& place) override {
    end_kind();
    if (!encode_png_) return;
    out_ += "<image";
    append_attribute(out_, "x", place.left);
    append_attribute(out_, "y", place.top);
    append_attribute(out_, "width", place.right - place.left);
    append_attribute(out_, "height", place.bottom - place.top);
    append_attribute(out_, "preserveAspectRatio", "none");
    if (place.right - place.left >= image.width) append_attribute(out_, "style", "image-rendering:pixelated");
    if (!opaque_) append_attribute(out_, "opacity", style_->opacity);
    append_attribute(out_, "xlink:href", "data:image/png;base64," + base64(encode_png_(image)));
    out_ += "/>\n";
  }

  void area(const Pixel_rings& rings, bool odd_even, Color color) override {
    begin_kind(odd_even ? Kind::odd_even_areas : Kind::winding_areas);
    std::string path;
    for (std::size_t i = 0; i < rings.size(); ++i) {
      const auto ring = rings.ring(i);
      append_ring(path, ring);
    }
    element_path(path, color);
  }

  void region(const Pixel_region& region, bool odd_even, Color color) override {
    end_kind();
    std::string path;
    for (std::size_t i = 0; i < region.rings.size(); ++i) append_ring(path, region.rings.ring(i));
    for (std::size_t i = 0; i < region.loop_count(); ++i) {
      append_point(path, 'M', region.loop(i)[0].from);
      for (const Pixel_arc& arc : region.loop(i)) append_arc(path, arc);
      path += 'Z';
    }
    out_ += "<path";
    append_attribute(out_, "fill", svg_hex(color));
    if (!opaque_) append_attribute(out_, "fill-opacity", style_->opacity);
    append_attribute(out_, "fill-rule", odd_even ? "evenodd" : "nonzero");
    append_attribute(out_, "d", path);
    out_ += "/>\n";
  }

  void disk(const Point_2& center, double radius, Color color) override {
    begin_kind(Kind::disks);
    element_circle(center, radius, "fill", color);
  }

  void dot(const Point_2& center, Color color) override {
    begin_kind(Kind::disks);
    element_circle(center, style_->point_size / 2, "fill", color);
  }

  void circle(const Point_2& center, double radius, Color color) override {
    begin_kind(Kind::curves);
    element_circle(center, radius, "stroke", color);
  }

  void outline(std::span<const Point_2> ring, Color color) override {
    begin_kind(Kind::curves);
    if (merges()) {
      append_ring(merged_, ring);
      return;
    }
    std::string path;
    append_ring(path, ring);
    element_path(path, color);
  }

  void arc(const Pixel_arc& arc, Color color) override {
    begin_kind(Kind::curves);
    std::string path;
    std::string& target = merges() ? merged_ : path;
    append_point(target, 'M', arc.from);
    append_arc(target, arc);
    if (!merges()) element_path(path, color);
  }

  void segment(const Point_2& from, const Point_2& to, Color color) override {
    begin_kind(Kind::curves);
    std::string path;
    std::string& target = merges() ? merged_ : path;
    append_point(target, 'M', from);
    append_point(target, 'L', to);
    if (!merges()) element_path(path, color);
  }

 private:
  enum class Kind { none, odd_even_areas, winding_areas, disks, curves };

  /// Elements that overlap in one path are painted once, which only opaque ones may be.
  bool merges() const { return uniform_ && opaque_; }

  void begin_kind(Kind kind) {
    if (kind == kind_) return;
    end_kind();
    kind_ = kind;
    out_ += "<g";
    if (kind == Kind::curves) {
      append_attribute(out_, "fill", "none");
      if (uniform_) append_attribute(out_, "stroke", svg_hex(style_->color));
      if (!opaque_) append_attribute(out_, "stroke-opacity", style_->opacity);
      append_attribute(out_, "stroke-width", style_->line_width);
      append_attribute(out_, "stroke-linecap", opaque_ ? "round" : "butt");
      append_attribute(out_, "stroke-linejoin", "round");
    } else {
      if (uniform_) append_attribute(out_, "fill", svg_hex(style_->color));
      if (!opaque_) append_attribute(out_, "fill-opacity", style_->opacity);
      if (kind != Kind::disks) {
        append_attribute(out_, "fill-rule", kind == Kind::odd_even_areas ? "evenodd" : "nonzero");
        if (!uniform_ && opaque_) append_attribute(out_, "stroke-width", seam_width);
        if (!uniform_ && !opaque_) append_attribute(out_, "shape-rendering", "crispEdges");
      }
    }
    out_ += ">\n";
  }

  void end_kind() {
    if (kind_ == Kind::none) return;
    if (!merged_.empty()) {
      out_ += "<path d=\"" + merged_ + "\"/>\n";
      merged_.clear();
    }
    out_ += "</g>\n";
    kind_ = Kind::none;
  }

  void element_path(const std::string& path, Color color) {
    out_ += "<path";
    if (!uniform_) {
      const bool is_area = kind_ != Kind::curves;
      if (is_area) append_attribute(out_, "fill", svg_hex(color));
      if (!is_area || opaque_) append_attribute(out_, "stroke", svg_hex(color));
    }
    append_attribute(out_, "d", path);
    out_ += "/>\n";
  }

  void element_circle(const Point_2& center, double radius, std::string_view paint, Color color) {
    out_ += "<circle";
    append_attribute(out_, "cx", center.x);
    append_attribute(out_, "cy", center.y);
    append_attribute(out_, "r", radius);
    if (!uniform_) append_attribute(out_, paint, svg_hex(color));
    out_ += "/>\n";
  }

  static void append_ring(std::string& path, std::span<const Point_2> ring) {
    append_point(path, 'M', ring[0]);
    for (const Point_2& p : ring.subspan(1)) append_point(path, 'L', p);
    path += 'Z';
  }

  /// After its first point.
  static void append_arc(std::string& path, const Pixel_arc& arc) {
    if (arc.radius > reach) {
      for (const Bezier& curve : to_beziers(arc)) {
        append_point(path, 'C', curve.control_1);
        append_point(path, ' ', curve.control_2);
        append_point(path, ' ', curve.to);
      }
      return;
    }
    const auto append_part = [&](double sweep, const Point_2& to) {
      path += 'A';
      append_number(path, arc.radius);
      path += ' ';
      append_number(path, arc.radius);
      path += " 0 ";
      path += std::abs(sweep) > std::numbers::pi ? '1' : '0';
      path += ' ';
      path += sweep > 0 ? '1' : '0';
      append_point(path, ' ', to);
    };
    if (arc.is_whole_circle()) {
      append_part(arc.sweep / 2, {2 * arc.center.x - arc.from.x, 2 * arc.center.y - arc.from.y});
      append_part(arc.sweep / 2, arc.to);
    } else {
      append_part(arc.sweep, arc.to);
    }
  }

  std::string& out_;
  const Png_encoder& encode_png_;
  std::set<std::string> ids_;
  const Style* style_ = nullptr;
  bool uniform_ = true;
  bool opaque_ = true;
  Kind kind_ = Kind::none;
  std::string merged_;
};

}  // namespace

void write_svg(std::ostream& out, const Scene& scene, const View_2& view, int width, int height,
               const Png_encoder& encode_png) {
  std::string text = svg_head(scene, width, height);
  Svg_sink sink(text, encode_png);
  send_scene(scene, {view, static_cast<double>(width), static_cast<double>(height), reach}, sink);
  append_color_bars(text, scene, width, height);
  text += "</svg>\n";
  out << text;
}

}  // namespace mesecina

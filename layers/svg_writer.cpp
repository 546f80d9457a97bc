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
#include "layers/color_bars.h"
#include "layers/scene_shapes.h"

namespace mesecina {
namespace {

/// Beyond it single-precision viewers are visibly wrong.
constexpr double reach = 1e5;
/// As in painter_canvas.cpp: closes the hairlines between neighbouring areas of different colour.
constexpr std::string_view seam_width = "0.6";

std::string hex(Color color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t component : {color.red, color.green, color.blue}) {
    text += digits[component >> 4];
    text += digits[component & 15];
  }
  return text;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        // XML has no other control characters.
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\t' || c == '\n') result += c;
    }
  }
  return result;
}

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

void append(std::string& text, std::string_view name, double value) {
  text += ' ';
  text += name;
  text += "=\"";
  append_number(text, value);
  text += '"';
}

void append(std::string& text, std::string_view name, std::string_view value) {
  text += ' ';
  text += name;
  text += "=\"";
  text += value;
  text += '"';
}

void append_point(std::string& path, char command, const Point_2& p) {
  path += command;
  append_number(path, p.x);
  path += ' ';
  append_number(path, p.y);
}

/// A name that XML allows and that no other layer has.
std::string unique_id(std::string_view layer, std::set<std::string>& taken) {
  std::string id = "layer-";
  for (const char c : layer) {
    const bool is_allowed =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    id += is_allowed ? c : '_';
  }
  std::string result = id;
  for (int i = 2; !taken.insert(result).second; ++i) result = id + "-" + std::to_string(i);
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
    append(out_, "id", unique_id(layer.id, ids_));
    append(out_, "inkscape:groupmode", "layer");
    append(out_, "inkscape:label", escaped(layer.label.empty() ? layer.id : layer.label));
    append(out_, "clip-path", "url(#page)");
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
    append(out_, "x", place.left);
    append(out_, "y", place.top);
    append(out_, "width", place.right - place.left);
    append(out_, "height", place.bottom - place.top);
    append(out_, "preserveAspectRatio", "none");
    if (place.right - place.left >= image.width) append(out_, "style", "image-rendering:pixelated");
    if (!opaque_) append(out_, "opacity", style_->opacity);
    append(out_, "xlink:href", "data:image/png;base64," + base64(encode_png_(image)));
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
    append(out_, "fill", hex(color));
    if (!opaque_) append(out_, "fill-opacity", style_->opacity);
    append(out_, "fill-rule", odd_even ? "evenodd" : "nonzero");
    append(out_, "d", path);
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
      append(out_, "fill", "none");
      if (uniform_) append(out_, "stroke", hex(style_->color));
      if (!opaque_) append(out_, "stroke-opacity", style_->opacity);
      append(out_, "stroke-width", style_->line_width);
      append(out_, "stroke-linecap", opaque_ ? "round" : "butt");
      append(out_, "stroke-linejoin", "round");
    } else {
      if (uniform_) append(out_, "fill", hex(style_->color));
      if (!opaque_) append(out_, "fill-opacity", style_->opacity);
      if (kind != Kind::disks) {
        append(out_, "fill-rule", kind == Kind::odd_even_areas ? "evenodd" : "nonzero");
        if (!uniform_ && opaque_) append(out_, "stroke-width", seam_width);
        if (!uniform_ && !opaque_) append(out_, "shape-rendering", "crispEdges");
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
      if (is_area) append(out_, "fill", hex(color));
      if (!is_area || opaque_) append(out_, "stroke", hex(color));
    }
    append(out_, "d", path);
    out_ += "/>\n";
  }

  void element_circle(const Point_2& center, double radius, std::string_view paint, Color color) {
    out_ += "<circle";
    append(out_, "cx", center.x);
    append(out_, "cy", center.y);
    append(out_, "r", radius);
    if (!uniform_) append(out_, paint, hex(color));
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

void append_box(std::string& out, const Pixel_box& box) {
  append(out, "x", box.left);
  append(out, "y", box.top);
  append(out, "width", box.right - box.left);
  append(out, "height", box.bottom - box.top);
}

void append_text(std::string& out, const Point_2& anchor, std::string_view text, bool centered) {
  out += "<text";
  append(out, "x", anchor.x);
  append(out, "y", anchor.y);
  if (centered) append(out, "text-anchor", "middle");
  out += ">" + escaped(text) + "</text>\n";
}

void append_color_bar(std::string& out, const Color_bar& bar, const Scene& scene, std::size_t number) {
  const std::string gradient = "colour-bar-" + std::to_string(number);
  const std::string ink = hex(ink_on(scene.background));
  out += "<linearGradient";
  append(out, "id", gradient);
  out += ">\n";
  for (const Color_bar::Stop& stop : bar.stops) {
    out += "<stop";
    append(out, "offset", stop.position);
    append(out, "stop-color", hex(stop.color));
    out += "/>\n";
  }
  out += "</linearGradient>\n<rect";
  append_box(out, bar.plate);
  append(out, "rx", "3");
  append(out, "fill", hex(scene.background));
  append(out, "fill-opacity", Color_bar_look::plate_opacity);
  out += "/>\n<rect";
  append_box(out, bar.strip);
  append(out, "fill", "url(#" + gradient + ")");
  append(out, "stroke", ink);
  out += "/>\n<g";
  append(out, "font-family", std::string(Color_bar_look::font) + ", sans-serif");
  append(out, "font-size", Color_bar_look::text_size);
  append(out, "fill", ink);
  out += ">\n";
  append_text(out, bar.title_anchor, bar.title, false);
  std::string ticks;
  for (const Color_bar::Tick& tick : bar.ticks) {
    const double x = bar.strip.left + tick.position * (bar.strip.right - bar.strip.left);
    append_point(ticks, 'M', {x, bar.strip.bottom});
    append_point(ticks, 'L', {x, bar.strip.bottom + Color_bar_look::tick_length});
    append_text(out, {x, bar.tick_base}, tick.text, true);
  }
  out += "</g>\n<path";
  append(out, "stroke", ink);
  append(out, "d", ticks);
  out += "/>\n";
}

}  // namespace

void write_svg(std::ostream& out, const Scene& scene, const View_2& view, int width, int height,
               const Png_encoder& encode_png) {
  const std::string size = "width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\""
      " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" ";
  text += size + " viewBox=\"0 0 " + std::to_string(width) + " " + std::to_string(height) + "\">\n";
  text += "<defs><clipPath id=\"page\"><rect " + size + "/></clipPath></defs>\n";
  if (!scene.transparent_background) text += "<rect " + size + " fill=\"" + hex(scene.background) + "\"/>\n";
  Svg_sink sink(text, encode_png);
  send_scene(scene, {view, static_cast<double>(width), static_cast<double>(height), reach}, sink);
  const std::vector<Color_bar> bars = color_bars(scene, width, height);
  if (!bars.empty()) {
    text += "<g id=\"colour-bars\" inkscape:groupmode=\"layer\" inkscape:label=\"Colour bars\">\n";
    for (std::size_t i = 0; i < bars.size(); ++i) append_color_bar(text, bars[i], scene, i + 1);
    text += "</g>\n";
  }
  text += "</svg>\n";
  out << text;
}

}  // namespace mesecina

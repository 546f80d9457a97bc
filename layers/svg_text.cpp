// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/svg_text.h"

#include "core/formats/number.h"
#include "layers/color_bars.h"

namespace mesecina {

std::string svg_hex(Color color) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t component : {color.red, color.green, color.blue}) {
    text += digits[component >> 4];
    text += digits[component & 15];
  }
  return text;
}

std::string svg_escaped(std::string_view text) {
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

void append_attribute(std::string& text, std::string_view name, double value) {
  text += ' ';
  text += name;
  text += "=\"";
  append_number(text, value);
  text += '"';
}

void append_attribute(std::string& text, std::string_view name, std::string_view value) {
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
std::string unique_svg_id(std::string_view layer, std::set<std::string>& taken) {
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

namespace {

void append_box(std::string& out, const Pixel_box& box) {
  append_attribute(out, "x", box.left);
  append_attribute(out, "y", box.top);
  append_attribute(out, "width", box.right - box.left);
  append_attribute(out, "height", box.bottom - box.top);
}

void append_text(std::string& out, const Point_2& anchor, std::string_view text, bool centered) {
  out += "<text";
  append_attribute(out, "x", anchor.x);
  append_attribute(out, "y", anchor.y);
  if (centered) append_attribute(out, "text-anchor", "middle");
  out += ">" + svg_escaped(text) + "</text>\n";
}

void append_color_bar(std::string& out, const Color_bar& bar, const Scene& scene, std::size_t number) {
  const std::string gradient = "colour-bar-" + std::to_string(number);
  const std::string ink = svg_hex(ink_on(scene.background));
  out += "<linearGradient";
  append_attribute(out, "id", gradient);
  out += ">\n";
  for (const Color_bar::Stop& stop : bar.stops) {
    out += "<stop";
    append_attribute(out, "offset", stop.position);
    append_attribute(out, "stop-color", svg_hex(stop.color));
    out += "/>\n";
  }
  out += "</linearGradient>\n<rect";
  append_box(out, bar.plate);
  append_attribute(out, "rx", "3");
  append_attribute(out, "fill", svg_hex(scene.background));
  append_attribute(out, "fill-opacity", Color_bar_look::plate_opacity);
  out += "/>\n<rect";
  append_box(out, bar.strip);
  append_attribute(out, "fill", "url(#" + gradient + ")");
  append_attribute(out, "stroke", ink);
  out += "/>\n<g";
  append_attribute(out, "font-family", std::string(Color_bar_look::font) + ", sans-serif");
  append_attribute(out, "font-size", Color_bar_look::text_size);
  append_attribute(out, "fill", ink);
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
  append_attribute(out, "stroke", ink);
  append_attribute(out, "d", ticks);
  out += "/>\n";
}

}  // namespace

std::string svg_head(const Scene& scene, int width, int height) {
  const std::string size = "width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) + "\"";
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\""
      " xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" ";
  text += size + " viewBox=\"0 0 " + std::to_string(width) + " " + std::to_string(height) + "\">\n";
  text += "<defs><clipPath id=\"page\"><rect " + size + "/></clipPath></defs>\n";
  if (!scene.transparent_background) text += "<rect " + size + " fill=\"" + svg_hex(scene.background) + "\"/>\n";
  return text;
}

void append_color_bars(std::string& text, const Scene& scene, int width, int height) {
  const std::vector<Color_bar> bars = color_bars(scene, width, height);
  if (!bars.empty()) {
    text += "<g id=\"colour-bars\" inkscape:groupmode=\"layer\" inkscape:label=\"Colour bars\">\n";
    for (std::size_t i = 0; i < bars.size(); ++i) append_color_bar(text, bars[i], scene, i + 1);
    text += "</g>\n";
  }
}

}  // namespace mesecina

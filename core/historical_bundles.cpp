// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/historical_bundles.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/formats/number.h"

namespace mesecina {

namespace {

constexpr std::uint32_t file_token = 0xB3;
constexpr std::uint32_t bundle_token = 0xB2;
constexpr std::uint32_t planar_layer_token = 0xB1;
constexpr std::uint32_t spatial_layer_token = 0xC1;
constexpr std::uint32_t list_version = 1;
constexpr std::uint32_t layer_version = 2;
constexpr std::uint32_t null_length = 0xFFFFFFFF;

std::string hexadecimal(std::uint32_t number) {
  std::string text;
  do {
    text.insert(text.begin(), "0123456789ABCDEF"[number % 16]);
    number /= 16;
  } while (number != 0);
  return "0x" + text;
}

/// A stream within the file; `offset` is where in the file it begins.
class Stream {
 public:
  Stream(std::string_view bytes, std::size_t offset) : bytes_(bytes), offset_(offset) {}

  bool at_end() const { return next_ == bytes_.size(); }
  std::size_t position() const { return offset_ + next_; }

  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
    throw std::invalid_argument("byte " + std::to_string(position()) + ": expected " + expected + ", found " + found);
  }

  std::string_view take(std::size_t count, const char* what) {
    if (count > bytes_.size() - next_)
      refuse(std::string(what) + " of " + std::to_string(count) + " bytes",
             std::to_string(bytes_.size() - next_) + " bytes to the end");
    next_ += count;
    return bytes_.substr(next_ - count, count);
  }

  std::uint64_t number(std::size_t size, const char* what) {
    std::uint64_t number = 0;
    for (const char byte : take(size, what)) number = number << 8 | static_cast<unsigned char>(byte);
    return number;
  }

  void expect(std::uint32_t expected, const char* what) {
    Stream before = *this;
    const auto found = static_cast<std::uint32_t>(number(4, what));
    if (found != expected) before.refuse(std::string(what) + " " + hexadecimal(expected), hexadecimal(found));
  }

  /// A byte array or the bytes of a text, and where it begins.
  Stream block(const char* what) {
    const auto length = static_cast<std::uint32_t>(number(4, what));
    if (length == null_length) return {{}, position()};
    const std::size_t begin = position();
    return {take(length, what), begin};
  }

  /// A text, from UTF-16 to UTF-8.
  std::string text(const char* what) {
    Stream units = block(what);
    std::string text;
    while (!units.at_end()) {
      auto code = static_cast<std::uint32_t>(units.number(2, what));
      if (code >= 0xD800 && code < 0xDC00 && !units.at_end()) {
        const auto low = static_cast<std::uint32_t>(units.number(2, what));
        if (low >= 0xDC00 && low < 0xE000) code = 0x10000 + (code - 0xD800) * 0x400 + (low - 0xDC00);
      }
      append_utf8(text, code >= 0xD800 && code < 0xE000 ? 0xFFFD : code);
    }
    return text;
  }

 private:
  static void append_utf8(std::string& text, std::uint32_t code) {
    const auto tail = [&](unsigned shift) { text += static_cast<char>(0x80 | (code >> shift & 0x3F)); };
    if (code < 0x80) {
      text += static_cast<char>(code);
    } else if (code < 0x800) {
      text += static_cast<char>(0xC0 | code >> 6);
      tail(0);
    } else if (code < 0x10000) {
      text += static_cast<char>(0xE0 | code >> 12);
      tail(6);
      tail(0);
    } else {
      text += static_cast<char>(0xF0 | code >> 18);
      tail(12);
      tail(6);
      tail(0);
    }
  }

  std::string_view bytes_;
  std::size_t offset_;
  std::size_t next_ = 0;
};

/// What is kept of a layer's state.
struct State {
  std::optional<Color> color;  ///< absent: of a kind that cannot be shown, as are invalid ones
  double opacity = 1;
  double point_size = 0;
  double line_width = 0;
  bool is_active = false;
};

double read_size(Stream& stream, std::size_t number_size, const char* what) {
  const Stream before = stream;
  const std::uint64_t bits = stream.number(number_size, what);
  const double size = number_size == 8 ? std::bit_cast<double>(bits)
                                       : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  constexpr double greatest = 1e6;
  if (!(std::abs(size) <= greatest)) before.refuse(std::string(what) + " from 0 to 1000000", format_number(size));
  return size;
}

bool read_flag(Stream& stream, const char* what) {
  const Stream before = stream;
  const std::uint64_t byte = stream.number(1, what);
  if (byte > 1) before.refuse(std::string(what) + " (0 or 1)", std::to_string(byte));
  return byte == 1;
}

void read_color(Stream& stream, State& state) {
  constexpr std::uint64_t kind_rgb = 1;
  constexpr std::uint64_t greatest_kind = 4;
  constexpr double opaque = 65535;
  const Stream before = stream;
  const std::uint64_t kind = stream.number(1, "a kind of colour");
  if (kind > greatest_kind) before.refuse("a kind of colour from 0 to 4", std::to_string(kind));
  std::array<std::uint64_t, 5> parts{};
  for (std::uint64_t& part : parts) part = stream.number(2, "a part of a colour");
  if (kind != kind_rgb) return;
  const auto component = [](std::uint64_t part) { return static_cast<std::uint8_t>(part >> 8); };
  state.color = Color{component(parts[1]), component(parts[2]), component(parts[3])};
  state.opacity = static_cast<double>(parts[0]) / opaque;
}

/// A state whose numbers have this many bytes. Fields behind `active` may be missing from some on.
State read_state(Stream stream, std::size_t number_size, bool is_spatial) {
  State state;
  stream.expect(is_spatial ? spatial_layer_token : planar_layer_token, "the mark of a layer");
  stream.expect(layer_version, "the version of a layer");
  read_color(stream, state);
  state.point_size = read_size(stream, number_size, "a size of points");
  state.line_width = read_size(stream, number_size, "a width of lines");
  state.is_active = read_flag(stream, "whether the layer is on");
  enum class Field { text, number, flag };
  constexpr std::array planar{Field::text, Field::text, Field::flag};
  constexpr std::array spatial{Field::text, Field::number, Field::number, Field::text, Field::flag, Field::flag};
  const auto skip_rest = [&](const auto& fields) {
    for (const Field field : fields) {
      if (stream.at_end()) return;
      if (field == Field::text) stream.block("a name");
      if (field == Field::number) read_size(stream, number_size, "a number");
      if (field == Field::flag) read_flag(stream, "a switch");
    }
    if (!stream.at_end()) stream.refuse("the end of the layer", "more bytes");
  };
  if (is_spatial)
    skip_rest(spatial);
  else
    skip_rest(planar);
  return state;
}

State read_state(const Stream& stream, bool is_spatial) {
  constexpr std::size_t old_size = 4;
  constexpr std::size_t new_size = 8;
  std::string reason;
  for (const std::size_t size : {old_size, new_size}) {
    try {
      return read_state(stream, size, is_spatial);
    } catch (const std::invalid_argument& error) {
      if (reason.empty()) reason = error.what();
    }
  }
  throw std::invalid_argument(reason);
}

Bundle read_bundle(Stream stream, std::string name, const Registry& registry) {
  constexpr double greatest_size = 100;
  Bundle bundle;
  bundle.name = std::move(name);
  stream.expect(bundle_token, "the mark of a bundle");
  stream.expect(list_version, "the version of a bundle");
  while (!stream.at_end()) {
    const std::string layer_name = stream.text("a name of a layer");
    const State state = read_state(stream.block("a layer"), registry.dimension() == 3);
    if (!state.is_active) continue;
    const Layer_spec* spec = registry.find_layer(layer_of_historical_name(layer_name, registry.dimension()));
    if (!spec) {
      bundle.unknown.notes.push_back("bundle '" + bundle.name + "': there is no layer for '" + layer_name + "'");
      continue;
    }
    if (find_entry(bundle.layers, spec->id)) continue;
    Style style = spec->style;
    style.visible = true;
    if (state.color) {
      style.color = *state.color;
      style.opacity = state.opacity;
    }
    if (state.point_size > 0) style.point_size = std::min(state.point_size, greatest_size);
    if (state.line_width > 0) style.line_width = std::min(state.line_width, greatest_size);
    bundle.layers.push_back({spec->id, style});
  }
  return bundle;
}

using Name = std::pair<std::string_view, std::string_view>;

constexpr std::array planar_names = std::to_array<Name>({
    {"Points", "points"},
    {"Delaunay", "delaunay"},
    {"Voronoi", "voronoi"},
    {"Curve", "one-step-crust"},
    {"Curve normals", "curve-normals"},
    {"Voronoi disks", "voronoi-disks"},
    {"Voronoi circles", "voronoi-disks"},
    {"Interior Voronoi circles", "inner-voronoi-disks"},
    {"Interior Voronoi disks", "inner-voronoi-disks"},
    {"Interior Voronoi vertices", "inner-voronoi-vertices"},
    {"Exterior Voronoi circles", "outer-voronoi-disks"},
    {"Exterior Voronoi disks", "outer-voronoi-disks"},
    {"Exterior Voronoi vertices", "outer-voronoi-vertices"},
    {"All medial axis", "full-medial-axis"},
    {"Medial axis", "medial-axis"},
    {"Lambda medial axis", "lambda-medial-axis"},
    {"Lambda medial disks", "lambda-medial-axis-disks"},
    {"Lambda medial circles", "lambda-medial-axis-disks"},
    {"Angle medial axis", "angle-medial-axis"},
    {"Angle medial disks", "angle-medial-axis-disks"},
    {"Angle medial circles", "angle-medial-axis-disks"},
    {"Scale medial axis", "scale-medial-axis"},
    {"Scale medial disks", "scale-medial-axis-disks"},
    {"Scale medial circles", "scale-medial-axis-disks"},
    {"Polar triangulation", "polar-triangulation"},
    {"Polar power diagram", "polar-power-diagram"},
    {"Power crust", "power-crust"},
    {"Interior polar circles", "inner-polar-disks"},
    {"Interior polar disks", "inner-polar-disks"},
    {"Interior polar vertices", "inner-poles"},
    {"Exterior polar circles", "outer-polar-disks"},
    {"Exterior polar disks", "outer-polar-disks"},
    {"Exterior polar vertices", "outer-poles"},
    {"A inner disks", "balls"},
    {"A inner circles", "balls"},
    {"A inner centers", "ball-centers"},
    {"A V points", "union-vertices"},
    {"A V origin edge", "union-vertices-origin"},
    {"A V Delaunay", "union-vertices-delaunay"},
    {"A V Voronoi", "union-vertices-voronoi"},
    {"A V alpha edges", "union-alpha-edges"},
    {"A V crossing edges", "union-crossing-edges"},
    {"A V interior vertices", "union-voronoi-interior"},
    {"A V exterior vertices", "union-voronoi-exterior"},
    {"A ball triangulation", "regular-triangulation"},
    {"A power diagram", "power-diagram"},
    {"A dual singular edges", "dual-singular-edges"},
    {"A dual regular edges", "dual-regular-edges"},
    {"A dual interior edges", "dual-interior-edges"},
    {"A dual faces", "dual-faces"},
    {"A ball medial axis", "union-medial-axis"},
    {"A ball medial circles", "union-medial-disks"},
    {"A ball medial disks", "union-medial-disks"},
    {"A scale axis circles", "scale-axis-disks"},
    {"A scale axis disks", "scale-axis-disks"},
    {"M ball medial axis", "grown-medial-axis"},
    {"Moebius scaled circles", "grown-disks"},
    {"Moebius scaled disks", "grown-disks"},
    {"Image", "image"},
});

constexpr std::array spatial_names = std::to_array<Name>({
    {"Points", "points"},
    {"Delaunay edges", "delaunay"},
    {"Voronoi edges", "voronoi"},
    {"Gabriel edges", "gabriel-complex"},
    {"Gabriel faces", "gabriel-complex"},
    {"Polar triangulation", "polar-triangulation"},
    {"Interior poles", "inner-poles"},
    {"Exterior poles", "outer-poles"},
    {"Polar pairs", "polar-pairs"},
    {"Convex hull", "convex-hull"},
    {"Alpha balls", "balls"},
    {"Alpha sphere", "balls"},
    {"Dual regular faces", "dual-triangles"},
    {"Dual singular faces", "dual-singular-triangles"},
    {"Dual singular edges", "dual-singular-edges"},
    {"V points", "union-vertices"},
    {"V origin", "union-vertices-origin"},
    {"V triangulation", "union-vertices-delaunay"},
    {"V interior vertices", "union-voronoi-interior"},
    {"Medial axis", "medial-axis"},
    {"Medial axis edges", "medial-axis"},
    {"Lambda medial axis", "lambda-medial-axis"},
    {"Angle medial axis", "angle-medial-axis"},
    {"Scale medial axis", "scale-medial-axis"},
    {"Scale axis balls", "scale-axis-balls"},
    {"Implicit mesh", "union-surface"},
    {"Boundary mesh", "skin-surface"},
    {"Scale boundary mesh", "scale-axis-surface"},
    {"Input mesh", "mesh"},
    {"Input wireframe", "mesh"},
    {"Mesh balls", "balls"},
    {"Medial faces", "medial-axis"},
    {"Medial sheets", "sheets"},
    {"Angle faces", "angle-medial-axis"},
    {"Lambda faces", "lambda-medial-axis"},
    {"Dense scale axis balls", "scale-axis-balls"},
});

}  // namespace

std::string_view layer_of_historical_name(std::string_view name, int dimension) {
  const auto look_up = [name](const auto& names) -> std::string_view {
    const auto* const found = std::ranges::find(names, name, &Name::first);
    return found == names.end() ? std::string_view() : found->second;
  };
  return dimension == 3 ? look_up(spatial_names) : look_up(planar_names);
}

std::vector<Bundle> parse_historical_bundles(std::string_view bytes, const Registry& registry) {
  std::vector<Bundle> bundles;
  Stream stream(bytes, 0);
  stream.expect(file_token, "the mark of a file of bundles");
  stream.expect(list_version, "the version of a file of bundles");
  while (!stream.at_end()) {
    std::string name = stream.text("a name of a bundle");
    bundles.push_back(read_bundle(stream.block("a bundle"), std::move(name), registry));
  }
  return bundles;
}

}  // namespace mesecina

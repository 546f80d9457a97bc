// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/formats/field_scanner.h"
#include "core/formats/number.h"
#include "core/formats/ply_header.h"
#include "core/formats/polygon_collector.h"
#include "core/formats/spatial_readers.h"

namespace mesecina {
namespace {

/// Rows of text, each on a line of its own.
class Text_rows {
 public:
  Text_rows(const Text_file& file, const Ply_header& header)
      : fields_(file, Field_scanner::Comments::hash, header.size) {}

  void begin(const Ply_element& element, std::uint64_t row) {
    if (!fields_.next_line()) {
      fields_.fail(std::to_string(element.count) + " rows of " + quote(element.name), std::to_string(row),
                   "the file is cut off or its header has the wrong number");
    }
  }
  void end() {
    if (fields_.has_field()) fields_.fail("the end of the line", quote(fields_.field()));
  }
  double number(Ply_type, const std::string& name) { return fields_.number(name); }
  void skip(Ply_type, std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i)
      if (fields_.field().empty()) fields_.fail(std::to_string(count) + " numbers more", std::to_string(i));
  }
  /// How many rows of an element there can be at most.
  std::uint64_t room_for(const Ply_element& element) const { return fields_.size() / (2 * element.properties.size()); }
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const { fields_.fail(expected, found); }
  bool has_more() { return fields_.next_line(); }

 private:
  Field_scanner fields_;
};

/// Rows of bytes.
class Binary_rows {
 public:
  Binary_rows(const Text_file& file, const Ply_header& header)
      : file_(file),
        rest_(std::string_view(file.text).substr(header.size)),
        is_big_endian_(header.encoding == Ply_encoding::big_endian) {}

  void begin(const Ply_element& element, std::uint64_t row) {
    element_ = &element;
    row_ = row;
  }
  void end() const {}
  double number(Ply_type type, const std::string& name) {
    need(size_of(type), 1);
    const double value = take(type);
    if (!std::isfinite(value)) fail("a finite number for " + name, format_number(value));
    return value;
  }
  void skip(Ply_type type, std::uint64_t count) {
    need(size_of(type), count);
    rest_.remove_prefix(size_of(type) * count);
  }
  /// How many rows of an element there can be at most.
  std::uint64_t room_for(const Ply_element& element) const {
    std::size_t row_size = 0;
    for (const Ply_property& property : element.properties)
      row_size += size_of(property.count_type.value_or(property.type));
    return rest_.size() / row_size;
  }
  [[noreturn]] void fail(const std::string& expected, const std::string& found,
                         const std::string& remedy = "correct it or export the file anew") const {
    std::string message = "expected ";
    message.append(expected).append(" in row ").append(std::to_string(row_ + 1)).append(" of ");
    message.append(quote(element_->name)).append(", found ").append(found).append("; ").append(remedy);
    throw File_error(file_.path, 0, message);
  }
  bool has_more() const { return rest_.find_first_not_of(" \t\r\n") != std::string_view::npos; }

 private:
  void need(std::size_t size, std::uint64_t count) const {
    if (count <= rest_.size() / size) return;
    fail(std::to_string(count) + (count == 1 ? " number of " : " numbers of ") + std::to_string(size) + " bytes",
         std::to_string(rest_.size()) + " bytes", "the file is cut off or its header has the wrong number");
  }

  double take(Ply_type type) {
    switch (type) {
      case Ply_type::int8:
        return static_cast<std::int8_t>(take_bits<std::uint8_t>());
      case Ply_type::uint8:
        return take_bits<std::uint8_t>();
      case Ply_type::int16:
        return static_cast<std::int16_t>(take_bits<std::uint16_t>());
      case Ply_type::uint16:
        return take_bits<std::uint16_t>();
      case Ply_type::int32:
        return static_cast<std::int32_t>(take_bits<std::uint32_t>());
      case Ply_type::uint32:
        return take_bits<std::uint32_t>();
      case Ply_type::int64:
        return static_cast<double>(static_cast<std::int64_t>(take_bits<std::uint64_t>()));
      case Ply_type::uint64:
        return static_cast<double>(take_bits<std::uint64_t>());
      case Ply_type::float32:
        return std::bit_cast<float>(take_bits<std::uint32_t>());
      default:
        return std::bit_cast<double>(take_bits<std::uint64_t>());
    }
  }
  template <class Unsigned>
  Unsigned take_bits() {
    constexpr std::size_t size = sizeof(Unsigned);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t place = is_big_endian_ ? size - 1 - i : i;
      bits |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * place);
    }
    rest_.remove_prefix(size);
    return static_cast<Unsigned>(bits);
  }

  const Text_file& file_;
  std::string_view rest_;
  bool is_big_endian_;
  const Ply_element* element_ = nullptr;
  std::uint64_t row_ = 0;
};

enum class Role { none, x, y, z, radius, corners };

template <class Rows>
class Ply_reader {
 public:
  Ply_reader(const Text_file& file, const Ply_header& header) : file_(file), header_(header), rows_(file, header) {}

  File_contents read() {
    const Ply_element* vertices = find("vertex");
    const Ply_element* faces = find("face");
    if (!vertices) fail_on_header("an element 'vertex'");
    if (vertices->count > std::numeric_limits<int>::max()) fail_on_header("fewer than 2^31 vertices");
    const bool has_faces = faces && faces->count != 0;
    vertex_count_ = vertices->count;
    for (const Ply_element& element : header_.elements) read_element(element, &element == vertices, &element == faces);
    if (rows_.has_more()) warnings_.add("what follows the last element of the header is not read");
    if (has_radius_ && !has_faces) return balls();
    if (has_radius_) warnings_.add("radii of vertices are not read, as there are faces");
    return std::move(mesh_).contents(file_.path, warnings_);
  }

 private:
  const Ply_element* find(std::string_view name) const {
    const auto it = std::ranges::find(header_.elements, name, &Ply_element::name);
    return it == header_.elements.end() ? nullptr : &*it;
  }
  [[noreturn]] void fail_on_header(const std::string& expected) const {
    throw File_error(file_.path, 0, "expected " + expected + ", found a header without; export the file anew");
  }

  static Role role_of(const Ply_property& property, bool is_vertex, bool is_face) {
    const std::string& name = property.name;
    if (is_face && property.count_type && (name == "vertex_indices" || name == "vertex_index")) return Role::corners;
    if (!is_vertex || property.count_type) return Role::none;
    if (name == "x") return Role::x;
    if (name == "y") return Role::y;
    if (name == "z") return Role::z;
    return name == "radius" ? Role::radius : Role::none;
  }

  void read_element(const Ply_element& element, bool is_vertex, bool is_face) {
    std::vector<Role> roles;
    const auto has = [&](Role role) { return std::ranges::find(roles, role) != roles.end(); };
    for (const Ply_property& property : element.properties) {
      const Role role = role_of(property, is_vertex, is_face);
      roles.push_back(has(role) ? Role::none : role);
    }
    if (is_vertex && !(has(Role::x) && has(Role::y) && has(Role::z)))
      fail_on_header("the properties x, y and z of 'vertex'");
    if (is_face && element.count != 0 && !has(Role::corners))
      fail_on_header("the property 'list vertex_indices' of 'face'");
    if (is_vertex) has_radius_ = has(Role::radius);
    if (!is_vertex && !is_face && element.count != 0) {
      warnings_.add(std::to_string(element.count) + (element.count == 1 ? " row of " : " rows of ") +
                    quote(element.name) + " are not read");
    }
    if (element.properties.empty()) return;
    const std::size_t most = std::min(element.count, rows_.room_for(element));
    if (is_vertex) mesh_.reserve(most, 0);
    if (is_face) mesh_.reserve(0, most);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows_.begin(element, row);
      read_row(element, roles, is_vertex);
      rows_.end();
    }
  }

  void read_row(const Ply_element& element, const std::vector<Role>& roles, bool is_vertex) {
    Point_3 point;
    for (std::size_t i = 0; i < roles.size(); ++i) {
      const Ply_property& property = element.properties[i];
      switch (roles[i]) {
        case Role::x:
          point.x = rows_.number(property.type, property.name);
          break;
        case Role::y:
          point.y = rows_.number(property.type, property.name);
          break;
        case Role::z:
          point.z = rows_.number(property.type, property.name);
          break;
        case Role::radius:
          read_radius(property);
          break;
        case Role::corners:
          read_corners(property);
          break;
        default:
          rows_.skip(property.type, property.count_type ? count_of(property) : 1);
      }
    }
    if (is_vertex) mesh_.add_vertex(point);
  }

  std::uint64_t count_of(const Ply_property& property) {
    const double count = rows_.number(*property.count_type, "the length of a list");
    constexpr double most = 1e15;
    if (count < 0 || count > most || count != std::floor(count))
      rows_.fail("an integer of at least 0 for the length of a list", format_number(count));
    return static_cast<std::uint64_t>(count);
  }
  void read_radius(const Ply_property& property) {
    radii_.push_back(rows_.number(property.type, property.name));
    if (radii_.back() < 0) rows_.fail("a radius of at least 0", format_number(radii_.back()));
  }
  void read_corners(const Ply_property& property) {
    for (std::uint64_t left = count_of(property); left > 0; --left) {
      const double vertex = rows_.number(property.type, "a vertex number");
      if (vertex < 0 || vertex >= static_cast<double>(vertex_count_) || vertex != std::floor(vertex)) {
        rows_.fail(vertex_count_ == 0 ? "no faces, as there are no vertices,"
                                      : "a vertex number from 0 to " + std::to_string(vertex_count_ - 1),
                   format_number(vertex));
      }
      mesh_.add_corner(static_cast<int>(vertex));
    }
    mesh_.end_face();
  }

  File_contents balls() {
    std::vector<Ball_3> balls;
    balls.reserve(radii_.size());
    for (std::size_t i = 0; i < radii_.size(); ++i) balls.push_back({mesh_.vertices()[i], radii_[i]});
    File_contents contents;
    contents.inputs = contents.inputs.with(balls_input, std::move(balls));
    contents.warnings = warnings_.take();
    return contents;
  }

  const Text_file& file_;
  const Ply_header& header_;
  Rows rows_;
  Polygon_collector mesh_;
  Warning_list warnings_;
  std::uint64_t vertex_count_ = 0;
  bool has_radius_ = false;
  std::vector<double> radii_;
};

}  // namespace

File_contents read_ply(const std::filesystem::path& path) {
  const Text_file file = load_bytes(path);
  const Ply_header header = parse_ply_header(file);
  if (header.encoding == Ply_encoding::text) return Ply_reader<Text_rows>(file, header).read();
  return Ply_reader<Binary_rows>(file, header).read();
}

}  // namespace mesecina

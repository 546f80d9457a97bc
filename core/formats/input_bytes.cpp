// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/input_bytes.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "core/formats/text_file.h"

namespace mesecina {

namespace {

constexpr std::string_view first_line = "mesecina-input 1 ";
/// Reads as another number where bytes go the other way round.
constexpr std::uint32_t byte_order_mark = 0x01020304;

[[noreturn]] void refuse(const std::string& expected, const std::string& found) {
  throw std::invalid_argument("expected " + expected + ", found " + found);
}

[[noreturn]] void refuse_damage(const std::string& found) {
  refuse("an input as it was kept", found + "; it is damaged");
}

std::uint32_t checksum(std::uint32_t before, std::string_view bytes) {
  uLong sum = before;
  while (!bytes.empty()) {
    const auto part = bytes.substr(0, std::numeric_limits<uInt>::max());
    sum = crc32(sum, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(part.size()));
    bytes.remove_prefix(part.size());
  }
  return static_cast<std::uint32_t>(sum);
}

class Byte_writer {
 public:
  explicit Byte_writer(std::ostream& stream) : stream_(stream) {}

  void bytes(std::string_view bytes) {
    sum_ = checksum(sum_, bytes);
    stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  template <class T>
  void value(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes({reinterpret_cast<const char*>(&value), sizeof value});
  }
  template <class T>
  void list(const std::vector<T>& elements) {
    static_assert(std::is_trivially_copyable_v<T>);
    value(static_cast<std::uint64_t>(elements.size()));
    if (!elements.empty()) bytes({reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(T)});
  }
  std::uint32_t sum() const { return sum_; }

 private:
  std::ostream& stream_;
  std::uint32_t sum_ = 0;
};

class Byte_reader {
 public:
  explicit Byte_reader(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  void value(T& value) {
    const std::string_view bytes = take(1, sizeof value);
    std::memcpy(&value, bytes.data(), sizeof value);
  }
  template <class T>
  void list(std::vector<T>& elements) {
    std::uint64_t count = 0;
    value(count);
    const std::string_view bytes = take(count, sizeof(T));
    elements.resize(count);
    if (count > 0) std::memcpy(static_cast<void*>(elements.data()), bytes.data(), bytes.size());
  }
  bool is_at_end() const { return rest_.empty(); }

 private:
  std::string_view take(std::uint64_t count, std::size_t size) {
    if (count > rest_.size() / size) refuse_damage("the end of the file");
    const std::string_view bytes = rest_.substr(0, count * size);
    rest_.remove_prefix(bytes.size());
    return bytes;
  }
  std::string_view rest_;
};

template <class T>
void write(Byte_writer& writer, const std::vector<T>& elements) {
  writer.list(elements);
}
void write(Byte_writer& writer, const Outline_2& outline) {
  writer.value(static_cast<std::uint64_t>(outline.rings.size()));
  for (const Ring_2& ring : outline.rings) writer.list(ring);
}
void write(Byte_writer& writer, const Triangle_mesh_3& mesh) {
  writer.list(mesh.vertices);
  writer.list(mesh.triangles);
}
void write(Byte_writer& writer, const Image& image) {
  writer.value(image.width);
  writer.value(image.height);
  writer.value(image.lower_left);
  writer.value(image.pixel_size);
  writer.list(image.rgba);
}

template <class T>
void read(Byte_reader& reader, std::vector<T>& elements) {
  reader.list(elements);
}
void read(Byte_reader& reader, Outline_2& outline) {
  std::uint64_t rings = 0;
  reader.value(rings);
  for (std::uint64_t i = 0; i < rings; ++i) reader.list(outline.rings.emplace_back());
}
void read(Byte_reader& reader, Triangle_mesh_3& mesh) {
  reader.list(mesh.vertices);
  reader.list(mesh.triangles);
  const auto is_vertex = [&](int corner) {
    return corner >= 0 && static_cast<std::size_t>(corner) < mesh.vertices.size();
  };
  for (const auto& triangle : mesh.triangles)
    if (!std::ranges::all_of(triangle, is_vertex)) refuse_damage("a triangle with a corner that is no vertex");
}
void read(Byte_reader& reader, Image& image) {
  reader.value(image.width);
  reader.value(image.height);
  reader.value(image.lower_left);
  reader.value(image.pixel_size);
  reader.list(image.rgba);
  constexpr int widest = 65536;
  const bool is_good = image.width >= 0 && image.height >= 0 && image.width <= widest && image.height <= widest &&
                       image.rgba.size() == std::size_t{4} * static_cast<std::size_t>(image.width) *
                                                static_cast<std::size_t>(image.height);
  if (!is_good) refuse_damage("another number of pixels than width times height");
}

/// Calls visit(key) for one key of each type until it returns true; false where it never does.
template <class Visit>
bool visit_types(const Visit& visit) {
  return visit(points_input) || visit(disks_input) || visit(outline_input) || visit(image_input) || visit(mesh_input) ||
         visit(balls_input) || visit(cloud_input);
}

}  // namespace

void write_input_bytes(std::ostream& stream, const Inputs& inputs, std::string_view id) {
  const auto write_as = [&]<class T>(Input_key<T> key) {
    const std::shared_ptr<const T> value = inputs.get(Input_key<T>{id});
    if (!value) return false;
    stream << first_line << key.id << '\n';
    Byte_writer writer(stream);
    writer.value(byte_order_mark);
    write(writer, *value);
    writer.value(writer.sum());
    return true;
  };
  if (!visit_types(write_as))
    throw std::invalid_argument("the input '" + std::string(id) + "' is of a type that cannot be kept");
}

bool is_input_bytes(std::string_view bytes) { return bytes.starts_with(first_line.substr(0, bytes.size())); }

Inputs with_input_bytes(const Inputs& inputs, std::string_view id, std::string_view bytes) {
  const auto end = bytes.find('\n');
  if (!bytes.starts_with(first_line) || end == std::string_view::npos) refuse_damage(quote(bytes.substr(0, end)));
  const std::string_view type = bytes.substr(first_line.size(), end - first_line.size());
  std::string_view body = bytes.substr(end + 1);
  std::uint32_t mark = 0;
  std::uint32_t sum = 0;
  if (body.size() < sizeof mark + sizeof sum) refuse_damage("the end of the file");
  std::memcpy(&mark, body.data(), sizeof mark);
  if (mark != byte_order_mark)
    refuse("an input kept on a machine with the byte order of this one", "another byte order");
  std::memcpy(&sum, body.data() + body.size() - sizeof sum, sizeof sum);
  body.remove_suffix(sizeof sum);
  if (checksum(0, body) != sum) refuse_damage("another checksum");
  Byte_reader reader(body.substr(sizeof mark));
  Inputs result = inputs;
  const auto read_as = [&]<class T>(Input_key<T> key) {
    if (type != key.id) return false;
    T value;
    read(reader, value);
    if (!reader.is_at_end()) refuse_damage("more than there should be");
    result = inputs.with(Input_key<T>{id}, std::move(value));
    return true;
  };
  if (!visit_types(read_as)) refuse("an input of a known type", quote(type));
  return result;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>
#include <vector>

#include "core/point.h"

namespace mesecina {

struct Disk_2 {
  Point_2 center;
  double radius = 0;
  bool operator==(const Disk_2&) const = default;
};

/// A closed polygon; the last vertex is joined to the first, which is not repeated.
using Ring_2 = std::vector<Point_2>;

/// Any number of rings; a point is inside by the even-odd rule, so islands in holes need no nesting information.
struct Outline_2 {
  std::vector<Ring_2> rings;
  bool operator==(const Outline_2&) const = default;
};

/// A picture in the plane: pixel (column 0, row 0) is the upper left one.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  ///< width * height * 4, rows from the top, straight alpha
  Point_2 lower_left;              ///< of the whole picture
  double pixel_size = 1;           ///< in units of the plane
};

struct Ball_3 {
  Point_3 center;
  double radius = 0;
  bool operator==(const Ball_3&) const = default;
};

/// Triangles in space as they were read, without any promise: they may be badly oriented, cross each other, or leave
/// holes. Polygons were triangulated.
struct Triangle_mesh_3 {
  std::vector<Point_3> vertices;
  std::vector<std::array<int, 3>> triangles;
  bool operator==(const Triangle_mesh_3&) const = default;
};

/// Names one kind of input data; two keys with the same id must have the same T.
template <class T>
struct Input_key {
  std::string_view id;
};

inline constexpr Input_key<std::vector<Point_2>> points_input{"points"};
inline constexpr Input_key<std::vector<Disk_2>> disks_input{"disks"};
inline constexpr Input_key<Outline_2> outline_input{"outline"};
inline constexpr Input_key<Image> image_input{"image"};
inline constexpr Input_key<Triangle_mesh_3> mesh_input{"mesh"};
inline constexpr Input_key<std::vector<Ball_3>> balls_input{"balls"};
inline constexpr Input_key<std::vector<Point_3>> cloud_input{"cloud"};

/// What the user gave: an immutable value per key, shared between copies, so that a copy costs a few pointers and
/// undo can keep hundreds of them. Changing one means making another with `with`.
class Inputs {
 public:
  /// Null when nothing was given under this key.
  template <class T>
  std::shared_ptr<const T> get(Input_key<T> key) const {
    const auto it = slots_.find(key.id);
    if (it == slots_.end() || it->second.type != std::type_index(typeid(T))) return nullptr;
    return std::static_pointer_cast<const T>(it->second.value);
  }

  /// A copy with `value` under `key`; a null value removes the key.
  template <class T>
  [[nodiscard]] Inputs with(Input_key<T> key, std::shared_ptr<const T> value) const {
    Inputs result = *this;
    if (value) {
      result.slots_.insert_or_assign(std::string(key.id), Slot{std::type_index(typeid(T)), std::move(value)});
    } else if (const auto it = result.slots_.find(key.id); it != result.slots_.end()) {
      result.slots_.erase(it);
    }
    return result;
  }
  template <class T>
  [[nodiscard]] Inputs with(Input_key<T> key, T value) const {
    return with(key, std::make_shared<const T>(std::move(value)));
  }

  /// Identity of the stored value, null if absent: two Inputs hold the same data iff these are equal.
  const void* identity(std::string_view id) const {
    const auto it = slots_.find(id);
    return it == slots_.end() ? nullptr : it->second.value.get();
  }
  std::vector<std::string> ids() const {
    std::vector<std::string> result;
    for (const auto& [id, slot] : slots_) result.push_back(id);
    return result;
  }
  bool is_empty() const { return slots_.empty(); }
  bool operator==(const Inputs& other) const {
    if (slots_.size() != other.slots_.size()) return false;
    for (const auto& [id, slot] : slots_)
      if (other.identity(id) != slot.value.get()) return false;
    return true;
  }

 private:
  struct Slot {
    std::type_index type;
    std::shared_ptr<const void> value;
  };
  std::map<std::string, Slot, std::less<>> slots_;
};

/// Bounding box of all inputs, disks and balls with their radius.
Box bounding_box(const Inputs& inputs);

}  // namespace mesecina

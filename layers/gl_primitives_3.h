// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/primitives.h"
#include "layers/gl_geometry_3.h"
#include "layers/gl_look.h"
#include "layers/gl_objects.h"

namespace mesecina {

/// The tables of one Primitive_set in space, each uploaded when it is first drawn. Every function takes the set that it
/// was made for.
class Gl_primitives_3 {
 public:
  explicit Gl_primitives_3(const std::shared_ptr<const Primitive_set>& set);

  bool is_of(const std::shared_ptr<const Primitive_set>& set) const { return set_.lock() == set; }
  bool is_expired() const { return set_.expired(); }

  /// That places are relative to.
  const Point_3& origin() const { return origin_; }
  /// Of the set; computed once.
  const Box& box() const { return box_; }

  const Gl_table& places(const Primitive_set& set);
  const Gl_table& pieces(const Primitive_set& set, Part_3 part);
  const Gl_table& balls(const Primitive_set& set);
  const Gl_table& face_normals(const Primitive_set& set);
  const Gl_table& vertex_normals(const Primitive_set& set);
  /// Number and rank of each element. `name` must be of values of the set, or "" for a colour of its own each.
  const Gl_table& number_table(const Primitive_set& set, const std::string& name);
  Layer_numbers& numbers() { return numbers_; }
  /// As is_closed_3(set), computed once.
  bool is_closed(const Primitive_set& set);

  /// Since it was made.
  std::size_t uploaded_bytes() const { return uploaded_bytes_; }

 private:
  template <class Make>
  const Gl_table& made(std::optional<Gl_table>& table, const Make& make);

  std::weak_ptr<const Primitive_set> set_;
  Point_3 origin_;
  Box box_;
  std::optional<Gl_table> places_;
  std::optional<Gl_table> balls_;
  std::optional<Gl_table> face_normals_;
  std::optional<Gl_table> vertex_normals_;
  std::map<Part_3, std::optional<Gl_table>> pieces_;
  std::map<std::string, std::optional<Gl_table>, std::less<>> number_tables_;
  Layer_numbers numbers_;
  std::optional<bool> is_closed_;
  std::size_t uploaded_bytes_ = 0;
};

}  // namespace mesecina

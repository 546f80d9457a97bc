// SPDX-License-Identifier: GPL-3.0-or-later
#include "layers/gl_primitives_3.h"

#include <cmath>
#include <vector>

namespace mesecina {

Gl_primitives_3::Gl_primitives_3(const std::shared_ptr<const Primitive_set>& set)
    : set_(set), box_(set->bounding_box()) {
  const Point_3 middle = midpoint(box_.lower, box_.upper);
  if (std::isfinite(middle.x) && std::isfinite(middle.y) && std::isfinite(middle.z)) origin_ = middle;
}

template <class Make>
const Gl_table& Gl_primitives_3::made(std::optional<Gl_table>& table, const Make& make) {
  if (!table) {
    table = make();
    uploaded_bytes_ += table->bytes();
  }
  return *table;
}

const Gl_table& Gl_primitives_3::places(const Primitive_set& set) {
  return made(places_, [&] { return Gl_table::quadruples(places_3(set, origin_)); });
}

const Gl_table& Gl_primitives_3::pieces(const Primitive_set& set, Part_3 part) {
  return made(pieces_[part], [&] { return Gl_table::whole_numbers(pieces_3(set, part)); });
}

const Gl_table& Gl_primitives_3::balls(const Primitive_set& set) {
  return made(balls_, [&] { return Gl_table::quadruples(balls_3(set, origin_)); });
}

const Gl_table& Gl_primitives_3::face_normals(const Primitive_set& set) {
  return made(face_normals_, [&] { return Gl_table::quadruples(face_normals_3(set)); });
}

const Gl_table& Gl_primitives_3::vertex_normals(const Primitive_set& set) {
  return made(vertex_normals_, [&] { return Gl_table::quadruples(vertex_normals_3(set)); });
}

const Gl_table& Gl_primitives_3::number_table(const Primitive_set& set, const std::string& name) {
  return made(number_tables_[name], [&] {
    if (!name.empty()) return Gl_table::pairs(numbers_.find(set, name)->pairs());
    std::vector<float> colors;
    for (std::size_t i = 0; i < set.element_count(); ++i) colors.insert(colors.end(), {packed_color(i), 0});
    return Gl_table::pairs(colors);
  });
}

bool Gl_primitives_3::is_closed(const Primitive_set& set) {
  if (!is_closed_) is_closed_ = is_closed_3(set);
  return *is_closed_;
}

}  // namespace mesecina

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/style.h"
#include "layers/color_map.h"
#include "layers/gl_objects.h"

namespace mesecina {

/// Values of a Primitive_set as the shaders take them. Comparisons are done between ranks, so that they come out as
/// they would for the doubles.
class Element_numbers {
 public:
  explicit Element_numbers(const std::vector<double>& values);

  /// A number as the shaders know it, in float precision relative to the spread of the values.
  float shown(double value) const { return static_cast<float>((value - base_) / unit_); }
  double base() const { return base_; }
  double unit() const { return unit_; }
  /// Ranks of the smallest value that is at least, and of the greatest that is at most, the limit.
  float lowest_rank(double limit) const;
  float highest_rank(double limit) const;
  /// Number and rank of every element by turns.
  const std::vector<float>& pairs() const { return pairs_; }

 private:
  double base_ = 0;
  double unit_ = 1;
  std::vector<double> sorted_;
  std::vector<float> pairs_;
};

/// The values of one Primitive_set, each prepared when it is first asked for.
class Layer_numbers {
 public:
  /// Null when the set has no values of this name.
  const Element_numbers* find(const Primitive_set& set, const std::string& name);
  /// As value_range(layer), computed again only when it may have changed.
  const Value_range& range(const Scene_layer& layer);

 private:
  std::map<std::string, Element_numbers, std::less<>> numbers_;
  Scene_layer range_layer_;
  std::optional<Value_range> range_;
};

/// Whether the same elements of one Primitive_set are drawn in the same colours, whatever their lines and opacity.
bool has_same_colors(const Scene_layer& a, const Scene_layer& b);

struct Color_map_texture {
  Gl_texture texture;
  int texels = 0;
};

/// Each colour map is uploaded when it is first asked for.
class Color_map_textures {
 public:
  const Color_map_texture& of(const Color_map& map);
  std::size_t uploaded_bytes() const { return uploaded_bytes_; }

 private:
  std::map<std::string, Color_map_texture, std::less<>> textures_;
  std::size_t uploaded_bytes_ = 0;
};

/// As in color_map.vert.
enum class Color_rule { one_color, interpolated_map, stepped_map, classes_of_map, packed_colors };

inline constexpr float no_limit = 3.4e38F;

/// What a layer's shaders are told about colour and selection; names of values are empty where there are none.
struct Gl_look {
  Color_rule rule = Color_rule::one_color;
  std::string number;     ///< values whose number chooses the colour
  std::string threshold;  ///< values whose rank is compared with the thresholds
  std::string cut;        ///< values whose rank is compared with the cut
  std::array<float, 2> threshold_ranks{-no_limit, no_limit};
  float lowest_cut_rank = -no_limit;
  std::array<float, 2> range{0, 1};
  std::array<float, 2> class_of_number{1, 0};
  const Color_map_texture* map = nullptr;
};

/// `numbers` are those of the layer's primitives, which are not null.
Gl_look look_of(const Scene_layer& layer, Layer_numbers& numbers, Color_map_textures& maps);

/// Tells the program, which is in use, and binds the colour map to the active texture unit, which must be 0.
void set_look(Gl_program& program, const Scene_layer& layer, const Gl_look& look);

/// Components from 0 to 1.
std::array<float, 4> to_floats(const Color& color, double alpha);

/// The colour of its own of each element, as shaders take it for Color_rule::packed_colors.
float packed_color(std::size_t element);

}  // namespace mesecina

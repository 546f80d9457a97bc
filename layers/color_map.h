// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/style.h"

namespace mesecina {

/// Colours for numbers in [0,1]: a value.
class Color_map {
 public:
  enum class Kind { sequential, diverging, cyclic, categorical, historical };
  enum class Rule {
    interpolated,  ///< linear between the stops
    stepped,       ///< stop i for [i/n, (i+1)/n)
    solid,         ///< the style's own colour
    hashed         ///< a colour of its own for each element
  };
  /// Components in [0,1].
  struct Stop {
    double position = 0;
    double red = 0;
    double green = 0;
    double blue = 0;
  };

  /// Stops in ascending order from 0 to 1; none for solid and hashed.
  Color_map(std::string name, Kind kind, Rule rule, std::vector<Stop> stops);

  const std::string& name() const { return name_; }
  Kind kind() const { return kind_; }
  Rule rule() const { return rule_; }
  const std::vector<Stop>& stops() const { return stops_; }

  /// The colour at t; beyond [0,1], infinities included, that of the nearer end, and `missing` for nan.
  /// A solid map answers its only colour, a dark grey; a hashed one shows a sample of its colours. O(log stops).
  Color lookup(double t, Color missing = {128, 128, 128}) const;
  /// Of the i-th class of a stepped map, counted modulo the number of stops.
  Color category(long long i) const;

 private:
  std::string name_;
  Kind kind_;
  Rule rule_;
  std::vector<Stop> stops_;
};

/// All maps, grouped by kind, in the order a menu shows them.
const std::vector<Color_map>& color_maps();
/// Null for an unknown name.
const Color_map* find_color_map(std::string_view name);

/// A colour that depends on the element number only, the same on every machine; of medium lightness.
Color hashed_color(std::size_t element);

/// What a colour map is stretched over.
struct Value_range {
  double minimum = 0;
  double maximum = 1;
  bool whole_numbers = false;  ///< every finite value is one: stepped maps show them as classes
  bool operator==(const Value_range&) const = default;
};

/// Range of the finite values of `layer.style.value` among the elements drawn, each end replaced by the style's own
/// where that has one. [0,1] when there is no such value. O(elements).
Value_range value_range(const Scene_layer& layer);

/// Colour of one element: `style.color` when `values` is null or the map is solid or unknown, else the map's colour of
/// the element's value. +infinity has the colour of the greatest value, nan is grey.
Color color_of(const Style& style, const Values* values, const Value_range& range, std::size_t element);

/// The same for a whole layer, with all searching by name done once. The layer must outlive it.
class Layer_colors {
 public:
  explicit Layer_colors(const Scene_layer& layer);
  Color operator()(std::size_t element) const;
  /// True when every element has the style's colour.
  bool is_uniform() const { return map_ == nullptr; }
  /// True when numbers choose the colours, so that a colour bar tells something.
  bool is_by_value() const { return map_ && map_->rule() != Color_map::Rule::hashed; }
  const Values* values() const { return values_; }  ///< null iff uniform
  const Color_map* map() const { return map_; }     ///< null iff uniform
  const Value_range& range() const { return range_; }

 private:
  const Style* style_;
  const Values* values_ = nullptr;
  const Color_map* map_ = nullptr;
  Value_range range_;
};

}  // namespace mesecina

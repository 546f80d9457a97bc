// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometries/balls_2/balls_2.h"
#include "tests/geometries/oracles.h"

/// The power diagram of disks and their dual complex by definition, in exact rationals: every face by cutting with
/// every other disk.
namespace mesecina::test {

/// A disk by its squared radius, which is rational where the radius is not. A negative one is an empty disk.
struct Exact_disk {
  Rational x;
  Rational y;
  Rational weight;
};

/// The disks as they are, squared radii changed by `alpha`.
std::vector<Exact_disk> exact_disks(const Balls_2& balls, double alpha = 0);
/// Centers, radii and contacts as source text, for messages.
std::string to_text(const Balls_2& balls);

int sign(const Rational& value);
/// Sign of a + b sqrt(c) for c >= 0.
int sign_with_root(const Rational& a, const Rational& b, const Rational& c);
/// Sign of the area of the triangle of centers: 1 counterclockwise.
int orientation(const Exact_disk& a, const Exact_disk& b, const Exact_disk& c);
bool are_concentric(const Exact_disk& a, const Exact_disk& b);
bool are_equal(const Exact_disk& a, const Exact_disk& b);

/// The line of equal power distance to disks i and j: points foot + t normal, the normal being the vector from i to j
/// turned to the left.
struct Radical_line {
  Rational foot_x;
  Rational foot_y;
  Rational normal_x;
  Rational normal_y;
  Rational squared_length;  ///< of the normal
  Rational foot_power;      ///< power distance of the foot; at t it is foot_power + t^2 squared_length
};
/// The centers must differ.
Radical_line radical_line(const Exact_disk& a, const Exact_disk& b);

/// Of a line, the t with low <= t <= high.
struct Exact_interval {
  bool is_empty = false;
  std::optional<Rational> low;   ///< nullopt: unbounded
  std::optional<Rational> high;  ///< nullopt: unbounded

  bool is_point() const { return !is_empty && low && high && *low == *high; }
  bool has_length() const { return !is_empty && !is_point(); }
};

/// Power distances and faces of the power diagram. O(n) per edge, O(n^2) per cell.
class Power_oracle {
 public:
  explicit Power_oracle(std::vector<Exact_disk> disks) : disks_(std::move(disks)) {}

  const std::vector<Exact_disk>& disks() const { return disks_; }
  /// Its cell has no interior, or an equal disk has a lesser index.
  bool is_hidden(int disk) const;
  /// Points of equal and least power distance to both; the centers must differ.
  Exact_interval edge(int i, int j) const;
  /// Least power distance on a face; nullopt for an empty face.
  std::optional<Rational> minimum_on_cell(int disk) const;
  std::optional<Rational> minimum_on_edge(int i, int j) const;
  /// The centers must not be on a line.
  std::optional<Rational> minimum_on_vertex(int i, int j, int k) const;
  /// Power distance of all three at their power vertex.
  Rational orthogonal_power(int i, int j, int k) const;
  Exact_point power_vertex(int i, int j, int k) const;
  Rational power_distance(const Exact_point& point, int disk) const;

 private:
  std::vector<Exact_disk> disks_;
};

}  // namespace mesecina::test

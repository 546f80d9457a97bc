// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace mesecina {

struct Point_2 {
  double x = 0;
  double y = 0;
  bool operator==(const Point_2&) const = default;
};

struct Point_3 {
  double x = 0;
  double y = 0;
  double z = 0;
  bool operator==(const Point_3&) const = default;
};

inline double squared_distance(const Point_2& p, const Point_2& q) {
  const double dx = p.x - q.x;
  const double dy = p.y - q.y;
  return dx * dx + dy * dy;
}

inline Point_3 operator+(const Point_3& p, const Point_3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
inline Point_3 operator-(const Point_3& p, const Point_3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
inline Point_3 operator*(double factor, const Point_3& p) { return {factor * p.x, factor * p.y, factor * p.z}; }
inline double dot(const Point_3& p, const Point_3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
inline Point_3 cross(const Point_3& p, const Point_3& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
inline double squared_distance(const Point_3& p, const Point_3& q) { return dot(p - q, p - q); }
inline double distance(const Point_3& p, const Point_3& q) { return std::sqrt(squared_distance(p, q)); }
inline Point_3 midpoint(const Point_3& p, const Point_3& q) {
  return {(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2};
}

/// sqrt(x^2 + y^2) without overflow or underflow, and as fast as the formula where neither threatens.
inline double euclidean_norm(double x, double y) {
  constexpr double smallest_safe_square = 1e-280;
  constexpr double largest_safe_square = 1e280;
  const double square = x * x + y * y;
  return square > smallest_safe_square && square < largest_safe_square ? std::sqrt(square) : std::hypot(x, y);
}

inline double distance(const Point_2& p, const Point_2& q) { return euclidean_norm(p.x - q.x, p.y - q.y); }

inline Point_2 midpoint(const Point_2& p, const Point_2& q) { return {(p.x + q.x) / 2, (p.y + q.y) / 2}; }

/// Axis-parallel box; empty until something is added. Planar data has z = 0.
struct Box {
  Point_3 lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                std::numeric_limits<double>::infinity()};
  Point_3 upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                -std::numeric_limits<double>::infinity()};

  bool is_empty() const { return lower.x > upper.x; }
  void add(const Point_3& p) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
  void add(const Point_2& p) { add(Point_3{p.x, p.y, 0}); }
  void add(const Box& box) {
    if (!box.is_empty()) {
      add(box.lower);
      add(box.upper);
    }
  }
  /// Length of the diagonal; 0 when empty. "Relative to the diagonal" always means this.
  double diagonal() const {
    return is_empty() ? 0 : std::hypot(upper.x - lower.x, upper.y - lower.y, upper.z - lower.z);
  }
};

}  // namespace mesecina

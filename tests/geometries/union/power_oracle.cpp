// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/geometries/union/power_oracle.h"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>

namespace mesecina::test {

std::vector<Exact_disk> exact_disks(const Balls_2& balls, double alpha) {
  std::vector<Exact_disk> result;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (balls.is_circumscribed()) {
      const auto contacts = balls.contacts_of(static_cast<int>(i));
      const auto& samples = *balls.samples;
      const Exact_point c = exact_circumcenter(samples[contacts[0]], samples[contacts[1]], samples[contacts[2]]);
      const Rational dx = c.x - Rational(samples[contacts[0]].x);
      const Rational dy = c.y - Rational(samples[contacts[0]].y);
      result.push_back({c.x, c.y, Rational(dx * dx + dy * dy + Rational(alpha))});
    } else {
      const Rational r(balls.radii[i]);
      result.push_back({Rational(balls.centers[i].x), Rational(balls.centers[i].y), Rational(r * r + Rational(alpha))});
    }
  }
  return result;
}

std::string to_text(const Balls_2& balls) {
  std::ostringstream text;
  text << std::setprecision(std::numeric_limits<double>::max_digits10) << "{";
  for (std::size_t i = 0; i < balls.size(); ++i) {
    text << (i ? ", " : "") << "{{" << balls.centers[i].x << ", " << balls.centers[i].y << "}, " << balls.radii[i]
         << "}";
  }
  text << "}";
  if (balls.is_circumscribed()) {
    text << " samples {";
    for (const Point_2& p : *balls.samples) text << "{" << p.x << ", " << p.y << "}, ";
    text << "} contacts {";
    for (std::size_t i = 0; i < balls.size(); ++i) {
      text << "{";
      for (const int contact : balls.contacts_of(static_cast<int>(i))) text << contact << ", ";
      text << "}, ";
    }
    text << "}";
  }
  return text.str();
}

int sign(const Rational& value) { return static_cast<int>(CGAL::sign(value)); }

int sign_with_root(const Rational& a, const Rational& b, const Rational& c) {
  const int sign_a = sign(a);
  const int sign_b = sign(c) == 0 ? 0 : sign(b);
  if (sign_a == 0 || sign_b == 0 || sign_a == sign_b) return sign_a != 0 ? sign_a : sign_b;
  const Rational difference = a * a - b * b * c;
  return sign(difference) * sign_a;
}

int orientation(const Exact_disk& a, const Exact_disk& b, const Exact_disk& c) {
  return sign(Rational((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)));
}

bool are_concentric(const Exact_disk& a, const Exact_disk& b) { return a.x == b.x && a.y == b.y; }
bool are_equal(const Exact_disk& a, const Exact_disk& b) { return are_concentric(a, b) && a.weight == b.weight; }

Radical_line radical_line(const Exact_disk& a, const Exact_disk& b) {
  const Rational dx = b.x - a.x;
  const Rational dy = b.y - a.y;
  const Rational square = dx * dx + dy * dy;
  const Rational s = (square + a.weight - b.weight) / (2 * square);
  return {
      Rational(a.x + s * dx), Rational(a.y + s * dy), Rational(-dy), dx, square, Rational(s * s * square - a.weight)};
}

Rational Power_oracle::power_distance(const Exact_point& point, int disk) const {
  const Exact_disk& d = disks_[disk];
  const Rational dx = point.x - d.x;
  const Rational dy = point.y - d.y;
  return dx * dx + dy * dy - d.weight;
}

Exact_interval Power_oracle::edge(int i, int j) const {
  const Radical_line line = radical_line(disks_[i], disks_[j]);
  const Exact_point foot{line.foot_x, line.foot_y};
  Exact_interval result;
  for (int k = 0; k < static_cast<int>(disks_.size()) && !result.is_empty; ++k) {
    if (k == i || k == j) continue;
    // Power distance to k less that to i, at t: constant + slope t, must not be negative.
    const Rational constant = power_distance(foot, k) - line.foot_power;
    const Rational slope =
        -2 * ((disks_[k].x - disks_[i].x) * line.normal_x + (disks_[k].y - disks_[i].y) * line.normal_y);
    if (sign(slope) == 0) {
      if (sign(constant) < 0) result.is_empty = true;
      continue;
    }
    const Rational bound = -constant / slope;
    if (sign(slope) > 0) {
      if (!result.low || *result.low < bound) result.low = bound;
    } else {
      if (!result.high || *result.high > bound) result.high = bound;
    }
    if (result.low && result.high && *result.low > *result.high) result.is_empty = true;
  }
  return result;
}

bool Power_oracle::is_hidden(int disk) const {
  const Exact_disk& d = disks_[disk];
  const int count = static_cast<int>(disks_.size());
  bool is_alone = true;
  for (int k = 0; k < count; ++k) {
    if (k == disk) continue;
    if (!are_concentric(d, disks_[k])) {
      is_alone = false;
    } else if (disks_[k].weight > d.weight || (disks_[k].weight == d.weight && k < disk)) {
      return true;
    }
  }
  if (is_alone) return false;
  // A cell with interior is bounded by an edge of positive length beyond which it does not go: of all disks with equal
  // power distance on that edge, this one must be the outermost.
  for (int j = 0; j < count; ++j) {
    if (j == disk || are_concentric(d, disks_[j])) continue;
    const Exact_interval interval = edge(disk, j);
    if (!interval.has_length()) continue;
    Rational t = 0;
    if (interval.low && interval.high) {
      t = (*interval.low + *interval.high) / 2;
    } else if (interval.low) {
      t = *interval.low + 1;
    } else if (interval.high) {
      t = *interval.high - 1;
    }
    const Radical_line line = radical_line(d, disks_[j]);
    const Exact_point inner{Rational(line.foot_x + t * line.normal_x), Rational(line.foot_y + t * line.normal_y)};
    const Rational power = power_distance(inner, disk);
    bool is_outermost = true;
    for (int k = 0; k < count && is_outermost; ++k) {
      if (power_distance(inner, k) != power) continue;
      const Rational advance = (disks_[k].x - d.x) * (disks_[j].x - d.x) + (disks_[k].y - d.y) * (disks_[j].y - d.y);
      if (sign(advance) < 0) is_outermost = false;
    }
    if (is_outermost) return false;
  }
  return true;
}

std::optional<Rational> Power_oracle::minimum_on_edge(int i, int j) const {
  const Exact_interval interval = edge(i, j);
  if (interval.is_empty) return std::nullopt;
  Rational t = 0;
  if (interval.low && t < *interval.low) t = *interval.low;
  if (interval.high && t > *interval.high) t = *interval.high;
  const Radical_line line = radical_line(disks_[i], disks_[j]);
  return Rational(line.foot_power + t * t * line.squared_length);
}

std::optional<Rational> Power_oracle::minimum_on_cell(int disk) const {
  const Exact_disk& d = disks_[disk];
  const int count = static_cast<int>(disks_.size());
  const Exact_point center{d.x, d.y};
  bool has_center = true;
  for (int k = 0; k < count && has_center; ++k) has_center = power_distance(center, k) >= -d.weight;
  if (has_center) return Rational(-d.weight);
  std::optional<Rational> result;
  for (int k = 0; k < count; ++k) {
    if (are_concentric(d, disks_[k])) continue;
    const auto value = minimum_on_edge(disk, k);
    if (value && (!result || *value < *result)) result = value;
  }
  return result;
}

Exact_point Power_oracle::power_vertex(int i, int j, int k) const {
  const Radical_line line = radical_line(disks_[i], disks_[j]);
  const Rational constant = power_distance({line.foot_x, line.foot_y}, k) - line.foot_power;
  const Rational slope =
      -2 * ((disks_[k].x - disks_[i].x) * line.normal_x + (disks_[k].y - disks_[i].y) * line.normal_y);
  const Rational t = -constant / slope;
  return {Rational(line.foot_x + t * line.normal_x), Rational(line.foot_y + t * line.normal_y)};
}

Rational Power_oracle::orthogonal_power(int i, int j, int k) const { return power_distance(power_vertex(i, j, k), i); }

std::optional<Rational> Power_oracle::minimum_on_vertex(int i, int j, int k) const {
  const Exact_point vertex = power_vertex(i, j, k);
  const Rational power = power_distance(vertex, i);
  for (int l = 0; l < static_cast<int>(disks_.size()); ++l)
    if (power_distance(vertex, l) < power) return std::nullopt;
  return power;
}

}  // namespace mesecina::test

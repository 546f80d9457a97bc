// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cmath>

namespace mesecina {

/// A number known to about 100 bits: the sum of two doubles, and how far that may be from it. For decisions that
/// intervals of doubles cannot take and that are rarely so close that rationals must. All but the
/// bounds require that rounding is to nearest. Overflow gives an unknown number.
/// [T. Dekker: A floating-point technique for extending the available precision, 1971]
class Double_double {
 public:
  Double_double() = default;
  explicit Double_double(double value) : high_(value) {}
  /// The sum of the two, exactly.
  Double_double(double high, double low) : high_(high + low), low_(low - (high_ - high)) {}

  /// The sum of the two, known to the last digit of `low`.
  static Double_double about(double high, double low) {
    return normalized(high, low, relative_error * std::abs(high) + 0x1p-52 * std::abs(low));
  }

  friend Double_double operator+(const Double_double& a, const Double_double& b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    const double sum = a.high_ + b.high_;
    const double shifted = sum - a.high_;
    const double rest = (a.high_ - (sum - shifted)) + (b.high_ - shifted);
    return normalized(sum, rest + (a.low_ + b.low_),
                      a.error_ + b.error_ + relative_error * (std::abs(a.high_) + std::abs(b.high_)));
  }
  friend Double_double operator-(const Double_double& a) {
    Double_double result = a;
    result.high_ = -a.high_;
    result.low_ = -a.low_;
    return result;
  }
  friend Double_double operator-(const Double_double& a, const Double_double& b) { return a + (-b); }
  friend Double_double operator*(const Double_double& a, const Double_double& b) {
    if (a.is_zero() || b.is_zero()) return {};
    const double product = a.high_ * b.high_;
    const auto [a1, a2] = split(a.high_);
    const auto [b1, b2] = split(b.high_);
    const double rest = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
    const double size_a = std::abs(a.high_);
    const double size_b = std::abs(b.high_);
    return normalized(product, rest + (a.high_ * b.low_ + a.low_ * b.high_),
                      size_a * b.error_ + size_b * a.error_ + a.error_ * b.error_ + relative_error * size_a * size_b);
  }
  friend Double_double operator/(const Double_double& a, const Double_double& b) {
    const double first = a.high_ / b.high_;
    const Double_double rest = a - Double_double(first) * exact_part(b);
    const double second = rest.high_ / b.high_;
    const double size_b = std::abs(b.high_) * (1 - 1e-9) - b.error_;
    if (!(size_b > 0)) return unknown();
    return normalized(first, second,
                      (a.error_ + std::abs(first) * (1 + 1e-9) * b.error_) / size_b + relative_error * std::abs(first));
  }

  /// Of a number that is not negative; of a negative one that of 0.
  friend Double_double sqrt(const Double_double& a) {
    if (!(a.high_ > 0)) return {};
    const double root = std::sqrt(a.high_);
    const Double_double rest = exact_part(a) - Double_double(root) * Double_double(root);
    return normalized(root, rest.high_ / (2 * root), a.error_ / root + relative_error * root);
  }

  CGAL::Uncertain<CGAL::Sign> sign() const {
    if (high_ > error_ * (1 + 1e-9)) return CGAL::POSITIVE;
    if (-high_ > error_ * (1 + 1e-9)) return CGAL::NEGATIVE;
    if (is_zero()) return CGAL::ZERO;
    return CGAL::Uncertain<CGAL::Sign>::indeterminate();
  }
  /// The number, rounded, and what rounding took from it.
  double high() const { return high_; }
  double low() const { return low_; }
  /// True when the error is at most this part of the number.
  bool is_known_to(double part) const { return error_ <= part * std::abs(high_); }
  /// Bounds of what `high` lacks. Require that rounding is upwards.
  double low_upper_bound() const { return low_ + error_; }
  double low_lower_bound() const { return -(-low_ + error_); }
  bool is_known() const { return std::isfinite(high_) && std::isfinite(error_); }

 private:
  bool is_zero() const { return high_ == 0 && error_ == 0; }
  /// Far above what the operations lose, so that errors in computing errors are covered as well.
  static constexpr double relative_error = 0x1p-98;
  /// Above what is lost where products are too small for doubles.
  static constexpr double absolute_error = 1e-290;

  struct Halves {
    double first;
    double second;
  };
  static Halves split(double value) {
    const double scaled = 134217729.0 * value;  // 2^27 + 1
    const double first = scaled - (scaled - value);
    return {first, value - first};
  }
  static Double_double normalized(double high, double low, double error) {
    Double_double result;
    result.high_ = high + low;
    result.low_ = low - (result.high_ - high);
    result.error_ = error * (1 + 1e-9) + absolute_error;
    if (!std::isfinite(result.high_) || !std::isfinite(result.low_) || !std::isfinite(result.error_)) return unknown();
    return result;
  }
  static Double_double unknown() {
    Double_double result;
    result.error_ = HUGE_VAL;
    return result;
  }
  static Double_double exact_part(const Double_double& a) {
    Double_double result = a;
    result.error_ = 0;
    return result;
  }

  double high_ = 0;
  double low_ = 0;
  double error_ = 0;
};

}  // namespace mesecina

// SPDX-License-Identifier: MIT
// A proved interval about y for a given x, in double or in pairs of doubles. The proof is docs/proofs/easing.md.
//
// x(t) and y(t) in Bernstein form; the signs of x(t) - x at two t, certain beyond the error bound, enclose the root,
// because x(t) does not fall; between them y(t) moves by at most their distance times the largest |y'|.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/easing/easing.hpp"
#include "core/error_free.hpp"

namespace bezierbench {

/// y is within `error` of high + low, |low| <= u |high|.
struct EasingEnclosure {
  double t;
  double high;
  double low;
  double error;
};

/// Arithmetic in double: operations have the relative error `unit`.
struct DoubleArithmetic {
  using Number = double;
  static constexpr double unit = 0x1p-53;
  static Number from(double a) { return a; }
  static Number sum(Number a, Number b) { return a + b; }
  static Number product(Number a, Number b) { return a * b; }
  static Number triple(double a) { return 3 * a; }
  static double high(Number a) { return a; }
  static double low(Number /*a*/) { return 0; }
};

/// Arithmetic in pairs of doubles: operations have a relative error of at most 5 u^2 ([Joldes et al. 2017], algorithms
/// 6 and 12, 3 u^2 + 13 u^3 and 4 u^2).
struct PairArithmetic {
  using Number = Expansion2<double>;
  static constexpr double unit = 5 * 0x1p-106;
  static Number from(double a) { return {a, 0}; }
  static Number sum(const Number& a, const Number& b) {
    const auto s = two_sum(a.value, b.value);
    const auto t = two_sum(a.error, b.error);
    const auto v = fast_two_sum(s.value, s.error + t.value);
    return fast_two_sum(v.value, v.error + t.error);
  }
  static Number product(const Number& a, const Number& b) {
    const auto c = two_prod(a.value, b.value);
    const double lost = std::fma(a.error, b.value, std::fma(a.value, b.error, a.error * b.error));
    return fast_two_sum(c.value, c.error + lost);
  }
  static Number triple(double a) { return two_prod(3.0, a); }
  static double high(const Number& a) { return a.value; }
  static double low(const Number& a) { return a.error; }
};

template <class Arithmetic>
class EasingEncloser {
  using Number = typename Arithmetic::Number;

 public:
  explicit EasingEncloser(const EasingCurve<double>& curve)
      : curve_(curve),
        triples_{Arithmetic::triple(curve.x1), Arithmetic::triple(curve.y1), Arithmetic::triple(curve.x2),
                 Arithmetic::triple(curve.y2)} {}

  /// x in [2^-300, 1), |y1| and |y2| at most 2^900, and a guess of t. Nothing where the signs are not certain.
  [[nodiscard]] std::optional<EasingEnclosure> at(double x, double guess) const {
    constexpr double u = Arithmetic::unit;
    if (!(guess > 0 && guess < 1)) return std::nullopt;
    Number t = Arithmetic::from(guess);
    const double x_error = operations * u * x;
    double slope = 0;
    double residual = 0;
    for (int step = 0;; ++step) {
      const double high = Arithmetic::high(t);
      slope = bernstein_cubic_slope(curve_.x1, curve_.x2, high);
      residual = residual_at(t, x);
      if (!(slope > 0)) return std::nullopt;
      if (step == most_corrections || std::abs(residual) <= x_error) break;
      t = Arithmetic::sum(t, Arithmetic::from(-residual / slope));
    }
    const double at = Arithmetic::high(t);
    if (!(at > 0 && at < 1)) return std::nullopt;
    double width = 2 * (std::abs(residual) + 2 * x_error) / slope + 8 * u * at;
    for (int attempt = 0; !encloses(t, width, x); ++attempt, width *= 16)
      if (attempt == 2) return std::nullopt;
    return around(t, width);
  }

 private:
  static constexpr int most_corrections = 6;
  /// Roundings of a sum of x(t) or y(t), with room for those of the bound itself.
  static constexpr double operations = 8.5;

  struct Terms {
    Number first, second, cube;
  };
  [[nodiscard]] static Terms terms(const Number& t, const Number& triple1, const Number& triple2) {
    const Number minus_t = Arithmetic::product(t, Arithmetic::from(-1));
    const Number s = Arithmetic::sum(Arithmetic::from(1), minus_t);
    const Number square = Arithmetic::product(t, t);
    return {Arithmetic::product(Arithmetic::product(Arithmetic::product(s, s), t), triple1),
            Arithmetic::product(Arithmetic::product(s, square), triple2), Arithmetic::product(square, t)};
  }
  [[nodiscard]] static Number sum(const Terms& terms) {
    return Arithmetic::sum(Arithmetic::sum(terms.first, terms.second), terms.cube);
  }

  /// x(t) - x with the relative error of one operation beside the error of x(t).
  [[nodiscard]] double residual_at(const Number& t, double x) const {
    const Number value = sum(terms(t, triples_.x1, triples_.x2));
    return Arithmetic::high(Arithmetic::sum(value, Arithmetic::from(-x)));
  }

  /// Whether the root is between t - width and t + width.
  [[nodiscard]] bool encloses(const Number& t, double width, double x) const {
    const Number low = Arithmetic::sum(t, Arithmetic::from(-width));
    const Number high = Arithmetic::sum(t, Arithmetic::from(width));
    const double certain = 1.25 * operations * Arithmetic::unit * x;
    const bool is_after = Arithmetic::high(low) <= 0 || residual_at(low, x) < -certain;
    return is_after && (Arithmetic::high(high) >= 1 || residual_at(high, x) > certain);
  }

  [[nodiscard]] EasingEnclosure around(const Number& t, double width) const {
    constexpr double u = Arithmetic::unit;
    const auto y = terms(t, triples_.y1, triples_.y2);
    const Number value = sum(y);
    const double at = Arithmetic::high(t);
    const double last = std::min(at + width, 1.0) * (1 + 0x1p-50);
    const double magnitude = std::abs(Arithmetic::high(y.first)) + std::abs(Arithmetic::high(y.second)) + at * at * at;
    const double slope =
        3 * (std::abs(curve_.y1) + last * (2 * std::abs(curve_.y2 - curve_.y1) + last * std::abs(1 - curve_.y2)));
    const double error = operations * u * magnitude + 1.02 * (width + 2 * u * at) * slope;
    return {at, Arithmetic::high(value), Arithmetic::low(value), error};
  }

  EasingCurve<double> curve_;
  struct {
    Number x1, y1, x2, y2;
  } triples_;
};

// On which side of a number an easing curve is, by exact integers.

/// The sign of y(t*) - (a + b) / 2, where t* in (0, 1) solves x(t*) = x; 0 where they are equal. x is in (0, 1), x1
/// and x2 in [0, 1], all numbers are finite. Takes microseconds; up to milliseconds where the exponents are hundreds
/// apart.
///
/// P = x(t) - x has one root in (0, 1), of any multiplicity, and none at 0 and 1. The sign is therefore the Tarski
/// query of Q = y(t) - (a + b) / 2 for P: in the signed remainder sequence of P and P' Q, the number of changes of sign
/// at 0 less that at 1. Source: [Basu et al. 2006], theorem 2.61.
int exact_easing_sign(const EasingCurve<double>& curve, double x, double a, double b);

}  // namespace bezierbench

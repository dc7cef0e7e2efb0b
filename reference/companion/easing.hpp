// SPDX-License-Identifier: MIT
// The true y of an easing curve at x: numbers are dyadic, so x(t) - x and y(t) have integer coefficients over a power
// of two. The root in [0, 1] is enclosed with integers, and y narrowed until every question is decided. Beyond the ends
// y is on the line that continues the curve.
#pragma once

#include <optional>

#include "reference/companion/integer_polynomial.hpp"
#include "reference/rational.hpp"

namespace bezierbench::reference {

/// y at one x of the curve (0,0) (x1,y1) (x2,y2) (1,1), with x1 and x2 in [0, 1] and y1, y2 finite. Source for x
/// outside [0, 1]: [CSS Easing 2023], section 2.3, with csswg-drafts#4046.
class ExactEased {
 public:
  /// Throws std::domain_error for a number that is not finite.
  ExactEased(double x1, double y1, double x2, double y2, double x);

  /// The number of the format nearest to y, ties to even.
  [[nodiscard]] double nearest(const Format& format);
  /// |value - y|, rounded to 24 bits once.
  [[nodiscard]] double error(double value);
  /// |value - y| over the distance of numbers of the format at y.
  [[nodiscard]] double error_ulp(double value, const Format& format);
  /// t, as a number nearest to the root; the nearer end for x outside [0, 1].
  [[nodiscard]] double t() const;

 private:
  /// Whether y is `value`: then x(t) - x and y(t) - value have a common root in [0, 1].
  [[nodiscard]] bool is(const Rational& value) const;
  void set(const Rational& value);
  void narrow();
  void enclose();

  IntegerPolynomial x_;       ///< x(t) - x
  IntegerPolynomial simple_;  ///< the same with every root once
  IntegerPolynomial y_;       ///< y(t), times 2^-exponent_
  long exponent_ = 0;
  mpz_class steepest_;  ///< no |y'| is larger, times 2^-exponent_
  RootInterval root_;
  Rational low_, high_;
  bool is_exact_ = false;  ///< y is low_; else it is between both, and no double
};

// A proved interval about y of an easing curve at one float x after another, in double or else in long double: for runs
// over every float.
//
// With v the unit roundoff of either type, x(t) = t (3 s (s x1 + t x2) + t^2), s = 1-t, has no cancelling terms and at
// most 8 roundings on a path, so its relative error is below 9 v; y(t) likewise has an error below 9 v times the same
// sum of magnitudes. No product of floats and t underflows. Where x(t) - x is negative beyond this error at t - w, and
// positive at t + w, the root is between, since x(t) does not fall, and y is within
// 3 w (|y1| + t_high (2 |y2 - y1| + t_high |1 - y2|)) of y(t), a bound of |y'| times w.

class FloatEasing {
 public:
  /// Floats: x1 and x2 in [0, 1], y1 and y2 finite.
  FloatEasing(float x1, float y1, float x2, float y2);

  struct Interval {
    double low, high;

    /// Whether every number of it has the same nearest float, the same binade, and 46 bits in common.
    [[nodiscard]] bool decides() const;
  };
  /// y at x in (0, 1) is between both: from double arithmetic where that decides. Nothing where the signs are not
  /// certain: there ExactEased decides. The last roots are where the search begins.
  [[nodiscard]] std::optional<Interval> at(float x);

 private:
  template <class Number>
  struct Curve {
    Number x1, y1, x2, y2;
  };
  template <class Number>
  [[nodiscard]] std::optional<Interval> at(const Curve<Number>& curve, Number x, int most_steps);

  Curve<double> in_double_;
  Curve<long double> in_long_double_;
  double t_ = 0.5;
  double t_before_ = 0.5;  ///< that of the x before
};

}  // namespace bezierbench::reference

// SPDX-License-Identifier: MIT
// The true y of an easing curve at x: numbers are dyadic, so x(t) - x and y(t) have integer coefficients over a power
// of two. The root in [0, 1] is enclosed with integers, and y narrowed until every question is decided. Beyond the ends
// y is on the line that continues the curve.
#pragma once

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

}  // namespace bezierbench::reference

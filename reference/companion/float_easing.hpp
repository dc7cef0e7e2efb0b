// SPDX-License-Identifier: MIT
// A proved interval about y of an easing curve at one float x after another, in double or else in long double: for runs
// over every float.
//
// With v the unit roundoff of either type, x(t) = t (3 s (s x1 + t x2) + t^2), s = 1-t, has no cancelling terms and at
// most 8 roundings on a path, so its relative error is below 9 v; y(t) likewise has an error below 9 v times the same
// sum of magnitudes. No product of floats and t underflows. Where x(t) - x is negative beyond this error at t - w, and
// positive at t + w, the root is between, since x(t) does not fall, and y is within
// 3 w (|y1| + t_high (2 |y2 - y1| + t_high |1 - y2|)) of y(t), a bound of |y'| times w.
#pragma once

#include <optional>

namespace bezierbench::reference {

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

// SPDX-License-Identifier: MIT
// A proved interval about y of an easing curve at one float x after another, in long double: for runs over every float.
//
// With unit roundoff v = 2^-64, x(t) = t (3 s (s x1 + t x2) + t^2), s = 1-t, has no cancelling terms and at most 8
// roundings on a path, so its relative error is below 9 v; y(t) likewise has an error below 9 v times the same sum of
// magnitudes. Where x(t) - x is negative beyond this error at t - w, and positive at t + w, the root is between, since
// x(t) does not fall, and y is within 3 w (|y1| + t_high (2 |y2 - y1| + t_high |1 - y2|)) of y(t), a bound of |y'|
// times w.
#pragma once

#include <optional>

namespace bezierbench::reference {

class FloatEasing {
 public:
  /// Floats: x1 and x2 in [0, 1], y1 and y2 finite.
  FloatEasing(float x1, float y1, float x2, float y2);

  struct Interval {
    long double low, high;
  };
  /// y at x in (0, 1) is between both. Nothing where the signs are not certain: there ExactEased decides. The last
  /// root is where the search begins.
  [[nodiscard]] std::optional<Interval> at(float x);

 private:
  [[nodiscard]] long double residual(long double t, long double x) const;

  long double x1_, y1_, x2_, y2_;
  long double t_ = 0.5L;
};

}  // namespace bezierbench::reference

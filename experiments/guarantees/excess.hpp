// SPDX-License-Identifier: MIT
// By how much an input breaks a property, or how far it is from that.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/evaluate/guarantee.hpp"
#include "core/evaluate/kernel/prepared_state.hpp"
#include "core/powers.hpp"

namespace bezierbench::guarantees {

// A method as the statements see it: points of curves, from the kernel that is timed.

inline constexpr int most_axes = 3;

/// Coordinates of a point; those past the dimension are 0.
template <class Scalar>
using Values = std::array<Scalar, most_axes>;

template <class Scalar>
class Evaluation {
 public:
  explicit Evaluation(const Kernel<Scalar>& kernel) : kernel_(kernel) {}

  /// The points at all `t` of the curve with these control points, which is prepared once.
  template <std::size_t Count>
  std::array<Values<Scalar>, Count> points(const std::vector<Scalar>& coefficients,
                                           const std::array<Scalar, Count>& t) {
    const int degree = static_cast<int>(coefficients.size()) / kernel_.dimension - 1;
    std::array<Scalar, Count * most_axes> flat;
    PreparedState<Scalar>(kernel_, {Form::bernstein, kernel_.dimension, degree, coefficients}).evaluate(t, flat.data());
    std::array<Values<Scalar>, Count> points{};
    const auto d = static_cast<std::size_t>(kernel_.dimension);
    for (std::size_t k = 0; k < Count; ++k)
      for (std::size_t axis = 0; axis < d; ++axis) points[k][axis] = flat[k * d + axis];
    return points;
  }
  Values<Scalar> point(const std::vector<Scalar>& coefficients, Scalar t) {
    return points(coefficients, std::array{t})[0];
  }

 private:
  const Kernel<Scalar>& kernel_;
};

/// Above 0 where the input breaks the property; else minus a distance from that. Empty where the statement is not about
/// the input. Values that are infinite or NaN count against `finite` and `total` alone: no other statement is about them.
using Excess = std::optional<double>;

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// The spacing of the numbers of the type at x.
template <class Scalar>
double ulp(Scalar x) {
  using Limits = std::numeric_limits<Scalar>;
  const int exponent = x == 0 ? Limits::min_exponent : binary_exponent(x);
  return std::ldexp(1.0, std::max(exponent, Limits::min_exponent) - Limits::digits);
}

/// (a - b) in ulp of the larger of both; 0 only where they are equal. Both are finite.
template <class Scalar>
double ulps_above(Scalar a, Scalar b) {
  const double unit = ulp(std::max(std::abs(a), std::abs(b)));
  if (unit < 1) return (static_cast<double>(a) - static_cast<double>(b)) / unit;
  return (static_cast<double>(a) / 2 - static_cast<double>(b) / 2) / unit * 2;  // the difference itself may be infinite
}

/// True where all coordinates of a point are finite; those past the dimension are 0.
template <class Scalar>
bool all_finite(const Values<Scalar>& point) {
  return std::ranges::all_of(point, [](Scalar value) { return std::isfinite(value); });
}

/// The largest difference of a coordinate, in ulp; empty where one is not finite.
template <class Scalar>
Excess difference(const Values<Scalar>& a, const Values<Scalar>& b) {
  if (!all_finite(a) || !all_finite(b)) return std::nullopt;
  double largest = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis)
    largest = std::max(largest, std::abs(ulps_above(a[axis], b[axis])));
  return largest;
}

}  // namespace bezierbench::guarantees

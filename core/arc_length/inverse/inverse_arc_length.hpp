// SPDX-License-Identifier: MIT
// The concept of a method for inverse arc length: `info`, and one function from a length to a parameter.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

#include "core/arc_length/arc_length.hpp"
#include "core/arc_length/gauss_legendre_adaptive.hpp"
#include "core/arc_length/inverse/kernel.hpp"
#include "core/arc_length/part.hpp"
#include "core/arc_length/rational_hodograph.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

/// Let s(t) be the integral of |h| over [0, t], h the hodograph of a curve. A method returns t in [0, 1] such that the
/// error |s(t) - target| is at most tolerance s(1). Its hodograph is not 0 and is scaled as for ArcLengthMethod.
/// `target` is finite. A target below 0 gives t = 0, and one above s(1), as a rounded s(1) may be, gives t = 1. The
/// tolerance applies to the length, not to t: where the speed is 0, the error of the length does not bound that of t.
template <class M>
concept InverseArcLengthMethod = requires(const HodographOf<M::info.form, 2>& hodograph, double target,
                                          double tolerance) {
  requires M::info.problem == Problem::inverse_arc_length;
  { M::solve(hodograph, target, tolerance) } -> std::same_as<InverseArcLength>;
};

// Lengths of parts of one curve with their errors, as accurate as a search for a length needs.

/// The smallest useful relative tolerance. Below it, roundings dominate the error and more speeds do not reduce it.
inline constexpr double finest_tolerance = 0x1p-46;

/// A size of parts, no smaller than their mean speed, by which the useless tolerances are known.
template <int Dimension>
double size_of_part(const Curve<Form::bernstein, double, Dimension>& part) {
  return polygon_length(part);
}
template <int Dimension>
double size_of_part(const RationalHodograph<Dimension>& part) {
  return sensitivity(part);
}

/// Measures parts by adaptive Gauss-Legendre rules and counts the speeds.
template <class Hodograph>
class PartLength {
 public:
  /// `tolerance` is relative to the length of the whole curve; a smaller one than finest_tolerance counts as that.
  PartLength(const Hodograph& hodograph, double tolerance)
      : hodograph_(hodograph),
        whole_(GaussLegendreAdaptive::measure(hodograph, std::max(tolerance, finest_tolerance) / 8)),
        share_(std::max(tolerance, finest_tolerance) / 8 * whole_.length),
        evaluations_(whole_.evaluations) {}

  [[nodiscard]] const ArcLength& whole() const { return whole_; }

  /// The length of the part between a and b, negative where b < a, and its error. The quadrature contributes at most an
  /// eighth of the tolerance times |b - a|, unless it reports more; the roundings of cutting the curve are added. Only
  /// parts that begin at 0 may leave [0, 1].
  ArcLength operator()(double a, double b) {
    if (b < a && a > 0) {
      auto backwards = (*this)(b, a);
      backwards.length = -backwards.length;
      return backwards;
    }
    const double width = b - a;
    if (width == 0) return {.length = 0, .error_estimate = 0};
    auto part = hodograph_;
    restrict_to(part, a, b);
    auto result =
        GaussLegendreAdaptive::measure_within(part, std::max(share_, finest_tolerance / 8 * size_of_part(part)));
    evaluations_ += result.evaluations;
    result.length *= width;
    // The products with the width and with u may underflow, those of the length and of the two errors.
    constexpr double underflow = 3 * std::numeric_limits<double>::denorm_min();
    result.error_estimate =
        result.error_estimate * std::abs(width) + rounding_of_part(hodograph_, part, a, b) + underflow;
    return result;
  }

  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

 private:
  Hodograph hodograph_;
  ArcLength whole_;
  double share_;
  std::int64_t evaluations_;
};

}  // namespace bezierbench

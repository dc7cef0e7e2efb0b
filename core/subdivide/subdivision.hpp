// SPDX-License-Identifier: MIT
// The concept of a method for subdivision: `info`, and one function from a curve and t to the control points of the
// curve over [0, t] and over [t, 1].
#pragma once

#include <concepts>
#include <limits>
#include <string_view>

#include "core/bound/error_bound.hpp"
#include "core/curve.hpp"
#include "core/method.hpp"

namespace bezierbench {

// A proved error bound of the control points of a split curve as data, like ErrorBound of a point.
//
// A new control point that took k levels, k = i for point i of the left half and n - i for point i of the right one, is
// a sum over k + 1 consecutive given control points c_j:
//   left_i = sum_(j=0..i) c_j B_j,i(t)        right_i = sum_(j=i..n) c_j B_(j-i),(n-i)(t)
// Its p~ is that sum with |c_j|. Errors of schemes that only combine with positive weights are bounded by p~, those of
// the others by max |c_j| of these control points.

/// The amplification in the bound of a control point.
enum class SplitAmplification {
  p_tilde,  ///< sum |c_j| B_j(t)
  largest   ///< max |c_j|
};

/// The bound of a control point of k levels with the amplification A. On each axis, for 0 <= t <= 1,
///   |computed - true| <= factor(k, u) u A + underflow(k) eta S,
/// where eta is the smallest subnormal. S is 1 or, where powers of t are rounded apart from the coefficients,
/// 1 + max |c_j|. The bound is infinite where none is proved, so also where growth max |c_j| leaves the range: no
/// result on the way is larger. For a rational curve it applies to the homogeneous coordinates (w_i b_i, w_i).
struct SplitBound {
  std::string_view text;  ///< for people
  SplitAmplification amplification;
  double (*factor)(int levels, double u);
  double (*underflow)(int levels);
  bool underflow_scales_with_coefficients = false;
  double growth = 1;
};

/// The sizes in the bound of one control point of a half: on one axis or, with Euclidean norms as magnitudes, on all
/// axes at once. For all axes only eta has to be multiplied by their number, since the terms with eta are per axis.
struct SplitScale {
  int levels;      ///< i in the left half, n - i in the right one
  double p_tilde;  ///< sum |c_j| B_j(t)
  double largest;  ///< max |c_j| of the same j
};

/// The unit roundoff and the smallest subnormal of a scalar type.
struct SplitArithmetic {
  double u;
  double eta;
};

namespace detail {

inline double split_underflow(const SplitBound& bound, const SplitScale& scale, const SplitArithmetic& arithmetic) {
  return arithmetic.eta * bound.underflow(scale.levels) *
         (bound.underflow_scales_with_coefficients ? 1 + scale.largest : 1);
}

inline bool split_stays_in_range(const SplitBound& bound, const SplitScale& scale, double u) {
  return bezierbench::stays_in_range(bound.growth * scale.largest, scale.levels, u);
}

inline double amplification(const SplitBound& bound, const SplitScale& scale) {
  return bound.amplification == SplitAmplification::p_tilde ? scale.p_tilde : scale.largest;
}

}  // namespace detail

/// The bound of the absolute error of a coordinate of a polynomial curve, or of a weight of a rational one.
inline double split_bound(const SplitBound& bound, const SplitScale& scale, const SplitArithmetic& arithmetic) {
  if (!detail::split_stays_in_range(bound, scale, arithmetic.u)) return std::numeric_limits<double>::infinity();
  return arithmetic.u * bound.factor(scale.levels, arithmetic.u) * detail::amplification(bound, scale) +
         detail::split_underflow(bound, scale, arithmetic);
}

/// The bound of the absolute error of a coordinate of a rational curve with weights >= 0. The coordinate is N / W,
/// which the method computes from w_j and the rounded w_j b_j. `point` has p~ = sum w_j |b_j| B_j(t) / W and
/// max |w_j b_j|; `weight` has W > 0 and max w_j.
///
/// With phi = factor u, A_N and A_W the amplifications of both, e_N and e_W what they lose to underflow, and less than
/// eta lost in each product w_j b_j, the denominator and the numerator are off by at most w W and v W with
///   w = (phi A_W + e_W) / W      v = ((phi (1 + u) + u) A_N + (1 + phi) eta + e_N) / W
/// and the quotient, which rounds once, by at most (1 + u) (v + p~ w) / (1 - w) + u p~ + eta / 2. Up to five roundings
/// of the computed bound itself may underflow, so 3 eta are added.
inline double split_quotient_bound(const SplitBound& bound, const SplitScale& point, const SplitScale& weight,
                                   const SplitArithmetic& arithmetic) {
  const auto [u, eta] = arithmetic;
  if (!detail::split_stays_in_range(bound, point, u) || !detail::split_stays_in_range(bound, weight, u) ||
      !stays_in_range(2 * point.p_tilde, point.levels, u))
    return std::numeric_limits<double>::infinity();
  const double phi = u * bound.factor(point.levels, u);
  const double sum = weight.p_tilde;
  const bool by_p_tilde = bound.amplification == SplitAmplification::p_tilde;
  const double point_size = by_p_tilde ? point.p_tilde : point.largest / sum;  // over W
  const double weight_size = by_p_tilde ? 1 : weight.largest / sum;
  const double w = phi * weight_size + detail::split_underflow(bound, weight, arithmetic) / sum;
  if (!(w < 1)) return std::numeric_limits<double>::infinity();
  const double v =
      (phi * (1 + u) + u) * point_size + ((1 + phi) * eta + detail::split_underflow(bound, point, arithmetic)) / sum;
  return (1 + u) * (v + point.p_tilde * w) / (1 - w) + u * point.p_tilde + 3 * eta;
}

/// Both parts of a curve, in its form, degree and direction, each over parameters from 0 to 1.
template <class C>
struct Halves {
  C left;   ///< over [0, t]; its last control point is the junction
  C right;  ///< over [t, 1]; its first control point is the junction
};

/// Properties of the values of the halves, among which -0 equals 0. A promised property holds for every curve and every
/// t in [0, 1] while nothing overflows. For a property that a method does not promise, the tests have a curve without
/// it.
struct SplitPromises {
  bool keeps_ends;            ///< the first control point of left is b_0 and the last of right b_n
  bool shares_junction;       ///< the last control point of left is the first of right
  bool exact_at_zero;         ///< at t = 0 right is the curve, and each control point of left b_0
  bool exact_at_one;          ///< at t = 1 left is the curve, and each control point of right b_n
  bool reproduces_constants;  ///< where all b_i are equal, so are all control points of the halves
  bool mirrors;               ///< the reversed curve, split at 1 - t where that is exact, has the reversed halves
};

/// `split(curve, t)` returns the halves, for finite t. It is pure, and neither allocates, prints nor throws. A method
/// with proved bounds has a `SplitBound bound`.
template <class M>
concept SplitMethod = requires(const Curve<M::info.form, double, 2>& curve, double t) {
  requires M::info.problem == Problem::subdivision;
  { M::promises } -> std::convertible_to<SplitPromises>;
  { M::split(curve, t) } -> std::same_as<Halves<Curve<M::info.form, double, 2>>>;
};

// The triangle of de Casteljau with both its sides kept: b_i^k = step(b_i^(k-1), b_(i+1)^(k-1)), left_k = b_0^k and
// right_(n-k) = b_(n-k)^k. Its variants share this loop and differ only in the step.

/// Splits into both halves; `step(a, b)` combines two neighbours on one axis.
template <class Scalar, int Dimension, int Degree, class Step>
Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> split_by_triangle(
    const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve, Step step) {
  const int n = curve.degree();
  Halves<Curve<Form::bernstein, Scalar, Dimension, Degree>> halves{curve, curve};
  auto& b = halves.right;  // level k leaves the last point of level k - 1 at its place in right
  for (int k = 1; k <= n; ++k) {
    for (int i = 0; i <= n - k; ++i)
      for (int axis = 0; axis < Dimension; ++axis) b(axis, i) = step(b(axis, i), b(axis, i + 1));
    for (int axis = 0; axis < Dimension; ++axis) halves.left(axis, k) = b(axis, 0);
  }
  return halves;
}

}  // namespace bezierbench

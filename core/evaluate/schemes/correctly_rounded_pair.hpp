// SPDX-License-Identifier: MIT
// What `correctly_rounded` does first, in both forms: a coordinate as a pair value + error with a proved bound on what
// the pair misses, and the test whether every number within that bound rounds to the same one.
//
// The test is that of [de Dinechin et al. 2013], with the bound on either side: rounding is monotonic, so if
// value + (error - e) and value + (error + e) round to the same number, so does the coordinate. Coefficients are
// multiplied by a power of two that brings the largest of an axis into [1, 2), hence nothing overflows, and what is
// lost to underflow is far below e. A result that is subnormal once the power is taken back is left undecided.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#include "core/error_free.hpp"
#include "core/evaluate/evaluator.hpp"
#include "core/evaluate/schemes/correctly_rounded_integers.hpp"
#include "core/evaluate/schemes/nearer_end.hpp"

namespace bezierbench {

/// The type of the numbers of a scalar that may be many of them.
template <class Scalar>
struct NumberOf {
  using Type = double;
};
template <std::floating_point Scalar>
struct NumberOf<Scalar> {
  using Type = Scalar;
};
template <class Lanes>
requires requires { typename Lanes::Scalar; }
struct NumberOf<Lanes> {
  using Type = typename Lanes::Scalar;
};

/// What the test needs of an axis.
template <class Scalar>
struct AxisRounding {
  Scalar error;     ///< e: more than a pair misses at any t in [0,1]; infinite where a coefficient is not finite
  Scalar smallest;  ///< results below it are subnormal
  Scalar unit;      ///< the power of two that was taken out
};

/// NaN, which marks what is not decided.
template <class Scalar>
Scalar undecided() {
  return Scalar(std::numeric_limits<typename NumberOf<Scalar>::Type>::quiet_NaN());
}

/// The number to which every number within `rounding.error` of the pair rounds; undecided where there are several.
template <class Scalar, class Rounding>
Scalar decided(const Expansion2<Scalar>& pair, const Rounding& rounding) {
  const Scalar upper = pair.value + (pair.error + Scalar(rounding.error));
  const Scalar lower = pair.value + (pair.error - Scalar(rounding.error));
  const Scalar magnitude = select(Scalar(0) <= upper, upper, -upper);
  const Scalar same = select(upper <= lower, upper, undecided<Scalar>());
  return select(Scalar(rounding.smallest) <= magnitude, same * Scalar(rounding.unit), undecided<Scalar>());
}

/// t where it is in [0,1], else undecided.
template <class Scalar>
Scalar in_unit_interval(const Scalar& t) {
  return select(Scalar(0) <= t, select(t <= Scalar(1), t, undecided<Scalar>()), undecided<Scalar>());
}

/// `result`, or what `settle` says of t where it is undecided. Counting scalars are never undecided.
template <class Scalar, class Settle>
Scalar or_else(const Scalar& result, const Scalar& t, const Settle& settle) {
  if constexpr (std::floating_point<Scalar>)
    return std::isnan(result) ? settle(t) : result;
  else
    return result;
}

/// Calls `of` with each axis as a constant: compilers keep arrays in registers if they see no loop over them.
template <int Dimension, class Of>
void each_axis(const Of& of) {
  [&]<int... Axis>(std::integer_sequence<int, Axis...> /*axes*/) { (of(std::integral_constant<int, Axis>()), ...); }
  (std::make_integer_sequence<int, Dimension>());
}

/// The pairs of the axes of a point.
template <class Scalar, int Dimension>
using Pairs = std::array<Expansion2<Scalar>, static_cast<std::size_t>(Dimension)>;

/// Calls `of.template operator()<First, Count>()` for ranges of axes that go through Horner's scheme side by side: all
/// of them, so that the steps of one hide the latency of another; or one by one where the scalar is many numbers, which
/// hide it themselves and need the registers.
template <class Scalar, int Dimension, class Of>
void each_range_of_axes(const Of& of) {
  if constexpr (std::floating_point<Scalar>)
    of.template operator()<0, Dimension>();
  else
    each_axis<Dimension>([&](auto axis) { of.template operator()<axis, 1>(); });
}

/// A step of Horner's scheme: value + error <- (value + error) r + c + correction, where r and c are numbers and the
/// correction is of the order of the error. It is two_sum of c and the product, whose own error one fused operation
/// adds to that of its part.
template <class Scalar>
void horner_step(Scalar& value, Scalar& error, const Scalar& r, const Scalar& c, const Scalar& correction) {
  const Scalar next = value * r + c;
  const Scalar minus_product = c - next;  // the part of the product in the sum, negated for the fused operation
  const Scalar lost_of_c = c - (next + minus_product);
  const Scalar lost_of_product = fused<Scalar>(value, r, minus_product);
  error = fused<Scalar>(error, r, correction + (lost_of_c + lost_of_product));
  value = next;
}

/// The power of two below `largest` (finite, not zero) in two factors, for the range of one may not hold its inverse.
template <class Scalar>
struct PowerOfTwo {
  explicit PowerOfTwo(Scalar largest) : exponent(std::ilogb(largest)) {
    inverse = {std::ldexp(Scalar(1), -exponent / 2), std::ldexp(Scalar(1), -exponent - -exponent / 2)};
  }
  /// value 2^-exponent; rounds where that is subnormal.
  [[nodiscard]] Scalar without(Scalar value) const { return value * inverse[0] * inverse[1]; }

  int exponent;
  std::array<Scalar, 2> inverse;
};

/// Scales one axis of `scaled` in place, and says how its pairs are tested: `factor` u^2 times the sum of the
/// magnitudes for power form, or the largest of them for Bernstein form, where the basis sums to one.
template <Form F, class Scalar, int Dimension, int Degree>
AxisRounding<Scalar> scale_axis(Curve<F, Scalar, Dimension, Degree>& scaled, int axis, double factor) {
  Scalar largest = 0;
  bool finite = true;
  for (int i = 0; i <= scaled.degree(); ++i) {
    const Scalar magnitude = std::abs(scaled(axis, i));
    finite = finite && std::isfinite(magnitude);
    if (largest < magnitude) largest = magnitude;
  }
  if (!finite) return {std::numeric_limits<Scalar>::infinity(), 0, 1};
  if (largest == 0) return {0, 0, 1};
  const PowerOfTwo<Scalar> power(largest);
  double sum = 0;
  for (int i = 0; i <= scaled.degree(); ++i) {
    scaled(axis, i) = power.without(scaled(axis, i));
    sum += std::abs(static_cast<double>(scaled(axis, i)));
  }
  const double size = F == Form::power ? sum : static_cast<double>(power.without(largest));
  constexpr double u = std::numeric_limits<Scalar>::epsilon() / 2;
  constexpr double rounded_up = 1 + 0x1p-20;  // of the sum and of this product, and to float
  return {static_cast<Scalar>(factor * u * u * size * rounded_up),
          std::ldexp(std::numeric_limits<Scalar>::min(), -power.exponent), std::ldexp(Scalar(1), power.exponent)};
}

/// One axis of what is prepared.
template <class Scalar>
struct AxisState {
  CoordinateView<Scalar> scaled;  ///< the coefficients of the pair
  CoordinateView<Scalar> lost;    ///< of the pair in Bernstein form
  CoordinateView<Scalar> given;   ///< the coefficients of the curve
  AxisRounding<Scalar> rounding;
};

/// The number nearest to a coordinate by the pair and a bound in terms of p~ at this t; undecided where that is too
/// large.
template <class Scalar>
Scalar settled_by_p_tilde(const AxisState<Scalar>& axis, Scalar t, Form form);

/// The number nearest to a coordinate that the pair left undecided: by p~, else by integers.
template <class Scalar>
Scalar settled(const AxisState<Scalar>& axis, Scalar t, Form form);

/// What is prepared: the coefficients of the pair, and all that is required where it does not decide; or a view of it
/// for lanes, of which those that are left undecided are settled one by one.
template <Form F, class Scalar, int Dimension, int Degree>
struct RoundedState {
  using Coefficients = Curve<F, Scalar, Dimension, Degree>;
  using Number = typename NumberOf<Scalar>::Type;
  using Roundings = std::conditional_t<ReadsCurves<Scalar>, const AxisRounding<Number>*,
                                       std::array<AxisRounding<Number>, static_cast<std::size_t>(Dimension)>>;
  static constexpr bool by_axis = true;  ///< the axes of a point are not evaluated side by side

  explicit RoundedState(int degree) : scaled(degree), lost(F == Form::bernstein ? degree : 0), given(degree) {}
  [[gnu::always_inline]] RoundedState(const Coefficients& scaled_curve, const Coefficients& lost_curve,
                                      const Coefficients& given_curve, const Roundings& of_axes)
      : scaled(scaled_curve), lost(lost_curve), given(given_curve), rounding(of_axes) {}

  [[nodiscard]] auto parts() const { return std::tie(scaled, lost, given, rounding); }
  [[nodiscard, gnu::always_inline]] AxisState<Number> axis(int a) const {
    const auto view = [a](const Coefficients& curve) {
      return CoordinateView<Number>{curve.data() + a, Dimension, curve.degree()};
    };
    return {view(scaled), view(lost), view(given), rounding[static_cast<std::size_t>(a)]};
  }

  Coefficients scaled;  ///< times a power of two; in Bernstein form also times C(n,i), rounded
  Coefficients lost;    ///< in Bernstein form, the error of this rounding
  Coefficients given;
  Roundings rounding;
};

/// The point of evaluator E: by its pairs where they decide.
template <class E, class State, class Scalar>
auto rounded_point(const State& prepared, const Scalar& t) {
  constexpr int dimension = State::Coefficients::dimension;
  const auto sums = E::template pairs<dimension>(prepared, in_unit_interval<Scalar>(t));
  Point<Scalar, dimension> point;
  // First for all axes, so that nothing that the scheme keeps in registers is used after a call.
  each_axis<dimension>(
      [&](auto axis) { point[axis] = decided<Scalar>(std::get<axis>(sums), prepared.rounding[axis]); });
  each_axis<dimension>([&](auto axis) {
    point[axis] = or_else(point[axis], t, [&](auto one) { return settled(prepared.axis(axis), one, E::info.form); });
  });
  return point;
}

}  // namespace bezierbench

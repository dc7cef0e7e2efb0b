// SPDX-License-Identifier: MIT
// Formula: the number nearest to y, ties to even, for x in [0, 1]. An enclosure of y from a guess of t by
//   easing_halley: in float first one in double, then one in pairs of doubles; where it leaves several numbers to
//   choose from, the sign of y minus their middles from exact integers.
// Source: derived here, with a proof: docs/proofs/easing.md; [de Dinechin et al. 2013] (the test); [Basu et al. 2006]
//   (the sign).
// Cost: integers take microseconds, and decide ties and fewer than one of 10^8 random x, all x below 2^-300 and y1, y2
//   beyond 2^900.
// Bound: it is correctly rounded: u |y|, eta/2 where y is subnormal. So it is monotone wherever the curve is.
// Fails: x1 or x2 outside [0, 1] are outside its domain, as of every method.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/easing/enclosure.hpp"
#include "core/easing/halley.hpp"

namespace bezierbench {

struct EasingCorrectlyRounded {
  static constexpr MethodInfo info{
      .id = "easing_correctly_rounded",
      .label = "Correctly rounded",
      .problem = Problem::easing,
      .min_degree = 3,
      .max_degree = 3,
      .promise = "the nearest number, so monotone where the curve is",
      .flops = "about 1100 in double, 350 in float",
      .citation = "[de Dinechin et al. 2013]; [Basu et al. 2006], theorem 2.61; bound derived here"};
  static constexpr bool is_correctly_rounded = true;

  template <class Scalar>
  struct Prepared {
    EasingCurve<double> curve;
    EasingEncloser<PairArithmetic> in_pairs;
    EasingEncloser<DoubleArithmetic> in_double;
    bool in_range;
  };

  template <class Scalar>
  static Prepared<Scalar> prepare(const EasingCurve<Scalar>& given) {
    const EasingCurve<double> curve{given.x1, given.y1, given.x2, given.y2};
    const bool in_range = std::abs(curve.y1) <= 0x1p900 && std::abs(curve.y2) <= 0x1p900;
    return {curve, EasingEncloser<PairArithmetic>(curve), EasingEncloser<DoubleArithmetic>(curve), in_range};
  }

  template <class Scalar>
  static Eased<Scalar> solve(const Prepared<Scalar>& prepared, Scalar given) {
    if (given == 0 || given == 1) return {given, given};
    const double x = given;
    const auto guess = EasingHalley::solve(prepared.curve, x);
    Eased<Scalar> eased{static_cast<Scalar>(guess.t), 0, guess.steps};
    const auto& [x1, y1, x2, y2] = prepared.curve;
    Ends<Scalar> ends{static_cast<Scalar>(std::min({0.0, 1.0, y1, y2})),
                      static_cast<Scalar>(std::max({0.0, 1.0, y1, y2}))};
    if (prepared.in_range && x >= 0x1p-300) {
      const auto narrow = [&](const auto& encloser) {
        if (const auto found = encloser.at(x, guess.t)) ends = rounded<Scalar>(*found);
      };
      if constexpr (sizeof(Scalar) == sizeof(float)) narrow(prepared.in_double);
      if (ends.low != ends.high) narrow(prepared.in_pairs);
    }
    eased.y = ends.low == ends.high ? ends.low : nearest(prepared.curve, x, ends);
    return eased;
  }

 private:
  /// The nearest number is one of them or between them.
  template <class Scalar>
  struct Ends {
    Scalar low, high;
  };

  template <class Scalar>
  static Ends<Scalar> rounded(const EasingEnclosure& y) {
    const double reach = y.error * (1 + 0x1p-50) + std::abs(y.low) * 0x1p-51;
    const double low = y.high + (y.low - reach);
    const double high = y.high + (y.low + reach);
    if constexpr (sizeof(Scalar) == sizeof(double)) return {low, high};
    // One more step outwards, since `low` and `high` are rounded already.
    const auto step = [](double a) { return std::abs(a) * 0x1p-52 + std::numeric_limits<double>::denorm_min(); };
    return {static_cast<Scalar>(low - step(low)), static_cast<Scalar>(high + step(high))};
  }

  /// Numbers in their order: neighbours differ by 1; both zeros are 0.
  template <class Scalar>
  static std::int64_t place_of(Scalar value) {
    using Bits = std::conditional_t<sizeof(Scalar) == sizeof(float), std::int32_t, std::int64_t>;
    const Bits bits = std::bit_cast<Bits>(std::abs(value));
    return value < 0 ? -std::int64_t{bits} : std::int64_t{bits};
  }
  template <class Scalar>
  static Scalar at_place(std::int64_t place) {
    using Bits = std::conditional_t<sizeof(Scalar) == sizeof(float), std::int32_t, std::int64_t>;
    const auto magnitude = std::bit_cast<Scalar>(static_cast<Bits>(place < 0 ? -place : place));
    return place < 0 ? -magnitude : magnitude;
  }

  template <class Scalar>
  static Scalar nearest(const EasingCurve<double>& curve, double x, const Ends<Scalar>& ends) {
    std::int64_t low = place_of(ends.low);
    std::int64_t high = place_of(ends.high);
    if (low < 0 && high > 0) {  // their distance may be too large for the type
      const int sign = exact_easing_sign(curve, x, 0, 0);
      if (sign == 0) return 0;
      (sign > 0 ? low : high) = 0;
    }
    while (high - low > 1) {
      const std::int64_t middle = low + (high - low) / 2;
      const double value = at_place<Scalar>(middle);
      const int sign = exact_easing_sign(curve, x, value, value);
      if (sign == 0) return at_place<Scalar>(middle);
      (sign > 0 ? low : high) = middle;
    }
    const int sign = exact_easing_sign(curve, x, at_place<Scalar>(low), at_place<Scalar>(high));
    if (sign == 0) return at_place<Scalar>(low % 2 == 0 ? low : high);
    return at_place<Scalar>(sign > 0 ? high : low);
  }
};

}  // namespace bezierbench

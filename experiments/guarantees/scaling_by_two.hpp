// SPDX-License-Identifier: MIT
// scaling_by_two: the points 2 b_i give 2 p(t) for t in [0,1], where nothing over- or underflows. That is said of the
// input alone: 4^(n+1) max |b_i| is in range, and there are powers of two beta and tau, at most 1, of which all b_i and t
// are multiples and for which beta tau^n is a number, subnormal or not. Then every product b_i t^j (1-t)^(n-j) is a
// multiple of the smallest subnormal.
#pragma once

#include "experiments/guarantees/bits.hpp"
#include "experiments/guarantees/case.hpp"
#include "experiments/guarantees/excess.hpp"
#include "experiments/guarantees/parameters.hpp"

namespace bezierbench::guarantees {

template <class Scalar>
struct ScalingByTwo {
  static constexpr Property property = Property::scaling_by_two;

  /// Takes those bits from t that would leave the range.
  static void fit(Case<Scalar>& input) {
    input.t = into_unit_interval(input.t);
    const int bits = (lattice_of(input.coefficients) - smallest) / input.degree();
    if (bits < 0 || lattice_exponent(input.t) >= -bits) return;
    input.t = std::ldexp(std::floor(std::ldexp(input.t, bits)), -bits);
  }

  static Excess excess(Evaluation<Scalar>& method, const Case<Scalar>& input) {
    const int n = input.degree();
    if (lattice_of(input.coefficients) + n * lattice_exponent(input.t) < smallest) return std::nullopt;
    auto twice = input;
    for (Scalar& value : twice.coefficients) {
      int exponent = 0;
      std::frexp(value, &exponent);
      if (exponent + 2 * n + 2 > std::numeric_limits<Scalar>::max_exponent) return std::nullopt;
      value *= 2;
    }
    auto expected = method.point(input.coefficients, input.t);
    for (Scalar& value : expected) value *= 2;
    return difference(method.point(twice.coefficients, input.t), expected);
  }

 private:
  static constexpr int smallest = std::numeric_limits<Scalar>::min_exponent - std::numeric_limits<Scalar>::digits;

  /// The exponent of the largest power of two up to 1 of which x is a multiple.
  static int lattice_exponent(Scalar x) { return x == 0 ? 0 : std::min(0, lowest_bit(static_cast<double>(x))); }
  static int lattice_of(const std::vector<Scalar>& values) {
    int least = 0;
    for (const Scalar value : values) least = std::min(least, lattice_exponent(value));
    return least;
  }
};

}  // namespace bezierbench::guarantees

// SPDX-License-Identifier: MIT
// Formula: p(t) = sum C(n,i) pow(t, i) pow(1-t, n-i) b_i: the definition, with the library's pow for every power.
// Bound: none. libm decides the last bits of pow, so the rows of this method are kept out of the digested files.
// Fails: it is slow, and not reproducible across C libraries.
#pragma once

#include <cmath>

#include "core/binomial.hpp"
#include "core/evaluate/evaluator.hpp"

namespace bezierbench {

struct DirectPow {
  static constexpr MethodInfo info{.id = "direct_pow",
                                   .label = "Direct with pow()",
                                   .form = Form::bernstein,
                                   .max_degree_float = 131,
                                   .bit_stable = false,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "2(n+1) pow and 2(n+1) + 2d(n+1)",
                                   .citation = "[Document 000], section 1"};

  template <class Scalar, int Dimension, int Degree>
  struct Prepared {
    Curve<Form::bernstein, Scalar, Dimension, Degree> curve;
    PerCoefficient<SharedBy<Scalar>, Degree> binomial;
  };

  template <class Scalar, int Dimension, int Degree>
  static Prepared<Scalar, Dimension, Degree> prepare(const Curve<Form::bernstein, Scalar, Dimension, Degree>& curve) {
    return {curve, binomials<Scalar, Degree>(curve.degree())};
  }

  template <class Scalar, int Dimension, int Degree>
  static Point<Scalar, Dimension> evaluate(const Prepared<Scalar, Dimension, Degree>& prepared, Scalar t) {
    const int n = prepared.curve.degree();
    const Scalar s = Scalar(1) - t;
    Point<Scalar, Dimension> sum = Point<Scalar, Dimension>::Zero();
    for (int i = 0; i <= n; ++i) {
      const Scalar basis =
          prepared.binomial[i] * std::pow(t, static_cast<Scalar>(i)) * std::pow(s, static_cast<Scalar>(n - i));
      for (int axis = 0; axis < Dimension; ++axis) sum[axis] += basis * prepared.curve(axis, i);
    }
    return sum;
  }
};

}  // namespace bezierbench

// SPDX-License-Identifier: MIT
// Formula: the differences of [Document 000] as printed: every one of the k passes runs over i = 0..n-k, where pass m
//   must run over i = 0..n-m. They are right for k = 0 and 1 only.
// Source: the document's function `at`, kept as a baseline for the corrected loop.
// Cost: once d k (n-k+1) flops.
// Bound: none.
// Fails: from the second derivative on. Points (1,1) (3,1) (4,2) (6,3), t = 1/2: C'' = (6,6), the truth is (0,3). The
//   factor (n)_k is an int of 32 bits, which 20 19 ... 13 exceeds; it wraps around here, too.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/derivative/derivative.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"

namespace bezierbench {

struct Seed000 {
  static constexpr MethodInfo info{.id = "seed_000",
                                   .label = "Document 000, as printed",
                                   .problem = Problem::derivative,
                                   .form = Form::bernstein,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "3d (n-k)(n-k+1)/2 + d + 1",
                                   .cost_exponent = 2,
                                   .prepare_exponent = 2,
                                   .citation = "[Document 000], section 2.2"};

  template <int Dimension>
  struct Prepared {
    Curve<Form::bernstein, double, Dimension> differences;
    double prefix;
  };

  template <int Dimension>
  static Prepared<Dimension> prepare(const Curve<Form::bernstein, double, Dimension>& curve, int order) {
    const int n = curve.degree();
    std::uint32_t prefix = 1;
    for (int i = 0; i < order && prefix != 0; ++i) prefix *= static_cast<std::uint32_t>(n - i);
    auto temp = curve;
    for (int k = 0; k < order && order <= n; ++k)
      for (int i = 0; i <= n - order; ++i)
        for (int axis = 0; axis < Dimension; ++axis) temp(axis, i) = temp(axis, i + 1) - temp(axis, i);
    Prepared<Dimension> prepared{Curve<Form::bernstein, double, Dimension>(std::max(n - order, 0)),
                                 static_cast<double>(static_cast<std::int32_t>(prefix))};
    for (int i = 0; i <= prepared.differences.degree(); ++i)
      for (int axis = 0; axis < Dimension; ++axis) prepared.differences(axis, i) = temp(axis, i);
    return prepared;
  }

  template <int Dimension>
  static Point<double, Dimension> evaluate(const Prepared<Dimension>& prepared, double t) {
    return prepared.prefix * DeCasteljau::evaluate(prepared.differences, t);
  }
};

}  // namespace bezierbench

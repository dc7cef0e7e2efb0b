// SPDX-License-Identifier: MIT
// The evaluator that a caller gets who names none: the fastest for many points of one curve (mode `point`) of those
// that have a proved bound and need neither a conversion nor a fused operation in hardware, unless another one has much
// smaller errors. The numbers are from committed bundles. Times are in nanoseconds per point (GCC 12, x86-64-v3),
// errors are the largest that were observed, in units of u p~.
//
//   Bernstein form, t in [0,1]   `horner_bernstein`: 3.0 against 3.3 of `de_casteljau` at degree 3, 15.2 against 75.9
//                                at 20, with errors of 3.7 against 3.9 and of 13.7 against 13.2 (results/atlas/speed,
//                                studies speed-bezier and speed-errors-bezier). To degree 2 `de_casteljau`, which
//                                prepares nothing; no committed table has times there. Past degree 600, too: C(n,i)
//                                b_i can overflow there for |b_i| above 2^(1024-n).
//   Bernstein form, other t      `de_casteljau_two_sided`, for its errors: 3.3 against 17.4 of `de_casteljau` and 17.7
//                                of `horner_bernstein` at degree 30 for t in [-100,100]. It is the slowest: 314
//                                against 249 and 31.6 (results/answers, studies answers-outside and
//                                answers-outside-time).
//   power form                   `horner`: 3.0 at degree 3 and 11.3 at 20, with errors of 1.9 and 1.6. `power_sum`
//                                takes 2.2 and 17.1, with errors of 2.1 and 6.4 (results/atlas/speed, studies
//                                speed-polynomial and speed-errors-polynomial).
//   rational curves              `horner_bernstein` from degree 3 on: 5.7 against 6.1 of `de_casteljau` at 3, 15.3
//                                against 36.6 at 10; at degree 2 both take 4.9 (results/atlas/rational, study
//                                rational-time). No method has a bound outside [0,1].
//
// A call that prepares for a single point (mode `one_shot`, as `evaluate(points, t)` does) would choose otherwise at
// low degrees. In Bernstein form `de_casteljau` takes 8.0 against 8.5 of `horner_bernstein` at degree 3 and as long at
// 5; at 10 it takes 26.2 against 13.7 (speed-bezier). In power form `power_sum` takes 8.1 against 8.5 of `horner` at
// degree 3 and 26.2 against 29.2 at 20 (speed-polynomial). Rational curves keep the choice at every degree
// (rational-time). The choice is the same for both uses, so that their points have the same bits.
//
// Scalars that are not floating-point numbers get the scheme that needs least of them, sums and products:
// `de_casteljau` or `horner`.
#pragma once

#include <concepts>

#include "core/evaluate/de_casteljau.hpp"
#include "core/evaluate/de_casteljau_two_sided.hpp"
#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/horner.hpp"
#include "core/evaluate/horner_bernstein.hpp"

namespace bezierbench::detail {

/// Whether a curve of this degree is for `horner_bernstein`.
template <class Scalar>
constexpr bool is_for_nested_scheme(int degree) {
  constexpr int highest = 600;
  return degree > 2 && degree <= highest && HornerBernstein::info.supports<Scalar>(degree);
}

/// Returns `use.template operator()<Method>()` of the method for a curve of this form and degree at t.
template <Form F, class Scalar, class Use>
auto with_recommended(int degree, const Scalar& t, const Use& use) {
  if constexpr (F == Form::power) {
    return use.template operator()<Horner>();
  } else if constexpr (F == Form::rational) {
    if constexpr (std::floating_point<Scalar>)
      if (is_for_nested_scheme<Scalar>(degree)) return use.template operator()<Homogeneous<HornerBernstein>>();
    return use.template operator()<Homogeneous<DeCasteljau>>();
  } else {
    static_assert(F == Form::bernstein, "curves are given in Bernstein, power or rational form");
    if constexpr (std::floating_point<Scalar>) {
      if (!(t >= 0 && t <= 1)) return use.template operator()<DeCasteljauTwoSided>();
      if (is_for_nested_scheme<Scalar>(degree)) return use.template operator()<HornerBernstein>();
    }
    return use.template operator()<DeCasteljau>();
  }
}

}  // namespace bezierbench::detail

namespace bezierbench {

/// What is known of the method that `evaluate` chooses: its id, label, cost, bound and source.
template <Form F = Form::bernstein, class Scalar = double>
const MethodInfo& recommended(int degree, const Scalar& t) {
  return *detail::with_recommended<F>(degree, t, []<class Method>() { return &Method::info; });
}

}  // namespace bezierbench

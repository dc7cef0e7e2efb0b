// SPDX-License-Identifier: MIT
// The evaluator that a caller gets who names none: the fastest in mode `point` of those that have a proved bound for
// every t and need neither a conversion nor a fused operation in hardware. Times are in nanoseconds (GCC 12,
// x86-64-v3), errors the largest that were observed, in units of u p~, each with the study that it is from, by its id
// in the shipped suites.
//
//   Bernstein form, t in [0,1]   `horner_bernstein`: 4.1 against 5.0 of `de_casteljau` at degree 4, 15.2 against 75.8
//                                at 20 (2.4-bezier of `report`), with errors no larger: 13.5 against 15.6 at degree 20
//                                (truth-bezier). To degree 2 and past 600, where its bound is infinite,
//                                `de_casteljau` (regimes-degree of `regimes`).
//   Bernstein form, other t      `de_casteljau_two_sided`: 4.7 against 19.0 of `de_casteljau` and 20.4 of
//                                `horner_bernstein` at degree 20 for t in [-1,0] (regimes-parameter).
//   power form                   `horner`: 11.2 at degree 20 (2.4-polynomial). `power_sum` takes 10.2, with errors of
//                                6.4 against 1.6 (speed-errors-polynomial of `speed`).
//   rational curves              `horner_bernstein` from degree 3 on: 3.7 against 4.4 of `de_casteljau` at 3, 11.4
//                                against 31.5 at 10 (rational-time of `rational`). No method has a bound outside [0,1].
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
  constexpr int largest_with_bound = 600;
  return degree > 2 && degree <= largest_with_bound && HornerBernstein::info.supports<Scalar>(degree);
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

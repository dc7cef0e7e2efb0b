// SPDX-License-Identifier: MIT
// The evaluator that a caller gets who names none. Rule: of the methods with a proved bound at every trial that need
// neither a conversion nor a fused operation in hardware, those whose times in mode `point` have a product over the
// degrees 3, 12 and 30 within a fifth of the smallest (a race is no sharper), and of these the one with the smallest
// errors. The test beside this file applies it to the committed bundle results/answers:
//
//   studies (and -time)               method            ns a point       largest error in u p~
//   answers-bezier, t in [0,1]        horner_bernstein  3.1, 13, 30      3.4, 8.6, 17
//                                     de_casteljau      3.3, 34, 210     3.0, 8.1, 16
//   answers-outside, t in [-100,100]  horner_bernstein  3.4, 11, 32      3.0, 9.6, 18
//                                     de_casteljau      3.8, 34, 249     3.3, 6.4, 17
//   answers-power, t in [0,1]         horner            3.5, 4.8, 20     1.9, 1.5, 1.7
//                                     power_sum         2.8, 5.6, 19     2.3, 4.3, 5.6
//   answers-rational, t in [0,1]      horner_bernstein  5.8, 19, 41      4.7, 6.7, 9.8
//                                     de_casteljau      6.2, 45, 250     5.0, 7.0, 11
//
// speed-bezier and speed-polynomial in results/atlas/speed say the same at degrees 10 and 20: 6.9 and 15 ns for
// `horner_bernstein`, 23 and 76 for `de_casteljau`; 3.8 and 11 for `horner`, 4.2 and 17 for `power_sum`. So inside and
// outside of [0,1] the choice is the same; for rational curves no method has a bound outside.
//
// `de_casteljau` takes the degrees to 2, where the triangle is as fast (4.9 ns both, rational-time in
// results/atlas/rational) and its bound smaller, and those past half of the type's largest exponent, 512 in double and
// 64 in float. Up to there C(n,i) < 2^n, so that C(n,i) b_i is finite for coordinates up to 1e154 in double, 1e19 in
// float.
//
// Scalars that are not floating-point numbers get the scheme that needs least of them, sums and products:
// `de_casteljau` or `horner`.
#pragma once

#include <concepts>
#include <limits>

#include "core/evaluate/de_casteljau.hpp"
#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/horner.hpp"
#include "core/evaluate/horner_bernstein.hpp"

namespace bezierbench::detail {

/// Whether a curve of this degree is for `horner_bernstein`.
template <std::floating_point Scalar>
constexpr bool is_for_nested_scheme(int degree) {
  return degree > 2 && degree <= std::numeric_limits<Scalar>::max_exponent / 2 &&
         HornerBernstein::info.supports<Scalar>(degree);
}

/// Returns `use.template operator()<Method>()` of the method for a curve of this form and degree at t.
template <Form F, class Scalar, class Use>
auto with_recommended(int degree, const Scalar& /*t*/, const Use& use) {
  if constexpr (F == Form::power) {
    return use.template operator()<Horner>();
  } else if constexpr (F == Form::rational) {
    if constexpr (std::floating_point<Scalar>)
      if (is_for_nested_scheme<Scalar>(degree)) return use.template operator()<Homogeneous<HornerBernstein>>();
    return use.template operator()<Homogeneous<DeCasteljau>>();
  } else {
    static_assert(F == Form::bernstein, "curves are given in Bernstein, power or rational form");
    if constexpr (std::floating_point<Scalar>)
      if (is_for_nested_scheme<Scalar>(degree)) return use.template operator()<HornerBernstein>();
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

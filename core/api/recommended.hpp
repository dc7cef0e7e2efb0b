// SPDX-License-Identifier: MIT
// The evaluator that a caller gets who names none. Rule: of the methods with a proved bound at every trial that need
// neither a conversion nor a fused operation in hardware, those whose times in mode `point` have a product over the
// degrees 3, 5, 12 and 30 within a fifth of the smallest (a race is no sharper), and of these the one with the
// smallest product of largest errors. The test beside this file applies it to timing.csv and accuracy.csv of the
// committed bundle results/answers: to the studies answers-bezier (t in [0,1]) and answers-outside (t in [-100,100])
// together, since the choice is the same inside and outside of [0,1], to answers-power and to answers-rational; for
// rational curves no method has a bound outside.
//
// `de_casteljau` takes the degrees to 2, where its bound is smaller and the time the same (the ratio at degree 2 in
// the same bundle), and those past half of the type's largest exponent, 512 in double and 64 in float. Up to there
// C(n,i) < 2^n, so that C(n,i) b_i is finite for coordinates up to 1e154 in double, 1e19 in float.
//
// In power form the choice is `estrin`, for degrees above 8. Up to there `horner` is as fast in that bundle (the ratios
// at degrees 3 and 5), and faster in a program that inlines it. `estrin` requires that t^n is finite, even where the
// last coefficients are 0.
//
// Scalars that are not floating-point numbers get the scheme that needs least of them, sums and products:
// `de_casteljau` or `horner`.
#pragma once

#include <concepts>
#include <limits>

#include "core/evaluate/homogeneous.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"
#include "core/evaluate/methods/estrin.hpp"
#include "core/evaluate/methods/horner.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench::detail {

/// Whether a curve of this degree is for `horner_bernstein`.
template <std::floating_point Scalar>
constexpr bool is_for_nested_scheme(int degree) {
  return degree > 2 && degree <= std::numeric_limits<Scalar>::max_exponent / 2 &&
         HornerBernstein::info.supports<Scalar>(degree);
}

/// Returns `use.template operator()<Method>()` of the method for a curve of this form, type and degree.
template <Form F, class Scalar, class Use>
auto with_recommended(int degree, const Use& use) {
  if constexpr (F == Form::power) {
    constexpr int most_for_horner = 8;
    if constexpr (std::floating_point<Scalar>)
      if (degree > most_for_horner) return use.template operator()<Estrin>();
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

/// What is known of the method that `evaluate` chooses for curves of this degree, at every t: its id, label, cost,
/// bound and source.
template <Form F = Form::bernstein, class Scalar = double>
const MethodInfo& recommended(int degree) {
  return *detail::with_recommended<F, Scalar>(degree, []<class Method>() { return &Method::info; });
}

}  // namespace bezierbench

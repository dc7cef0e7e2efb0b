// SPDX-License-Identifier: MIT
// Formula: the hodograph of order k by differences (hodograph.hpp), evaluated by nested multiplication in Bernstein
//   form.
// Cost: once d k (2n - k + 1)/2 + 2d (n-k+1) + k flops.
// Bound: gamma_k A + gamma_(k + 3(n-k) + 1) p~, to first order, and n-k more roundings past n-k = 54.
// Fails: where the hodograph does (hodograph.hpp).
#pragma once

#include "core/derivative/hodograph.hpp"
#include "core/evaluate/methods/horner_bernstein.hpp"

namespace bezierbench {

struct DifferencesHorner : HodographBy<HornerBernstein> {
  static constexpr DerivativeBound bound =
      bound_as("gamma_k A + gamma_(k+3(n-k)+1) p~, and n-k more roundings past n-k = 54");
  static constexpr MethodInfo info{.id = "differences_horner",
                                   .label = "Differences, Horner-Bernstein",
                                   .problem = Problem::derivative,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "(n-k)(1+3d) + 1",
                                   .prepare_exponent = 2,
                                   .citation = "[Farin 2002], nested multiplication"};
  static constexpr std::string_view flops_of_all = "(1+6d)(k+1)(2n-k)/2 + (1+3d)(k+1) - d(n+1)";
};

}  // namespace bezierbench

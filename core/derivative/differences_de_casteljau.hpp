// SPDX-License-Identifier: MIT
// Formula: the hodograph of order k by differences (hodograph.hpp), evaluated by de Casteljau's algorithm.
// Source: the document's difference loop (section 2.2) is corrected: pass m runs to n - m.
// Cost: once d k (2n - k + 1)/2 + d (n-k+1) + k flops.
// Bound: gamma_k A + gamma_(k + 3(n-k)) p~, to first order.
// Fails: where the hodograph does (hodograph.hpp).
#pragma once

#include "core/derivative/hodograph.hpp"
#include "core/evaluate/methods/de_casteljau.hpp"

namespace bezierbench {

struct DifferencesDeCasteljau : HodographBy<DeCasteljau> {
  static constexpr DerivativeBound bound = bound_as("gamma_k A + gamma_(k+3(n-k)) p~");
  static constexpr MethodInfo info{.id = "differences_de_casteljau",
                                   .label = "Differences, de Casteljau",
                                   .problem = Problem::derivative,
                                   .form = Form::bernstein,
                                   .promise = bound.text,
                                   .one_minus_t = OneMinusT::summed,
                                   .flops = "3d (n-k)(n-k+1)/2 + 1",
                                   .cost_exponent = 2,
                                   .prepare_exponent = 2,
                                   .citation = "[Farin 2002]; [Document 000], eq. (6)"};
};

}  // namespace bezierbench

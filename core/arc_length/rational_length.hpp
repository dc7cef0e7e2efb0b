// SPDX-License-Identifier: MIT
// Formula: a method for polynomial curves that requires no more than their hodograph, with |U| / W^2 of
//   core/arc_length/rational_hodograph.hpp in its place.
// Bound: that of the method, with the constants of docs/proofs/proved_rule.md for the denominator.
// Fails: where W vanishes the length is infinite; no method converges then. Where W cancels to 2^-38 of its terms no
//   bound of the roundings is found. Degrees above 512.
#pragma once

#include "core/arc_length/rational_hodograph.hpp"
#include "core/evaluate/joined.hpp"

namespace bezierbench {

template <class Method>
struct OfRational : Method {
  static constexpr MethodInfo info = [] {
    MethodInfo composed = Method::info;
    composed.form = Form::rational;
    composed.max_degree = rational_degree_limit;
    composed.flops =
        detail::Joined<detail::FlopsOf<Method>, detail::Literal<" of degree 2n - 1 for n, and of W">>::text;
    composed.prepare_exponent = 2;
    return composed;
  }();
};

}  // namespace bezierbench

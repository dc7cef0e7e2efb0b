// SPDX-License-Identifier: MIT
// Formula: the C2 natural cubic spline by its handles P1,i, with the back-substitution that [Document 003] prints:
//   P2,i = 2 K_i - P1,i for i = 0 .. n-2, and P2,(n-1) = (K_n + P1,(n-1)) / 2.
// Source: as printed; a baseline for c2_natural_handles, whose system it shares. The document has no equation for a
//   single segment, which is straight here, too.
// Bound: none.
// Fails: wherever there are three points or more. P2,i lies opposite P1,i about the beginning of segment i, where C1
//   requires that it lies opposite P1,(i+1) about its end. K = 0, 1, 0, 1 gives P2 = -5/9, 10/9, 4/9 with residuals of
//   C1 of -5/3 and 1; the spline has 10/9, 1/9, 4/9.
#pragma once

#include "core/interpolate/c2_natural_handles.hpp"

namespace bezierbench {

struct Seed003 {
  static constexpr MethodInfo info{.id = "seed_003",
                                   .label = "C2 natural spline by its handles, as printed",
                                   .problem = Problem::interpolation,
                                   .form = Form::bernstein,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .flops = "per point 9d",
                                   .citation = "[Document 003], section 3"};

  static constexpr double residual_bound = 0;

  static InnerPoints inner_points(std::span<const double> k) {
    auto points = C2NaturalHandles::inner_points(k);
    for (std::size_t i = 0; i + 2 < k.size(); ++i) points.second[i] = 2 * k[i] - points.first[i];
    return points;
  }
};

}  // namespace bezierbench

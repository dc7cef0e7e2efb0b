// SPDX-License-Identifier: MIT
// Formula: the quintic of [Document 002] with the coefficients that it prints,
//     k2 = A.D + 6 B.C + 3 C.C,  k3 = 3 B.D + 6 C.C + 3 C.D,  k4 = 3 C.D + 3 D.D,
//   where expanding (A + 3B u + 3C u^2 + D u^3).(B + 2C u + D u^2) gives A.D + 9 B.C, 4 B.D + 6 C.C and 5 C.D.
// Source: as printed; the solver is that of quintic_companion. Its t is not polished, which would hide what the printed
//   coefficients are worth.
// Bound: none.
// Fails: on most curves, because the coefficients are wrong. (0,0) (0,1) (1,1) (1,0) and P = (1/2, 0) have their foot
//   point at u = 1/2, where the printed quintic is 5/2. (0,0) (1,0) (2,1) (3,3), whose D is 0, and P = (1,1) have k2 =
//   0; the printed one is 3.
#pragma once

#include "core/project/companion_projection.hpp"

namespace bezierbench {

struct QuinticSeed002 : CompanionProjection<QuinticSeed002> {
  static constexpr MethodInfo info{.id = "quintic_seed_002",
                                   .label = "Quintic as printed",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 3,
                                   .max_degree = 3,
                                   .bit_stable = false,
                                   .flops = "about 10 5^3",
                                   .cost_exponent = 0,
                                   .citation = "[Document 002]"};

  /// k0 .. k5 as printed, divided by the square of m (OffsetCurve).
  template <int Dimension>
  static std::vector<double> coefficients(const OffsetCurve<Dimension>& offset) {
    const auto& first = offset.differences_of_points();
    const Point<double, Dimension> A = offset.offsets().col(0);
    const Point<double, Dimension> B = first.col(0);
    const Point<double, Dimension> C = first.col(1) - first.col(0);
    const Point<double, Dimension> D = first.col(2) - 2 * first.col(1) + first.col(0);
    const auto product = [](const auto& a, const auto& b) { return dot<Dimension>(a, b); };
    return {product(A, B),
            2 * product(A, C) + 3 * product(B, B),
            product(A, D) + 6 * product(B, C) + 3 * product(C, C),
            3 * product(B, D) + 6 * product(C, C) + 3 * product(C, D),
            3 * product(C, D) + 3 * product(D, D),
            product(D, D)};
  }
};

}  // namespace bezierbench

// SPDX-License-Identifier: MIT
// Formula: roots of f = (C - P).C' / n in power form as eigenvalues of a companion matrix. With q_i = C(n,i) D^i (b_0 -
//   P) and h_j = C(n-1,j) D^(j+1) b_0 (D the forward difference), f_k = sum_(i+j=k) q_i.h_j. For a cubic, with A = b_0
//   - P, B = D b_0, C = D^2 b_0, D = D^3 b_0:
//     k0 = A.B, k1 = 2 A.C + 3 B.B, k2 = A.D + 9 B.C, k3 = 4 B.D + 6 C.C, k4 = 5 C.D, k5 = D.D.
// Source: the document's k2, k3 and k4 are corrected.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1).
// Fails: f is rounded in power form, so the error of a k-fold root is (3^n u)^(1/k), 1e-5 where a cusp is the foot
//   point; where several points are about equally near, the polished one may then be another.
#pragma once

#include "core/binomial.hpp"
#include "core/project/companion_projection.hpp"

namespace bezierbench {

struct QuinticCompanion : CompanionProjection<QuinticCompanion> {
  static constexpr MethodInfo info{.id = "quintic_companion",
                                   .label = "Companion matrix",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 100,
                                   .bit_stable = false,
                                   .flops = "about 10 (2n-1)^3",
                                   .cost_exponent = 3,
                                   .citation = "[Document 002], corrected; [Edelman and Murakami 1995]"};
  static constexpr auto residual_bound = polished_residual_bound;

  /// f_0 .. f_(2n-1), divided by the square of m (OffsetCurve).
  template <int Dimension>
  static std::vector<double> coefficients(const OffsetCurve<Dimension>& offset) {
    const int n = offset.degree();
    const auto curve_binomials = binomials<double, dynamic>(n);
    const auto difference_binomials = binomials<double, dynamic>(n - 1);
    const auto curve = first_differences(offset.offsets());
    const auto difference = first_differences(offset.differences_of_points());
    std::vector<double> f(static_cast<std::size_t>(2 * n), 0.0);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j < n; ++j)
        f[static_cast<std::size_t>(i + j)] +=
            curve_binomials[i] * difference_binomials[j] * dot<Dimension>(curve.col(i), difference.col(j));
    return f;
  }

 private:
  /// Column k is D^k b_0.
  template <class Columns>
  static Columns first_differences(Columns b) {
    for (Eigen::Index k = 1; k < b.cols(); ++k)
      for (Eigen::Index i = b.cols() - 1; i >= k; --i)
        for (Eigen::Index axis = 0; axis < b.rows(); ++axis) b(axis, i) = b(axis, i) - b(axis, i - 1);
    return b;
  }
};

}  // namespace bezierbench

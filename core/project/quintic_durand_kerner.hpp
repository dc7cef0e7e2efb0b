// SPDX-License-Identifier: MIT
// Formula: all roots x_1 .. x_m of f = (C - P).C' / n in power form at once, each moved by
//     x_k <- x_k - f(x_k) / (f_m prod_(j != k) (x_k - x_j)),
//   starting at the powers of 0.4 + 0.9 i, until f(x_k) consists of rounding errors for every k.
// Source: the document names this solver. The coefficients are those of quintic_companion.
// Cost: some ten steps for simple roots, one for each bit of a multiple one.
// Bound: polished_residual_bound of (C - P).C' at t inside (0, 1).
// Fails: as quintic_companion, whose rounded coefficients it shares. Where leading coefficients are small, roots are
//   large, and beyond n = 9 their powers may overflow.
#pragma once

#include "core/project/complex_polynomial.hpp"
#include "core/project/quintic_companion.hpp"

namespace bezierbench {

struct QuinticDurandKerner : RootProjection<QuinticDurandKerner> {
  static constexpr MethodInfo info{.id = "quintic_durand_kerner",
                                   .label = "Durand-Kerner",
                                   .problem = Problem::projection,
                                   .form = Form::bernstein,
                                   .min_degree = 1,
                                   .max_degree = 9,
                                   .flops = "14 (2n-1)^2 per step",
                                   .cost_exponent = 2,
                                   .citation = "[Durand 1960]; [Kerner 1966]; [Document 002], section 4"};
  static constexpr auto residual_bound = polished_residual_bound;
  static constexpr int step_limit = 500;

  template <int Dimension>
  static std::vector<double> coefficients(const OffsetCurve<Dimension>& offset) {
    return QuinticCompanion::coefficients(offset);
  }

  static RootCandidates roots(const std::vector<double>& coefficients) {
    if (coefficients.size() < 2) return {};
    const ComplexPolynomial f(coefficients.begin(), coefficients.end());
    std::vector<Complex> x{Complex(1, 0)};
    while (x.size() + 1 < f.size()) x.push_back(product(x.back(), Complex(0.4, 0.9)));
    bool moved = true;
    for (int step = 0; moved && step < step_limit; ++step) {
      moved = false;
      for (std::size_t k = 0; k < x.size(); ++k) {
        const auto [value, is_rounding] = value_at(f, x[k]);
        if (is_rounding) continue;
        moved = true;
        Complex slope = f.back();
        for (std::size_t j = 0; j < x.size(); ++j)
          if (j != k) slope = product(slope, x[k] - x[j]);
        x[k] -= quotient(value, slope);
      }
    }
    return {candidates_of(x), !moved};
  }
};

}  // namespace bezierbench

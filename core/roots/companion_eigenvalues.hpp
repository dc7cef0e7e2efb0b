// SPDX-License-Identifier: MIT
// Formula: power coefficients q_j = C(n,j) D^j b_0 (D the forward difference), without those at the end that are 0; the
//   eigenvalues of their companion matrix, of which those within 1e-9 of [0, 1] are roots, moved onto it.
// Source: numpy.roots and MATLAB's roots take the eigenvalues of the same matrix.
// Bound: none.
// Fails: coefficients and eigenvalues are off by u of the largest power coefficient, which the conversion makes up to
//   3^n times as large; a double root becomes a pair off the axis, or two roots.
#pragma once

#include <algorithm>

#include "core/binomial.hpp"
#include "core/project/companion_projection.hpp"
#include "core/roots/roots.hpp"

namespace bezierbench {

struct CompanionEigenvalues {
  static constexpr MethodInfo info{.id = "companion_eigenvalues",
                                   .label = "Eigenvalues of the companion matrix",
                                   .problem = Problem::roots,
                                   .max_degree = 100,
                                   .bit_stable = false,
                                   .flops = "about 10 n^3",
                                   .cost_exponent = 3,
                                   .citation = "[Edelman and Murakami 1995]"};

  static FoundRoots find(std::vector<double> b) {
    constexpr double near = 1e-9;
    const std::size_t n = b.size() - 1;
    for (std::size_t k = 1; k <= n; ++k)
      for (std::size_t i = n; i >= k; --i) b[i] -= b[i - 1];
    const auto row = binomials<double, dynamic>(static_cast<int>(n));
    for (std::size_t j = 0; j <= n; ++j) b[j] *= row[static_cast<Eigen::Index>(j)];
    while (!b.empty() && b.back() == 0) b.pop_back();
    FoundRoots found;
    found.t = companion_roots(b, near, near);
    for (double& t : found.t) t = std::clamp(t, 0.0, 1.0);
    std::ranges::sort(found.t);
    return found;
  }
};

}  // namespace bezierbench

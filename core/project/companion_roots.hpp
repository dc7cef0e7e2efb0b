// SPDX-License-Identifier: MIT
// Candidates from the eigenvalues of a companion matrix, balanced and iterated by Eigen. The bits of Eigen's iterations
// depend on how Eigen was built, so methods that use this are not bit-stable.
#pragma once

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/Polynomials>
#include <vector>

namespace bezierbench {

/// Candidates for the roots of sum coefficients[k] t^k in [0, 1]: the real parts there of all complex roots. This
/// includes a double root that rounding split into a pair; a parameter too many costs one comparison of distances.
///
/// Leading coefficients of at most u times the largest one are dropped. In [0, 1] they change the polynomial by no more
/// than the rounding of the others did, and the companion matrix would divide by them.
inline std::vector<double> companion_roots(std::vector<double> coefficients) {
  double largest = 0;
  for (const double coefficient : coefficients) largest = std::max(largest, std::abs(coefficient));
  while (!coefficients.empty() && std::abs(coefficients.back()) <= 0x1p-53 * largest) coefficients.pop_back();
  std::vector<double> roots;
  if (coefficients.size() < 2) return roots;
  const Eigen::Map<const Eigen::VectorXd> polynomial(coefficients.data(),
                                                     static_cast<Eigen::Index>(coefficients.size()));
  const Eigen::PolynomialSolver<double, Eigen::Dynamic> solver(polynomial);
  for (const auto& root : solver.roots())
    if (root.real() >= 0 && root.real() <= 1) roots.push_back(root.real());
  return roots;
}

}  // namespace bezierbench

// SPDX-License-Identifier: MIT
#include "core/project/companion_projection.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/Polynomials>

namespace bezierbench {

std::vector<double> companion_roots(std::vector<double> coefficients) {
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

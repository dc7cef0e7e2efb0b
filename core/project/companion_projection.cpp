// SPDX-License-Identifier: MIT
#include "core/project/companion_projection.hpp"

#include <unsupported/Eigen/Polynomials>

namespace bezierbench {

std::vector<double> companion_roots(const std::vector<double>& coefficients) {
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

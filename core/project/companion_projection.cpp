// SPDX-License-Identifier: MIT
#include "core/project/companion_projection.hpp"

#include <cmath>
#include <unsupported/Eigen/Polynomials>

namespace bezierbench {

std::vector<double> companion_roots(const std::vector<double>& coefficients, double beyond, double off_axis) {
  std::vector<double> roots;
  if (coefficients.size() < 2) return roots;
  const Eigen::Map<const Eigen::VectorXd> polynomial(coefficients.data(),
                                                     static_cast<Eigen::Index>(coefficients.size()));
  const Eigen::PolynomialSolver<double, Eigen::Dynamic> solver(polynomial);
  for (const auto& root : solver.roots())
    if (root.real() >= -beyond && root.real() <= 1 + beyond && std::abs(root.imag()) <= off_axis)
      roots.push_back(root.real());
  return roots;
}

}  // namespace bezierbench

// SPDX-License-Identifier: MIT
// Projection by the roots of one polynomial as eigenvalues of a companion matrix, which Eigen balances and iterates.
// The bits of Eigen's iterations depend on how Eigen was built, so methods that use it are not bit-stable.
#pragma once

#include <limits>
#include <vector>

#include "core/project/root_projection.hpp"

namespace bezierbench {

/// Candidates for the roots of sum coefficients[k] t^k in [0, 1], whose last coefficient is not 0: the real parts of
/// the complex roots that lie in [-beyond, 1 + beyond], where the imaginary part is at most `off_axis`. With the
/// defaults the imaginary part does not matter: a double root that rounding has split into a pair is then among them,
/// and a superfluous candidate costs one comparison of distances.
std::vector<double> companion_roots(const std::vector<double>& coefficients, double beyond = 0,
                                    double off_axis = std::numeric_limits<double>::infinity());

template <class Method>
struct CompanionProjection : RootProjection<Method> {
  static RootCandidates roots(const std::vector<double>& coefficients) { return {companion_roots(coefficients)}; }
};

}  // namespace bezierbench

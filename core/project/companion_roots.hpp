// SPDX-License-Identifier: MIT
// Candidates from the eigenvalues of a companion matrix, balanced and iterated by Eigen. The bits of Eigen's iterations
// depend on how Eigen was built, so methods that use this are not bit-stable.
#pragma once

#include <vector>

namespace bezierbench {

/// Candidates for the roots of sum coefficients[k] t^k in [0, 1]: the real parts there of all complex roots. This
/// includes a double root that rounding split into a pair; a parameter too many costs one comparison of distances.
///
/// Leading coefficients of at most u times the largest one are dropped. In [0, 1] they change the polynomial by no more
/// than the rounding of the others did, and the companion matrix would divide by them.
std::vector<double> companion_roots(std::vector<double> coefficients);

}  // namespace bezierbench

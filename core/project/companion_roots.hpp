// SPDX-License-Identifier: MIT
// Candidates from the eigenvalues of a companion matrix, which Eigen balances and iterates. The bits of Eigen's
// iterations depend on how Eigen was built, so methods that use it are not bit-stable.
#pragma once

#include <vector>

namespace bezierbench {

/// Candidates for the roots of sum coefficients[k] t^k in [0, 1]: the real parts in [0, 1] of all complex roots. They
/// include a double root that rounding has split into a pair. A superfluous candidate costs one comparison of
/// distances.
///
/// Leading coefficients of at most u times the largest one are dropped. In [0, 1] this changes the polynomial by no
/// more than the rounding of the others did; the companion matrix would divide by them.
std::vector<double> companion_roots(std::vector<double> coefficients);

}  // namespace bezierbench

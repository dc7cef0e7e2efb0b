// SPDX-License-Identifier: MIT
// The floating-point operations of an evaluator for a point, counted while its own code runs.
#pragma once

#include "core/method.hpp"

namespace bezierbench::batch {

/// The operations of an evaluator of the batch roster for one point. A fused multiply-add counts as two; changes of
/// sign, comparisons and choices count as none. Dimension is 1, 2 or 3.
double flops_per_point(const MethodInfo& evaluator, int degree, int dimension);

}  // namespace bezierbench::batch

// SPDX-License-Identifier: MIT
// How many floating-point operations an evaluator does for a point: counted while its own code runs.
#pragma once

#include "core/method.hpp"

namespace bezierbench::batch {

/// Of an evaluator of the batch roster, of one point; a fused multiply-add counts as two. Changes of sign, comparisons
/// and choices are free. Dimension is 1, 2 or 3.
double flops_per_point(const MethodInfo& evaluator, int degree, int dimension);

}  // namespace bezierbench::batch

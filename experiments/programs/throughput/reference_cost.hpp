// SPDX-License-Identifier: MIT
// The cost of a true point: the certified tier against the exact integers and against 50 decimal digits in software.
#pragma once

#include <vector>

#include "experiments/programs/throughput/comparison.hpp"

namespace bezierbench::throughput {

/// Distances of points of a curve of `degree` in the plane from the truth, in both tiers, and the bare point by
/// Horner-Bernstein in cpp_bin_float_50: per point, of random curves in [-1, 1].
std::vector<Comparison> reference_costs(int degree);

}  // namespace bezierbench::throughput

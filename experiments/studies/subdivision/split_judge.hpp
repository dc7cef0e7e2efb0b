// SPDX-License-Identifier: MIT
// One method on one trial of a study of subdivision.
#pragma once

#include <cstdint>

#include "experiments/studies/subdivision/split_truth.hpp"
#include "experiments/studies/subdivision/subdivision_tally.hpp"

namespace bezierbench::studies {

/// Splits `curve` at t by `method` and adds what is found against `truth`, which is that of this curve and t.
void judge_split(const SplitKernel& method, const CurveView<double>& curve, double t, const SplitTruth& truth,
                 std::uint64_t trial, SubdivisionErrors& errors);

}  // namespace bezierbench::studies

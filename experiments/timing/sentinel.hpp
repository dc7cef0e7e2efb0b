// SPDX-License-Identifier: MIT
// Fixed work that runs beside every race: when it takes longer, the machine changed, not the methods.
//
// The work is a chain, x <- 1 - 1 x, in which every step waits for the one before: one product and one difference, a
// fixed number of cycles whatever else the processor could do at once. Started from 1/4, x alternates between 3/4 and
// 1/4 without rounding, so that the result is known.
#pragma once

#include "experiments/timing/race.hpp"

namespace bezierbench::timing {

inline constexpr std::string_view sentinel_name = "sentinel";

/// The sentinel as a contestant; a point is one step of the chain.
Rival sentinel();

/// A race in which the sentinel is slower than in the fastest by more than this is run again: twice the practical
/// margin of verdicts.
inline constexpr double tolerated_drift = 0.02;

}  // namespace bezierbench::timing

// SPDX-License-Identifier: MIT
// Fixed work that runs beside every race: when it takes longer, the machine changed, not the methods.
//
// Two kinds, for what slows the one may leave the other as it was. Another thread on the same core takes half of its
// arithmetic units, but not of those cycles in which a chain waits for its last result. The chain, x <- 1 - 1 x, lets
// every step wait for the one before: one product and one difference, a fixed number of cycles whatever else the
// processor could do at once. The sweep does the same steps on many numbers, none of which waits for another, so that
// it takes as long as the core needs to issue, load, compute and store. Started from 1/4, x alternates between 3/4 and
// 1/4 without rounding, so that the results are known.
#pragma once

#include <array>

#include "experiments/race/race.hpp"

namespace bezierbench::race {

/// What timing.csv calls the chain, in whose units it also states times.
inline constexpr std::string_view sentinel_name = "sentinel";

/// The chain as a contestant; a point is one step.
Rival chain_sentinel();
/// The sweep; a point is one step of one number.
Rival sweep_sentinel();

/// Both, as they end the list of rivals: the sweep, then the chain.
std::array<Rival, 2> sentinels();

}  // namespace bezierbench::race

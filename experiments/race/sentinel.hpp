// SPDX-License-Identifier: MIT
// Fixed work that runs beside every race: when it takes longer, the machine changed, not the methods.
//
// There are two sentinels, because a disturbance may slow only one of them. Another thread on the same core takes half
// of its arithmetic units, but not the cycles in which a chain waits for its last result. The chain, x <- 1 - 1 x, is
// bound by latency: every step waits for the one before, one product and one difference. The sweep is bound by
// throughput: it does the same steps on many independent numbers, which take as long as the core needs to issue, load,
// compute and store. Started from 1/4, x alternates between 3/4 and 1/4 without rounding, so that the results are
// known.
#pragma once

#include <array>

#include "experiments/race/rounds.hpp"

namespace bezierbench::race {

/// The name of the chain in timing.csv, which also states times in units of it.
inline constexpr std::string_view sentinel_name = "sentinel";

/// The chain as a rival; a point is one step.
Rival chain_sentinel();
/// The sweep; a point is one step of one number.
Rival sweep_sentinel();

/// Both sentinels in the order in which they end the list of rivals: the sweep, then the chain.
std::array<Rival, 2> sentinels();

}  // namespace bezierbench::race

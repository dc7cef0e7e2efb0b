// SPDX-License-Identifier: MIT
// Fixed work that runs beside every race: when it takes longer, the machine changed, not the methods.
//
// The work is a chain, x <- 1 - 1 x, in which every step waits for the one before: one product and one difference, a
// fixed number of cycles whatever else the processor could do at once. Started from 1/4, x alternates between 3/4 and
// 1/4 without rounding, so that the result is known.
#pragma once

#include <span>

#include "experiments/timing/race.hpp"

namespace bezierbench::timing {

inline constexpr std::string_view sentinel_name = "sentinel";

/// The sentinel as a contestant; a point is one step of the chain.
Rival sentinel();

/// The medians of the first and of the second half of a race's rounds, in order of size.
struct HalfMedians {
  double fast;
  double slow;
};

/// At least one round.
HalfMedians half_medians(std::span<const double> ns_per_point);

/// More of the sentinel's drift than this and a race is run again. A race whose halves differ by 2 % has its medians
/// within 1 %, the practical margin of verdicts, of either half's.
inline constexpr double tolerated_drift = 0.02;

/// By how much the slower half of a race is slower than the fastest half of all races that are compared.
constexpr double drift(const HalfMedians& race, double fastest) { return race.slow / fastest - 1; }

}  // namespace bezierbench::timing

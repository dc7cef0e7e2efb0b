// SPDX-License-Identifier: MIT
// The clock of races, and the check that it is fit for them. A clock that stands still, goes back or has coarse steps
// gives plausible but wrong times, or lets a race wait for ever.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace bezierbench::race {

/// Nanoseconds since a moment that stays the same.
using Clock = std::int64_t (*)();

/// std::chrono::steady_clock.
std::int64_t steady_ns();

/// The least time of one rival's turn in one round of a race, unless its options say otherwise.
inline constexpr double shortest_turn_seconds = 5e-5;

/// The largest step of a clock, as a share of a turn: the practical margin of verdicts. A coarser clock could cause or
/// hide a difference of that size.
inline constexpr double largest_step_share = 0.01;

/// Says why the clock cannot time turns of this length; empty where it can. Reads the clock a million times at most, so
/// it ends even if the clock stands still. A step is the least change seen between two readings, the time that a
/// reading takes included.
std::optional<std::string> clock_fault(Clock clock, double turn_seconds = shortest_turn_seconds);

/// Throws Failure(Exit::environment) where the clock of races is not fit for them.
void require_steady_clock();

/// Ends the program: Failure(Exit::environment).
[[noreturn]] void refuse_clock(const std::string& fault);

}  // namespace bezierbench::race

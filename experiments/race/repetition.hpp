// SPDX-License-Identifier: MIT
// A race is run in repetitions, which are spread over the time of the whole suite. A repetition allocates its own memory
// for results and prepared states, and has its own stack offset. Statistics of a time or a ratio are over repetitions.
//
// The rounds of one repetition share conditions (addresses of stack and data, speed of the processor) that differ
// between repetitions. The spread of the rounds does not show that difference: an interval from all rounds, as if they
// were independent, would become ever narrower around the conditions of one run. So each repetition is one observation:
// its median over rounds, in which all rivals met the same conditions. Kalibera and Jones, Rigorous benchmarking in
// reasonable time (ISMM 2013), section 4, say why to repeat the highest level that varies. Hurlbert, Pseudoreplication
// and the design of ecological field experiments (Ecological Monographs 54, 1984, 187-211), says what becomes of
// intervals if dependent observations count as independent. Mytkowicz, Diwan, Hauswirth and Sweeney, Producing wrong
// data without doing anything obviously wrong (ASPLOS 2009), section 4, show that the address of the stack alone can
// bias a time by more than the difference that is compared.
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "experiments/race/race.hpp"

namespace bezierbench::race {

/// Enough repetitions that the median's interval of metric::timing_confidence leaves out the smallest and the largest
/// one, which other processes may have disturbed: 2 (1 + 12) / 2^12 = 0.6 %. With 8 to 11 it is the whole range. No
/// distribution is assumed; Student's interval on logarithms would be a tenth narrower for a normal distribution, which
/// repetitions do not have.
inline constexpr std::size_t repetitions_per_race = 12;

/// The limits of one race, divided among its repetitions.
RaceOptions options_of_a_repetition();

/// Median over the rounds of one repetition.
double median_ns(const Lap& repetition);

/// Median over the rounds of one repetition of the time over another rival's in the same round.
double median_ratio(const Lap& repetition, const Lap& base);

/// These ratios for each repetition; both rivals took part in all of them.
std::vector<double> repetition_ratios(std::span<const Lap> repetitions, std::span<const Lap> base);

// Runs code with an offset of its stack. Local arrays that straddle cache lines, or share sets of a cache with the
// data, cost time that is not the method's, so several offsets are tried.

/// Calls `body()` with the stack 528 * step bytes further down: each step has another 16-byte offset within a cache
/// line and another eighth of a page. step < 1024.
template <class Body>
[[gnu::noinline]] auto with_stack_moved(std::size_t step, Body&& body) {
  constexpr std::size_t bytes_per_step = 528;
  auto* room = static_cast<volatile char*>(__builtin_alloca(bytes_per_step * step + 1));
  *room = 0;  // keeps the compiler from removing the allocation
  return std::forward<Body>(body)();
}

}  // namespace bezierbench::race

// SPDX-License-Identifier: MIT
// A race is run in repetitions, each with memory allocated anew and the stack elsewhere, spread over the time of the
// whole suite; what is said of a time or a ratio is said of the repetitions.
//
// What rounds of one repetition share (where the stack and the data lie, how fast the processor happens to be) differs
// from repetition to repetition, and the spread of rounds does not show it: an interval from all rounds together, as if
// these were independent, grows ever narrower around what one run happened to meet. So each repetition is one
// observation: its median over rounds, in which rivals met the same machine. That repetition belongs at the highest
// level that varies: Kalibera and Jones, Rigorous benchmarking in reasonable time (ISMM 2013), section 4; what counting
// the lower ones as independent does to intervals: Hurlbert, Pseudoreplication and the design of ecological field
// experiments (Ecological Monographs 54, 1984, 187-211). That the place of the stack alone can bias a time more than
// what is compared: Mytkowicz, Diwan, Hauswirth and Sweeney, Producing wrong data without doing anything obviously
// wrong (ASPLOS 2009), section 4.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "experiments/race/race.hpp"

namespace bezierbench::race {

/// So many that the median's interval of metric::timing_confidence leaves out the least and the greatest, in which
/// others may have been at work: 2 (1 + 12) / 2^12 = 0.6 %. Of 8 to 11 it is the whole range. Nothing is assumed of how
/// repetitions differ; Student's interval on logarithms would be a tenth narrower if they were normal, and they are
/// not.
inline constexpr std::size_t repetitions_per_race = 12;

/// What a race may take, divided among its repetitions.
RaceOptions options_of_a_repetition();

/// Median over the rounds of one repetition.
double median_ns(const Lap& repetition);

/// Median over the rounds of one repetition of the time over another rival's in the same round.
double median_ratio(const Lap& repetition, const Lap& base);

/// The same of each repetition; both rivals were in all of them.
std::vector<double> repetition_ratios(std::span<const Lap> repetitions, std::span<const Lap> base);

}  // namespace bezierbench::race

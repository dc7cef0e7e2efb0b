// SPDX-License-Identifier: MIT
// Times of one method in two programs. Both run in turn, so that what changes on the machine affects both alike, and
// each pair of runs gives one ratio. In every second pair the other program goes first.
//
// A pair is one observation, as a repetition is in a race (experiments/race/race.hpp): every process has its own
// addresses of stack, heap and code, which may change a time by more than the difference that is looked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/compare/rows.hpp"
#include "experiments/metric/order_statistics.hpp"
#include "experiments/metric/verdict.hpp"

namespace bezierbench::cli {

struct PairedTime {
  compare::Inputs inputs;   ///< the row of timing.csv
  metric::Interval before;  ///< nanoseconds per point
  metric::Interval after;   ///< likewise
  metric::Interval ratio;   ///< after over before, of the pairs
  metric::Verdict verdict;  ///< unresolved where there are too few pairs for an interval
  bool right = true;        ///< whether every timed result was the judged one
};

/// What one row says; element k of both is pair k. Not empty.
PairedTime paired_time(compare::Inputs inputs, const std::vector<double>& before_ns,
                       const std::vector<double>& after_ns);

struct TimedPrograms {
  std::filesystem::path before;
  std::filesystem::path after;
  std::filesystem::path suite;    ///< a file with timing studies
  std::filesystem::path scratch;  ///< a folder for their bundles
};

/// Runs both programs `pairs` times. Rows that only one of them has are left out. Throws Failure where a program fails.
std::vector<PairedTime> paired_times(const TimedPrograms& programs, const std::string& method, int pairs);

}  // namespace bezierbench::cli

// SPDX-License-Identifier: MIT
// An estimate of what a run will take. Small pilots of its studies are run and measured on this machine, so that the
// program has no numbers for machines, compilers or methods, which would become wrong in time.
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/run/kinds.hpp"

namespace bezierbench::run {

/// What a study takes on this machine.
struct StudyEstimate {
  double per_cost = 0;       ///< nanoseconds of processor time per unit of Job::cost
  double result_bytes = 0;   ///< of the results of all blocks, as files of blocks hold them
  double result_memory = 0;  ///< of the same in memory
  /// The bytes of a result grow with this power of the number of trials; 0 where more trials add none.
  double result_exponent = 0;
};

/// Runs pilots of a study until they have taken long enough to be timed: blocks of a few trials each, of parts that are
/// chosen in proportion to their cost. Timing studies have no trials to leave out, so whole blocks of them are run.
/// Takes some tenths of a second, or as long as two trials take. After an interruption the estimate means nothing.
StudyEstimate estimate(const suite::Study& study, const Kinds& kinds, const JobContext& context);

}  // namespace bezierbench::run

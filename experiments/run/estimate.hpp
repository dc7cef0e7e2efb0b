// SPDX-License-Identifier: MIT
// What a run will take, before it is done: small pilots of its studies are run and measured on this machine, so that
// no number for a machine, a compiler or a method stands in the program and grows old there.
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
  /// Of so many times the trials a result takes so many times the bytes, to this power; 0 where it is full.
  double result_exponent = 0;
};

/// Runs pilots of a study: some blocks of a few trials each, of parts that stand for all by their cost, until they have
/// taken long enough to be timed. A study of races is cut by no number of trials, so that whole blocks of it are run.
/// Takes some tenths of a second, or as long as two trials take. One that is interrupted says nothing of use.
StudyEstimate estimate(const suite::Study& study, const Kinds& kinds, const JobContext& context);

}  // namespace bezierbench::run

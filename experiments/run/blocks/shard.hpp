// SPDX-License-Identifier: MIT
// Which blocks of a run are whose, where several processes share it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "experiments/run/blocks/block_set.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::run {

struct Shard {
  std::uint64_t number = 1;  ///< from 1
  std::uint64_t count = 1;
};

/// The blocks of this shard: one slice of every job, of about equal cost; the slices move on from job to job, so that
/// small jobs do not all fall to the same shard. Timings (`exclusive`) belong to the first shard as a whole, for times
/// of several machines, or taken beside each other, do not compare. Every block is exactly one shard's.
BlockSet::Run dealt(const Job& job, std::size_t job_number, const Shard& shard);

}  // namespace bezierbench::run

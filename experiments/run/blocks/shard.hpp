// SPDX-License-Identifier: MIT
// The blocks of each process where several share a run.
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
/// small jobs do not all fall to the same shard. Timings (`exclusive`) belong to the first shard as a whole, because
/// times of several machines, or of processes that run at the same time, cannot be compared. Every block belongs to
/// exactly one shard.
BlockSet::Run dealt(const Job& job, std::size_t job_number, const Shard& shard);

}  // namespace bezierbench::run

// SPDX-License-Identifier: MIT
// The order of exclusive blocks, beside which nothing else may run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/run/blocks/block_set.hpp"
#include "experiments/run/blocks/checkpoints.hpp"

namespace bezierbench::run {

struct BlockOfJob {
  std::size_t job;
  std::uint64_t block;
  friend bool operator==(const BlockOfJob&, const BlockOfJob&) = default;
};

/// The blocks of the exclusive jobs; `blocks[job]` holds whole parts of a job. The first block of every part of every
/// job comes first, then the second, and so on, so that the blocks of a part are spread over the time of the whole
/// suite. A disturbance of the machine then affects some blocks of many parts rather than all blocks of a few.
std::vector<BlockOfJob> exclusive_order(const Jobs& jobs, std::span<const BlockSet::Run> blocks);

}  // namespace bezierbench::run

// SPDX-License-Identifier: MIT
// The part of a run that this process does, by --shard: the blocks of each process where several share a run, and the
// order in which it runs those beside which nothing else may run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "experiments/run/blocks/checkpoints.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::run {

/// The blocks of this shard: one slice of every job, of about equal cost; the slices move on from job to job, so that
/// small jobs do not all fall to the same shard. Timings (`exclusive`) belong to the first shard as a whole, because
/// times of several machines, or of processes that run at the same time, cannot be compared. Every block belongs to
/// exactly one shard.
BlockSet::Run dealt(const Job& job, std::size_t job_number, const Shard& shard);

struct BlockOfJob {
  std::size_t job;
  std::uint64_t block;
  friend bool operator==(const BlockOfJob&, const BlockOfJob&) = default;
};

/// The blocks of the exclusive jobs; `blocks[job]` holds whole parts of a job. The first block of every part of every
/// job comes first, then the second, and so on, so that the blocks of a part are spread over the time of the whole
/// suite. A disturbance of the machine then affects some blocks of many parts rather than all blocks of a few.
std::vector<BlockOfJob> exclusive_order(const Jobs& jobs, std::span<const BlockSet::Run> blocks);

/// The work of one process. Jobs and checkpoints must outlive it.
class Share {
 public:
  Share(const Jobs& jobs, const Checkpoints& checkpoints, const Shard& shard);

  [[nodiscard]] BlockSet::Run blocks(std::size_t job) const { return blocks_[job]; }
  [[nodiscard]] const std::vector<BlockSet::Run>& blocks() const { return blocks_; }
  [[nodiscard]] std::uint64_t count(std::size_t job) const { return blocks(job).second - blocks(job).first; }
  [[nodiscard]] std::uint64_t count_done(std::size_t job) const {
    return checkpoints_.done(job).within(blocks(job)).size();
  }
  /// Of all jobs.
  [[nodiscard]] std::uint64_t count() const;
  [[nodiscard]] std::uint64_t count_done() const;
  /// The cost of the blocks that are not done, in nanoseconds; see Job::cost().
  [[nodiscard]] double cost_left(std::size_t job) const;

 private:
  const Jobs& jobs_;
  const Checkpoints& checkpoints_;
  std::vector<BlockSet::Run> blocks_;  ///< per job
};

/// The value of an environment variable, or nullptr; tests replace std::getenv.
using Environment = std::function<const char*(const char*)>;

/// Parses `i/N`, or `auto` for the values that Open MPI, PMI (MPICH and others) or Slurm set for their processes. In an
/// array of jobs with several processes each, N is the product of both numbers. Throws Failure(usage).
Shard shard_of(std::string_view text, const Environment& environment);

}  // namespace bezierbench::run

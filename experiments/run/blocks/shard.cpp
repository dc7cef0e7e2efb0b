// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/shard.hpp"

#include <algorithm>
#include <cmath>

namespace bezierbench::run {
namespace {

/// The first block such that the blocks before it have at least this share of the job's cost.
std::uint64_t boundary(const Job& job, double share) {
  const auto each = job.blocks_per_part();
  const double wanted = share * job.total_cost();
  double before = 0;
  for (std::size_t part = 0; part < job.parts(); ++part) {
    const double cost = job.cost(part);
    const double whole = cost * static_cast<double>(each);
    if (before + whole > wanted) {
      const double blocks = std::ceil((wanted - before) / cost);
      return part * each + std::min<std::uint64_t>(each, static_cast<std::uint64_t>(std::max(0.0, blocks)));
    }
    before += whole;
  }
  return job.blocks();
}

}  // namespace

BlockSet::Run dealt(const Job& job, std::size_t job_number, const Shard& shard) {
  if (shard.count == 1) return {0, job.blocks()};
  if (job.exclusive()) return {0, shard.number == 1 ? job.blocks() : 0};
  const auto slice = (shard.number - 1 + job_number) % shard.count;
  const auto end_of = [&](std::uint64_t slices) -> std::uint64_t {
    if (slices == 0) return 0;
    if (slices == shard.count) return job.blocks();
    return boundary(job, static_cast<double>(slices) / static_cast<double>(shard.count));
  };
  return {end_of(slice), end_of(slice + 1)};
}

}  // namespace bezierbench::run

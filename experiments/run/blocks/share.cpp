// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/share.hpp"

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

std::vector<BlockOfJob> exclusive_order(const Jobs& jobs, std::span<const BlockSet::Run> blocks) {
  std::size_t most = 0;
  for (const auto& job : jobs) most = std::max(most, job->exclusive() ? job->blocks_per_part() : 0);
  std::vector<BlockOfJob> order;
  for (std::size_t k = 0; k < most; ++k)
    for (std::size_t job = 0; job < jobs.size(); ++job) {
      const auto each = jobs[job]->blocks_per_part();
      if (!jobs[job]->exclusive() || k >= each) continue;
      for (auto block = blocks[job].first + k; block < blocks[job].second; block += each) order.push_back({job, block});
    }
  return order;
}

Share::Share(const Jobs& jobs, const Checkpoints& checkpoints, const Shard& shard)
    : jobs_(jobs), checkpoints_(checkpoints) {
  for (std::size_t job = 0; job < jobs.size(); ++job) blocks_.push_back(dealt(*jobs[job], job, shard));
}

std::uint64_t Share::count() const {
  std::uint64_t sum = 0;
  for (std::size_t job = 0; job < jobs_.size(); ++job) sum += count(job);
  return sum;
}

std::uint64_t Share::count_done() const {
  std::uint64_t sum = 0;
  for (std::size_t job = 0; job < jobs_.size(); ++job) sum += count_done(job);
  return sum;
}

double Share::cost_left(std::size_t number) const {
  const Job& job = *jobs_[number];
  const auto each = job.blocks_per_part();
  const auto [first, end] = blocks(number);
  double sum = 0;
  for (std::uint64_t at = first; at < end;) {
    const auto part = job.part_of(at);
    const BlockSet::Run run{at, std::min<std::uint64_t>(end, (part + 1) * each)};
    sum += job.cost(part) * static_cast<double>(run.second - run.first - checkpoints_.done(number).within(run).size());
    at = run.second;
  }
  return sum;
}

}  // namespace bezierbench::run

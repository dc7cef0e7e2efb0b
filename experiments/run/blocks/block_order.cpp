// SPDX-License-Identifier: MIT
#include "experiments/run/blocks/block_order.hpp"

#include <algorithm>

namespace bezierbench::run {

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

}  // namespace bezierbench::run

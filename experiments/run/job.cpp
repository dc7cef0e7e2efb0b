// SPDX-License-Identifier: MIT
#include "experiments/run/job.hpp"

namespace bezierbench::run {

void Job::add(std::size_t part, std::unique_ptr<Result> result) {
  if (totals_.empty()) totals_.resize(parts());
  auto& total = totals_[part];
  if (total)
    total->merge(*result);
  else
    total = std::move(result);
}

double Job::total_cost() const {
  double sum = 0;
  for (std::size_t part = 0; part < parts(); ++part) sum += cost(part) * static_cast<double>(blocks_per_part());
  return sum;
}

void run_all(Job& job) {
  for (std::size_t block = 0; block < job.blocks(); ++block) job.add(job.part_of(block), job.run_block(block));
}

}  // namespace bezierbench::run

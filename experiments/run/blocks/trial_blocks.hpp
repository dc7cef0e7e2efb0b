// SPDX-License-Identifier: MIT
// The trials of a part of a job, cut into blocks, and the loop over the trials of one block.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "experiments/run/interruption.hpp"

namespace bezierbench::run {

/// Consecutive trials of one replicate.
struct TrialBlock {
  std::int64_t replicate;
  std::int64_t first;
  std::int64_t end;  ///< one past the last
};

/// Cuts every replicate into blocks of at most `most` trials, the last of which may be shorter. A block has trials of
/// one replicate only; studies that do not tell replicates apart take all trials as one.
class TrialBlocks {
 public:
  TrialBlocks(std::int64_t trials, std::int64_t replicates, std::int64_t most)
      : trials_(trials), replicates_(replicates), most_(most) {}

  [[nodiscard]] std::int64_t per_replicate() const { return (trials_ - 1) / most_ + 1; }
  [[nodiscard]] std::size_t count() const { return static_cast<std::size_t>(per_replicate() * replicates_); }
  /// The number of trials of a full block.
  [[nodiscard]] std::int64_t full() const { return std::min(trials_, most_); }
  /// The trials of block `number`, from 0 on.
  [[nodiscard]] TrialBlock operator[](std::size_t number) const {
    const auto block = static_cast<std::int64_t>(number);
    const auto first = block % per_replicate() * most_;
    return {block / per_replicate(), first, std::min(trials_, first + most_)};
  }

 private:
  std::int64_t trials_;
  std::int64_t replicates_;
  std::int64_t most_;
};

/// Calls visit(first trial, number of trials) for groups of at most `together` consecutive trials, until an
/// interruption arrives.
template <class Visit>
void each_group(const TrialBlock& block, std::int64_t together, const Visit& visit) {
  for (auto trial = block.first; trial < block.end && !interrupted(); trial += together)
    visit(trial, std::min(together, block.end - trial));
}

/// Calls visit(trial) for every trial, until an interruption arrives.
template <class Visit>
void each_trial(const TrialBlock& block, const Visit& visit) {
  each_group(block, 1, [&](std::int64_t trial, std::int64_t /*count*/) { visit(trial); });
}

}  // namespace bezierbench::run

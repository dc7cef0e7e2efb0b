// SPDX-License-Identifier: MIT
// A set of block numbers, kept as runs of consecutive numbers: there may be too many blocks to list in memory.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace bezierbench::run {

class BlockSet {
 public:
  using Run = std::pair<std::uint64_t, std::uint64_t>;  ///< first block, and the one after the last

  BlockSet() = default;
  explicit BlockSet(const std::vector<Run>& runs) {
    for (const Run& run : runs) insert(run);
  }

  /// Adds the blocks of `run`, which may be empty.
  void insert(Run run) {
    if (run.first >= run.second) return;
    auto next = ends_.upper_bound(run.first);
    if (next != ends_.begin() && std::prev(next)->second >= run.first) {
      --next;
      run.first = next->first;
    }
    while (next != ends_.end() && next->first <= run.second) {
      run.second = std::max(run.second, next->second);
      next = ends_.erase(next);
    }
    ends_.emplace(run.first, run.second);
  }
  void insert(std::uint64_t block) { insert(Run{block, block + 1}); }
  void insert(const BlockSet& other) {
    for (const auto& run : other.ends_) insert(Run(run));
  }

  [[nodiscard]] bool contains(std::uint64_t block) const { return overlaps(Run{block, block + 1}); }
  [[nodiscard]] bool overlaps(Run run) const {
    const auto next = ends_.lower_bound(run.second);
    return run.first < run.second && next != ends_.begin() && std::prev(next)->second > run.first;
  }
  [[nodiscard]] bool overlaps(const BlockSet& other) const {
    return std::ranges::any_of(other.ends_, [this](const auto& run) { return overlaps(Run(run)); });
  }

  [[nodiscard]] bool empty() const { return ends_.empty(); }
  [[nodiscard]] std::uint64_t size() const {
    std::uint64_t sum = 0;
    for (const auto& [first, end] : ends_) sum += end - first;
    return sum;
  }
  [[nodiscard]] std::vector<Run> runs() const { return {ends_.begin(), ends_.end()}; }
  /// The parts of `run` that are in the set.
  [[nodiscard]] BlockSet within(Run run) const {
    BlockSet both;
    auto next = ends_.upper_bound(run.first);
    if (next != ends_.begin()) --next;
    for (; next != ends_.end() && next->first < run.second; ++next)
      both.insert(Run{std::max(run.first, next->first), std::min(run.second, next->second)});
    return both;
  }

 private:
  std::map<std::uint64_t, std::uint64_t> ends_;  ///< first to end; neither overlapping nor touching
};

}  // namespace bezierbench::run

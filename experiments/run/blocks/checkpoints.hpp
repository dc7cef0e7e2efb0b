// SPDX-License-Identifier: MIT
// Finished blocks of a run, in memory and on disk. Results of blocks are added and written to files at intervals, so
// that a run that was killed can be continued.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/bundle/block_file.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::run {

// A set of block numbers, kept as runs of consecutive numbers: there may be too many blocks to list in memory.

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

using Jobs = std::vector<std::unique_ptr<Job>>;

/// A readable file of blocks.
struct FoundBlocks {
  std::filesystem::path path;
  bundle::BlockFile file;
};

/// The files in a folder of blocks, in order of their names; of damaged files only the path.
struct Found {
  std::vector<FoundBlocks> readable;
  std::vector<std::filesystem::path> damaged;

  [[nodiscard]] bool empty() const { return readable.empty() && damaged.empty(); }
};

/// Reads blocks/ of a bundle; empty where there is none. Throws Failure(input_output) for what cannot be read.
Found find_blocks(const std::filesystem::path& folder);

class Checkpoints {
 public:
  /// The name of this process among those that write; it begins the names of its files.
  struct Owner {
    std::filesystem::path folder;  ///< blocks/
    std::string writer;
    bundle::Manifest manifest;
    std::string reference;                                   ///< the tier
    std::string machine;                                     ///< fingerprint; timings of other machines do not count
    std::optional<std::chrono::milliseconds> interval = {};  ///< between two files; if empty, see add()
  };

  Checkpoints(const Jobs& jobs, Owner owner);

  /// Adds the results that were found to the jobs, of all writers or of this one alone, unless they overlap with blocks
  /// that are there already. Blocks of other writers then count as done(), but not as settled(). Returns one line for
  /// each file that was skipped.
  enum class Whose { all, own };
  std::vector<std::string> load(const Found& found, Whose whose);

  /// True where the block was done when load() was called.
  [[nodiscard]] bool done(std::size_t job, std::uint64_t block) const { return done_[job].contains(block); }
  [[nodiscard]] const BlockSet& done(std::size_t job) const { return done_[job]; }
  /// Whether the results of all blocks of all jobs were added.
  [[nodiscard]] bool all_settled() const;
  [[nodiscard]] const BlockSet& settled(std::size_t job) const { return settled_[job]; }

  /// Takes the result of one block, from any thread, and writes a file when it is time. Without an `interval`, files
  /// are written so rarely that they cost a twentieth of the time, and so often that a killed run loses little more
  /// than a fiftieth. Throws as write_file.
  void add(std::size_t job, std::uint64_t block, std::unique_ptr<Result> result);

  /// Writes the results that are in no file yet. Throws as write_file.
  void checkpoint();
  /// Adds the remaining results to the jobs, and writes nothing.
  void settle();

 private:
  using Clock = std::chrono::steady_clock;
  /// Results that no file holds yet.
  struct Slot {
    std::mutex mutex;
    std::unique_ptr<Result> fresh;
    BlockSet blocks;
  };

  void load_record(const FoundBlocks& from, const bundle::BlockRecord& record, Whose whose,
                   std::vector<std::string>& notes);
  [[nodiscard]] bool is_own(const std::filesystem::path& path) const;
  [[nodiscard]] BlockSet::Run blocks_of(std::size_t job, std::uint64_t part) const;
  /// Adds all fresh results to the jobs; returns them as records on request.
  void drain(std::vector<bundle::BlockRecord>* records);
  void write_checkpoint();
  [[nodiscard]] Clock::duration pause_after(Clock::duration cost) const;

  const Jobs& jobs_;
  Owner owner_;
  std::vector<BlockSet> done_;           ///< per job; constant while blocks are added
  std::vector<std::deque<Slot>> slots_;  ///< per job and part

  std::mutex mutex_;  ///< guards all below, and the jobs' totals
  std::vector<BlockSet> settled_;
  std::uint64_t next_number_ = 1;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point next_checkpoint_ = start_;
};

}  // namespace bezierbench::run

// SPDX-License-Identifier: MIT
// What is done of a run, in memory and on disk: results of blocks go in, files of blocks come out every now and then,
// and whoever comes after a killed run goes on from there.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/block_file.hpp"
#include "experiments/run/blocks/block_set.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::run {

using Jobs = std::vector<std::unique_ptr<Job>>;

/// A readable file of blocks.
struct FoundBlocks {
  std::filesystem::path path;
  bundle::BlockFile file;
};

/// What lies in a folder of blocks, by name; damaged files only by their path.
struct Found {
  std::vector<FoundBlocks> readable;
  std::vector<std::filesystem::path> damaged;
};

/// Reads blocks/ of a bundle; empty where there is none. Throws Failure(input_output) for what cannot be read.
Found find_blocks(const std::filesystem::path& folder);

class Checkpoints {
 public:
  /// Who writes: files of this writer are named after it.
  struct Owner {
    std::filesystem::path folder;  ///< blocks/
    std::string writer;
    bundle::Manifest manifest;
    std::string reference;                                   ///< the tier
    std::string machine;                                     ///< fingerprint; timings of other machines do not count
    std::optional<std::chrono::milliseconds> interval = {};  ///< between two files; left out: see add()
  };

  Checkpoints(const Jobs& jobs, Owner owner);

  /// Adds to the jobs what was found, where it does not overlap with what is there already: of all writers, or of this
  /// one alone. Blocks of other writers then count as done(), but not as settled(). Returns what had to be passed over,
  /// one line each.
  enum class Whose { all, own };
  std::vector<std::string> load(const Found& found, Whose whose);

  /// Was it done when load() was called?
  [[nodiscard]] bool done(std::size_t job, std::uint64_t block) const { return done_[job].contains(block); }
  [[nodiscard]] const BlockSet& done(std::size_t job) const { return done_[job]; }
  /// Whether the results of all blocks of all jobs were added.
  [[nodiscard]] bool all_settled() const;
  [[nodiscard]] const BlockSet& settled(std::size_t job) const { return settled_[job]; }

  /// Takes the result of one block, from any thread, and writes a file when it is time: unless the owner says when,
  /// rarely enough that writing costs a twentieth of the time, often enough that a killed run loses two seconds at
  /// most. Throws as write_file.
  void add(std::size_t job, std::uint64_t block, std::unique_ptr<Result> result);

  struct Files {
    double written = 0;   ///< about, at the longest interval
    double gathered = 0;  ///< the share of them that was gathered into one
  };
  /// Of a run that takes so many seconds.
  [[nodiscard]] static Files files_of(double seconds);

  /// Writes what is in no file yet. Throws as write_file.
  void checkpoint();
  /// Adds to the jobs what was not added yet, and writes nothing.
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
  /// All fresh results, added to the jobs, and as records where these are asked for.
  void drain(std::vector<bundle::BlockRecord>* records);
  [[nodiscard]] std::vector<bundle::BlockRecord> everything() const;
  void write(std::vector<bundle::BlockRecord> records);
  void write_checkpoint();
  [[nodiscard]] Clock::duration pause_after(Clock::duration cost) const;

  const Jobs& jobs_;
  Owner owner_;
  std::vector<BlockSet> done_;           ///< per job; constant while blocks are added
  std::vector<std::deque<Slot>> slots_;  ///< per job and part

  std::mutex mutex_;  ///< guards all below, and the jobs' totals
  std::vector<BlockSet> settled_;
  std::vector<std::filesystem::path> files_;  ///< that hold nothing but what is settled
  std::uint64_t next_number_ = 1;
  Clock::time_point next_checkpoint_;
};

}  // namespace bezierbench::run

// SPDX-License-Identifier: MIT
// The bundle's folder while runs work in it: the locks that decide which processes may be there and write.
#pragma once

#include <optional>
#include <string>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/lock_file.hpp"
#include "experiments/run/plan.hpp"

namespace bezierbench::run {

/// Fingerprint of the machine that the bundle's machine.json describes, or else of this one.
std::string machine_of(const RunRequest& request);

/// Locks are files in blocks/, which is removed when the bundle is complete:
///   run.lock       held by a run alone, or by shards together
///   WRITER.lock    held by the process of this shard
///   bundle.lock    held for moments, by whoever writes outside blocks/
class RunFolder {
 public:
  /// Makes the folder where it is absent. Throws Failure(input_output) where another process does the same work.
  RunFolder(const RunRequest& request, const Plan& plan);

  /// Writes the files that describe a bundle before it has results. False where the bundle is complete.
  bool begin();

  [[nodiscard]] const bundle::BundleDirectory& directory() const { return directory_; }
  /// The finished blocks, all of this run. To be called after begin().
  [[nodiscard]] const Found& found() const { return found_; }
  [[nodiscard]] Checkpoints::Owner owner() const;

  /// Waits for the lock. While the guard lives, no other process writes outside blocks/. Throws Failure(interrupted).
  class Guard {
   public:
    explicit Guard(bundle::LockFile& lock) : lock_(lock) {}
    ~Guard() { lock_.unlock(); }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;
    Guard(Guard&&) = delete;
    Guard& operator=(Guard&&) = delete;

   private:
    bundle::LockFile& lock_;
  };
  [[nodiscard]] Guard lock_bundle();

 private:
  void claim(bundle::LockFile& lock, bundle::Sharing sharing, const std::string& holder);
  void choose_machine();

  const RunRequest& request_;
  const Plan& plan_;
  bundle::BundleDirectory directory_;
  std::string writer_;
  bundle::LockFile run_lock_;
  bundle::LockFile bundle_lock_;
  std::optional<bundle::LockFile> shard_lock_;
  std::string machine_;  ///< fingerprint
  Found found_;
};

}  // namespace bezierbench::run

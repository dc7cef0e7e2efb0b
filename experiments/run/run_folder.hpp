// SPDX-License-Identifier: MIT
// A bundle's folder as runs, shards and merges meet it: what it holds, who works there, and how it is written.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/lock_file.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/plan.hpp"

namespace bezierbench::run {

/// How results of another run are refused.
struct Refusal {
  Exit exit;
  std::string_view advice;
};
inline constexpr Refusal run_refusal{Exit::usage, "choose another --out or move it away"};
inline constexpr Refusal merge_refusal{Exit::finding, "merge what one program made of one suite"};

/// The files of a bundle whose blocks are all done.
struct WholeBundle {
  /// Name and bytes of each file, in the order in which to write them. bundle.json, digests.csv and SHA256SUMS follow
  /// from them.
  std::vector<std::pair<std::string, std::string>> files;
  std::vector<bundle::MethodDigest> digests;
};

/// The tables of a run as files.
WholeBundle written(const tables::Tables& tables);

/// Locks are files in blocks/, which is removed when the bundle is complete:
///   run.lock       held by a run or a merge alone, or by shards together
///   WRITER.lock    held by the process of this shard
///   bundle.lock    held for moments, by the shard that writes outside blocks/
class RunFolder {
 public:
  /// Looks at the folder, which may be absent. Throws as look().
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) { look(); }

  /// Reads what the folder holds now, except its blocks. Throws Failure(input_output) for a file that cannot be read.
  void look();
  /// Reads the finished blocks.
  void read_blocks() { found_ = find_blocks(blocks()); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path blocks() const { return path_ / "blocks"; }
  /// Whether there is a bundle.
  [[nodiscard]] bool is_begun() const { return manifest_.has_value(); }
  [[nodiscard]] bool is_complete() const { return is_begun() && manifest_->state == bundle::complete; }
  /// Whether there is blocks/: somebody is at work or was killed.
  [[nodiscard]] bool has_blocks() const { return has_blocks_; }
  /// Of a bundle that was begun.
  [[nodiscard]] const bundle::Manifest& manifest() const { return *manifest_; }
  [[nodiscard]] const bundle::BundleDirectory& directory() const { return *directory_; }
  /// The blocks that read_blocks() found.
  [[nodiscard]] Found& found() { return found_; }
  [[nodiscard]] const Found& found() const { return found_; }

  /// Throws the refusal where the bundle or a file of blocks belongs to another run, and Failure(input_output) where a
  /// file that describes the bundle is damaged.
  void require_same(const RunRequest& request, const Plan& plan, const Refusal& refusal) const;

  /// Makes the folder where it is absent, and takes the locks of a run, or of a shard of it. Throws
  /// Failure(input_output) where another process does the same work, or where the folder holds something else.
  void lock(const std::optional<Shard>& shard);
  /// Takes the lock of a merge. Throws as lock().
  void lock_for_merge();
  /// Waits until no other shard writes outside blocks/. None does while the result lives. Throws Failure(interrupted).
  [[nodiscard]] std::shared_ptr<void> lock_bundle();

  /// Takes the locks, reads the blocks, and writes the files that describe a bundle before it has results. False where
  /// the bundle is complete. Throws as lock() and require_same(), and Failure(input_output) for foreign files.
  [[nodiscard]] bool begin(const RunRequest& request, const Plan& plan);
  /// Writes the bundle and removes blocks/. Throws Failure(input_output) for files that do not belong to it: they would
  /// get into the list of files and, under the name of a table, into the digest. Hidden files are ignored.
  void complete(const Plan& plan, const WholeBundle& whole);
  /// Throws Failure(usage) unless the complete bundle has these files.
  void require_equal(const WholeBundle& whole) const;

  /// Fingerprint of the machine that machine.json describes; empty without one.
  [[nodiscard]] const std::string& machine() const { return machine_; }

 private:
  void claim(const std::string& name, bundle::Sharing sharing, const std::string& holder);
  void refuse_foreign(const std::function<bool(const std::string&)>& is_own) const;
  void write_description(const RunRequest& request, const Plan& plan);
  void choose_machine(const RunRequest& request, const Plan& plan);
  void write_machine(const RunRequest& request);

  std::filesystem::path path_;
  std::optional<bundle::BundleDirectory> directory_;
  std::optional<bundle::Manifest> manifest_;
  std::string machine_;
  bool has_blocks_ = false;
  Found found_;
  std::vector<std::unique_ptr<bundle::LockFile>> locks_;
  std::unique_ptr<bundle::LockFile> bundle_lock_;
};

/// The process among those that write; it begins the names of its files in blocks/.
std::string writer_of(const std::optional<Shard>& shard);

}  // namespace bezierbench::run

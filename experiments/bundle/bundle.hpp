// SPDX-License-Identifier: MIT
// A bundle: the folder that holds everything one run gave, with checksums over it, and the file names that have a
// meaning there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/manifest.hpp"

namespace bezierbench::bundle {

/// Begins the name of a copy of a curve set that the suites of a bundle name: curves_ID.csv.
inline constexpr const char* curves_prefix = "curves_";
[[nodiscard]] constexpr bool is_curves_name(std::string_view name) {
  return name.starts_with(curves_prefix) && name.ends_with(".csv");
}

/// A bundle's folder. Several threads and processes may write different files at once; finish() must run alone.
class BundleDirectory {
 public:
  /// Makes the folder, and blocks/ in it, where they are absent. Throws Failure(Exit::input_output) where it cannot be
  /// made or holds something else: a folder that is not empty must contain bundle.json or blocks/.
  [[nodiscard]] static BundleDirectory create(const std::filesystem::path& path);

  /// Opens an existing bundle. Throws Failure(Exit::input_output) where `path` is not one.
  [[nodiscard]] static BundleDirectory open(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path blocks() const { return path_ / "blocks"; }

  /// Replaces the file `name` as write_file does. A complete bundle first becomes partial, until finish() is called.
  /// Throws as write_file does. Throws std::invalid_argument for a name with a folder in it, a hidden name, bundle.json
  /// and SHA256SUMS; finish() writes the last two.
  void write(std::string_view name, std::string_view bytes) const;

  /// All bytes of the file `name`. Throws as read_file.
  [[nodiscard]] std::string read(std::string_view name) const;

  /// All bytes of the file `name`, if they have the checksum in SHA256SUMS; empty if they do not or if it is not
  /// listed.
  [[nodiscard]] std::optional<std::string> read_if_listed(std::string_view name) const;

  /// The same, but throws Failure(Exit::input_output) where the other is empty.
  [[nodiscard]] std::string read_listed(std::string_view name) const;

  /// The rows of the table `name`, as read_listed; empty where the bundle has no such file, and lists none.
  [[nodiscard]] std::optional<CsvDocument> table(std::string_view name) const;

  /// The path of the file `name`, for messages.
  [[nodiscard]] std::string place(std::string_view name) const { return (path_ / name).string(); }

  /// Whether there is a regular file `name`.
  [[nodiscard]] bool has(std::string_view name) const;

  /// bundle.json. Throws as read_file and parse_manifest.
  [[nodiscard]] Manifest manifest() const;

  /// Completes the manifest with the accuracy digest, which follows from `digests`, those of the rows of all tables.
  /// Writes digests.csv if the bundle is `complete`, then SHA256SUMS, over all regular files but itself and hidden ones,
  /// then bundle.json. No bundle ever says `complete` that is not, wherever this is interrupted. With state `complete`,
  /// also removes blocks/ and files that killed writers left. A bundle that is already so keeps all its bytes. Throws as
  /// write_file does.
  void finish(Manifest manifest, const std::vector<MethodDigest>& digests = {}) const;

  /// Removes blocks/ and the files that killed writers left. Throws Failure(Exit::input_output).
  void clear_away() const;

 private:
  explicit BundleDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  void make_partial_before_change() const;
  void write_if_different(std::string_view name, std::string_view bytes) const;

  std::filesystem::path path_;
};

inline constexpr std::string_view manifest_name = "bundle.json";
inline constexpr std::string_view sums_name = "SHA256SUMS";
inline constexpr std::string_view blocks_name = "blocks";

/// Names in a folder, each list sorted by name as bytes.
struct Folder {
  std::vector<std::string> files;        ///< regular files
  std::vector<std::string> temporaries;  ///< temporary files of write_file, whose writer is at work or was killed
  std::vector<std::string> others;       ///< folders, links and devices, blocks/ among them
};

/// Whether `path`, inside a bundle, is a folder; false where nothing has this name. Throws Failure(Exit::input_output)
/// for anything else, also for a link to a folder: a stranger's bundle must not lead out of its folder.
[[nodiscard]] bool is_inner_folder(const std::filesystem::path& path);

/// Whether anything has this name, also a link to nothing.
[[nodiscard]] bool is_there(const std::filesystem::path& path);

/// The contents of the folder `path`, without those of its subfolders. Throws Failure(Exit::input_output) where it
/// cannot be listed.
[[nodiscard]] Folder list_folder(const std::filesystem::path& path);

}  // namespace bezierbench::bundle

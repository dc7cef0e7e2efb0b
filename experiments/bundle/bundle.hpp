// SPDX-License-Identifier: MIT
// A bundle: the folder that holds everything one run gave, with checksums over it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/manifest.hpp"

namespace bezierbench::bundle {

/// A bundle's folder. Several threads and processes may write different files at once; finish() wants to be alone.
class BundleDirectory {
 public:
  /// Makes the folder, and blocks/ in it, where they are absent. Throws Failure(Exit::input_output) where it cannot be
  /// made or holds something else: it is neither empty nor has it bundle.json or blocks/.
  [[nodiscard]] static BundleDirectory create(const std::filesystem::path& path);

  /// A bundle that is there. Throws Failure(Exit::input_output) where there is none.
  [[nodiscard]] static BundleDirectory open(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path blocks() const { return path_ / "blocks"; }

  /// Replaces the file `name` as write_file does. A complete bundle first becomes partial: finish() makes it whole
  /// again. Throws as write_file, and std::invalid_argument for a name with a folder in it, a hidden one, and for
  /// bundle.json and SHA256SUMS, which are finish()'s.
  void write(std::string_view name, std::string_view bytes) const;

  /// All bytes of the file `name`. Throws as read_file.
  [[nodiscard]] std::string read(std::string_view name) const;

  /// All bytes of the file `name`, if SHA256SUMS lists them: a file that changed since has none.
  [[nodiscard]] std::optional<std::string> read_if_listed(std::string_view name) const;

  /// The same, but throws Failure(Exit::input_output) for a file that changed since, or is not there.
  [[nodiscard]] std::string read_listed(std::string_view name) const;

  /// Whether there is a regular file `name`.
  [[nodiscard]] bool has(std::string_view name) const;

  /// bundle.json. Throws as read_file and parse_manifest.
  [[nodiscard]] Manifest manifest() const;

  /// Fills in the accuracy digest, for which a bundle that is `complete` gets digests.csv, and writes SHA256SUMS, over every regular file but itself
  /// and hidden ones, then bundle.json: wherever it is cut short, no bundle says `complete` that is not. With state
  /// `complete`, removes blocks/ and what killed writers left. Changes no byte of a bundle that is so already. Throws as
  /// write_file, and Failure(Exit::input_output) for a table that cannot be read or lacks a digested column.
  void finish(Manifest manifest) const;

  /// Removes blocks/ and what killed writers left. Throws Failure(Exit::input_output).
  void clear_away() const;

 private:
  explicit BundleDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  void make_partial_before_change() const;
  void write_if_different(std::string_view name, std::string_view bytes) const;

  std::filesystem::path path_;
};

}  // namespace bezierbench::bundle

// SPDX-License-Identifier: MIT
// Files of a bundle, read with a check of their checksums, for programs that use what they say.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/manifest.hpp"

namespace bezierbench::bundle {

/// What happens with a file that differs from its checksum in SHA256SUMS: a Failure, or an entry in told().
enum class Damage { refused, told };

class CheckedReader {
 public:
  /// Opens the bundle. Throws Failure(Exit::input_output) where `path` is not a bundle.
  CheckedReader(const std::filesystem::path& path, Damage damage);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The path of the file `name`, for messages.
  [[nodiscard]] std::string place(std::string_view name) const { return (path_ / name).string(); }

  /// Whether there is a file `name`. A file that is listed but missing counts as damage.
  [[nodiscard]] bool has(std::string_view name);
  /// All bytes of the file `name`. Damage throws Failure(Exit::input_output) or is noted in told().
  [[nodiscard]] std::string read(std::string_view name);
  /// bundle.json. Throws as read() and parse_manifest.
  [[nodiscard]] Manifest manifest();

  /// The damaged files that were used nevertheless, as paths that place() gives.
  [[nodiscard]] const std::vector<std::string>& told() const { return told_; }

 private:
  void damage(std::string_view name, std::string_view what);

  std::filesystem::path path_;
  Damage damage_;
  Sums sums_;
  std::vector<std::string> told_;
};

}  // namespace bezierbench::bundle

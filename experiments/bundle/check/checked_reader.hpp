// SPDX-License-Identifier: MIT
// Files of a bundle, read with a check of their checksums, for programs that use what they say.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/manifest.hpp"

namespace bezierbench::bundle {

/// A missing file that is listed, and one that differs from its checksum in SHA256SUMS, is a Failure(Exit::input_output).
class CheckedReader {
 public:
  /// Opens the bundle. Throws Failure(Exit::input_output) where `path` is not a bundle.
  explicit CheckedReader(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The path of the file `name`, for messages.
  [[nodiscard]] std::string place(std::string_view name) const { return (path_ / name).string(); }

  /// Whether there is a file `name`.
  [[nodiscard]] bool has(std::string_view name) const;
  /// All bytes of the file `name`.
  [[nodiscard]] std::string read(std::string_view name) const;
  /// bundle.json. Throws as read() and parse_manifest.
  [[nodiscard]] Manifest manifest() const;

 private:
  [[noreturn]] void refuse(std::string_view name, std::string_view what) const;

  std::filesystem::path path_;
  Sums sums_;
};

}  // namespace bezierbench::bundle

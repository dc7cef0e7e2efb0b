// SPDX-License-Identifier: MIT
// Files of a bundle for whoever uses what they say: held to the checksums that the bundle was written with.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/check/sums.hpp"
#include "experiments/bundle/manifest.hpp"

namespace bezierbench::bundle {

/// What a file that is not as SHA256SUMS lists it leads to.
enum class Damage { refused, told };

class CheckedReader {
 public:
  /// Throws Failure(Exit::input_output) where `path` is no bundle.
  CheckedReader(const std::filesystem::path& path, Damage damage);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Where the file `name` is, for messages.
  [[nodiscard]] std::string place(std::string_view name) const { return (path_ / name).string(); }

  /// Whether there is a file `name`. One that is listed and not there is damage.
  [[nodiscard]] bool has(std::string_view name);
  /// All bytes of the file `name`. Damage is a Failure(Exit::input_output), or told().
  [[nodiscard]] std::string read(std::string_view name);
  /// bundle.json. Throws as read() and parse_manifest.
  [[nodiscard]] Manifest manifest();

  /// The files, as place() gives them, that were used although they are not what SHA256SUMS lists.
  [[nodiscard]] const std::vector<std::string>& told() const { return told_; }

 private:
  void damage(std::string_view name, std::string_view what);

  std::filesystem::path path_;
  Damage damage_;
  Sums sums_;
  std::vector<std::string> told_;
};

}  // namespace bezierbench::bundle

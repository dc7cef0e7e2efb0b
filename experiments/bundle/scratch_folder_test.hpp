// SPDX-License-Identifier: MIT
// A folder that is removed at the end of the test, for this folder's tests only.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"

namespace bezierbench::bundle {

class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "bezierbench-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("mkdtemp failed");
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  [[nodiscard]] std::set<std::string> names() const {
    std::set<std::string> result;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) result.insert(entry.path().filename());
    return result;
  }

  /// Writes the file without the code under test and makes missing folders.
  void put(const std::filesystem::path& name, std::string_view bytes) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }

 private:
  std::filesystem::path path_;
};

/// A file of the committed bundle.
inline std::string committed(const std::string& name) {
  return read_file(BEZIERBENCH_SOURCE_DIR "/experiments/bundle/fixture/" + name);
}

inline Manifest with_state(const char* state) {
  return {.suites = {"fixture"},
          .suite_digest = sha256_hex(committed("suite.toml")),
          .seed = 1,
          .state = state,
          .accuracy_digest = "",
          .program_version = "0.1.0",
          .git_commit = "unknown",
          .git_clean = true,
          .fp_flags = "-f"};
}

inline BundleDirectory filled(const std::filesystem::path& path) {
  BundleDirectory bundle = BundleDirectory::create(path);
  for (const char* name : {"suite.toml", "machine.json", "accuracy.csv", "timing.csv"})
    bundle.write(name, committed(name));
  return bundle;
}

/// Finishes the bundle with the digests of the tables that lie in its folder.
inline void finish(const BundleDirectory& bundle, const Manifest& manifest) {
  std::vector<MethodDigest> digests;
  for (const auto& name : list_folder(bundle.path()).files)
    if (const auto* table = declared_table(name); table != nullptr && table->is_deterministic)
      std::ranges::move(method_digests(*table, parse_csv(bundle.read(name), name), table->digested()),
                        std::back_inserter(digests));
  bundle.finish(manifest, digests);
}

/// A reader of suite.toml that always returns this answer.
inline Expected expected(const std::string& /*text*/, const std::string& /*file_name*/) {
  return {.suites = {"fixture"}, .seed = 1, .studies = {"fixture-accuracy", "fixture-timing"}};
}

}  // namespace bezierbench::bundle

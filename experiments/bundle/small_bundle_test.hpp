// SPDX-License-Identifier: MIT
// A bundle with two tables of a committed one, for this folder's tests only.
#pragma once

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/method_digest.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/csv.hpp"
#include "experiments/bundle/digest.hpp"
#include "experiments/bundle/folder.hpp"

namespace bezierbench::bundle {

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

// SPDX-License-Identifier: MIT
// A bundle with two tables of a committed one, for this folder's tests only.
#pragma once

#include <fmt/format.h>

#include <string>

#include "experiments/bundle/atomic_file.hpp"
#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/bundle/digest.hpp"

namespace bezierbench::bundle {

/// A file of the committed bundle of a schema version.
inline std::string committed(const std::string& name, int version = 1) {
  return read_file(fmt::format(BEZIERBENCH_SOURCE_DIR "/experiments/bundle/fixtures/schema-{}/{}", version, name));
}

inline Manifest with_state(const char* state, int version = 1) {
  return {.schema_version = version,
          .suites = {"fixture"},
          .suite_digest = sha256_hex(committed("suite.toml", version)),
          .seed = 1,
          .state = state,
          .accuracy_digest = "",
          .program_version = "0.1.0",
          .git_commit = "unknown",
          .git_clean = true,
          .fp_flags = "-f"};
}

inline BundleDirectory filled(const std::filesystem::path& path, int version = 1) {
  BundleDirectory bundle = BundleDirectory::create(path);
  for (const char* name : {"suite.toml", "machine.json", "accuracy.csv", "timing.csv"})
    bundle.write(name, committed(name, version));
  return bundle;
}

/// A reader of suite.toml that always returns this answer.
inline Expected expected(const std::string& /*text*/, const std::string& /*file_name*/) {
  return {.suites = {"fixture"},
          .seed = 1,
          .studies = {"fixture-accuracy", "fixture-timing"},
          .tables = {{"fixture-accuracy", {"accuracy.csv", "unstable.csv"}}, {"fixture-timing", {"timing.csv"}}}};
}

}  // namespace bezierbench::bundle

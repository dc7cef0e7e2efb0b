// SPDX-License-Identifier: MIT
// From resolved suites to a bundle: plan, work in blocks over threads, write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/bundle/machine.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::studies {

struct RunRequest {
  std::vector<suite::Suite> suites;  ///< resolved: overrides applied
  std::filesystem::path out;
  int jobs = 0;  ///< threads; 0: all cores
  reference::Tier tier = reference::Tier::certified;
  bool dry_run = false;
  bool quiet = false;
  bundle::BuildFacts build;
  std::string git_commit;
  bool git_clean = false;
  std::string methods_csv;  ///< the list of methods that goes into the bundle
};

/// What a run found; each line is for the user, and any makes the exit code 1.
using Findings = std::vector<std::string>;

/// Runs all studies and writes the bundle. Throws Failure: interrupted when a signal arrived (no result is written),
/// usage when `out` holds another suite, seed or build, input_output when it cannot be written.
Findings run(const RunRequest& request);

}  // namespace bezierbench::studies

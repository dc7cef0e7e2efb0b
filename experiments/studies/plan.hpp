// SPDX-License-Identifier: MIT
// A run before it starts: its jobs, and what tells it from any other run.
#pragma once

#include <optional>
#include <string>

#include "experiments/bundle/bundle.hpp"
#include "experiments/failure.hpp"
#include "experiments/studies/ledger.hpp"
#include "experiments/studies/run.hpp"

namespace bezierbench::studies {

struct Plan {
  explicit Plan(const RunRequest& request);

  Jobs jobs;
  std::string suite_text;     ///< the resolved suites
  bundle::Manifest manifest;  ///< state `partial`
  std::string reference;      ///< the tier
};

/// Why results of `theirs` are none of `ours`, naming both: "seed 1, this run has 2". Nothing where they may be mixed.
std::optional<std::string> difference(const bundle::Manifest& theirs, const bundle::Manifest& ours);

/// Refuses files of blocks that belong to another run: Failure(exit).
void require_same(const Found& found, const Plan& ours, Exit exit);

/// Writes the tables of jobs whose blocks are all done, and completes the bundle.
Findings assemble(const RunRequest& request, const Plan& plan, const bundle::BundleDirectory& directory);

}  // namespace bezierbench::studies

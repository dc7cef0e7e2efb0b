// SPDX-License-Identifier: MIT
// From resolved suites to a bundle: plan, work in blocks over threads, write.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/machine.hpp"
#include "experiments/run/blocks/shard.hpp"
#include "experiments/run/kinds.hpp"
#include "experiments/run/notes.hpp"
#include "experiments/run/outcome.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::run {

struct RunRequest {
  Kinds kinds;                                ///< the roster of studies/
  std::vector<suite::Suite> suites;           ///< resolved: overrides applied
  std::vector<suite::OutsideMethod> outside;  ///< methods that every study takes beside its own, where its kind can
  std::filesystem::path out;
  int jobs = 0;  ///< threads; 0: all cores
  reference::Tier tier = reference::Tier::certified;
  std::optional<Shard> shard;
  std::optional<std::chrono::milliseconds> checkpoint;  ///< between two files of finished blocks; if empty, by cost
  bool dry_run = false;
  Telling telling = Telling::text;
  bundle::BuildFacts build;
  std::string git_commit;
  bool git_clean = false;
  bundle::HostName host_name = bundle::HostName::left_out;
  std::string counters;        ///< whether the processor's counters can be read, as machine.json says it
  std::string methods_csv;     ///< the list of methods that goes into the bundle
  std::string generators_csv;  ///< the list of generators, likewise
};

/// Runs all studies, or a shard of them, and writes the bundle once no block is missing. Until then blocks/ keeps the
/// finished blocks, which are not run again. Throws Failure: interrupted when a signal arrived, usage when `out` holds
/// another suite, seed or build, input_output when it cannot be written or another process does the same work there.
Outcome run(const RunRequest& request);

}  // namespace bezierbench::run

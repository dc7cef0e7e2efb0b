// SPDX-License-Identifier: MIT
// From resolved suites to a bundle: plan, work in blocks over threads, write; and from the bundles of shards to that
// of the whole run.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/bundle/machine.hpp"
#include "experiments/run/job.hpp"
#include "experiments/suite/external.hpp"
#include "experiments/suite/suite.hpp"
#include "reference/true_point.hpp"

namespace bezierbench::run {

/// The findings of a run, lines for the user; any of them makes the exit code 1.
using Findings = std::vector<std::string>;

/// What this process did.
enum class Ending { complete, partial, nothing_to_do };

struct Outcome {
  Findings findings;
  Ending ending = Ending::nothing_to_do;
  std::size_t cells = 0;              ///< of the whole bundle
  std::uint64_t violations = 0;       ///< trials beyond a proved bound
  std::uint64_t broken_promises = 0;  ///< trials in which a method said what does not hold
  std::uint64_t refuted_proofs = 0;   ///< properties that are stated as proved and do not hold
  std::size_t times = 0;              ///< rows of timing.csv
  double ratio_width = 0;             ///< of the intervals of their ratios, as a share of the ratio; the median
  double seconds = 0;                 ///< since the first block
};

// The functions by which the engine uses kinds of studies. It knows no kind by name; the roster in studies/ passes
// them.

struct Kinds {
  /// The studies that one stands for: one for each form and degree of its curve sets. A job is made of each.
  std::vector<suite::Study> (*studies_of)(const suite::Study& study) = nullptr;
  /// The work of one study. Throws Failure(usage) where its methods do not fit.
  std::unique_ptr<Job> (*make_job)(const suite::Study& study, const JobContext& context) = nullptr;
  /// The work of one study on an external method; null where studies of this kind take none, or not this one. A
  /// method that is not available can be written and merged, but not run.
  std::function<std::unique_ptr<Job>(const suite::Study& study, const suite::ExternalMethod& method,
                                     const JobContext& context)>
      make_external_job = nullptr;
  /// Why there is no such job, a sentence about the study; empty where there is one.
  std::string (*why_unasked)(const suite::Study& study, const suite::ExternalMethod& method) = nullptr;
};

/// One of several processes that share a run.
struct Shard {
  std::uint64_t number = 1;  ///< from 1
  std::uint64_t count = 1;
};

struct RunRequest {
  Kinds kinds;                                  ///< the roster of studies/
  std::vector<suite::Suite> suites;             ///< resolved: overrides applied
  std::vector<suite::ExternalMethod> external;  ///< methods that every study takes beside its own, where its kind can
  std::filesystem::path out;
  int jobs = 0;  ///< threads; 0: all cores
  reference::Tier tier = reference::Tier::certified;
  std::optional<Shard> shard;
  std::optional<std::chrono::milliseconds> checkpoint;  ///< between two files of finished blocks; if empty, by cost
  bool dry_run = false;
  bool quiet = false;  ///< prints no progress
  bundle::BuildFacts build;
  std::string git_commit;
  bool git_clean = false;
  bundle::HostName host_name = bundle::HostName::left_out;
  std::string counters;        ///< whether the processor's counters can be read, as machine.json says it
  std::string methods_csv;     ///< the list of methods that goes into the bundle
  std::string generators_csv;  ///< the list of generators, likewise
  std::vector<std::pair<std::string, std::string>> curve_files;  ///< curve sets of the suites that are files, likewise
  /// JobContext::count_jobs, for studies that count instructions.
  std::function<std::vector<std::string>()> count_jobs = {};
};

/// Runs all studies, or a shard of them, and writes the bundle once no block is missing. Until then blocks/ keeps the
/// finished blocks, which are not run again. Throws Failure: interrupted when a signal arrived, usage when `out` holds
/// another suite, seed or build, input_output when it cannot be written or another process does the same work there.
Outcome run(const RunRequest& request);

/// Calls Job::count() of every job, in a process that Callgrind runs. A job that fails, as an external method may, has
/// no counts.
void count(const RunRequest& request);

/// Joins partial bundles of the run that `request` describes into `request.out`, which may be one of them. The others
/// stay as they are. The order does not matter. The ending is `nothing_to_do` where one of them is the whole run's
/// already, of which `request.out` is then a copy. Throws Failure: finding for bundles of another suite, seed or build,
/// for blocks that two of them hold or none, and for times of several machines; input_output where one cannot be read
/// or another process works there.
Outcome merge(RunRequest request, const std::vector<std::filesystem::path>& bundles);

}  // namespace bezierbench::run

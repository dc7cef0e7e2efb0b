// SPDX-License-Identifier: MIT
// A run before it starts: its jobs, and the manifest that identifies it.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/blocks/checkpoints.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::run {

/// A study with a job for our own methods.
struct PlannedStudy {
  suite::Study study;
  JobContext context;
};

/// An external method that a study does not ask.
struct Unasked {
  std::string method;
  std::string study;
  std::string why;  ///< a sentence about the study
};

struct Plan {
  explicit Plan(const RunRequest& request);

  Jobs jobs;                           ///< those of `studies` in their order, then those for external methods
  std::vector<std::string> job_names;  ///< of the study of a job; of the study and the method for an external method
  std::vector<PlannedStudy> studies;   ///< without the names of external methods
  std::vector<Unasked> unasked;
  std::string suite_text;     ///< the resolved suites
  bundle::Manifest manifest;  ///< state `partial`
  std::string reference;      ///< the tier
};

/// Tells the user which studies ask nothing of which external method. Throws Failure(usage) where no study asks a
/// method.
void tell_unasked(const RunRequest& request, const Plan& plan);

/// The first difference between two manifests whose results must not be mixed, for example "seed 1, this run has 2".
/// Empty where there is none.
std::optional<std::string> difference(const bundle::Manifest& theirs, const bundle::Manifest& ours);

/// The manifest of a bundle that is in `request.out` already. Throws Failure(usage) where it belongs to another run.
std::optional<bundle::Manifest> existing(const RunRequest& request, const Plan& plan);

inline constexpr const char* suite_name = "suite.toml";
inline constexpr const char* machine_name = "machine.json";

/// The program's lists that are part of a bundle and explain the ids in its tables, by file name.
std::vector<std::pair<std::string, std::string>> lists_of(const RunRequest& request);

/// Refuses a folder with files that no run writes: they would get into the list of files and, under the name of a
/// table, into the digest. Hidden files are ignored. Throws Failure(input_output).
void refuse_foreign(const RunRequest& request, const std::function<bool(const std::string&)>& is_table);

/// Refuses files of blocks that belong to another run: Failure(exit).
void require_same(const Found& found, const Plan& ours, Exit exit);

/// The tables of jobs whose blocks are all done.
tables::Tables written_tables(const RunRequest& request, const Plan& plan);

std::size_t cells_of(const Jobs& jobs);

/// What a complete bundle has to say, without the seconds: the jobs are done, the tables are theirs.
Outcome outcome_of(const Jobs& jobs, const tables::Tables& tables);

/// Writes the tables, and completes the bundle.
void assemble(const RunRequest& request, const tables::Tables& tables, const Plan& plan,
              const bundle::BundleDirectory& directory);

}  // namespace bezierbench::run

// SPDX-License-Identifier: MIT
// A run before it starts: its jobs, and the manifest that identifies it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/check/verify.hpp"
#include "experiments/failure.hpp"
#include "experiments/run/blocks/checkpoints.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::run {

/// A study with a job for our own methods.
struct PlannedStudy {
  suite::Study study;
  JobContext context;
};

/// An external method that a study does not evaluate.
struct Unasked {
  std::string method;
  std::string study;
  std::string why;  ///< a sentence about the study
};

struct Plan {
  explicit Plan(const RunRequest& request);

  Jobs jobs;                           ///< those of `studies` in their order, then those for external methods
  std::vector<std::string> job_names;  ///< of the study of a job; of that and the method for an external method
  std::vector<PlannedStudy> studies;   ///< without the names of external methods
  std::vector<Unasked> unasked;
  std::string suite_text;     ///< the resolved suites
  bundle::Manifest manifest;  ///< state `partial`
  std::string reference;      ///< the tier
};

/// Tells the user which studies do not evaluate which external method. Throws Failure(usage) for a method that no
/// study evaluates.
void tell_unasked(const RunRequest& request, const Plan& plan);

/// The first difference between two manifests whose results must not be mixed, for example "seed 1, this run has 2".
/// Empty where there is none.
std::optional<std::string> difference(const bundle::Manifest& theirs, const bundle::Manifest& ours);

inline constexpr const char* suite_name = "suite.toml";
inline constexpr const char* machine_name = "machine.json";
inline constexpr const char* methods_name = "methods.csv";
inline constexpr const char* generators_name = "generators.csv";

/// The program's lists that are part of a bundle and explain the ids in its tables, by file name.
std::vector<std::pair<std::string, std::string>> lists_of(const RunRequest& request);

/// The tables of jobs whose blocks are all done.
tables::Tables filled_tables(const RunRequest& request, const Plan& plan);

std::size_t cells_of(const Jobs& jobs);

/// The outcome of a complete bundle, without the seconds: the jobs are done, the tables are theirs.
Outcome outcome_of(const Jobs& jobs, const tables::Tables& tables);

/// The contents that `verify` expects in a bundle of these suites.
[[nodiscard]] bundle::Expected expected_of(std::span<const suite::Suite> suites);

}  // namespace bezierbench::run

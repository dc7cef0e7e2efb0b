// SPDX-License-Identifier: MIT
// A run before it starts: its jobs, and what tells it from any other run.
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

struct Plan {
  explicit Plan(const RunRequest& request);

  Jobs jobs;
  std::string suite_text;     ///< the resolved suites
  bundle::Manifest manifest;  ///< state `partial`
  std::string reference;      ///< the tier
};

/// Why results of `theirs` are none of `ours`, naming both: "seed 1, this run has 2". Nothing where they may be mixed.
std::optional<std::string> difference(const bundle::Manifest& theirs, const bundle::Manifest& ours);

/// The manifest of the bundle that is in `request.out` already, if there is any. Throws Failure(usage) where that is
/// another run's.
std::optional<bundle::Manifest> existing(const RunRequest& request, const Plan& plan);

inline constexpr const char* suite_name = "suite.toml";
inline constexpr const char* machine_name = "machine.json";

/// Lists of the program that travel with a bundle, by file name: what the ids in its tables mean.
std::vector<std::pair<std::string, std::string>> lists_of(const RunRequest& request);

/// Refuses a folder with something beside tables and what every run writes: it would get into the list of files and,
/// under the name of a table, into the digest. Hidden files are passed over. Throws Failure(input_output).
void refuse_foreign(const RunRequest& request, const std::function<bool(const std::string&)>& is_table);

/// Refuses files of blocks that belong to another run: Failure(exit).
void require_same(const Found& found, const Plan& ours, Exit exit);

/// The tables of jobs whose blocks are all done.
tables::Tables written_tables(const RunRequest& request, const Plan& plan);

/// Where proved bounds were seen to fail.
Findings violations_in(const Jobs& jobs);

/// Writes the tables, and completes the bundle.
Findings assemble(const RunRequest& request, const tables::Tables& tables, const Plan& plan,
                  const bundle::BundleDirectory& directory);

}  // namespace bezierbench::run

// SPDX-License-Identifier: MIT
// Merges the bundles of a run's shards into the bundle of the whole run.
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/run/run.hpp"

namespace bezierbench::run {

/// Joins partial bundles of the run that `request` describes into `request.out`, which may be one of them. The others
/// stay as they are. The order does not matter. The ending is `nothing_to_do` where one of them is the whole run's
/// already, of which `request.out` is then a copy. Throws Failure: finding for bundles of another suite, seed or build,
/// for blocks that two of them hold or none, and for times of several machines; input_output where one cannot be read
/// or another process works there.
Outcome merge(RunRequest request, const std::vector<std::filesystem::path>& bundles);

}  // namespace bezierbench::run

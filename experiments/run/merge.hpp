// SPDX-License-Identifier: MIT
// From the shards of a run, each in a bundle of its own, to the bundle of the whole run.
#pragma once

#include <filesystem>
#include <vector>

#include "experiments/run/run.hpp"

namespace bezierbench::run {

/// Joins partial bundles of the run that `request` describes into `request.out`, which may be one of them. The others
/// stay as they are. The order does not matter. Throws Failure: finding for bundles of another suite, seed or build,
/// for blocks that two of them hold or none, and for times of several machines; input_output where one cannot be read
/// or somebody is at work there.
Findings merge(RunRequest request, const std::vector<std::filesystem::path>& bundles);

}  // namespace bezierbench::run

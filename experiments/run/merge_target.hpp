// SPDX-License-Identifier: MIT
// Where a merge puts its result.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/lock_file.hpp"
#include "experiments/run/plan.hpp"

namespace bezierbench::run {

/// Name and bytes of every file of a whole bundle but bundle.json and SHA256SUMS, in the order in which to write them.
using Files = std::vector<std::pair<std::string, std::string>>;

/// The lock of whoever works in a bundle's folder, until it is gone. Throws Failure(input_output) where a run has it.
std::unique_ptr<bundle::LockFile> lock_of_run(const bundle::BundleDirectory& directory);

/// Makes of `request.out` a complete bundle of these files. Does nothing where it is just that already. `is_source`
/// says that it is one of the bundles that were joined, `is_locked` that the run's lock is held. Throws Failure: usage
/// for a bundle of another run, or a complete one with other files; finding for blocks that were not joined;
/// input_output where a run is at work, where there is what no run writes, and where it cannot be written.
void put_whole(const RunRequest& request, const Plan& plan, const Files& files, bool is_source, bool is_locked);

}  // namespace bezierbench::run

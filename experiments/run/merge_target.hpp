// SPDX-License-Identifier: MIT
// The bundle that a merge writes.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/bundle/bundle.hpp"
#include "experiments/bundle/lock_file.hpp"
#include "experiments/run/plan.hpp"

namespace bezierbench::run {

/// A bundle whose blocks are all done.
struct WholeBundle {
  /// Name and bytes of every file but bundle.json, digests.csv and SHA256SUMS, in the order in which to write them.
  std::vector<std::pair<std::string, std::string>> files;
  std::vector<bundle::MethodDigest> digests;
};

/// Locks a bundle's folder as long as it lives. Throws Failure(input_output) where a run holds the lock.
std::unique_ptr<bundle::LockFile> lock_of_run(const bundle::BundleDirectory& directory);

/// Makes `request.out` this bundle. Does nothing where it is that bundle already. `is_source`: it
/// is one of the bundles that are merged; `is_locked`: the caller holds the run's lock. Throws Failure: usage for a
/// bundle of another run, or a complete one with other files; finding for blocks that were not merged; input_output
/// where a run works there, where the folder holds files that no run writes, and where it cannot be written.
void put_whole(const RunRequest& request, const Plan& plan, const WholeBundle& whole, bool is_source, bool is_locked);

}  // namespace bezierbench::run

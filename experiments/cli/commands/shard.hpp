// SPDX-License-Identifier: MIT
// --shard: which part of a run this process is to do.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "experiments/run/blocks/shard.hpp"

namespace bezierbench::cli {

/// The value of an environment variable, or nullptr: std::getenv, but for tests.
using Environment = std::function<const char*(const char*)>;

/// `i/N`, or `auto`: what Open MPI, PMI (MPICH and others) or Slurm tell their processes. An array of jobs that each
/// have several processes is arrays times processes. Throws Failure(usage).
run::Shard shard_of(std::string_view text, const Environment& environment);

}  // namespace bezierbench::cli

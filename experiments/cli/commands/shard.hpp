// SPDX-License-Identifier: MIT
// --shard: the part of a run that this process does.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "experiments/run/run.hpp"

namespace bezierbench::cli {

/// The value of an environment variable, or nullptr; tests replace std::getenv.
using Environment = std::function<const char*(const char*)>;

/// Parses `i/N`, or `auto` for the values that Open MPI, PMI (MPICH and others) or Slurm set for their processes. In an
/// array of jobs with several processes each, N is the product of both numbers. Throws Failure(usage).
run::Shard shard_of(std::string_view text, const Environment& environment);

}  // namespace bezierbench::cli

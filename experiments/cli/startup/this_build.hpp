// SPDX-License-Identifier: MIT
// The facts about this program that a run records.
#pragma once

#include "experiments/run/run.hpp"

namespace bezierbench::cli {

/// A request with the facts of this build filled in, and nothing else.
run::RunRequest request_of_this_build();

}  // namespace bezierbench::cli

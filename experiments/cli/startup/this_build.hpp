// SPDX-License-Identifier: MIT
// The facts about this program that a run records.
#pragma once

#include <vector>

#include "experiments/outside/method.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::cli {

/// A request with the facts of this build and the methods from outside filled in, and nothing else.
run::RunRequest request_of_this_build(const outside::Methods& outside = {});

/// Makes these the methods from outside that the request records.
void record_outside(run::RunRequest& request, std::vector<suite::OutsideMethod> outside);

}  // namespace bezierbench::cli

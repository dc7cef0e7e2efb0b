// SPDX-License-Identifier: MIT
// The facts about this program that a run records.
#pragma once

#include <vector>

#include "experiments/external/method.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::cli {

/// A request with the facts of this build and the external methods filled in, and nothing else.
run::RunRequest request_of_this_build(const external::Methods& external = {});

/// Makes these the external methods that the request records.
void record_external(run::RunRequest& request, std::vector<suite::ExternalMethod> external);

}  // namespace bezierbench::cli

// SPDX-License-Identifier: MIT
// The contents that `verify` expects in a bundle of some suites.
#pragma once

#include "experiments/bundle/check/verify.hpp"
#include "experiments/run/run.hpp"

namespace bezierbench::run {

/// The contents that `verify` expects in a bundle of the request's suites and external methods, by the jobs that a
/// run of each study would have. Methods of other libraries that this build lacks are left out; of a study that it cannot
/// plan without them it expects no table.
[[nodiscard]] bundle::Expected expected_of(const RunRequest& request);

}  // namespace bezierbench::run

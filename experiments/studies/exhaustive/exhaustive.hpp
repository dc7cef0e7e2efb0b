// SPDX-License-Identifier: MIT
// Studies of kind `exhaustive`: named curves at every float of an interval.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// Every method in float at every t, against the correctly rounded values. Rows go to exhaustive.csv. Throws
/// Failure(usage) for curves that have no such name, and for an interval without a float.
std::unique_ptr<run::Job> exhaustive_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

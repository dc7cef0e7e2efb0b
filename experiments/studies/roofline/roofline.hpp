// SPDX-License-Identifier: MIT
// Studies of kind `roofline`: batch kernels against the peak of each target, measured in the same rounds.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

std::unique_ptr<run::Job> roofline_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

// SPDX-License-Identifier: MIT
// Studies of kind `timing`: the methods of a study race each other in every cell and mode.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

std::unique_ptr<run::Job> timing_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

// SPDX-License-Identifier: MIT
// Studies of kind `accuracy`: random curves and parameters, every method, errors against the exact point or a baseline.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

std::unique_ptr<run::Job> accuracy_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

// SPDX-License-Identifier: MIT
// Studies of kind `search`: the largest error that a climb finds, starting from the worst inputs of a sample.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// `trials` random inputs per cell and method, then `budget` steps of a climb. Rows go to search.csv; a method whose
/// last bits depend on libm is left out, because other machines could not replay it.
std::unique_ptr<run::Job> search_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

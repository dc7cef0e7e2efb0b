// SPDX-License-Identifier: MIT
// Studies of kind `search`: how bad a method can be made, starting from the worst of a sample.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// `trials` random inputs per cell and method, then `budget` steps of a climb. Rows go to search.csv; a method whose
/// last bits hang on libm is left out, since nobody else could replay it.
std::unique_ptr<run::Job> search_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

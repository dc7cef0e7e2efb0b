// SPDX-License-Identifier: MIT
// Studies of kind `hard_cases`: inputs whose exact values are hard to round, for tests of other libraries.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// `trials` cases of each family; of these, each search keeps as many as the study says. Rows go to hard_cases.csv.
/// Values are of the integers of the reference, and no method takes part.
std::unique_ptr<run::Job> hard_cases_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

// SPDX-License-Identifier: MIT
// Studies of kind `guarantees`: what methods keep of a curve's properties, proved or refuted by an input.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// For every cell, method and property: `trials` random inputs, then a search with `budget` inputs for one that breaks
/// the property, the smallest that it can find. Rows go to guarantees.csv, those of methods whose last bits depend on
/// libm or on another library to guarantees_unstable.csv. A proved property that is broken is a violation.
std::unique_ptr<run::Job> guarantees_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

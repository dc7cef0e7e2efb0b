// SPDX-License-Identifier: MIT
// Studies of kind `conversion`. Random curves go through one conversion, judged against the exact one, or through a
// chain such as `factorial+forward_substitution+factorial`, judged by the distance of the last curve in the original
// form from the original curve. The error of a trial is the largest distance between corresponding coefficients.
#pragma once

#include <memory>

#include "experiments/run/job.hpp"

namespace bezierbench::studies {

std::unique_ptr<run::Job> conversion_job(const suite::Study& study, const run::JobContext& context);

}  // namespace bezierbench::studies

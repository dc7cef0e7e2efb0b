// SPDX-License-Identifier: MIT
// Studies of kind `derivative`: derivatives of random curves at random t, order by order, against the exact ones.
#pragma once

#include <memory>

#include "experiments/studies/job.hpp"

namespace bezierbench::studies {

/// Throws Failure(usage) for rational curves and for scalars but double.
void check_derivatives(const suite::Study& study);

/// Throws Failure(usage) also where no method takes curves of this form.
std::unique_ptr<Job> derivative_job(const suite::Study& study, const JobContext& context);

}  // namespace bezierbench::studies

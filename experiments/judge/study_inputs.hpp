// SPDX-License-Identifier: MIT
// Whether a study is of inputs that its kind, or the problem that it times, takes. The reader of suites has checked the
// former; studies are also made by hand.
#pragma once

#include "core/method.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

/// Throws Failure(usage) for inputs that the kind of the study does not take: suite::check_inputs.
void check_inputs(const suite::Study& study);

/// Throws Failure(usage) for inputs and axes that the problem of a timing study does not take: suite::check_timed.
void check_timed(const suite::Study& study, Problem problem);

}  // namespace bezierbench::judge

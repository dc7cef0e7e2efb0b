// SPDX-License-Identifier: MIT
// Checks that the kind of a study, or the problem that it times, takes the inputs of the study. The reader of suites
// has checked them for the kind, but programs and tests also make studies without it.
#pragma once

#include "experiments/suite/suite.hpp"

namespace bezierbench::judge {

/// Throws Failure(usage) for inputs that the kind of the study does not take: suite::check_inputs.
void check_inputs(const suite::Study& study);

/// Throws Failure(usage) for inputs and axes that the problem of a timing study does not take: suite::check_timed.
void check_timed(const suite::Study& study, const suite::Kind& judged);

}  // namespace bezierbench::judge

// SPDX-License-Identifier: MIT
// Studies of kind `bspline`: random B-spline curves in one knot span, over every kind of knots in sample::knot_kinds();
// the point at a random t of the span is judged against the exact one and, of methods that make the Bernstein form of
// the span, every control point of it.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The job of the study. Throws Failure(usage) for inputs that the kind does not take.
std::unique_ptr<run::Job> bspline_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_bspline;

}  // namespace bezierbench::studies

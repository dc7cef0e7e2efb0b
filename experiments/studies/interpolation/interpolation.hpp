// SPDX-License-Identifier: MIT
// Studies of kind `interpolation`: random points joined by the cubic Bezier segments of a C2 natural spline, whose
// control points are judged against the exact ones and against the conditions that they must meet. Writes
// interpolation.csv, a row for each number of points and method.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// Through more points the exact spline is not computed: its size grows with the square of their number. Conditions are
/// exact through any number of points.
inline constexpr int most_points_of_exact_splines = 1025;

/// Throws Failure(usage) for inputs that the kind does not take.
std::unique_ptr<run::Job> interpolation_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_interpolation;

}  // namespace bezierbench::studies

// SPDX-License-Identifier: MIT
// Studies of kind `interpolation`: random points joined by the cubic Bezier segments of a C2 natural spline, whose
// control points are judged against the exact ones and by the conditions that they must meet. Writes interpolation.csv,
// with a row for each number of points and method.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// The largest number of points for which the exact spline is computed: its size grows with the square of this number.
/// The conditions are checked exactly for any number of points.
inline constexpr int most_points_of_exact_splines = 1025;

/// The job of the study. Throws Failure(usage) for inputs that the kind does not take.
std::unique_ptr<run::Job> interpolation_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_interpolation;

}  // namespace bezierbench::studies

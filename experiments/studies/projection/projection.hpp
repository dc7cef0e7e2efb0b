// SPDX-License-Identifier: MIT
// Studies of kind `projection`: points, placed in every way in sample::placements(), projected onto random curves in
// Bernstein form, judged against the exact foot point. Writes projection.csv, and projection_unstable.csv for methods
// that are not bit-stable.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// A foot point misses the nearest point if it is farther away than that by more than this times the largest coordinate
/// of the control points and the point. No method is that inaccurate about a minimum that it found.
inline constexpr double missed_tolerance = 0x1p-20;

std::unique_ptr<run::Job> projection_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_projection;

}  // namespace bezierbench::studies

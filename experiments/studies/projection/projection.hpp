// SPDX-License-Identifier: MIT
// Studies of kind `projection`: points, placed in every way that sample::placements() knows, projected onto random
// curves in Bernstein form, judged against the exact foot point. Writes projection.csv, and projection_unstable.csv for
// methods that are not bit-stable.
#pragma once

#include <memory>

#include "experiments/race/timed_problem.hpp"
#include "experiments/run/job.hpp"

namespace bezierbench::studies {

/// A foot point is missed where it is farther than the nearest point by more than this times the largest coordinate of
/// control points and point: no method is that inaccurate about the minimum that it did find.
inline constexpr double missed_tolerance = 0x1p-20;

std::unique_ptr<run::Job> projection_job(const suite::Study& study, const run::JobContext& context);

extern const race::TimedProblem timed_projection;

}  // namespace bezierbench::studies

// SPDX-License-Identifier: MIT
// Methods of companion problems as contestants of a timing study, which names them in place of evaluators: each time is
// that of one problem from the control points on, all that a method prepares included (mode one_shot).
#pragma once

#include <cstdint>
#include <vector>

#include "core/method.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/timing/race.hpp"

namespace bezierbench::studies {

/// Contestants, and whether the results that each must reproduce are right.
struct JudgedRivals {
  std::vector<timing::Rival> rivals;
  std::vector<bool> right;
};

/// What is timed: the companion problem whose methods the study names, else evaluation.
Problem timed_problem(const suite::Study& study);

/// The methods of a timing study of a companion problem that support the degree of the cell, in roster order. Throws
/// Failure(usage) for what cannot be timed: another curve, scalar or mode, and for arc lengths all but one tolerance.
std::vector<const MethodInfo*> timed_companions(const suite::Study& study, Problem problem, const sample::Cell& cell);

/// One rival for each method. Lengths are right where they keep the tolerance of the study; foot points where none is
/// missed. The points that are projected are drawn like control points.
JudgedRivals companion_rivals(const std::vector<const MethodInfo*>& methods, Problem problem, const suite::Study& study,
                              const sample::Cell& cell, std::uint64_t seed);

}  // namespace bezierbench::studies

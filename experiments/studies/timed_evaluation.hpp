// SPDX-License-Identifier: MIT
// Evaluation as a timing study asks it: every scalar type, cell and mode is a heat.
#pragma once

#include "experiments/studies/timed_problem.hpp"

namespace bezierbench::studies {

std::vector<Heat> heats_of_evaluation(const suite::Study& study);
JudgedRivals rivals_of_evaluation(const Heat& heat, const suite::Study& study, std::uint64_t seed);

inline constexpr TimedProblem timed_evaluation{Problem::evaluation, Size::degree, heats_of_evaluation,
                                               rivals_of_evaluation};

}  // namespace bezierbench::studies

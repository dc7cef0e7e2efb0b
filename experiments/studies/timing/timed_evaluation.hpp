// SPDX-License-Identifier: MIT
// Evaluation as a timed problem: every scalar type, cell and mode is a race.
#pragma once

#include "experiments/race/race.hpp"

namespace bezierbench::studies {

std::vector<race::Race> races_of_evaluation(const suite::Study& study);
race::JudgedRivals rivals_of_evaluation(const race::Race& race, const suite::Study& study, std::uint64_t seed,
                                        std::shared_ptr<const void>& trials);

inline constexpr race::TimedProblem timed_evaluation{race::Size::degree, races_of_evaluation, rivals_of_evaluation};

}  // namespace bezierbench::studies

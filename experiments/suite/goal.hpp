// SPDX-License-Identifier: MIT
// What can be wrong with a goal of a roofline study.
#pragma once

#include <span>
#include <string>

#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

/// What is wrong, for people, else empty. `methods` are the ids that there are.
std::string goal_problem(const Goal& goal, std::span<const std::string> methods);

}  // namespace bezierbench::suite

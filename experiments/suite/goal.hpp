// SPDX-License-Identifier: MIT
// The check of a goal of a roofline study.
#pragma once

#include <span>
#include <string>

#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

/// What is wrong with `goal`, as a message; empty where nothing is. `methods` are all known ids.
std::string goal_problem(const Goal& goal, std::span<const std::string> methods);

}  // namespace bezierbench::suite

// SPDX-License-Identifier: MIT
// The keys of a goal of a roofline study, and its check.
#pragma once

#include <span>
#include <string>

#include "experiments/suite/suite.hpp"

namespace bezierbench::suite {

/// Calls visit(key, meaning, member) for every key of a goal, in the order in which they are written; `member` points
/// to a member of Goal.
template <class Visit>
void each_goal_key(const Visit& visit) {
  visit("method", "id of the method whose batch kernels are meant", &Goal::method);
  visit("share", "least share of the peak; 1 is the peak", &Goal::share);
  visit("scalar", "scalar type of the rows", &Goal::scalar);
  visit("from_degree", "lowest degree of the rows", &Goal::from_degree);
  visit("to_degree", "highest degree of the rows", &Goal::to_degree);
  visit("needs_additions_beside", "only on processors that do additions beside multiply-adds",
        &Goal::needs_additions_beside);
}

/// What is wrong with `goal`, as a message; empty where nothing is. `methods` are all known ids.
std::string goal_problem(const Goal& goal, std::span<const std::string> methods);

}  // namespace bezierbench::suite

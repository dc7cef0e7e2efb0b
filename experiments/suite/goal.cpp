// SPDX-License-Identifier: MIT
#include "experiments/suite/goal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/suite/nearest.hpp"

namespace bezierbench::suite {

std::string goal_problem(const Goal& goal, std::span<const std::string> methods) {
  for (const std::string& id : {goal.method, goal.no_slower_than})
    if (!id.empty() && std::ranges::find(methods, id) == methods.end())
      return fmt::format("unknown method \"{}\"{}", id, suggestion(id, methods));
  if (goal.method.empty()) return "a goal needs a method; add method = \"horner_fma\"";
  if ((goal.share == 0) == goal.no_slower_than.empty())
    return "a goal is a share of the peak or no_slower_than another method; give one of them";
  if (!(goal.share >= 0) || !std::isfinite(goal.share)) return "share must be above 0; 1 is the peak";
  if (goal.from_degree > goal.to_degree) return "from_degree is above to_degree; no row has such a degree";
  return {};
}

}  // namespace bezierbench::suite

// SPDX-License-Identifier: MIT
#include "experiments/suite/goal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/suite/nearest.hpp"

namespace bezierbench::suite {

std::string goal_problem(const Goal& goal, std::span<const std::string> methods) {
  if (goal.method.empty()) return "a goal needs a method; add method = \"horner_fma\"";
  if (std::ranges::find(methods, goal.method) == methods.end())
    return fmt::format("unknown method \"{}\"{}", goal.method, suggestion(goal.method, methods));
  if (!(goal.share > 0) || !std::isfinite(goal.share))
    return "a goal requires a share of the peak above 0; add share = 0.6, where 1 is the peak";
  if (goal.from_degree > goal.to_degree) return "from_degree is above to_degree; no row has such a degree";
  return {};
}

}  // namespace bezierbench::suite

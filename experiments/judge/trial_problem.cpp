// SPDX-License-Identifier: MIT
#include "experiments/judge/trial_problem.hpp"

namespace bezierbench::judge {

std::vector<TrialPart> parts_of(const suite::Study& study, CaseAxes axes, Problem problem) {
  suite::Study swept = study;
  swept.tolerance.clear();
  axes.tolerance = false;
  const auto cases = cases_of(swept, axes, name(problem));
  std::vector<TrialPart> parts;
  if (axes.degree) {
    for (const auto& cell : sample::cells(swept))
      for (const auto& values : cases) parts.push_back({cell, values});
    return parts;
  }
  swept.degree = study.points;
  for (const auto& cell : sample::cells(swept)) {
    parts.push_back({cell, {.points = cell.degree}});
    parts.back().cell.degree = segment_degree;
  }
  return parts;
}

std::vector<double> tolerances_of(const suite::Study& study, const CaseAxes& axes) {
  return axes.tolerance ? study.tolerance : std::vector<double>{0};
}

}  // namespace bezierbench::judge

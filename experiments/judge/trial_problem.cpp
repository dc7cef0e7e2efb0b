// SPDX-License-Identifier: MIT
#include "experiments/judge/trial_problem.hpp"

#include "experiments/suite/kind.hpp"

namespace bezierbench::judge {

std::vector<TrialPart> parts_of(const suite::Study& study, CaseAxes axes) {
  axes.tolerance = false;
  std::vector<TrialPart> parts;
  if (axes.degree) {
    const auto cases = cases_of(study, axes);
    for (const auto& cell : sample::cells(study))
      for (const auto& values : cases) parts.push_back({cell, values});
    return parts;
  }
  suite::Study swept = study;
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

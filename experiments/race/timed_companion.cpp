// SPDX-License-Identifier: MIT
#include "experiments/race/timed_companion.hpp"

namespace bezierbench::race {

std::vector<RaceCell> companion_race_cells(const suite::Study& study, judge::CaseAxes axes) {
  axes.placement = false;  // only the first placement is timed
  axes.knots = false;      // and the first kind of knots
  const auto all_cases = judge::cases_of(study, axes);
  auto with_degree = study;
  if (!axes.degree) with_degree.degree = {judge::segment_degree};
  std::vector<RaceCell> race_cells;
  for (const auto& cell : sample::cells(with_degree))
    for (const auto& case_values : all_cases)
      race_cells.push_back({cell, suite::ScalarKind::float64, suite::Mode::one_shot, {}, case_values});
  return race_cells;
}

}  // namespace bezierbench::race

// SPDX-License-Identifier: MIT
#include "experiments/race/timed_companion.hpp"

#include "experiments/judge/study_inputs.hpp"

namespace bezierbench::race {

std::vector<RaceCell> companion_race_cells(const suite::Study& study, Problem problem, bool each_data) {
  judge::check_timed(study, problem);
  const auto all_cases = judge::cases_of(study, each_data);
  auto with_degree = study;
  if (study.degree.empty()) with_degree.degree = {3};  // of the segments
  std::vector<RaceCell> race_cells;
  for (const auto& cell : sample::cells(with_degree))
    for (const auto& case_values : all_cases)
      race_cells.push_back({cell, suite::ScalarKind::float64, suite::Mode::one_shot, {}, case_values});
  return race_cells;
}

}  // namespace bezierbench::race

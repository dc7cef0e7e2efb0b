// SPDX-License-Identifier: MIT
#include "experiments/studies/timing/timed_problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "experiments/judge/companions.hpp"
#include "experiments/judge/methods.hpp"
#include "experiments/studies/arc_length/arc_length.hpp"
#include "experiments/studies/bspline/bspline.hpp"
#include "experiments/studies/derivative/derivative.hpp"
#include "experiments/studies/fitting/fitting.hpp"
#include "experiments/studies/grid/grid.hpp"
#include "experiments/studies/interpolation/interpolation.hpp"
#include "experiments/studies/inverse_arc_length/inverse_arc_length.hpp"
#include "experiments/studies/projection/projection.hpp"
#include "experiments/studies/subdivision/subdivision.hpp"
#include "experiments/studies/timing/timed_evaluation.hpp"
#include "experiments/suite/fault.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::array roster{&timed_evaluation, &timed_derivative,    &timed_arc_length, &timed_inverse_arc_length,
                            &timed_projection, &timed_interpolation, &timed_fitting,    &timed_subdivision,
                            &timed_grid,       &timed_bspline};

bool means_an_evaluator(const std::string& pattern) {
  constexpr int any_dimension = 2;
  return std::ranges::any_of(judge::methods<double>(any_dimension),
                             [&](const auto& kernel) { return suite::means(pattern, kernel.info->id); });
}

Problem named_problem(const suite::Study& study) {
  for (const auto& pattern : study.methods) {
    if (means_an_evaluator(pattern)) continue;
    for (const auto* info : judge::companion_infos())
      if (suite::means(pattern, info->id)) return info->problem;
  }
  return Problem::evaluation;
}

}  // namespace

const race::TimedProblem& timed_problem(const suite::Study& study) {
  const Problem problem = named_problem(study);
  const auto* const found =
      std::ranges::find_if(roster, [problem](const auto* one) { return one->problem == problem; });
  if (found == roster.end())
    suite::refuse(
        study, {"methods", 0, {}, fmt::format("methods for the problem {} are not timed; name others", name(problem))});
  return **found;
}

}  // namespace bezierbench::studies

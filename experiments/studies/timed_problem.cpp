// SPDX-License-Identifier: MIT
#include "experiments/studies/timed_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "experiments/failure.hpp"
#include "experiments/studies/companions.hpp"
#include "experiments/studies/methods.hpp"
#include "experiments/studies/timed_arc_length.hpp"
#include "experiments/studies/timed_derivative.hpp"
#include "experiments/studies/timed_evaluation.hpp"
#include "experiments/studies/timed_fitting.hpp"
#include "experiments/studies/timed_interpolation.hpp"
#include "experiments/studies/timed_inverse_arc_length.hpp"
#include "experiments/studies/timed_projection.hpp"
#include "experiments/suite/pattern.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::array roster{timed_evaluation,                                   //
                            timed_companion<TimedDerivative>(),                 //
                            timed_companion<TimedArcLength>(),                  //
                            timed_companion<TimedInverseArcLength>(),           //
                            timed_companion<TimedProjection>(),                 //
                            timed_companion<TimedInterpolation>(Size::points),  //
                            timed_companion<TimedFitting>()};

bool means_an_evaluator(const std::string& pattern) {
  constexpr int any_dimension = 2;
  return std::ranges::any_of(methods<double>(any_dimension),
                             [&](const auto& kernel) { return suite::means(pattern, kernel.info->id); });
}

Problem named_problem(const suite::Study& study) {
  for (const auto& pattern : study.methods) {
    if (means_an_evaluator(pattern)) continue;
    for (const auto* info : companion_infos())
      if (suite::means(pattern, info->id)) return info->problem;
  }
  return Problem::evaluation;
}

}  // namespace

const TimedProblem& timed_problem(const suite::Study& study) {
  const Problem problem = named_problem(study);
  const auto* const found = std::ranges::find(roster, problem, &TimedProblem::problem);
  if (found == roster.end())
    throw Failure(Exit::usage, fmt::format("study \"{}\": methods for the problem {} are not timed; name others",
                                           study.id, name(problem)));
  return *found;
}

}  // namespace bezierbench::studies

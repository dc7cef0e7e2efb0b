// SPDX-License-Identifier: MIT
#include "experiments/studies/timed_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/failure.hpp"
#include "experiments/studies/companions.hpp"
#include "experiments/studies/timed_arc_length.hpp"
#include "experiments/studies/timed_derivative.hpp"
#include "experiments/studies/timed_evaluation.hpp"
#include "experiments/studies/timed_fitting.hpp"
#include "experiments/studies/timed_interpolation.hpp"
#include "experiments/studies/timed_inverse_arc_length.hpp"
#include "experiments/studies/timed_projection.hpp"

namespace bezierbench::studies {
namespace {

constexpr std::array roster{timed_evaluation,                                   //
                            timed_companion<TimedDerivative>(),                 //
                            timed_companion<TimedArcLength>(),                  //
                            timed_companion<TimedInverseArcLength>(),           //
                            timed_companion<TimedProjection>(),                 //
                            timed_companion<TimedInterpolation>(Size::points),  //
                            timed_companion<TimedFitting>()};

Problem named_problem(const suite::Study& study) {
  for (const auto& entry : study.methods)
    for (const auto* info : companion_infos())
      if (info->id == entry) return info->problem;
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

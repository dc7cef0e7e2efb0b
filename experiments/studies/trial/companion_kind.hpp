// SPDX-License-Identifier: MIT
// The kind of study of a companion problem: its errors, its times and its methods follow from problem.hpp.
#pragma once

#include "experiments/race/timed_companion.hpp"
#include "experiments/studies/roster.hpp"
#include "experiments/studies/trial/external_trial.hpp"
#include "experiments/studies/trial/trial_study.hpp"

namespace bezierbench::studies {

/// The kind that judges and times the methods of P. `asks` states what else suites may ask of it.
template <StudiedProblem P>
constexpr StudyKind companion_kind(suite::Kind asks, race::Size size = race::Size::unclaimed) {
  asks.problem = P::problem;
  StudyKind kind{asks, trial_job<P>, race::timed_companion<P>(size), judge::infos<P>};
  if constexpr (ExternalProblem<P>) kind.make_external = external_trial_job<P>;
  return kind;
}

}  // namespace bezierbench::studies

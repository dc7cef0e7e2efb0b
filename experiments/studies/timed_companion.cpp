// SPDX-License-Identifier: MIT
#include "experiments/studies/timed_companion.hpp"

#include <fmt/format.h>

#include "experiments/failure.hpp"

namespace bezierbench::studies {

std::vector<Heat> companion_heats(const suite::Study& study, Problem problem, const Asks& asks) {
  if (study.modes != std::vector{suite::Mode::one_shot})
    throw Failure(Exit::usage, fmt::format("study \"{}\": a companion problem is timed from the control points on; "
                                           "write modes = [\"one_shot\"]",
                                           study.id));
  const auto all_asked = asked_of(study, asks, name(problem));
  auto with_degree = study;
  if (!asks.degree) with_degree.degree = {3};  // of the segments
  std::vector<Heat> heats;
  for (const auto& cell : sample::cells(with_degree))
    for (const auto& asked : all_asked)
      heats.push_back({cell, suite::ScalarKind::float64, suite::Mode::one_shot, {}, asked});
  return heats;
}

}  // namespace bezierbench::studies

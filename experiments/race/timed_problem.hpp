// SPDX-License-Identifier: MIT
// A problem that a timing study can time: evaluation, or a companion problem, whose methods the study then names in
// place of evaluators. The kind of study that judges the problem states it. A companion problem is timed as its
// problem.hpp states (race/timed_companion.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/method.hpp"
#include "experiments/race/race.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::race {

/// What was found of the results that a rival must reproduce.
struct Judgement {
  bool right = true;
  std::optional<double> max_error_u = std::nullopt;  ///< as in JudgedPoints
};

struct JudgedRivals {
  std::vector<Rival> rivals;
  std::vector<Judgement> judged;             ///< of each
  std::shared_ptr<const void> inputs;        ///< the inputs that the rivals read
  std::optional<Rival> call = std::nullopt;  ///< an empty kernel, beside evaluators
};

/// The size that the claimed costs of a problem's methods grow with.
enum class Size { unclaimed, degree, points };

struct TimedProblem {
  Problem problem;
  Size size;
  /// The races of a study, before any repetition. Throws Failure(usage) for studies that cannot be timed.
  std::vector<Race> (*races)(const suite::Study& study);
  /// One rival for each method of the race. `trials` is what the last call for the race left there, null for
  /// the first: the trials of a companion problem, whose truths take longer than their race. Others leave nothing.
  JudgedRivals (*rivals)(const Race& race, const suite::Study& study, std::uint64_t seed,
                         std::shared_ptr<const void>& trials);
};

// One repetition of a race among rivals that were judged beforehand.

/// Races all rivals and the sentinels against each other. A rival whose results were wrong is not `checked`.
RaceTimes run_rivals(const Race& race, const suite::Study& study, JudgedRivals judged, std::size_t repetition,
                     const RaceOptions& options);

}  // namespace bezierbench::race

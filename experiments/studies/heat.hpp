// SPDX-License-Identifier: MIT
// One cell of a timing study in one scalar type and mode: its methods race each other, with a sentinel beside them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/method.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"
#include "experiments/timing/race.hpp"
#include "experiments/timing/sentinel.hpp"

namespace bezierbench::studies {

struct Heat {
  sample::Cell cell;
  suite::ScalarKind scalar;
  suite::Mode mode;
  std::vector<const MethodInfo*> methods;  ///< those that support the degree
  std::vector<timing::Lap> laps = {};      ///< all that running it gives: of each method, then of the sentinel
};

/// The heats of a study, none of which ran. Throws Failure(usage) for methods that do not take the curves.
std::vector<Heat> heats_of(const suite::Study& study);

/// Judges the methods, then races them. A method whose points are wrong is timed all the same, and not `checked`.
std::vector<timing::Lap> run(const Heat& heat, const suite::Study& study, std::uint64_t seed,
                             const timing::RaceOptions& options);

/// The sentinel's half medians of a heat that ran.
timing::HalfMedians sentinel_of(const std::vector<timing::Lap>& laps);

/// The fastest half that the sentinel had in any of the heats; infinite where none ran.
double fastest_sentinel(const std::vector<Heat>& heats);

/// Whether the sentinel drifted more than is tolerated from `fastest`, the fastest of the study.
bool drifted(const std::vector<timing::Lap>& laps, double fastest);

/// The method id that a study names as its baseline; empty where it names none.
std::string named_baseline(const suite::Study& study);

/// Which of a heat's methods its ratios are relative to: the study's baseline or, if it names none, the first that the
/// study names and that supports the degree. Empty where the baseline is not in the race.
std::optional<std::size_t> relative_to(const Heat& heat, const suite::Study& study);

}  // namespace bezierbench::studies

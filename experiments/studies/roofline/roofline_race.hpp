// SPDX-License-Identifier: MIT
// One cell of a roofline study in one scalar type: the batch kernels of every target that this processor can run race
// each other, their scalar kernels and the peak of each target.
#pragma once

#include <cstdint>
#include <vector>

#include "core/batch/batch.hpp"
#include "experiments/race/race.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

enum class Work {
  scalar_points,        ///< a method's scalar kernel, one point at a time
  batch_points,         ///< its batch kernel for a target, all points at once
  multiply_add,         ///< a target's peak; a point is a floating-point operation
  multiply_add_and_add  ///< the same with as many additions beside the fused multiply-adds
};

struct TargetRival {
  Work work;
  const MethodInfo* method;  ///< null for a peak
  const MethodInfo* evaluator;
  const batch::Target* target;  ///< null for a scalar kernel
};

struct RooflineRace {
  sample::Cell cell;
  suite::ScalarKind scalar;
  std::vector<TargetRival> rivals;   ///< those that support the degree; none where no method does
  std::vector<race::Lap> laps = {};  ///< of each, once it ran
};

/// The races of a study, before they run. Methods without a batch kernel take no part. Throws Failure(usage) for
/// methods that do not take the curves.
std::vector<RooflineRace> roofline_races_of(const suite::Study& study);

/// Judges the methods, then races them. A method whose points are wrong is timed all the same, and not `checked`.
std::vector<race::Lap> run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                           const race::RaceOptions& options);

}  // namespace bezierbench::studies

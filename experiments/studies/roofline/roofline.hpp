// SPDX-License-Identifier: MIT
// One cell of a roofline study in one scalar type: the batch kernels of every target that this processor can run race
// each other and the peak of each target.
#pragma once

#include <cstdint>
#include <vector>

#include "core/batch/batch.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

enum class Work {
  batch_points,         ///< a method's batch kernel, all points at once
  multiply_add,         ///< a target's peak; a point is a floating-point operation
  multiply_add_and_add  ///< the same with as many additions beside the fused multiply-adds
};

struct TargetRival {
  Work work;
  const batch::Target* target;
  const MethodInfo* method = nullptr;  ///< null for a peak
  const MethodInfo* evaluator = nullptr;
};

/// The times of each rival.
using RooflineTimes = std::vector<race::RoundTimes>;

struct RooflineRace {
  sample::Cell cell;
  suite::ScalarKind scalar;
  std::vector<TargetRival> rivals;  ///< the kernels that support the degree; none where there is no such kernel
  RooflineTimes times = {};         ///< once it ran
};

/// The races of a study, before they run. Methods without a batch kernel have no part in them. Throws
/// Failure(usage) for methods that do not take the curves.
std::vector<RooflineRace> roofline_races_of(const suite::Study& study);

/// Judges the methods, then races them. A method whose points are wrong is timed nevertheless, and not `checked`.
RooflineTimes run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                  const race::RaceOptions& options);

// roofline.csv: the batch kernels' share of the peak of each target, and which goals they reach. How near the kernel of
// a method is to the limit of the processor stands in timing.csv.

/// A row per method, target, scalar type and cell; races that did not run have none. Shares are taken within rounds,
/// where method and peak met the same conditions. `goal_share` is the goal of the row, if it has one, and `goal_met` is
/// `yes` or `no`.
void write_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables);

/// The keys of the same rows, of races before they run, on this processor.
void list_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables);

}  // namespace bezierbench::studies

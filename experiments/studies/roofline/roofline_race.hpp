// SPDX-License-Identifier: MIT
// One cell of a roofline study in one scalar type: the batch kernels of every target that this processor can run race
// each other, the kernels for one point, empty ones and the peak of each target.
#pragma once

#include <cstdint>
#include <vector>

#include "core/batch/batch.hpp"
#include "experiments/race/operation_times.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/run/job.hpp"
#include "experiments/sample/cell.hpp"
#include "experiments/suite/suite.hpp"

namespace bezierbench::studies {

enum class Work {
  scalar_points,        ///< a method's kernel for one point, one at a time
  scalar_chain,         ///< the same, each t waiting for the last point
  batch_points,         ///< its batch kernel for a target, all points at once
  call,                 ///< an empty kernel, in the mode of one of these
  multiply_add,         ///< a target's peak; a point is a floating-point operation
  multiply_add_and_add  ///< the same with as many additions beside the fused multiply-adds
};

struct TargetRival {
  Work work;
  suite::Mode mode;
  const MethodInfo* method;  ///< null for a peak and a call
  const MethodInfo* evaluator;
  const batch::Target* target;  ///< null for a kernel for one point and a call
};

/// The times of the rivals, and what the operations of the processor took beside them.
struct RooflineTimes {
  std::vector<race::RoundTimes> each;
  race::ProcessorTimes operations = {};

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.each, self.operations);
  }
};

struct RooflineRace {
  sample::Cell cell;
  suite::ScalarKind scalar;
  std::vector<TargetRival> rivals;  ///< those that support the degree; none where no method does
  RooflineTimes times = {};         ///< once it ran
};

/// The races of a study, before they run. Methods without a batch kernel have no part in mode `batch`. Throws
/// Failure(usage) for methods that do not take the curves.
std::vector<RooflineRace> roofline_races_of(const suite::Study& study);

/// Judges the methods, then races them. A method whose points are wrong is timed nevertheless, and not `checked`.
RooflineTimes run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                  const race::RaceOptions& options);

// roofline.csv: the batch kernels' share of the peak of each target, which goals they reach, and how near all kernels
// are to the limit of the processor.

/// A row per method, target, mode, scalar type and cell; races that did not run have none. Target `scalar` is the kernel
/// for one point, in the modes `point` and `latency`, and has no peak. Shares are taken within rounds, where method and
/// peak met the same conditions. `goal_share` and `goal_ns` are the goals of the row, if it has any, and `goal_met` is
/// `yes` or `no`. `quality` is `noisy` where the peak of a race was more than 2 % slower than in the quickest of the
/// study: other processes disturbed the race.
void write_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables);

/// The keys of the same rows, of races before they run, on this processor.
void list_roofline_rows(const suite::Study& study, const std::vector<RooflineRace>& races, tables::Tables& tables);

}  // namespace bezierbench::studies

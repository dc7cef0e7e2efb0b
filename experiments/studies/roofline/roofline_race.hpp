// SPDX-License-Identifier: MIT
// One cell of a roofline study in one scalar type: the batch kernels of every target that this processor can run race
// each other, the kernels for one point, empty ones and the peak of each target.
#pragma once

#include <cstdint>
#include <vector>

#include "core/batch/batch.hpp"
#include "experiments/race/operation_times.hpp"
#include "experiments/race/race.hpp"
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

/// The laps of the rivals, and what the operations of the processor took beside them.
struct RooflineLaps {
  std::vector<race::Lap> each;
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
  RooflineLaps laps = {};           ///< once it ran
};

/// The races of a study, before they run. Methods without a batch kernel have no part in mode `batch`. Throws
/// Failure(usage) for methods that do not take the curves.
std::vector<RooflineRace> roofline_races_of(const suite::Study& study);

/// Judges the methods, then races them. A method whose points are wrong is timed all the same, and not `checked`.
RooflineLaps run(const RooflineRace& race, const suite::Study& study, std::uint64_t seed,
                 const race::RaceOptions& options);

}  // namespace bezierbench::studies

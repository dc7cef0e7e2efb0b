// SPDX-License-Identifier: MIT
// What the floating-point operations of this processor take: the units in which the limit of a method is stated.
#pragma once

#include <cstddef>
#include <vector>

#include "core/evaluate/operations.hpp"
#include "experiments/race/clock.hpp"

namespace bezierbench::race {

/// Of operations on vectors of one width, in nanoseconds.
struct OperationTimes {
  std::size_t lanes = 0;
  ByOperation apart;    ///< from the end of one to the end of the next, where none waits for another
  ByOperation latency;  ///< where each waits for the one before
  double mixed = 0;     ///< as `apart`, of additions and fused multiply-adds side by side

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.lanes, self.apart.values, self.latency.values, self.mixed);
  }
};

/// By the width of vectors, narrowest first; of the best target that this processor can run, or of none.
using ProcessorTimes = std::vector<OperationTimes>;

/// Measured now, in about a millisecond: of several turns of the same work the fastest.
template <class Scalar>
ProcessorTimes measured_operations(Clock clock);

/// The medians over several measurements; without any, nothing.
ProcessorTimes median_of(const std::vector<ProcessorTimes>& measurements);

}  // namespace bezierbench::race

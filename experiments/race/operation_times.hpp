// SPDX-License-Identifier: MIT
// What the floating-point operations of this processor take: the units in which the limit of a method is stated.
#pragma once

#include <cstddef>
#include <vector>

#include "core/operations/operations.hpp"
#include "experiments/race/rounds.hpp"

namespace bezierbench::race {

/// The times of operations on vectors of one width, in nanoseconds.
struct OperationTimes {
  std::size_t lanes = 0;
  ByOperation apart;    ///< for each of many operations that do not wait for each other
  ByOperation latency;  ///< for each of a chain, in which it waits for the one before
  double mixed = 0;     ///< as `apart`, of additions and fused multiply-adds side by side

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.lanes, self.apart.values, self.latency.values, self.mixed);
  }
};

/// One entry for each width of vectors, narrowest first, of this processor's best target; empty where it has none.
using ProcessorTimes = std::vector<OperationTimes>;

/// Measures them in about a millisecond. Each time is the fastest of several turns of the same work.
template <class Scalar>
ProcessorTimes measured_operations(Clock clock);

/// The medians over several measurements; empty without any.
ProcessorTimes median_of(const std::vector<ProcessorTimes>& measurements);

}  // namespace bezierbench::race

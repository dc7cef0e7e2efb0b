// SPDX-License-Identifier: MIT
// What the floating-point operations of this processor take: the units in which the limit of a method is stated. And
// that limit: the least time that a processor could take for the floating-point operations of a method, by their
// kinds. Loads, stores, comparisons and calls count as nothing.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/method.hpp"
#include "core/operations/operations.hpp"
#include "experiments/race/rounds.hpp"
#include "experiments/suite/suite.hpp"

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

/// What a method does in one race.
struct TimedWork {
  const MethodInfo* evaluator;
  const MethodInfo* conversion;  ///< before it; null where there is none
  int degree;
  int dimension;
};

/// Nanoseconds per point.
struct Limit {
  double ns;
  std::optional<double> chain_ns;  ///< of the longest chain of operations from t on; in modes `point` and `latency`

  friend bool operator==(const Limit&, const Limit&) = default;
};

/// The least time of operations that do not wait for each other. Processors have units for additions, units for
/// products and fused multiply-adds, perhaps the same ones, and one for divisions and square roots. The time is at
/// least that of the operations of each, and that of additions, products and fused multiply-adds together.
double least_ns(const ByOperation& count, const OperationTimes& times);

/// In mode `batch` every lane holds a point, in vectors of the fastest measured width. In the others a vector holds the
/// axes of one point, in the narrowest width that has room for them. The chain counts in mode `latency` where it takes
/// longer, preparation in `one_shot`. Empty where the method's operations are not counted or nothing was measured.
std::optional<Limit> limit(const TimedWork& work, suite::Mode mode, const ProcessorTimes& times);

/// limit / (ns - call): more than 1 where the processor did part of the work beside the call, infinite where the call
/// alone took as long.
double share_of_limit(double limit_ns, double ns, double call_ns);

}  // namespace bezierbench::race

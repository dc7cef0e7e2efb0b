// SPDX-License-Identifier: MIT
// Counts for methods that get a tolerance: how often they keep it, break it, or report that they did not converge.
#pragma once

#include <cstdint>

#include "experiments/metric/counts.hpp"

namespace bezierbench::studies {

struct Promises {
  std::uint64_t non_finite = 0;
  std::uint64_t non_converged = 0;
  metric::TrialCount broken;  ///< reported as within the tolerance, but beyond it
  metric::Total evaluations;

  void add(bool converged, std::int64_t evaluated) {
    evaluations.add(static_cast<std::uint64_t>(evaluated));
    non_converged += converged ? 0 : 1;
  }

  /// Whether an error is within the tolerance. Both are absolute, and `error` is rounded to 24 bits.
  static bool keeps(double error, double allowed) { return error <= allowed * (1 + 0x1p-20); }

  void judge(bool converged, double error, double allowed, std::uint64_t trial) {
    if (converged && !keeps(error, allowed)) broken.add(trial);
  }

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.non_finite, self.non_converged, self.broken, self.evaluations);
  }
};

}  // namespace bezierbench::studies

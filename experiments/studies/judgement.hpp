// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "experiments/metric/tally.hpp"

namespace bezierbench::studies {

/// What is kept of one method against one baseline.
struct Judgement {
  metric::Tally error;
  metric::Tally error_u;
  std::uint64_t non_finite = 0;
  std::uint64_t bounded = 0;  ///< trials for which a bound is proved
  std::uint64_t violations = 0;
  std::int64_t first_violation = std::numeric_limits<std::int64_t>::max();  ///< trial
  double bound_u = 0;

  void merge(const Judgement& other) {
    error.merge(other.error);
    error_u.merge(other.error_u);
    non_finite += other.non_finite;
    bounded += other.bounded;
    violations += other.violations;
    first_violation = std::min(first_violation, other.first_violation);
    bound_u = std::max(bound_u, other.bound_u);
  }
};

}  // namespace bezierbench::studies

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "experiments/judge/error_sources.hpp"
#include "experiments/metric/counts.hpp"

namespace bezierbench::judge {

/// The trial with a method's largest error in units of u p~; of equal ones the first.
struct Worst {
  double error_u = 0;
  double error = 0;
  std::uint64_t trial = 0;

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error_u, self.error, self.trial);
  }

  [[nodiscard]] bool is_worse_than(const Worst& other) const {
    return error_u > other.error_u || (error_u == other.error_u && trial < other.trial);
  }
};

/// The errors of one method, measured from one baseline.
struct Judgement {
  metric::Tally error;
  metric::Tally error_u;
  metric::Tally error_ulp;  ///< against the exact reference only, like all below
  metric::Tally relative;
  std::optional<Worst> worst;
  SourceTallies sources;
  std::uint64_t non_finite = 0;
  std::uint64_t own_kernel = 0;  ///< trials whose point was computed by the method's own kernel, the one that is timed
  std::uint64_t bounded = 0;     ///< trials for which a bound is proved
  std::uint64_t violations = 0;
  std::int64_t first_violation = std::numeric_limits<std::int64_t>::max();  ///< trial
  double bound = 0;                                                         ///< the largest, in coordinate units
  double bound_u = 0;                                                       ///< the largest of bound / (u p~)

  template <class Bytes, class Self>
  static void each_field(Bytes& bytes, Self& self) {
    bytes(self.error, self.error_u, self.error_ulp, self.relative, self.worst, self.sources, self.non_finite,
          self.own_kernel, self.bounded, self.violations, self.first_violation, self.bound, self.bound_u);
  }

  void keep_worst(const Worst& candidate) {
    if (!worst || candidate.is_worse_than(*worst)) worst = candidate;
  }

  void merge(const Judgement& other) {
    error.merge(other.error);
    error_u.merge(other.error_u);
    error_ulp.merge(other.error_ulp);
    relative.merge(other.relative);
    if (other.worst) keep_worst(*other.worst);
    metric::merge_fields(sources, other.sources);
    non_finite += other.non_finite;
    own_kernel += other.own_kernel;
    bounded += other.bounded;
    violations += other.violations;
    first_violation = std::min(first_violation, other.first_violation);
    bound = std::max(bound, other.bound);
    bound_u = std::max(bound_u, other.bound_u);
  }
};

}  // namespace bezierbench::judge

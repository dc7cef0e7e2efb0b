// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
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
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error_u, self.error, self.trial);
  }

  void merge(const Worst& other) {
    if (other.error_u > error_u || (other.error_u == error_u && other.trial < trial)) *this = other;
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
  metric::TrialCount violations;
  metric::Largest<double> bound;    ///< in coordinate units
  metric::Largest<double> bound_u;  ///< bound / (u p~)

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.error_ulp, self.relative, self.worst, self.sources, self.non_finite,
                 self.own_kernel, self.bounded, self.violations, self.bound, self.bound_u);
  }
};

}  // namespace bezierbench::judge

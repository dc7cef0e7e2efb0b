// SPDX-License-Identifier: MIT
// The norms and amplifications of a group of trials, many lanes at a time. The formulas are those that TrialScale uses
// for one trial, instantiated with the lanes of core/batch/lanes.hpp, so every lane has the bits of TrialScale.
#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <vector>

#include "core/bound/error_bound.hpp"
#include "core/curve_view.hpp"
#include "reference/certified_points.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::metric {

/// Curves in Bernstein or power form, of one dimension and degree. Reusable; keeps its memory.
class ScaleLanes {
 public:
  using Lanes = reference::CertifiedLanes;

  void begin(int dimension, int degree);
  void load(std::size_t lane, const CurveView<double>& curve, double t);
  /// Computes the norms of all coefficients and these amplifications of them. Must be called after the last `load` and
  /// before what follows.
  void compute(const std::set<Amplification>& kinds);

  /// The largest norm of a coefficient.
  [[nodiscard]] double largest(std::size_t lane) const { return largest_[lane]; }
  /// The amplifications that were computed.
  [[nodiscard]] reference::Amplifications amplified(std::size_t lane) const {
    reference::Amplifications result;
    for (const Amplification kind : kinds_)
      result[static_cast<std::size_t>(kind)] = amplified_[static_cast<std::size_t>(kind)][lane];
    return result;
  }

 private:
  int dimension_ = 0;
  int degree_ = 0;
  std::vector<Lanes> coefficients_;  ///< point by point
  std::vector<Lanes> norms_;
  Lanes t_{};
  Lanes largest_{};
  std::set<Amplification> kinds_;
  std::array<Lanes, amplification_count> amplified_{};
};

}  // namespace bezierbench::metric

// SPDX-License-Identifier: MIT
// Judges one spline through drawn points against the truth, axis by axis.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "experiments/metric/counts.hpp"
#include "reference/companion/interpolation.hpp"

namespace bezierbench::studies {

/// The largest errors of each trial over knots and axes. All but `error` are in u times the largest coordinate of the
/// axis.
struct SplineErrors {
  metric::Tally error;              ///< of the inner control points, in coordinate units
  metric::Tally error_u;            ///< the same in u times the largest coordinate
  metric::Tally data;               ///< residuals: |P0,i - K_i| and |P3,i - K_(i+1)|
  metric::Tally c0;                 ///< gaps between segments
  metric::Tally c1;                 ///< jumps of first differences
  metric::Tally c2;                 ///< jumps of second differences
  metric::Tally natural;            ///< second differences at the ends
  metric::Largest<double> bound_u;  ///< the proved bound with its underflow term; 0 if there is none
  std::uint64_t non_finite = 0;
  metric::TrialCount violations;  ///< trials with a residual above its proved bound

  template <class Bytes, class Self>
  static auto each_field(Bytes& bytes, Self& self) {
    return bytes(self.error, self.error_u, self.data, self.c0, self.c1, self.c2, self.natural, self.bound_u,
                 self.non_finite, self.violations);
  }
};

/// The points of one trial and, unless there are too many of them, the exact spline through them.
class SplineJudge {
 public:
  SplineJudge(std::span<const double> points, int dimension, bool with_exact);

  /// Adds the errors of `segments`, 4 control points each, point by point. `bound` is the bound of the residuals in u
  /// times the largest coordinate of an axis; 0 if there is none.
  void judge(std::span<const double> segments, double bound, std::uint64_t trial, SplineErrors& errors) const;

  /// Whether all numbers are finite and all residuals within `bound`.
  [[nodiscard]] bool meets(std::span<const double> segments, double bound) const;

 private:
  struct Axis {
    std::vector<double> coordinates;
    reference::Rational unit;  ///< u times the largest coordinate
    std::optional<reference::ExactSpline> exact;
  };
  std::vector<Axis> axes_;
};

}  // namespace bezierbench::studies

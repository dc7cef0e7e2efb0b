// SPDX-License-Identifier: MIT
// One spline through drawn points against the truth, axis by axis.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "experiments/studies/interpolation/interpolation_tally.hpp"
#include "reference/interpolation.hpp"

namespace bezierbench::studies {

/// The points of one trial, with the exact spline through them unless they are too many.
class SplineJudge {
 public:
  SplineJudge(std::span<const double> points, int dimension, bool with_exact);

  /// Adds what is wrong with the segments, 4 control points each, point by point. `bound` is that of the residuals, in
  /// u times the largest coordinate of an axis; 0 for none.
  void judge(std::span<const double> segments, double bound, std::uint64_t trial, SplineErrors& errors) const;

 private:
  struct Axis {
    std::vector<double> coordinates;
    reference::Rational unit;  ///< u times the largest
    std::optional<reference::ExactSpline> exact;
  };
  std::vector<Axis> axes_;
};

}  // namespace bezierbench::studies

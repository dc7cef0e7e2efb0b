// SPDX-License-Identifier: MIT
// The points of a group of trials, one method after the other: side by side in the vectors of this processor where
// core/batch has kernels for that, else curve by curve. No bit depends on which.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/batch/batch.hpp"
#include "experiments/judge/workspace.hpp"
#include "reference/certified_points.hpp"

namespace bezierbench::judge {

inline constexpr std::size_t trials_at_once = batch::curves_at_once;
static_assert(trials_at_once == reference::certified_lanes);

/// Coordinates of a group's points; in double, which holds any float.
using PointsOfGroup = reference::PointLanes;

/// A method as groups are evaluated by it.
template <class Scalar>
struct GroupMethod {
  /// Of this processor's best target.
  explicit GroupMethod(const Kernel<Scalar>& method);

  const Kernel<Scalar>* kernel;
  const Kernel<Scalar>* evaluator;  ///< of a path, if it can be had alone; else the method itself
  batch::GroupKernel<Scalar> side_by_side;

  /// True where there are no kernels for groups: every point comes from the method's own.
  [[nodiscard]] bool is_judged_alone() const { return side_by_side.evaluate == nullptr && evaluator == kernel; }
};

/// Reusable; keeps its memory.
template <class Scalar>
class GroupPoints {
 public:
  /// Another group of curves; they must live until its points are computed.
  void begin(int dimension, int degree) {
    dimension_ = dimension;
    degree_ = degree;
    count_ = 0;
    conversion_ = nullptr;
    given_.resize(static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(dimension) * trials_at_once);
  }
  /// The next one of at most `trials_at_once` trials.
  void add(const CurveView<Scalar>& curve, Scalar t);

  /// The points of the trials that were added; leaves axes that there are none of as they are.
  void evaluate(const GroupMethod<Scalar>& method, PointsOfGroup& points);
  /// Throws std::logic_error where the first of these points is not, bit by bit, that of the method's own kernel, which
  /// is the one that is timed.
  void check_first(const GroupMethod<Scalar>& method, const PointsOfGroup& points);

 private:
  const std::vector<Scalar>& evaluated_coefficients(const GroupMethod<Scalar>& method);
  void evaluate_one_by_one(const GroupMethod<Scalar>& method, PointsOfGroup& points);

  int dimension_ = 0;
  int degree_ = 0;
  std::size_t count_ = 0;
  std::array<CurveView<Scalar>, trials_at_once> curves_;
  std::array<Scalar, trials_at_once> t_{};
  std::vector<Scalar> given_;               ///< side by side, as core/batch/target_table.hpp says
  std::vector<Scalar> converted_;           ///< likewise
  const MethodInfo* conversion_ = nullptr;  ///< that gave `converted_`: many methods share one
  std::vector<Scalar> one_;                 ///< curve, converted
  PreparedStorage prepared_;
};

}  // namespace bezierbench::judge

// SPDX-License-Identifier: MIT
// The points of a group of trials, one method after the other. Where core/batch has a kernel for groups, the trials are
// lanes of this processor's vectors, else they are evaluated one by one. Both give the same bits.
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

/// Coordinates of a group's points, as doubles for both scalar types.
using PointsOfGroup = reference::PointLanes;

/// A method with its kernels for one curve and for groups.
template <class Scalar>
struct GroupMethod {
  /// The kernels for groups are those of this processor's best target.
  explicit GroupMethod(const Kernel<Scalar>& method);

  const Kernel<Scalar>* kernel;
  const Kernel<Scalar>* evaluator;  ///< of a path, if it has a kernel of its own; else the method's
  batch::GroupKernel<Scalar> side_by_side;

  /// True where there are no kernels for groups, so that every point comes from the method's own kernel.
  [[nodiscard]] bool is_judged_alone() const { return side_by_side.evaluate == nullptr && evaluator == kernel; }
};

/// Reusable; keeps its memory.
template <class Scalar>
class GroupPoints {
 public:
  /// Begins another group of curves, which must live until its points are computed.
  void begin(int dimension, int degree) {
    dimension_ = dimension;
    degree_ = degree;
    count_ = 0;
    conversion_ = nullptr;
    given_.resize(static_cast<std::size_t>(degree + 1) * static_cast<std::size_t>(dimension) * trials_at_once);
  }
  /// Adds a trial; at most `trials_at_once`.
  void add(const CurveView<Scalar>& curve, Scalar t);

  /// Writes the points of the trials that were added. Axes beyond the dimension are not written.
  void evaluate(const GroupMethod<Scalar>& method, PointsOfGroup& points);
  /// Throws std::logic_error unless the first of these points has the bits that the method's own kernel computes. That
  /// kernel is the one that is timed.
  void check_first(const GroupMethod<Scalar>& method, const PointsOfGroup& points);

 private:
  [[nodiscard]] bool fits_in_groups() const { return degree_ <= batch::max_degree_of_groups; }
  const std::vector<Scalar>& evaluated_coefficients(const GroupMethod<Scalar>& method);
  void evaluate_one_by_one(const GroupMethod<Scalar>& method, PointsOfGroup& points);

  int dimension_ = 0;
  int degree_ = 0;
  std::size_t count_ = 0;
  std::array<CurveView<Scalar>, trials_at_once> curves_;
  std::array<Scalar, trials_at_once> t_{};
  std::vector<Scalar> given_;               ///< side by side, as core/batch/target_table.hpp says
  std::vector<Scalar> converted_;           ///< likewise
  const MethodInfo* conversion_ = nullptr;  ///< the conversion that computed `converted_`; methods share it
  std::vector<Scalar> one_;                 ///< coefficients of one converted curve
  PreparedStorage prepared_;
};

}  // namespace bezierbench::judge

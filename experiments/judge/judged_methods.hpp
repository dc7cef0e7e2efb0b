// SPDX-License-Identifier: MIT
// The methods that a cell of an accuracy study judges, each measured from every baseline.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "core/batch/batch.hpp"
#include "experiments/sample/cell.hpp"
#include "reference/certified_points.hpp"
#include "reference/error/trial_scale.hpp"

namespace bezierbench::judge {

// The points of a group of trials, one method after the other. Where core/batch has a kernel for groups, the trials are
// lanes of this processor's vectors, else they are evaluated one by one. Both give the same bits.

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
};

template <class Scalar>
class JudgedMethods {
 public:
  /// Throws Failure(usage) for methods and baselines that do not take the study's curves.
  JudgedMethods(const suite::Study& study, const sample::Cell& cell);
  /// One method only, which need not be in the roster; the kernel must outlive the object.
  JudgedMethods(const suite::Study& study, const sample::Cell& cell, const Kernel<Scalar>& method);

  [[nodiscard]] std::size_t count() const { return methods_.size(); }
  [[nodiscard]] std::size_t baseline_count() const { return baselines_.size(); }
  [[nodiscard]] const GroupMethod<Scalar>& operator[](std::size_t method) const { return methods_[method]; }
  [[nodiscard]] const MethodInfo& info(std::size_t method) const { return *methods_[method].kernel->info; }
  [[nodiscard]] const std::optional<reference::BoundAtDegree>& bound(std::size_t method) const {
    return bounds_[method];
  }
  /// Empty for the exact reference.
  [[nodiscard]] const std::optional<GroupMethod<Scalar>>& baseline(std::size_t baseline) const {
    return baselines_[baseline];
  }
  /// The amplifications that the bounds multiply, and that of p~.
  [[nodiscard]] const std::set<Amplification>& amplifications() const { return amplifications_; }

  /// Judgements are method by method, baseline by baseline.
  [[nodiscard]] std::size_t judgement_count() const { return count() * baseline_count(); }
  [[nodiscard]] std::size_t index(std::size_t method, std::size_t baseline) const {
    return method * baseline_count() + baseline;
  }
  [[nodiscard]] bool supported(const GroupMethod<Scalar>& method) const {
    return method.kernel->info->template supports<Scalar>(degree_);
  }
  [[nodiscard]] bool is_exact(std::size_t baseline) const { return !baselines_[baseline]; }
  [[nodiscard]] bool is_baseline(std::size_t method, std::size_t baseline) const {
    return baselines_[baseline] && baselines_[baseline]->kernel == methods_[method].kernel;
  }
  /// A method is not measured against itself.
  [[nodiscard]] bool judged(std::size_t method, std::size_t baseline) const {
    return !is_baseline(method, baseline) && supported(methods_[method]) &&
           (is_exact(baseline) || supported(*baselines_[baseline]));
  }
  [[nodiscard]] bool is_stable(std::size_t method, std::size_t baseline) const {
    return info(method).bit_stable && (is_exact(baseline) || baselines_[baseline]->kernel->info->bit_stable);
  }

 private:
  void add(const Kernel<Scalar>& method);
  void add_baselines(const suite::Study& study, const sample::Cell& cell);

  int degree_;
  std::vector<GroupMethod<Scalar>> methods_;
  std::vector<std::optional<reference::BoundAtDegree>> bounds_;
  std::set<Amplification> amplifications_;
  std::vector<std::optional<GroupMethod<Scalar>>> baselines_;
};

}  // namespace bezierbench::judge

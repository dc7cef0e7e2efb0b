// SPDX-License-Identifier: MIT
// Batch kernels: one curve at many t, or many curves at one t each, several of them in every instruction. Each point
// has the bits of the scalar kernel's.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/batch/operation_work.hpp"
#include "core/batch/target_table.hpp"
#include "core/evaluate/kernel/kernel.hpp"

namespace bezierbench::batch {

/// An instruction set that kernels were compiled for.
struct Target {
  std::string_view name;
  bool (*is_usable)();  ///< whether this processor can run it
  const TargetTable<float>* float_table;
  const TargetTable<double>* double_table;
  const WorksOfWidths<float>* float_works;
  const WorksOfWidths<double>* double_works;
};

/// All targets of this program, best first.
std::span<const Target> built_targets();

/// The targets that this processor can run, best first.
std::vector<const Target*> usable_targets();

/// The kernels of a target; call them only where the target is usable.
template <class Scalar>
const TargetTable<Scalar>& table_of(const Target& target);

/// The work of single kinds of operations of a target, by the width of vectors; run it only where the target is usable.
template <class Scalar>
WorksOfWidths<Scalar> works_of(const Target& target);

/// A kernel for a target; `evaluate` is null where there is none.
template <class Scalar>
struct BatchKernel {
  Parts (*parts)(const void* prepared) = nullptr;
  Evaluate<Scalar> evaluate = nullptr;
  Divide<Scalar> divide = nullptr;  ///< not null where `evaluate` writes homogeneous coordinates of rational curves
  int dimension = 0;                ///< of the points

  explicit operator bool() const { return evaluate != nullptr; }

  /// `prepared` is what the scalar kernel's `prepare` filled. Writes coordinate `axis` of the point at t[k] to
  /// points[axis * t.size() + k].
  void operator()(const void* prepared, std::span<const Scalar> t, Scalar* points) const;
};

/// The batch kernel that gives the same bits as `kernel`, if there is one: its evaluator needs a member `lanes`.
template <class Scalar>
BatchKernel<Scalar> find(const Target& target, const Kernel<Scalar>& kernel);

/// How a target evaluates many curves, of degrees to max_degree_of_groups, at one t each; target_table.hpp describes
/// the layout of a group.
template <class Scalar>
struct GroupKernel {
  ConvertGroup<Scalar> convert = nullptr;    ///< null where the curve is evaluated as given, or by exact integers
  EvaluateGroup<Scalar> evaluate = nullptr;  ///< takes coefficients in the form that the kernel evaluates
};

/// The parts of `kernel` that exist for groups, with the same bits: evaluators and conversions of the batch roster.
template <class Scalar>
GroupKernel<Scalar> find_group(const Target& target, const Kernel<Scalar>& kernel);

}  // namespace bezierbench::batch

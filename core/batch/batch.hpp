// SPDX-License-Identifier: MIT
// Batch kernels: one curve at many t, or many curves at one t each, several of them in every instruction. Each point
// has the bits of the scalar kernel's.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/batch/target_table.hpp"
#include "core/evaluate/kernel.hpp"

namespace bezierbench::batch {

/// An instruction set that kernels were compiled for.
struct Target {
  std::string_view name;
  std::int64_t highway;  ///< its bit in what Highway finds on a processor
  const TargetTable<float>* float_table;
  const TargetTable<double>* double_table;
};

/// All targets of this program, best first.
std::span<const Target> built_targets();

/// Can this processor run it?
bool is_usable(const Target& target);

/// Those that this processor can run, best first.
std::vector<const Target*> usable_targets();

/// The kernels and peak work of a target; only to be called where it is usable.
template <class Scalar>
const TargetTable<Scalar>& table_of(const Target& target);

/// A kernel for a target; none where `evaluate` is null.
template <class Scalar>
struct BatchKernel {
  Parts<Scalar> (*parts)(const void* prepared) = nullptr;
  Evaluate<Scalar> evaluate = nullptr;

  explicit operator bool() const { return evaluate != nullptr; }

  /// `prepared` is what the scalar kernel's `prepare` filled. Writes coordinate `axis` of the point at t[k] to
  /// points[axis * t.size() + k].
  void operator()(const void* prepared, std::span<const Scalar> t, Scalar* points) const {
    evaluate(parts(prepared), t.data(), t.size(), points);
  }
};

/// The batch kernel that gives the same bits as `kernel`, if there is one: an evaluator needs a line in the roster, a
/// fused one also a target with fused multiply-add in hardware.
template <class Scalar>
BatchKernel<Scalar> find(const Target& target, const Kernel<Scalar>& kernel);

/// How a target evaluates many curves at one t each; see target_table.hpp for where which number lies.
template <class Scalar>
struct GroupKernel {
  ConvertGroup<Scalar> convert = nullptr;  ///< none where the curve is evaluated as given, or by way of exact integers
  EvaluateGroup<Scalar> evaluate = nullptr;  ///< of coefficients in the form that the kernel evaluates
};

/// What of `kernel` exists for groups with the same bits: an evaluator or a conversion needs a place in the roster.
template <class Scalar>
GroupKernel<Scalar> find_group(const Target& target, const Kernel<Scalar>& kernel);

}  // namespace bezierbench::batch

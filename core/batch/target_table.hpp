// SPDX-License-Identifier: MIT
// All that passes between code for any processor and code for one target: plain arrays and function pointers.
#pragma once

#include <cstddef>

namespace bezierbench {

template <class Scalar>
struct AxisRounding;

namespace batch {

inline constexpr int max_dimension = 3;

/// The prepared state of an evaluator: up to three arrays, each with the (degree + 1) * dimension coefficients of a
/// curve, point by point, or with degree + 1 values. Those that a method does not have are null.
template <class Scalar>
struct Parts {
  int degree;
  const Scalar* first;
  const Scalar* second = nullptr;
  const Scalar* third = nullptr;
  const AxisRounding<Scalar>* rounding = nullptr;  ///< by axis, of methods that round correctly
};

/// Writes coordinate `axis` of the point at t[k] to points[axis * count + k].
template <class Scalar>
using Evaluate = void (*)(const Parts<Scalar>& parts, const Scalar* t, std::size_t count, Scalar* points);

/// An evaluator's kernels for 1, 2 and 3 dimensions, and for 4 where it takes the homogeneous coordinates of rational
/// curves, else null.
template <class Scalar>
struct TargetKernels {
  Evaluate<Scalar> by_dimension[max_dimension + 1];
};

/// The kernels of a family of evaluators, in its order, the fused ones last, or not at all.
template <class Scalar>
struct FamilyTable {
  const TargetKernels<Scalar>* kernels;
  std::size_t count;
};

/// Divides `count` points in homogeneous coordinates, axis by axis: points[axis * stride + k] is coordinate `axis`,
/// one of `dimension`, of point k.
template <class Scalar>
using Divide = void (*)(const Scalar* homogeneous, int dimension, std::size_t count, Scalar* points,
                        std::size_t stride);

/// Curves that lie side by side. All arrays of a group have the values of its curves next to each other: coordinate
/// `axis` of coefficient i of curve k is at [(i * dimension + axis) * curves_at_once + k] (of double-double
/// coefficients all high parts, then all low parts), of its point at [axis * curves_at_once + k], and its t at [k].
inline constexpr std::size_t curves_at_once = 16;

/// Both process all curves of a group, also those whose results nobody reads.
template <class Scalar>
using ConvertGroup = void (*)(int degree, const Scalar* given, Scalar* converted);
template <class Scalar>
using EvaluateGroup = void (*)(int degree, const Scalar* coefficients, const Scalar* t, Scalar* points);

/// For 1, 2 and 3 dimensions, one of each per method of the roster, fused evaluators last, or not at all.
template <class Scalar>
struct GroupTable {
  struct Evaluators {
    EvaluateGroup<Scalar> by_dimension[max_dimension];
  };
  struct Conversions {
    ConvertGroup<Scalar> by_dimension[max_dimension];
  };
  const Evaluators* evaluators;
  std::size_t evaluator_count;
  const Conversions* conversions;
};

template <class Scalar>
struct TargetTable {
  const FamilyTable<Scalar>* const* families;  ///< in the order of the roster
  Divide<Scalar> divide;
  const GroupTable<Scalar>* group;
};

}  // namespace batch
}  // namespace bezierbench

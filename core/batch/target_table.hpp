// SPDX-License-Identifier: MIT
// All that passes between code for any processor and code for one target: plain arrays and function pointers.
#pragma once

#include <cstddef>

namespace bezierbench {

struct Parts;

namespace batch {

inline constexpr int max_dimension = 3;

/// Writes coordinate `axis` of the point at t[k] to points[axis * count + k].
template <class Scalar>
using Evaluate = void (*)(const Parts& parts, const Scalar* t, std::size_t count, Scalar* points);

/// An evaluator's kernels for 1, 2 and 3 dimensions, and for 4 where it takes the homogeneous coordinates of rational
/// curves, else null.
template <class Scalar>
struct TargetKernels {
  Evaluate<Scalar> by_dimension[max_dimension + 1];
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
/// Their largest degree: what a method keeps of them lies on the stack.
inline constexpr int max_degree_of_groups = 127;

/// Both process all curves of a group, also those whose results nobody reads.
template <class Scalar>
using ConvertGroup = void (*)(int degree, const Scalar* given, Scalar* converted);
template <class Scalar>
using EvaluateGroup = void (*)(int degree, const Scalar* coefficients, const Scalar* t, Scalar* points);

/// For 1, 2 and 3 dimensions, one of each per method of the roster.
template <class Scalar>
struct GroupTable {
  struct Evaluators {
    EvaluateGroup<Scalar> by_dimension[max_dimension];
  };
  struct Conversions {
    ConvertGroup<Scalar> by_dimension[max_dimension];
  };
  const Evaluators* evaluators;
  const Conversions* conversions;
};

template <class Scalar>
struct TargetTable {
  const TargetKernels<Scalar>* const* const* units;  ///< the kernels of each unit
  Divide<Scalar> divide;
  const GroupTable<Scalar>* group;
};

}  // namespace batch
}  // namespace bezierbench

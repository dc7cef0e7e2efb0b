// SPDX-License-Identifier: MIT
// All that passes between the code for any processor and the code for one target: plain arrays and function pointers.
#pragma once

#include <cstddef>

namespace bezierbench::batch {

inline constexpr int max_dimension = 3;

/// What an evaluator keeps of a curve: the (degree + 1) * dimension coefficients of one or two curves, point by point.
template <class Scalar>
struct Parts {
  int degree;
  const Scalar* first;
  const Scalar* second;  ///< null where there is one
};

/// Writes coordinate `axis` of the point at t[k] to points[axis * count + k].
template <class Scalar>
using Evaluate = void (*)(const Parts<Scalar>& parts, const Scalar* t, std::size_t count, Scalar* points);

/// An evaluator's kernels for 1, 2 and 3 dimensions.
template <class Scalar>
struct TargetKernels {
  Evaluate<Scalar> of_dimension[max_dimension];
};

/// A target's kernels: one entry per evaluator of the roster, the fused ones last, or not at all.
template <class Scalar>
struct TargetTable {
  const TargetKernels<Scalar>* first;
  std::size_t count;
};

}  // namespace bezierbench::batch
